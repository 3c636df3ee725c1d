// SPDX-License-Identifier: Apache-2.0
#include "assimp_convert.hpp"

#include "image_decode.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <assimp/GltfMaterial.h>

namespace scenes {
namespace {

// A texture of the file itself, or beside it. Missing pictures are noted, not refused: the shape can still be
// seen.
std::optional<Texture> loadTexture(const aiScene& source, const std::string& name,
                                   const std::filesystem::path& folder, std::string& why) {
    try {
        if (const aiTexture* embedded = source.GetEmbeddedTexture(name.c_str())) {
            if (embedded->pcData == nullptr) throw Refusal{"is empty"};
            if (embedded->mHeight == 0)
                return decodeImage({reinterpret_cast<const std::byte*>(embedded->pcData), embedded->mWidth});
            throw Refusal{"is embedded without compression, which is not supported"};
        }
        std::string path = name;
        std::ranges::replace(path, '\\', '/');
        const std::vector<std::byte> bytes = readFile(folder / path, size_t(256) << 20);
        return decodeImage(bytes);
    } catch (const Refusal& refusal) {
        why = refusal.reason;
        return std::nullopt;
    }
}

glm::vec3 colour(const aiMaterial& material, const char* key, unsigned type, unsigned index,
                 glm::vec3 otherwise) {
    aiColor3D value;
    if (material.Get(key, type, index, value) != aiReturn_SUCCESS) return otherwise;
    const glm::vec3 result(value.r, value.g, value.b);
    const bool sane = std::isfinite(result.x) && std::isfinite(result.y) && std::isfinite(result.z);
    return sane ? glm::clamp(result, 0.0f, 60000.0f) : otherwise;
}

float number(const aiMaterial& material, const char* key, unsigned type, unsigned index, float otherwise,
             float high) {
    float value = otherwise;
    if (material.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) return otherwise;
    return std::clamp(value, 0.0f, high);
}

float roughnessOf(const aiMaterial& material) {
    float shininess = 0.0f;
    if (material.Get(AI_MATKEY_SHININESS, shininess) == aiReturn_SUCCESS && shininess > 0.0f &&
        std::isfinite(shininess))
        // The exponent of Blinn's lobe that is as wide as GGX of this roughness.
        shininess = std::pow(2.0f / (shininess + 2.0f), 0.25f);
    else
        shininess = 0.8f;
    return number(material, AI_MATKEY_ROUGHNESS_FACTOR, shininess, 1.0f);
}

void readAlpha(const aiMaterial& material, const Scene& scene, Material& result) {
    aiString mode;
    const bool named = material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS;
    if (!named || std::string(mode.C_Str()) == "OPAQUE" || result.texture < 0) {
        result.baseColour.a = 1.0f;
        return;
    }
    // Blended surfaces are drawn as tested ones: the renderer has no sorting.
    const bool masked = std::string(mode.C_Str()) == "MASK";
    const float cutoff = masked ? number(material, AI_MATKEY_GLTF_ALPHACUTOFF, 0.5f, 1.0f) : 0.5f;
    const std::vector<uint8_t>& texels = scene.textures[size_t(result.texture)].texels;
    bool seeThrough = false;
    for (size_t i = 3; i < texels.size() && !seeThrough; i += 4)
        seeThrough = texels[i] < 255;
    if (seeThrough) result.alphaCutoff = std::max(cutoff, 1.0f / 255.0f);
}

Material convertMaterial(const aiMaterial& material, const Scene& scene, int texture) {
    Material result;
    result.texture = texture;
    const glm::vec3 diffuse = colour(material, AI_MATKEY_COLOR_DIFFUSE, glm::vec3(0.8f));
    result.baseColour = glm::vec4(colour(material, AI_MATKEY_BASE_COLOR, diffuse), 1.0f);
    // OBJ files often name a texture and leave the colour black; white shows it.
    if (texture >= 0 && glm::length(glm::vec3(result.baseColour)) < 1e-3f)
        result.baseColour = glm::vec4(1.0f);
    // Without its texture a factor would make the whole surface glow.
    if (material.GetTextureCount(aiTextureType_EMISSIVE) == 0)
        result.emission = colour(material, AI_MATKEY_COLOR_EMISSIVE, glm::vec3(0.0f)) *
                          number(material, AI_MATKEY_EMISSIVE_INTENSITY, 1.0f, 60000.0f);
    result.roughness = roughnessOf(material);
    int twoSided = 0;
    result.twoSided = material.Get(AI_MATKEY_TWOSIDED, twoSided) == aiReturn_SUCCESS && twoSided != 0;
    readAlpha(material, scene, result);
    return result;
}

} // namespace

void convertMaterials(const aiScene& source, const std::filesystem::path& folder, Scene& scene) {
    constexpr size_t maxTextures = 512;
    std::map<std::string, int> known;
    for (unsigned i = 0; i < source.mNumMaterials; ++i) {
        const aiMaterial& material = *source.mMaterials[i];
        aiString name;
        int texture = -1;
        if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == aiReturn_SUCCESS ||
            material.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS) {
            const auto [entry, isNew] = known.try_emplace(name.C_Str(), -1);
            std::string why;
            if (isNew && scene.textures.size() < maxTextures) {
                if (auto loaded = loadTexture(source, name.C_Str(), folder, why)) {
                    entry->second = int(scene.textures.size());
                    scene.textures.push_back(std::move(*loaded));
                } else {
                    scene.notes.push_back("The texture " + std::string(name.C_Str()) +
                                          " is left out: " + why + ".");
                }
            }
            texture = entry->second;
        }
        scene.materials.push_back(convertMaterial(material, scene, texture));
    }
    if (scene.materials.empty()) scene.materials.emplace_back();
}

} // namespace scenes
