// SPDX-License-Identifier: Apache-2.0
// From the importer's structures to ours, each value checked.
#pragma once

#include "model_check.hpp"
#include "scenes.hpp"

#include <assimp/scene.h>

namespace scenes {

glm::dmat4 convertMatrix(const aiMatrix4x4& matrix);
Mesh convertMesh(const aiMesh& mesh);
// Appends materials and their textures; what could not be had goes to scene.notes.
void convertMaterials(const aiScene& source, const std::filesystem::path& folder, Scene& scene);

} // namespace scenes
