// SPDX-License-Identifier: Apache-2.0
// d3d_cases prepare DIRECTORY   writes what d3d_run (windows/) is to compile and run
// d3d_cases judge DIRECTORY     compares what came out with the oracle and prints the table
#include "cases.hpp"

#include <algorithm>
#include <cstdio>

namespace {

using namespace d3d;

void prepare(const fs::path& directory) {
    fs::remove_all(directory);
    fs::create_directories(directory);
    writeControls(directory);
    JobFile jobs(directory);
    std::vector<Case> cases = allCases(directory);
    for (const Platform& platform : platforms)
        cases.push_back(rampCase(platform));
    size_t runs = 0;
    for (const Case& each : cases)
        for (const Shader& shader : each.shaders)
            jobs.add(shader);
    for (const Platform& platform : platforms)
        for (const Shader& header : headerJobs(platform))
            jobs.addHeader(header);
    for (const Case& each : cases)
        for (const CaseRun& run : each.runs) {
            jobs.add(run.run);
            ++runs;
        }
    std::printf("%zu cases, %zu runs\n", cases.size(), runs);
}

struct Count {
    size_t passed = 0, failed = 0;
    bool add(bool pass) {
        ++(pass ? passed : failed);
        return pass;
    }
};

// Below these a device could not show the half pixel that is looked for: an eighth of a bit of an 8-bit
// weight, and 1/1024 px.
constexpr double mostFilterErrorPx = 0x1p-8, mostInterpolationErrorPx = 0x1p-10;

DeviceErrors measure(const Platform& platform, const std::vector<Case>& cases, const Results& results,
                     Count& count) {
    const DeviceErrors errors = errorsOf(platform, cases, results);
    const double interpolationPx = errors.largestInterpolationPx();
    const bool fits =
        count.add(errors.filterPx <= mostFilterErrorPx && interpolationPx <= mostInterpolationErrorPx);
    const std::string report = results.of("device", std::to_string(platform.version));
    std::printf("Direct3D %d on %s: linear filter within %.1e px, positions within %.1e px%s\n",
                platform.version, report.starts_with("ok ") ? report.substr(3).c_str() : report.c_str(),
                errors.filterPx, interpolationPx, fits ? "" : ": FAILED, too coarse to judge with");
    return errors;
}

// The first columns of a row; names are as wide as the longest.
void printStart(const std::string& name, size_t width, std::string_view platform, std::string_view profile) {
    std::printf("%-*s  %-5s  %-6s  ", static_cast<int>(width), name.c_str(), std::string(platform).c_str(),
                std::string(profile).c_str());
}

std::string nameOf(const Case& which) {
    return which.title + (which.control ? ", " + std::string(which.control->summary) : "");
}

void printCase(const Case& which, const Verdict& verdict, size_t width) {
    const Platform& platform = *which.platform;
    printStart(nameOf(which), width, platform.name,
               profileOf(platform, which.stage == Stage::vertex ? Stage::fragment : which.stage));
    std::printf("%-16s", verdict.result.c_str());
    const passes::Comparison& found = verdict.comparison;
    if (which.control && verdict.passed)
        std::printf("  %zu of %zu pixels wrong", found.outside, found.pixels);
    else if (found.pixels > 0)
        std::printf("  %.1e (bound %.1e), %zu pixels", verdict.first.largestError, verdict.first.boundThere,
                    found.pixels);
    std::printf("\n");
    if (!verdict.passed) std::printf("    %s\n", verdict.detail.c_str());
}

// Functions that compile, and those listed as not expressible that the compiler refuses for that reason.
void judgeHeader(const Platform& platform, const Shader& job, size_t width, const Results& results,
                 Count& count) {
    const std::string header = job.file.substr(job.file.find('/') + 1);
    const std::string report = results.of("header", job.name);
    size_t compiled = 0, refused = 0;
    std::string detail;
    if (!count.add(report.starts_with("ok"))) detail += "    " + report + "\n";
    for (const auto& [signature, said] : results.functions(job.name)) {
        const HeaderException* exception = exceptionOf(platform, header, signature);
        const bool ok = said.starts_with("ok");
        const bool expected = exception ? !ok && said.find(exception->compilerSays) != std::string::npos : ok;
        ++(ok ? compiled : refused);
        if (!count.add(expected)) detail += "    " + signature + ": " + said + "\n";
    }
    printStart(job.name.substr(job.name.find('.') + 1), width, platform.name, platform.fragmentProfile);
    std::printf("%s%zu functions", detail.empty() ? "" : "FAILED, ", compiled);
    if (refused > 0) std::printf(", %zu not expressible", refused);
    std::printf("\n%s", detail.c_str());
}

// Rows that no longer name anything are wrong as well.
void judgeExceptions(const std::vector<Case>& cases, const Results& results, Count& count) {
    std::printf("\nNot expressible, each refused by the compiler:\n");
    for (const Exception& row : exceptions()) {
        const auto variants =
            std::ranges::count_if(cases, [&](const Case& each) { return each.exception == &row; });
        std::printf("  %s under %s = %s, %s, d3d%d, %td variants%s: %s\n", std::string(row.pass).c_str(),
                    std::string(row.condition.switchName).c_str(), std::string(row.condition.value).c_str(),
                    std::string(reprise::stageName(row.stage)).c_str(), row.version, variants,
                    count.add(variants > 0) ? "" : " (FAILED: the row names nothing)",
                    std::string(row.reason).c_str());
    }
    for (const HeaderException& row : headerExceptions()) {
        bool found = false;
        for (const auto& [signature, said] :
             results.functions("d3d" + std::to_string(row.version) + "." + std::string(row.header)))
            found = found || signature == row.function;
        std::printf("  %s of %s, d3d%d%s: %s\n", std::string(row.function).c_str(),
                    std::string(row.header).c_str(), row.version,
                    count.add(found) ? "" : " (FAILED: the row names nothing)",
                    std::string(row.reason).c_str());
    }
    std::printf(
        "  compute, d3d9: shader model 3 has none; every pass with a compute form has a fragment form\n");
}

int judgeAll(const fs::path& directory) {
    const Results results(directory);
    const std::vector<Case> cases = allCases(directory);
    Count count;
    std::map<int, DeviceErrors> errors;
    for (const Platform& platform : platforms)
        errors[platform.version] = measure(platform, cases, results, count);
    size_t width = 0;
    for (const Case& each : cases)
        width = std::max(width, nameOf(each).size());
    std::printf("\n");
    printStart("pass and switches", width, "", "");
    std::printf("%-16s  %s\n", "result", "worst error at 64x64; pixels compared at all sizes");
    for (const Case& each : cases) {
        const Verdict verdict = judge(each, results, errors[each.platform->version]);
        count.add(verdict.passed);
        printCase(each, verdict, width);
    }
    std::printf("\n");
    printStart("header, and the switch that is on", width, "", "");
    std::printf("compiled, each function called by a shader of its own\n");
    for (const Platform& platform : platforms)
        for (const Shader& job : headerJobs(platform))
            judgeHeader(platform, job, width, results, count);
    judgeExceptions(cases, results, count);
    std::printf("\n%zu passed, %zu failed\n", count.passed, count.failed);
    return count.failed == 0 && count.passed > 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const std::string command = argc == 3 ? argv[1] : "";
    try {
        if (command == "judge") return judgeAll(argv[2]);
        if (command == "prepare") return prepare(argv[2]), 0;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "d3d_cases: %s\n", failure.what());
        return 1;
    }
    std::fprintf(stderr, "usage: d3d_cases prepare|judge DIRECTORY\n");
    return 1;
}
