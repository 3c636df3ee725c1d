// SPDX-License-Identifier: Apache-2.0
// A moving triangle, rigid or skinned, drawn by the recorder over the camera's motion.
#pragma once

#include "camera_case.hpp"
#include "reprise/frame.hpp"

#include <glm/gtc/type_precision.hpp>

#include <optional>

namespace passes {

struct ObjectCase {
    bool skinned = false;
    Stage stage = Stage::fragment; // of the full-screen passes around it
    CameraKind kind{};
    glm::dvec2 jitterPx{0.28125, -0.34375};
    int width = 64, height = 48;
    int occludedColumns = 0; // of the left, where the scene's depth is nearer than the object
    // Every element of where it was, in place of the matrix or palette: NaN, infinity.
    std::optional<float> brokenPrevPlacement{};
};

// What a draw of the object takes, for devices that no recorder serves.
struct ObjectDrawData {
    std::array<glm::vec3, 3> positions;
    std::array<glm::u8vec4, 3> joints;
    std::array<glm::vec4, 3> weights;
    std::vector<glm::mat4> palette, prevPalette; // of a skinned object
    reprise::ObjectVelocityParameters parameters{};
};
ObjectDrawData drawDataOf(const ObjectCase& object);
// What the motion image holds where the object is not seen.
Pixels backgroundMotion(const ObjectCase& object, VkFormat format);

// The recorder's motion image of the second of two frames. `from` is the pack that gives its modules, those
// of the object under platform switches.
Pixels recordedMotion(const ObjectCase& object, const reprisec::Pack& from = pack(),
                      const PlatformSwitches& platform = {});
// The whole image against the oracle: the object's motion where it is seen, the camera's elsewhere.
Comparison compareWithOracle(const ObjectCase& object, const Pixels& motion);

} // namespace passes
