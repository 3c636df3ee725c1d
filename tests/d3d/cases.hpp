// SPDX-License-Identifier: Apache-2.0
// Every pass of the table x its committed variants x both Direct3D versions, as jobs and as verdicts.
#pragma once

#include "platforms.hpp"
#include "scenes.hpp"

namespace d3d {

struct CaseRun {
    Run run;
    Scene scene;
};

struct Case {
    std::string title; // the variant, or an engine's own shader
    const Platform* platform = nullptr;
    Stage stage = Stage::fragment;
    const Exception* exception = nullptr; // then its shader must be refused
    const Control* control = nullptr;     // then its result must be wrong
    std::vector<Shader> shaders;
    std::vector<CaseRun> runs;
};

// `directory` is where the changed texts of the controls are, or will be.
std::vector<Case> allCases(const fs::path& directory);
// Reads a ramp: shows the error of the platform's filter.
Case rampCase(const Platform& platform);

// The headers of hlsl/reprise for a platform: as they are, and under each switch that they test.
std::vector<Shader> headerJobs(const Platform& platform);
// Whether the header's text has a function: what d3d_run finds is held against it.
bool hasFunctions(const Shader& header);

// Writes the texts that controls change.
void writeControls(const fs::path& directory);

struct Verdict {
    bool passed = false;
    std::string result;                   // a word for the table
    passes::Comparison first, comparison; // of the first scene, and of all together
    std::string detail;                   // what went wrong
};

// What the device showed of itself in the same run.
struct DeviceErrors {
    double filterPx = 0.0;
    std::map<std::pair<int, int>, double> interpolationPx; // by extent
    double largestInterpolationPx() const;
    DeviceError at(int width, int height) const;
};
DeviceErrors errorsOf(const Platform& platform, const std::vector<Case>& cases, const Results& results);

Verdict judge(const Case& which, const Results& results, const DeviceErrors& errors);

} // namespace d3d
