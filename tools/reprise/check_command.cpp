// SPDX-License-Identifier: Apache-2.0
// Numerical stability of every function on the chosen device.
#include "commands.hpp"

#include "progress.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {
namespace fs = std::filesystem;
namespace {

std::vector<check::Case> chosenCases(const std::string& function) {
    std::vector<check::Case> cases = check::table();
    if (function.empty()) return cases;
    std::vector<std::string> names;
    for (const check::Case& each : cases)
        if (std::find(names.begin(), names.end(), each.function()) == names.end())
            names.push_back(each.function());
    std::erase_if(cases, [&](const check::Case& each) { return each.function() != function; });
    if (cases.empty())
        throw std::runtime_error(
            fmt::format("--function {} is not known; there are {}", function, fmt::join(names, ", ")));
    return cases;
}

// Beside the file and renamed when it is whole, so that a failure leaves what was there.
void writeWhole(const fs::path& file, const std::string& text) {
    fs::path made = file;
    made += ".part";
    {
        std::ofstream stream(made, std::ios::binary);
        stream << text;
        stream.close();
        if (!stream) {
            std::error_code ignored;
            fs::remove(made, ignored);
            throw std::runtime_error(
                fmt::format("{} cannot be written: choose another place with --out", file.string()));
        }
    }
    fs::rename(made, file);
}

// What cannot be written should be known before minutes have passed.
void requirePlace(const fs::path& file) {
    const fs::path directory = file.has_parent_path() ? file.parent_path() : ".";
    if (fs::is_directory(file) || !fs::is_directory(directory))
        throw std::runtime_error(
            fmt::format("--out {} is no file in a directory that exists", file.string()));
}

std::vector<check::Outcome> runAll(const functions::Bench& bench, const std::vector<check::Case>& cases,
                                   bool quick) {
    std::vector<check::Outcome> outcomes;
    Progress progress(static_cast<double>(cases.size()));
    for (const check::Case& each : cases) {
        outcomes.push_back(check::run(bench, each, {quick}));
        progress.step(1.0, each.function());
    }
    progress.finish();
    return outcomes;
}

void throwFailures(const std::vector<check::Outcome>& outcomes,
                   const std::vector<check::PublicFunction>& unchecked) {
    std::vector<std::string> failures;
    for (const check::Outcome& outcome : outcomes)
        if (std::string text = check::failure(outcome); !text.empty()) failures.push_back(text);
    for (const check::PublicFunction& function : unchecked)
        failures.push_back(fmt::format("{} of {} has no case", function.name, function.header));
    if (!failures.empty())
        throw std::runtime_error(fmt::format("{} of {} checks do not hold: {}", failures.size(),
                                             outcomes.size() + unchecked.size(), fmt::join(failures, "; ")));
}

} // namespace

void checkCases(const CheckOptions& options, const std::vector<check::Case>& cases,
                const std::vector<check::PublicFunction>& unchecked) {
    requirePlace(options.out);
    harness::Gpu gpu(harness::DeviceOptions{.device = options.device, .validation = false});
    const functions::Bench bench{gpu, findAssets().packToml.parent_path()};
    const auto outcomes = runAll(bench, cases, options.quick);
    fmt::print("{} ({})\n{}\n", gpu.name(), gpu.driver(), check::tableHead());
    for (const check::Outcome& outcome : outcomes)
        for (const std::string& line : check::tableLines(outcome))
            fmt::print("{}\n", line);
    writeWhole(options.out, check::jsonText({gpu.name(), gpu.driver(), gpu.type()}, outcomes, options.quick));
    fmt::print("{}\n", options.out.string());
    std::fflush(stdout);
    throwFailures(outcomes, unchecked);
}

void checkCommand(const CheckOptions& options) {
    const auto functions = check::publicFunctions(findAssets().packToml.parent_path());
    checkCases(options, chosenCases(options.function), check::withoutCase(functions, check::table()));
}

} // namespace report
