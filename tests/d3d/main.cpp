// SPDX-License-Identifier: Apache-2.0
// d3d_cases prepare DIRECTORY   writes what d3d_run (windows/) is to compile and run
// d3d_cases judge DIRECTORY     compares what came out with the oracle and prints the table
#include "cases.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace {

using namespace d3d;

void prepare(const fs::path& directory) {
    const bool isOwn =
        !fs::exists(directory) || fs::is_empty(directory) || fs::exists(directory / "jobs.txt");
    if (!isOwn)
        throw std::runtime_error(directory.string() + " holds something else; give another directory");
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
    fmt::print("{} cases, {} runs\n", cases.size(), runs);
}

struct Count {
    size_t passed = 0, failed = 0;
    bool add(bool pass) {
        ++(pass ? passed : failed);
        return pass;
    }
};

// A device that errs by more could not show the half pixel that is looked for: a step of an 8-bit weight, and
// 1/1024 px.
constexpr double mostFilterErrorPx = 0x1p-8, mostInterpolationErrorPx = 0x1p-10;

DeviceErrors measure(const Platform& platform, const std::vector<Case>& cases, const Results& results,
                     Count& count) {
    const std::string report = results.of("device", std::to_string(platform.version));
    if (!report.starts_with("ok "))
        throw std::runtime_error(fmt::format("there is no Direct3D {} device: {}", platform.version, report));
    const DeviceErrors errors = errorsOf(platform, cases, results);
    const double interpolationPx = errors.largestInterpolationPx();
    const bool fits =
        count.add(errors.filterPx <= mostFilterErrorPx && interpolationPx <= mostInterpolationErrorPx);
    fmt::print("Direct3D {} on {}: linear filter within {:.1e} px, positions within {:.1e} px{}\n",
               platform.version, report.substr(3), errors.filterPx, interpolationPx,
               fits ? "" : ": FAILED, too coarse to judge with");
    return errors;
}

// The first columns of a row; names are as wide as the longest.
std::string rowStart(std::string_view name, size_t width, std::string_view platform,
                     std::string_view profile) {
    return fmt::format("{:<{}}  {:<5}  {:<6}  ", name, width, platform, profile);
}

std::string nameOf(const Case& which) {
    return which.title + (which.control ? ", " + std::string(which.control->summary) : "");
}

void printCase(const Case& which, const Verdict& verdict, size_t width) {
    const Platform& platform = *which.platform;
    const auto profile = profileOf(platform, which.stage == Stage::vertex ? Stage::fragment : which.stage);
    fmt::print("{}{:<16}", rowStart(nameOf(which), width, platform.name, profile), verdict.result);
    const passes::Comparison& found = verdict.comparison;
    if (which.control && verdict.passed)
        fmt::print("  {} of {} pixels wrong", found.outside, found.pixels);
    else if (found.pixels > 0)
        fmt::print("  {:.1e} (bound {:.1e}), {} pixels", verdict.first.largestError, verdict.first.boundThere,
                   found.pixels);
    fmt::print("\n");
    if (!verdict.passed) fmt::print("    {}\n", verdict.detail);
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
        if (!count.add(expected)) detail += fmt::format("    {}: {}\n", signature, said);
    }
    if (!count.add(hasFunctions(job) == (compiled + refused > 0)))
        detail += "    it has functions, and none was found\n";
    fmt::print(
        "{}{}{} functions{}\n{}",
        rowStart(job.name.substr(job.name.find('.') + 1), width, platform.name, platform.fragmentProfile),
        detail.empty() ? "" : "FAILED, ", compiled,
        refused > 0 ? fmt::format(", {} not expressible", refused) : "", detail);
}

// Rows that no longer name anything are wrong as well.
void judgeExceptions(const std::vector<Case>& cases, const Results& results, Count& count) {
    const auto stale = [&](bool names) { return count.add(names) ? "" : " (FAILED: the row names nothing)"; };
    fmt::print("\nNot expressible, each refused by the compiler:\n");
    for (const Exception& row : exceptions()) {
        const auto variants =
            std::ranges::count_if(cases, [&](const Case& each) { return each.exception == &row; });
        fmt::print("  {} under {} = {}, {}, d3d{}, {} variants{}: {}\n", row.pass, row.condition.switchName,
                   row.condition.value, reprise::stageName(row.stage), row.version, variants,
                   stale(variants > 0), row.reason);
    }
    for (const HeaderException& row : headerExceptions()) {
        const auto functions = results.functions(fmt::format("d3d{}.{}", row.version, row.header));
        const bool names = std::ranges::any_of(
            functions, [&](const auto& function) { return function.first == row.function; });
        fmt::print("  {} of {}, d3d{}{}: {}\n", row.function, row.header, row.version, stale(names),
                   row.reason);
    }
    fmt::print("  compute, d3d9: shader model 3 has none; every pass has a fragment form, lighting_cache in "
               "the three that it does the work of\n");
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
    fmt::print("\n{}{:<16}  worst error at 64x64; pixels compared at all sizes\n",
               rowStart("pass and switches", width, "", ""), "result");
    for (const Case& each : cases) {
        const Verdict verdict = judge(each, results, errors[each.platform->version]);
        count.add(verdict.passed);
        printCase(each, verdict, width);
    }
    fmt::print("\n{}compiled, each function called by a shader of its own\n",
               rowStart("header, and the switch that is on", width, "", ""));
    for (const Platform& platform : platforms)
        for (const Shader& job : headerJobs(platform))
            judgeHeader(platform, job, width, results, count);
    judgeExceptions(cases, results, count);
    fmt::print("\n{} passed, {} failed\n", count.passed, count.failed);
    return count.failed == 0 && count.passed > 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const std::string command = argc == 3 ? argv[1] : "";
    try {
        if (command == "judge") return judgeAll(argv[2]);
        if (command == "prepare") return prepare(argv[2]), 0;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "d3d_cases: {}\n", failure.what());
        return 1;
    }
    fmt::print(stderr, "usage: d3d_cases prepare|judge DIRECTORY\n");
    return 1;
}
