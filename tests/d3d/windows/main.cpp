// SPDX-License-Identifier: Apache-2.0
// d3d_run DIRECTORY: compiles the shaders of DIRECTORY/jobs.txt with Microsoft's compiler, runs its draws and
// dispatches on Direct3D 9 and 11 devices, and writes what came out to DIRECTORY. It judges nothing: a job
// that fails is a line of DIRECTORY/results.txt like any other.
#include "devices.hpp"

#include <cstdio>
#include <fstream>

namespace {

using namespace d3d;

class Runner {
public:
    explicit Runner(const fs::path& directory)
        : directory_(directory), results_(directory / "results.txt", std::ios::binary) {}

    void compileAll(const std::vector<ShaderJob>& jobs) {
        for (const ShaderJob& job : jobs)
            attempt("shader " + job.name, [&] {
                codes_[job.name] = compile(job);
                return std::to_string(codes_[job.name]->GetBufferSize());
            });
    }

    void compileAll(const std::vector<HeaderJob>& jobs) {
        for (const HeaderJob& job : jobs)
            attempt("header " + job.name, [&] {
                const auto lines = compileFunctions(job);
                for (const std::string& line : lines)
                    results_ << "function " << job.name << " " << line << "\n";
                return std::to_string(lines.size());
            });
    }

    void openDevices() {
        attempt("device 9", [&] { return (devices_[9] = openDevice9())->name(); });
        attempt("device 11", [&] { return (devices_[11] = openDevice11())->name(); });
    }

    void runAll(const std::vector<RunJob>& jobs) {
        for (const RunJob& job : jobs)
            attempt("run " + job.name, [&] {
                Device* device = devices_[job.version].get();
                if (!device) throw Failure("there is no device");
                const auto targets = device->run(job, [&](const std::string& name) { return codeOf(name); });
                for (size_t i = 0; i < targets.size(); ++i)
                    writeTexels(directory_ / (job.name + "." + std::to_string(i)), targets[i]);
                return std::to_string(targets.size());
            });
    }

private:
    ID3DBlob* codeOf(const std::string& name) const {
        const auto found = codes_.find(name);
        if (found == codes_.end()) throw Failure("the shader " + name + " did not compile");
        return found->second.Get();
    }

    template <class Work> void attempt(const std::string& what, Work work) {
        try {
            const std::string text = work();
            results_ << what << " ok " << text << "\n";
        } catch (const std::exception& failure) {
            results_ << what << " failed " << failure.what() << "\n";
        }
        results_.flush();
    }

    fs::path directory_;
    std::ofstream results_;
    std::map<std::string, ComPtr<ID3DBlob>> codes_;
    std::map<int, std::unique_ptr<Device>> devices_;
};

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: d3d_run DIRECTORY\n");
        return 1;
    }
    try {
        const fs::path directory = arguments[1];
        const Jobs jobs = readJobs(directory / "jobs.txt");
        Runner runner(directory);
        runner.compileAll(jobs.shaders);
        runner.compileAll(jobs.headers);
        runner.openDevices();
        runner.runAll(jobs.runs);
        return 0;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "d3d_run: %s\n", failure.what());
        return 1;
    }
}
