// SPDX-License-Identifier: Apache-2.0
#include "builtin.hpp"

namespace scenes {

std::vector<Scene> builtInScenes() {
    return {build::thinGeometry(), build::fastObject(),   build::hdrEmitters(),
            build::foliage(),      build::staticCamera(), build::cameraCut()};
}

std::vector<Scene> lightingScenes() {
    return {build::hallStatic(), build::hallSlowPan(), build::hallFastPan(), build::hallMoving(),
            build::hallRemoved()};
}

std::vector<Scene> allScenes() {
    std::vector<Scene> all = builtInScenes();
    for (Scene& scene : lightingScenes())
        all.push_back(std::move(scene));
    return all;
}

} // namespace scenes
