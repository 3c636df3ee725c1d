// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

namespace reprisec {

namespace {

std::string bytesOf(const Words& words) {
    return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(uint32_t)};
}

std::string_view extension(Target target) {
    switch (target) {
    case Target::spirv:
        return ".spv";
    case Target::glsl450:
        return ".450.glsl";
    case Target::glslEs:
        return ".es.glsl";
    case Target::json:
        break;
    }
    return ".json";
}

Result<void> writeWhole(const fs::path& file, const std::string& bytes) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    const fs::path temporary = file.string() + ".part";
    {
        std::ofstream stream(temporary, std::ios::binary);
        stream << bytes;
        stream.close();
        if (!stream) {
            fs::remove(temporary, error);
            return Error{ErrorCode::fileError,
                         "cannot write " + file.string() + "; is the directory writable?"};
        }
    }
    fs::rename(temporary, file, error);
    if (error) return Error{ErrorCode::fileError, "cannot write " + file.string() + ": " + error.message()};
    return {};
}

// Of the form PASS/PASS.STAGE.EXTENSION or PASS/PASS--SWITCHES.STAGE.EXTENSION: only such files are ever
// removed.
bool isModuleFile(const fs::path& file) {
    const std::string name = file.filename().string(), pass = file.parent_path().filename().string();
    if (!name.starts_with(pass + ".") && !name.starts_with(pass + "--")) return false;
    for (Stage stage : {Stage::vertex, Stage::fragment, Stage::compute})
        for (Target target : {Target::spirv, Target::glsl450, Target::glslEs, Target::json})
            if (name.ends_with("." + std::string(reprise::stageName(stage)) + std::string(extension(target))))
                return true;
    return false;
}

// Spaces and dollars mean something in a makefile.
std::string makePath(const fs::path& path) {
    std::string escaped;
    for (char c : path.generic_string()) {
        if (c == ' ' || c == '#') escaped += '\\';
        if (c == '$') escaped += '$';
        escaped += c;
    }
    return escaped;
}

} // namespace

fs::path outputPath(const Job& job, Target target) {
    const std::string name =
        reprise::variantName(job.variant) + "." + std::string(reprise::stageName(job.stage));
    return fs::path(std::string(job.variant.pass->name)) / (name + std::string(extension(target)));
}

std::vector<Job> jobsOf(const Variant& variant, std::optional<Stage> stage) {
    std::vector<Job> jobs;
    for (Stage each : variant.pass->stages)
        if (!stage || *stage == each) jobs.push_back({reprise::forStage(variant, each), each});
    return jobs;
}

std::vector<Job> committedJobs(const Pack& pack, std::string_view pass) {
    std::vector<Job> jobs;
    std::set<fs::path> seen; // switches without effect in a stage make two variants the same there
    for (const PassInfo& each : pack.passes()) {
        if (!pass.empty() && pass != each.name) continue;
        for (const Variant& variant : pack.committedVariants(each))
            for (Job& job : jobsOf(variant, std::nullopt))
                if (seen.insert(outputPath(job, Target::spirv)).second) jobs.push_back(std::move(job));
    }
    return jobs;
}

Result<std::vector<Product>> compileAll(const Pack& pack, const std::vector<Job>& jobs,
                                        const std::map<std::string, int>& platformSwitches, unsigned threads,
                                        const std::function<void(size_t, const Job&)>& progress) {
    std::vector<std::optional<Result<Compiled>>> results(jobs.size());
    std::atomic<size_t> next = 0;
    std::mutex mutex;
    size_t done = 0;
    const auto work = [&] {
        for (size_t i = next++; i < jobs.size(); i = next++) {
            results[i] = compile(pack, jobs[i].variant, jobs[i].stage,
                                 {.glsl = true, .platformSwitches = platformSwitches});
            const std::lock_guard lock(mutex);
            progress(++done, jobs[i]);
        }
    };
    {
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i < std::max(threads, 1u); ++i)
            workers.emplace_back(work);
    }
    std::vector<Product> products;
    std::string errors;
    for (size_t i = 0; i < jobs.size(); ++i) {
        if (*results[i])
            products.push_back({jobs[i], std::move(**results[i])});
        else
            errors += (errors.empty() ? "" : "\n") + results[i]->error().message;
    }
    if (!errors.empty()) return badShader(errors);
    return products;
}

std::set<Target> targetsOf(const Job& job, std::set<Target> targets) {
    if (job.vulkanAlone)
        std::erase_if(targets, [](Target each) { return each == Target::glsl450 || each == Target::glslEs; });
    return targets;
}

Files filesOf(const Pack& pack, const std::vector<Product>& products, const std::set<Target>& targets) {
    Files files;
    const fs::path root = pack.file().parent_path();
    for (const auto& [job, compiled] : products) {
        if (targets.contains(Target::spirv)) files[outputPath(job, Target::spirv)] = bytesOf(compiled.spirv);
        if (targets.contains(Target::glsl450) && compiled.glsl450)
            files[outputPath(job, Target::glsl450)] = *compiled.glsl450;
        if (targets.contains(Target::glslEs) && compiled.glslEs)
            files[outputPath(job, Target::glslEs)] = *compiled.glslEs;
        if (targets.contains(Target::json))
            files[outputPath(job, Target::json)] = reflectionJson(job.variant, job.stage, compiled, root);
    }
    return files;
}

Result<size_t> writeFiles(const fs::path& out, const Files& files) {
    size_t written = 0;
    for (const auto& [path, bytes] : files) {
        const auto present = readText(out / path);
        if (present && *present == bytes) continue;
        if (auto done = writeWhole(out / path, bytes); !done) return done.error();
        ++written;
    }
    return written;
}

std::vector<fs::path> superfluousFiles(const fs::path& out, const Files& files) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::recursive_directory_iterator each(out, error), end; !error && each != end;
         each.increment(error)) {
        const fs::path relative = each->path().lexically_relative(out);
        if (each->is_regular_file() && isModuleFile(each->path()) && !files.contains(relative))
            found.push_back(relative);
    }
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> compareFiles(const fs::path& out, const Files& files) {
    std::vector<std::string> differences;
    for (const auto& [path, bytes] : files) {
        const auto present = readText(out / path);
        if (!present)
            differences.push_back("missing: " + (out / path).string());
        else if (*present != bytes)
            differences.push_back("differs: " + (out / path).string());
    }
    for (const fs::path& path : superfluousFiles(out, files))
        differences.push_back("superfluous: " + (out / path).string());
    return differences;
}

Result<void> writeDepfile(const fs::path& depfile, const std::vector<fs::path>& targets,
                          const std::vector<fs::path>& inputs, const Pack& pack,
                          const std::vector<Product>& products) {
    std::set<std::string> dependencies{makePath(pack.file())};
    for (const fs::path& file : inputs)
        dependencies.insert(makePath(file));
    for (const Product& product : products)
        for (const fs::path& file : product.compiled.dependencies)
            dependencies.insert(makePath(file));
    std::string text;
    for (const fs::path& target : targets)
        text += (text.empty() ? "" : " ") + makePath(target);
    text += ":";
    for (const std::string& file : dependencies)
        text += " \\\n  " + file;
    return writeWhole(depfile, text + "\n");
}

std::vector<std::string> missingTargets(const std::vector<Product>& products,
                                        const std::set<Target>& targets) {
    std::vector<std::string> missing;
    for (const auto& [job, compiled] : products) {
        const auto asked = targetsOf(job, targets);
        const auto note = [&](Target target, const std::string& reason) {
            if (asked.contains(target) && !reason.empty())
                missing.push_back("there is no " + outputPath(job, target).string() + ": " + reason);
        };
        note(Target::glsl450, compiled.glsl450 ? "" : compiled.glsl450Reason);
        note(Target::glslEs, compiled.glslEs ? "" : compiled.glslEsReason);
    }
    return missing;
}

} // namespace reprisec
