// SPDX-License-Identifier: Apache-2.0
// From modules to files: compiled in parallel, compared or written whole.
#pragma once

#include "internal.hpp"

namespace reprisec {

struct Job {
    Variant variant; // as forStage gives it
    Stage stage;
    bool vulkanAlone = false; // the same without quad operations is there too: no GLSL is asked of this one
};

struct Product {
    Job job;
    Compiled compiled;
};

enum class Target { spirv, glsl450, glslEs, json };

// Path relative to the output directory, and the bytes.
using Files = std::map<fs::path, std::string>;

// Every committed variant of `pass`, or of all passes if it is empty, in each of its stages.
std::vector<Job> committedJobs(const Pack& pack, std::string_view pass);
std::vector<Job> jobsOf(const Variant& variant, std::optional<Stage> stage);
// needs.cpp: the modules that the plan of a scene uses.
Result<std::vector<Job>> jobsForNeeds(const Pack& pack, const fs::path& needsToml);
fs::path outputPath(const Job& job, Target target);
// Of `targets`, those that are asked of a module.
std::set<Target> targetsOf(const Job& job, std::set<Target> targets);

// `progress` is called from one thread at a time with the number done. All errors come back, one a line.
Result<std::vector<Product>> compileAll(const Pack& pack, const std::vector<Job>& jobs,
                                        const std::map<std::string, int>& platformSwitches, unsigned threads,
                                        const std::function<void(size_t, const Job&)>& progress);
Files filesOf(const Pack& pack, const std::vector<Product>& products, const std::set<Target>& targets);

// table.cpp: include/reprise/pack_table.hpp.
Result<std::string> tableHeader(const Pack& pack, const std::vector<Product>& products);

// Writes those that differ, each to a temporary file first that then takes its place; gives how many.
Result<size_t> writeFiles(const fs::path& out, const Files& files);
// Files of modules under `out` that are not among `files`.
std::vector<fs::path> superfluousFiles(const fs::path& out, const Files& files);
// One sentence for each file that differs, is missing or is superfluous.
std::vector<std::string> compareFiles(const fs::path& out, const Files& files);
// A makefile rule: `targets` depend on the table, on `inputs` and on every file that the products were made
// from.
Result<void> writeDepfile(const fs::path& depfile, const std::vector<fs::path>& targets,
                          const std::vector<fs::path>& inputs, const Pack& pack,
                          const std::vector<Product>& products);
// One sentence for each target asked for that a product does not have.
std::vector<std::string> missingTargets(const std::vector<Product>& products,
                                        const std::set<Target>& targets);

} // namespace reprisec
