// SPDX-License-Identifier: Apache-2.0
#include "gltf_document.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace scenes {
namespace {

using gltf::Accessor;
using gltf::Document;
using gltf::Json;

void checkIndices(const Document& document, const Accessor& indices, size_t vertices,
                  const std::string& where) {
    if (indices.components != 1 || indices.componentType == gltf::floatType)
        throw Refusal{where + " has indices that are not whole numbers; export it again"};
    for (size_t i = 0; i < indices.count; ++i) {
        const uint64_t index = document.unsignedAt(indices, i, 0);
        if (index >= vertices)
            throw Refusal{where + " uses vertex " + std::to_string(index) + " of " +
                          std::to_string(vertices) + "; export it again"};
    }
}

void checkFinite(const Document& document, const Accessor& accessor, const std::string& where) {
    if (accessor.componentType != gltf::floatType) return;
    for (size_t i = 0; i < accessor.count; ++i)
        for (size_t c = 0; c < accessor.components; ++c)
            if (!std::isfinite(document.floatAt(accessor, i, c)))
                throw Refusal{where + " holds a value that is infinite or not a number; export it again"};
}

void checkPrimitive(const Document& document, const Json& primitive, const std::string& where,
                    size_t& elements) {
    const Json& attributes = gltf::object(primitive, "attributes", where);
    if (!attributes.contains("POSITION"))
        throw Refusal{where + " has no positions; export the mesh with its vertices"};
    const Accessor positions = document.accessor(attributes["POSITION"], where + " positions");
    if (positions.components != 3 || positions.componentType != gltf::floatType)
        throw Refusal{where + " has positions that are not three floats; export without quantization"};
    for (const auto& [name, index] : attributes.items()) {
        const Accessor accessor = document.accessor(index, where + " attribute " + name);
        if (accessor.count != positions.count)
            throw Refusal{where + " has " + std::to_string(accessor.count) + " values of " + name + " for " +
                          std::to_string(positions.count) + " vertices; export it again"};
        checkFinite(document, accessor, where + " attribute " + name);
    }
    size_t corners = positions.count;
    if (primitive.contains("indices")) {
        const Accessor indices = document.accessor(primitive["indices"], where + " indices");
        checkIndices(document, indices, positions.count, where);
        corners = indices.count;
    }
    const size_t mode = gltf::optionalIndex(primitive, "mode", where, 4);
    if (mode > 6) throw Refusal{where + " has primitives of an unknown kind; export triangles"};
    // Strips and fans: the importer takes two from the number of corners, whatever it is.
    if (mode >= 5 && corners < 3)
        throw Refusal{where + " has a strip of fewer corners than a triangle; export it again"};
    for (const Json& target : gltf::array(primitive, "targets"))
        for (const auto& [name, index] : target.items())
            if (document.accessor(index, where + " morph target " + name).count != positions.count)
                throw Refusal{where + " has a morph target of another size than the mesh; export it again"};
    document.checkIndex(primitive, "material", "materials", where);
    elements += corners + positions.count;
    if (elements > maxElements)
        throw Refusal{"it has more than 20 million vertices and indices; simplify it"};
}

void checkMeshes(const Document& document) {
    size_t elements = 0, number = 0;
    for (const Json& mesh : gltf::array(document.root, "meshes")) {
        const std::string where = "mesh " + std::to_string(number++);
        const Json& primitives = gltf::array(mesh, "primitives");
        if (primitives.empty()) throw Refusal{where + " has no primitives; export it again"};
        for (const Json& primitive : primitives)
            checkPrimitive(document, primitive, where, elements);
    }
}

void checkNumbers(const Json& object, const char* key, size_t count, const std::string& where) {
    if (!object.contains(key)) return;
    const Json& values = object[key];
    bool good = values.is_array() && values.size() == count;
    for (size_t i = 0; good && i < count; ++i)
        good = values[i].is_number() && std::isfinite(values[i].get<double>());
    if (!good)
        throw Refusal{where + " has a " + key + " that is not " + std::to_string(count) +
                      " numbers; export it again"};
}

// Every node has at most one parent, and no walk down from a root comes back or goes too deep.
void checkNodeGraph(const Json& nodes) {
    std::vector<size_t> parents(nodes.size(), 0);
    for (const Json& node : nodes)
        for (const Json& child : gltf::array(node, "children"))
            ++parents[child.get<size_t>()];
    if (std::ranges::any_of(parents, [](size_t count) { return count > 1; }))
        throw Refusal{"a node has two parents; export it again"};
    std::vector<std::pair<size_t, int>> open;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (parents[i] == 0) open.emplace_back(i, 1);
    size_t reached = 0;
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        ++reached;
        if (depth > maxNodeDepth) throw Refusal{"its nodes are nested more than 256 deep; flatten them"};
        for (const Json& child : gltf::array(nodes[node], "children"))
            open.emplace_back(child.get<size_t>(), depth + 1);
    }
    if (reached != nodes.size()) throw Refusal{"a node is its own ancestor; export it again"};
}

void checkNodes(const Document& document) {
    const Json& nodes = gltf::array(document.root, "nodes");
    if (nodes.size() > maxNodes) throw Refusal{"it has more than 100000 nodes; merge some"};
    size_t number = 0;
    for (const Json& node : nodes) {
        const std::string where = "node " + std::to_string(number++);
        if (!node.is_object()) throw Refusal{where + " is not an object; export it again"};
        for (const Json& child : gltf::array(node, "children"))
            if (!child.is_number_unsigned() || child.get<size_t>() >= nodes.size())
                throw Refusal{where + " has a child that does not exist; export it again"};
        checkNumbers(node, "matrix", 16, where);
        checkNumbers(node, "translation", 3, where);
        checkNumbers(node, "rotation", 4, where);
        checkNumbers(node, "scale", 3, where);
        document.checkIndex(node, "mesh", "meshes", where);
        document.checkIndex(node, "camera", "cameras", where);
        document.checkIndex(node, "skin", "skins", where);
    }
    checkNodeGraph(nodes);
}

void checkScenes(const Document& document) {
    const Json& scenes = gltf::array(document.root, "scenes");
    if (scenes.empty()) throw Refusal{"it has no scene; export one that contains the model"};
    document.checkIndex(document.root, "scene", "scenes", "the file");
    for (const Json& scene : scenes) {
        std::set<size_t> seen;
        for (const Json& node : gltf::array(scene, "nodes")) {
            const bool known = node.is_number_unsigned() &&
                               node.get<size_t>() < gltf::array(document.root, "nodes").size() &&
                               seen.insert(node.get<size_t>()).second;
            if (!known)
                throw Refusal{
                    "its scene names a node that does not exist or names one twice; export it again"};
        }
    }
    const Json& shown = scenes[gltf::optionalIndex(document.root, "scene", "the file", 0)];
    if (gltf::array(shown, "nodes").empty())
        throw Refusal{"its scene is empty; export one that contains the model"};
}

void checkSkins(const Document& document) {
    size_t number = 0;
    for (const Json& skin : gltf::array(document.root, "skins")) {
        const std::string where = "skin " + std::to_string(number++);
        const Json& joints = gltf::array(skin, "joints");
        if (joints.empty()) throw Refusal{where + " has no joints; export it again"};
        for (const Json& joint : joints)
            if (!joint.is_number_unsigned() ||
                joint.get<size_t>() >= gltf::array(document.root, "nodes").size())
                throw Refusal{where + " has a joint that does not exist; export it again"};
        document.checkIndex(skin, "skeleton", "nodes", where);
        if (!skin.contains("inverseBindMatrices"))
            throw Refusal{where + " has no inverse bind matrices; export them with the skin"};
        const Accessor matrices = document.accessor(skin["inverseBindMatrices"], where);
        if (matrices.components != 16 || matrices.componentType != gltf::floatType ||
            matrices.count < joints.size())
            throw Refusal{where + " has too few inverse bind matrices; export it again"};
        checkFinite(document, matrices, where);
    }
}

// JOINTS_n must stay within the skin of the node that shows the mesh.
void checkJoints(const Document& document) {
    for (const Json& node : gltf::array(document.root, "nodes")) {
        if (!node.contains("skin") || !node.contains("mesh")) continue;
        const size_t joints =
            gltf::array(document.root["skins"][node["skin"].get<size_t>()], "joints").size();
        for (const Json& primitive :
             gltf::array(document.root["meshes"][node["mesh"].get<size_t>()], "primitives")) {
            for (const auto& [name, index] : primitive["attributes"].items()) {
                if (name.rfind("JOINTS_", 0) != 0) continue;
                const Accessor accessor = document.accessor(index, name);
                if (accessor.components != 4 || accessor.componentType == gltf::floatType)
                    throw Refusal{name + " is not four whole numbers; export it again"};
                for (size_t i = 0; i < accessor.count; ++i)
                    for (size_t c = 0; c < 4; ++c)
                        if (document.unsignedAt(accessor, i, c) >= joints)
                            throw Refusal{"a vertex hangs on a joint that does not exist; export it again"};
            }
        }
    }
}

void checkAnimation(const Document& document, const Json& animation, const std::string& where) {
    const Json& samplers = gltf::array(animation, "samplers");
    for (const Json& sampler : samplers) {
        if (!sampler.is_object() || !sampler.contains("input") || !sampler.contains("output"))
            throw Refusal{where + " has a sampler without times or values; export it again"};
        const Accessor times = document.accessor(sampler["input"], where),
                       values = document.accessor(sampler["output"], where);
        if (times.components != 1 || times.componentType != gltf::floatType || values.count < times.count)
            throw Refusal{where + " has fewer values than times; export it again"};
        const Json interpolation = sampler.value("interpolation", Json("LINEAR"));
        if (!interpolation.is_string())
            throw Refusal{where + " has an interpolation without name; export it again"};
        if (interpolation == "CUBICSPLINE" && values.count < times.count * 3)
            throw Refusal{where + " has a spline without its tangents; export it again"};
        checkFinite(document, times, where);
        checkFinite(document, values, where);
    }
    for (const Json& channel : gltf::array(animation, "channels")) {
        if (!channel.is_object() || !channel.contains("sampler") ||
            gltf::index(channel["sampler"], where) >= samplers.size())
            throw Refusal{where + " has a channel without a sampler; export it again"};
        const Json& target = gltf::object(channel, "target", where);
        document.checkIndex(target, "node", "nodes", where);
        const Json path = target.value("path", Json());
        if (path != "rotation" && path != "translation" && path != "scale" && path != "weights")
            throw Refusal{where + " has a channel that moves nothing known; export it again"};
        const size_t components =
            document.accessor(samplers[channel["sampler"].get<size_t>()]["output"], where).components;
        const bool fits = path == "rotation"  ? components == 4
                          : path == "weights" ? components == 1
                                              : components == 3;
        if (!fits)
            throw Refusal{where + " has values of another kind than its channel moves; export it again"};
    }
}

void checkImages(const Document& document) {
    size_t number = 0;
    for (const Json& image : gltf::array(document.root, "images")) {
        const std::string where = "image " + std::to_string(number++);
        if (!image.is_object() || (!image.contains("uri") && !image.contains("bufferView")))
            throw Refusal{where + " has no data; export it again"};
        document.checkIndex(image, "bufferView", "bufferViews", where);
        if (image.contains("uri")) document.checkLink(image["uri"], where);
        // The importer takes what follows the slash for the kind of the picture and does not look whether one
        // is there.
        const Json kind = image.value("mimeType", Json("image/png"));
        if (!kind.is_string() || kind.get<std::string>().rfind("image/", 0) != 0)
            throw Refusal{where + " is of no kind of picture; export it as PNG or JPEG"};
    }
    for (const Json& texture : gltf::array(document.root, "textures")) {
        document.checkIndex(texture, "source", "images", "a texture");
        document.checkIndex(texture, "sampler", "samplers", "a texture");
    }
}

// Wherever a material has an object named ...Texture, its index must exist; extensions nest them at any
// depth.
void checkTextureLinks(const Document& document, const Json& material, int depth) {
    if (depth > 8) throw Refusal{"a material nests too deep; export it again"};
    for (const auto& [name, value] : material.items()) {
        if (!value.is_object()) continue;
        if (name.size() >= 7 && name.compare(name.size() - 7, 7, "Texture") == 0) {
            if (!value.contains("index"))
                throw Refusal{"a material has a texture without an index; export it again"};
            document.checkIndex(value, "index", "textures", "a material");
            gltf::optionalIndex(value, "texCoord", "a material", 0);
        }
        checkTextureLinks(document, value, depth + 1);
    }
}

void checkExtensions(const Document& document) {
    static const std::set<std::string> known{
        "KHR_texture_transform", "KHR_materials_unlit",        "KHR_materials_clearcoat",
        "KHR_materials_sheen",   "KHR_materials_transmission", "KHR_materials_emissive_strength",
        "KHR_materials_ior",     "KHR_materials_specular",     "KHR_materials_pbrSpecularGlossiness",
        "KHR_lights_punctual",   "KHR_technique_webgl"};
    for (const Json& extension : gltf::array(document.root, "extensionsRequired")) {
        if (!extension.is_string()) throw Refusal{"it requires an extension without a name; export it again"};
        if (!known.contains(extension.get<std::string>()))
            throw Refusal{"it requires " + extension.get<std::string>() +
                          ", which is not supported; export without it"};
    }
}

} // namespace

void checkGltf(const std::filesystem::path& file) {
    const Document document = gltf::open(file);
    checkExtensions(document);
    document.checkTables();
    checkScenes(document);
    checkNodes(document);
    checkMeshes(document);
    checkSkins(document);
    checkJoints(document);
    size_t number = 0;
    for (const Json& animation : gltf::array(document.root, "animations"))
        checkAnimation(document, animation, "animation " + std::to_string(number++));
    checkImages(document);
    for (const Json& material : gltf::array(document.root, "materials")) {
        if (!material.is_object()) throw Refusal{"a material is not an object; export it again"};
        checkTextureLinks(document, material, 0);
    }
}

} // namespace scenes
