// SPDX-License-Identifier: Apache-2.0
// The program: pack.toml and HLSL in, files out.
#include "output.hpp"

#include <cstdio>
#include <thread>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

using namespace reprisec;

struct Arguments {
    std::string pack = "hlsl/pack.toml", out = "generated", pass, needs, stage, depfile, stamp;
    std::vector<std::string> variants, targets, defines;
    unsigned jobs = std::max(std::thread::hardware_concurrency(), 1u);
    bool check = false, list = false, listOutputs = false;
};

int fail(const std::string& message) {
    fmt::print(stderr, "reprisec: {}\n", message);
    return 1;
}

void addOptions(CLI::App& app, Arguments& arguments) {
    app.add_option("--pack", arguments.pack, "The table of passes")->capture_default_str();
    app.add_option("--out", arguments.out, "Directory of the output")->capture_default_str();
    app.add_option("--pass", arguments.pass, "Only the committed variants of this pass");
    app.add_option(
        "--variant", arguments.variants,
        "Only this variant, by its canonical name, e.g. temporal_aa--neighbourhood-square; repeatable");
    app.add_option("--needs", arguments.needs, "Only what the plan of this scene uses: a needs.toml");
    app.add_option("--stage", arguments.stage, "With --variant: only this stage")
        ->check(CLI::IsMember({"vertex", "fragment", "compute"}));
    app.add_option("--targets", arguments.targets,
                   "What to write, and must exist; by default all that can be expressed")
        ->check(CLI::IsMember({"spirv", "glsl450", "glsles", "json"}));
    app.add_option("--depfile", arguments.depfile, "Write the files read, as a makefile rule");
    app.add_option("--stamp", arguments.stamp, "Write an empty file at the end; the depfile's target");
    app.add_flag("--list-outputs", arguments.listOutputs,
                 "Compile nothing; print VARIANT STAGE PATH TARGET for each file, for a build system");
    app.add_option("--define", arguments.defines,
                   "Set a platform switch of the table, e.g. NDC_AND_UV_SHARE_Y=1; repeatable");
    app.add_option("--jobs", arguments.jobs, "Threads")->check(CLI::Range(1u, 1024u))->capture_default_str();
    app.add_flag("--check", arguments.check, "Write nothing; fail if the output directory is not up to date");
}

constexpr std::pair<std::string_view, Target> targetNames[] = {{"spirv", Target::spirv},
                                                               {"glsl450", Target::glsl450},
                                                               {"glsles", Target::glslEs},
                                                               {"json", Target::json}};

std::set<Target> targetsOf(const Arguments& arguments) {
    std::set<Target> targets;
    for (const auto& [name, target] : targetNames)
        if (arguments.targets.empty() ||
            std::ranges::find(arguments.targets, name) != arguments.targets.end())
            targets.insert(target);
    return targets;
}

std::optional<Stage> stageOf(const std::string& name) {
    for (Stage stage : {Stage::vertex, Stage::fragment, Stage::compute})
        if (stageWord(stage) == name) return stage;
    return std::nullopt;
}

Result<std::vector<Job>> wantedJobs(const Pack& pack, const Arguments& arguments) {
    if (!arguments.needs.empty()) return jobsForNeeds(pack, arguments.needs);
    if (arguments.variants.empty()) {
        if (!arguments.pass.empty())
            if (auto known = reprise::makeVariant(pack.passes(), arguments.pass); !known)
                return known.error();
        return committedJobs(pack, arguments.pass);
    }
    std::vector<Job> jobs;
    for (const std::string& name : arguments.variants) {
        auto variant = pack.parseVariant(name);
        if (!variant) return variant.error();
        const auto stage = stageOf(arguments.stage);
        auto of = jobsOf(*variant, stage);
        if (of.empty())
            return Error{ErrorCode::invalidArgument,
                         fmt::format("the pass {} has no {} stage", variant->pass->name, arguments.stage)};
        jobs.insert(jobs.end(), of.begin(), of.end());
    }
    return jobs;
}

void list(const Pack& pack) {
    for (const PassInfo& pass : pack.passes()) {
        fmt::print("{}: {}\n", pass.name, pass.summary);
        for (const auto& info : pass.switches) {
            fmt::print("  {:<22}", info.name);
            for (size_t i = 0; i < info.values.size(); ++i)
                fmt::print("{}{}{}", i == info.defaultValue ? " [" : " ", info.values[i],
                           i == info.defaultValue ? "]" : "");
            fmt::print("  {}\n", info.summary);
        }
        for (const auto& preset : pack.presets(pass.name))
            fmt::print("  preset {:<15} {}\n", preset.name, preset.summary);
    }
    for (const Job& job : committedJobs(pack, {}))
        fmt::print("{}\n", outputPath(job, Target::spirv).generic_string());
}

int report(const Arguments& arguments, const std::vector<std::string>& differences, size_t files) {
    for (const std::string& line : differences)
        fmt::print("{}\n", line);
    if (!differences.empty())
        return fail(fmt::format("{} is not up to date; run reprisec --pack {} --out {}", arguments.out,
                                arguments.pack, arguments.out));
    fmt::print("{} files of {} are up to date\n", files, arguments.out);
    return 0;
}

// A build system wants its outputs newer than what they come from, even where the bytes are the same.
Result<void> writeForBuildSystem(const Arguments& arguments, const Pack& pack,
                                 const std::vector<Product>& products, const Files& files) {
    std::vector<fs::path> targets;
    std::error_code error;
    // In the order of --list-outputs: Ninja wants its first output first in the depfile.
    for (const Product& product : products)
        for (Target target : targetsOf(arguments))
            if (const fs::path path = outputPath(product.job, target); files.contains(path)) {
                targets.push_back(arguments.out / path);
                fs::last_write_time(targets.back(), fs::file_time_type::clock::now(), error);
            }
    std::vector<fs::path> inputs;
    if (!arguments.needs.empty()) inputs.emplace_back(arguments.needs);
    if (!arguments.stamp.empty()) targets = {arguments.stamp};
    if (!arguments.depfile.empty())
        if (auto done = writeDepfile(arguments.depfile, targets, inputs, pack, products); !done) return done;
    if (arguments.stamp.empty()) return {};
    const fs::path stamp = arguments.stamp;
    auto done = writeFiles(stamp.parent_path(), {{stamp.filename(), ""}});
    fs::last_write_time(stamp, fs::file_time_type::clock::now(), error);
    return done ? Result<void>{} : Result<void>{done.error()};
}

int write(const Arguments& arguments, const Pack& pack, const std::vector<Product>& products,
          const Files& files, bool whole) {
    auto written = writeFiles(arguments.out, files);
    if (!written) return fail(written.error().message);
    std::error_code error;
    if (whole)
        for (const fs::path& path : superfluousFiles(arguments.out, files))
            fs::remove(arguments.out / path, error);
    if (!arguments.depfile.empty() || !arguments.stamp.empty())
        if (auto done = writeForBuildSystem(arguments, pack, products, files); !done)
            return fail(done.error().message);
    fmt::print("{} modules, {} of {} files written to {}\n", products.size(), *written, files.size(),
               arguments.out);
    return 0;
}

Result<std::map<std::string, int>> platformSwitches(const std::vector<std::string>& defines) {
    std::map<std::string, int> switches;
    for (const std::string& define : defines) {
        const size_t equals = define.find('=');
        const std::string value = equals == std::string::npos ? "1" : define.substr(equals + 1);
        if (value != "0" && value != "1")
            return Error{ErrorCode::invalidArgument, "--define " + define + ": a switch is 0 or 1"};
        switches[define.substr(0, equals)] = value == "1";
    }
    return switches;
}

Result<std::vector<Product>> compileWithProgress(const Arguments& arguments, const Pack& pack,
                                                 const std::vector<Job>& jobs) {
    auto switches = platformSwitches(arguments.defines);
    if (!switches) return switches.error();
    const bool interactive = isatty(fileno(stderr));
    return compileAll(pack, jobs, *switches, arguments.jobs, [&](size_t done, const Job&) {
        if (interactive)
            fmt::print(stderr, "\rcompiling {}/{}{}", done, jobs.size(), done == jobs.size() ? "\n" : "");
    });
}

int compileAndWrite(const Arguments& arguments, const Pack& pack, const std::vector<Job>& jobs) {
    auto products = compileWithProgress(arguments, pack, jobs);
    if (!products) return fail(products.error().message);
    if (!arguments.targets.empty())
        if (const auto missing = missingTargets(*products, targetsOf(arguments)); !missing.empty())
            return fail(fmt::format("{}", fmt::join(missing, "\n")));

    const bool whole = arguments.variants.empty() && arguments.pass.empty() && arguments.needs.empty();
    Files files = filesOf(pack, *products, targetsOf(arguments));
    if (whole && arguments.targets.empty()) {
        auto header = tableHeader(pack, *products);
        if (!header) return fail(header.error().message);
        files["include/reprise/pack_table.hpp"] = *header;
    }
    if (arguments.check) return report(arguments, compareFiles(arguments.out, files), files.size());
    return write(arguments, pack, *products, files, whole && arguments.targets.empty());
}

int run(const Arguments& arguments) {
    auto table = readTable(arguments.pack);
    if (!table) return fail(table.error().message);
    const Pack pack{*table};
    if (arguments.list) return list(pack), 0;
    auto jobs = wantedJobs(pack, arguments);
    if (!jobs) return fail(jobs.error().message);
    if (!arguments.listOutputs) return compileAndWrite(arguments, pack, *jobs);
    for (const Job& job : *jobs) {
        const auto asked = targetsOf(job, targetsOf(arguments));
        for (const auto& [name, target] : targetNames)
            if (asked.contains(target))
                fmt::print("{} {} {} {}\n", reprise::variantName(job.variant), stageWord(job.stage),
                           outputPath(job, target).generic_string(), name);
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Compiles the shader pack: SPIR-V, GLSL, reflection and the C++ table of passes."};
    Arguments arguments;
    addOptions(app, arguments);
    app.add_subcommand("list", "Print passes, switches, presets and committed modules")
        ->fallthrough()
        ->callback([&] { arguments.list = true; });
    CLI11_PARSE(app, argc, argv);
    return run(arguments);
}
