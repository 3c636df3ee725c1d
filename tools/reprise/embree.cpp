// SPDX-License-Identifier: Apache-2.0
#include "embree.hpp"

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

namespace report {
namespace fs = std::filesystem;
namespace {

constexpr const char* libraryName = "libembree3.so.3";

// A file in memory that stays open as long as the program: the loader maps the library from it.
void* openPacked(const fs::path& packed) {
    gzFile source = gzopen(packed.c_str(), "rb");
    if (!source) return nullptr;
    const int file = memfd_create(libraryName, MFD_CLOEXEC);
    std::array<char, 1 << 16> block;
    int read = file < 0 ? -1 : 0;
    while (read >= 0 && (read = gzread(source, block.data(), block.size())) > 0)
        if (write(file, block.data(), static_cast<size_t>(read)) != read) read = -1;
    gzclose(source);
    if (read < 0)
        throw std::runtime_error(
            fmt::format("{} could not be unpacked into memory; copy the folder anew", packed.string()));
    return dlopen(fmt::format("/proc/self/fd/{}", file).c_str(), RTLD_NOW | RTLD_LOCAL);
}

void* openLibrary() {
    if (void* library = dlopen(libraryName, RTLD_NOW | RTLD_LOCAL)) return library;
    const std::string reason = dlerror();
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path packed = program.parent_path().parent_path() / "lib" / fmt::format("{}.gz", libraryName);
    if (fs::exists(packed, error)) {
        if (void* library = openPacked(packed)) return library;
        throw std::runtime_error(fmt::format("{}: {}; copy the folder anew", packed.string(), dlerror()));
    }
    throw std::runtime_error(fmt::format(
        "Ground truth by ray casting needs Embree 3 ({}); install Debian's libembree3-3", reason));
}

template <class Function> void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function)
        throw std::runtime_error(fmt::format("{} lacks {}; install Embree 3.13", libraryName, name));
}

Embree load() {
    void* library = openLibrary();
    Embree e{};
    find(library, "rtcNewDevice", e.newDevice);
    find(library, "rtcReleaseDevice", e.releaseDevice);
    find(library, "rtcGetDeviceError", e.getDeviceError);
    find(library, "rtcNewScene", e.newScene);
    find(library, "rtcReleaseScene", e.releaseScene);
    find(library, "rtcSetSceneFlags", e.setSceneFlags);
    find(library, "rtcSetSceneBuildQuality", e.setSceneBuildQuality);
    find(library, "rtcCommitScene", e.commitScene);
    find(library, "rtcNewGeometry", e.newGeometry);
    find(library, "rtcReleaseGeometry", e.releaseGeometry);
    find(library, "rtcSetNewGeometryBuffer", e.setNewGeometryBuffer);
    find(library, "rtcSetGeometryUserData", e.setGeometryUserData);
    find(library, "rtcSetGeometryIntersectFilterFunction", e.setGeometryIntersectFilterFunction);
    find(library, "rtcSetGeometryOccludedFilterFunction", e.setGeometryOccludedFilterFunction);
    find(library, "rtcCommitGeometry", e.commitGeometry);
    find(library, "rtcAttachGeometryByID", e.attachGeometryByID);
    find(library, "rtcIntersect1", e.intersect1);
    find(library, "rtcOccluded1", e.occluded1);
    return e;
}

} // namespace

const Embree& embree() {
    static const Embree functions = load();
    return functions;
}

} // namespace report
