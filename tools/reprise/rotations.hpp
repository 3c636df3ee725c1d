// SPDX-License-Identifier: Apache-2.0
// Wronski's rotations on a scene that stands still: three in turn with a history, against a frame alone and
// against one frame of three times the taps. Errors are to what the technique converges to, not to rays, so
// that they are of sampling alone.
#pragma once

#include "experiment.hpp"

#include <string>
#include <vector>

namespace report {

// The first scene in which neither camera nor objects move and nothing vanishes; null if there is none.
const scenes::Scene* stillScene(const Plan& plan);

// As many taps, and three times as many in one frame: numbers that scalable_obscurance has. A frame that is
// black stops there, so that the mean of three is not that of all their taps: seldom at an intensity of 1, at
// 2 often enough to be seen in the error.
struct RotationCase {
    uint32_t few, many;
    float intensity;
};
std::vector<RotationCase> rotationCases(const Plan& plan);
// The rows' variants; their technique is scalable_obscurance, their scene the still one.
std::string oneFrameName(uint32_t taps, const RotationCase& of);
std::string rotationsName(const RotationCase& of);

// Frames after which three rotations are compared: the first three, and when the history has settled.
inline constexpr uint32_t rotations = 3, settledFrames = 63;

// Rows without a time, whose curve begins with the first frame. Nothing without occlusion or a still scene.
void measureRotations(Experiment& experiment);
double rotationsWork(const Plan& plan); // steps of progress of it

} // namespace report
