// SPDX-License-Identifier: Apache-2.0
#include "builtin.hpp"

namespace scenes {

std::vector<Scene> builtInScenes() {
    return {build::thinGeometry(), build::fastObject(),   build::hdrEmitters(),
            build::foliage(),      build::staticCamera(), build::cameraCut()};
}

} // namespace scenes
