// SPDX-License-Identifier: Apache-2.0
#include "animation.hpp"
#include "assimp_convert.hpp"
#include "camera_path.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>

namespace scenes {
namespace {

using TreePointer = std::shared_ptr<const NodeTree>;

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

const aiScene& import(Assimp::Importer& importer, const std::filesystem::path& file) {
    // Points and lines are split off and dropped; only triangles remain.
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyInteger(AI_CONFIG_PP_LBW_MAX_WEIGHTS, 4);
    const unsigned steps = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                           aiProcess_JoinIdenticalVertices | aiProcess_LimitBoneWeights | aiProcess_FlipUVs;
    const aiScene* scene = importer.ReadFile(file.string(), steps);
    const std::string message = importer.GetErrorString();
    if (message == "No meshes remaining") throw Refusal{"it has only points and lines; export triangles"};
    if (scene == nullptr) throw Refusal{"the importer refuses it (" + message + "); export it again"};
    if (scene->mRootNode == nullptr) throw Refusal{"it has no scene; export one that contains the model"};
    return *scene;
}

// The importer's message can be long or of several lines: one sentence is wanted.
std::string oneLine(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20; }, ' ');
    if (text.size() > 300) text.resize(300);
    return text;
}

Instance skinnedInstance(const aiMesh& mesh, const TreePointer& tree) {
    std::vector<std::pair<size_t, glm::dmat4>> joints;
    bool moves = false;
    for (unsigned i = 0; i < mesh.mNumBones; ++i) {
        const int node = tree->find(mesh.mBones[i]->mName.C_Str());
        if (node < 0) throw Refusal{"a mesh hangs on a joint that does not exist; export it again"};
        joints.emplace_back(size_t(node), convertMatrix(mesh.mBones[i]->mOffsetMatrix));
        moves = moves || tree->nodes[size_t(node)].animated;
    }
    Instance instance;
    instance.moves = moves;
    instance.objectToWorld = [](double) { return glm::dmat4(1.0); };
    instance.palette = [tree, joints](double seconds) {
        std::vector<glm::mat4> palette;
        for (const auto& [node, offset] : joints)
            palette.emplace_back(tree->toWorld(node, seconds) * offset);
        return palette;
    };
    return instance;
}

Instance rigidInstance(size_t node, const TreePointer& tree) {
    Instance instance;
    instance.moves = tree->nodes[node].animated;
    if (instance.moves)
        instance.objectToWorld = [tree, node](double seconds) { return tree->toWorld(node, seconds); };
    else
        instance.objectToWorld = [world = tree->toWorld(node, 0.0)](double) { return world; };
    return instance;
}

// Nodes are numbered in the order of the walk that made the tree.
void addInstances(const aiScene& source, const aiNode& node, size_t& number, const TreePointer& tree,
                  Scene& scene) {
    const size_t self = number++;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= source.mNumMeshes)
            throw Refusal{"a node shows a mesh that does not exist; export it again"};
        const aiMesh& mesh = *source.mMeshes[node.mMeshes[i]];
        if (scene.meshes[node.mMeshes[i]].indices.empty()) continue;
        Instance instance = mesh.HasBones() ? skinnedInstance(mesh, tree) : rigidInstance(self, tree);
        instance.mesh = node.mMeshes[i];
        instance.material = std::min(mesh.mMaterialIndex, unsigned(scene.materials.size()) - 1);
        instance.id = uint32_t(scene.instances.size());
        scene.instances.push_back(std::move(instance));
        if (scene.instances.size() > maxNodes) throw Refusal{"it shows more than 100000 meshes; merge some"};
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        addInstances(source, *node.mChildren[i], number, tree, scene);
}

glm::dvec3 skinnedPosition(const Mesh& mesh, size_t vertex, const std::vector<glm::mat4>& palette) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 4; ++i)
        sum += glm::dvec3(palette[mesh.joints[vertex][i]] * glm::vec4(mesh.vertices[vertex].position, 1.0f)) *
               double(mesh.weights[vertex][i]);
    return sum;
}

// Calls visit with every corner of every triangle in the world, at a few moments of the animation.
void forEachPoint(const Scene& scene, double duration, const std::function<void(const glm::dvec3&)>& visit) {
    const int moments = duration > 0.0 ? 8 : 1;
    for (int moment = 0; moment < moments; ++moment) {
        const double seconds = duration * moment / moments;
        for (const Instance& instance : scene.instances) {
            const Mesh& mesh = scene.meshes[instance.mesh];
            const glm::dmat4 world = instance.objectToWorld(seconds);
            const auto palette = instance.palette ? instance.palette(seconds) : std::vector<glm::mat4>{};
            for (uint32_t index : mesh.indices)
                visit(palette.empty() ? glm::dvec3(world * glm::dvec4(mesh.vertices[index].position, 1.0))
                                      : skinnedPosition(mesh, index, palette));
        }
    }
}

Sphere boundsOf(const Scene& scene, double duration) {
    glm::dvec3 low(1e300), high(-1e300);
    forEachPoint(scene, duration, [&](const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    });
    Sphere sphere{(low + high) * 0.5, 0.0};
    bool finite = true;
    forEachPoint(scene, duration, [&](const glm::dvec3& point) {
        const double distance = glm::length(point - sphere.centre);
        finite = finite && std::isfinite(distance);
        sphere.radius = std::max(sphere.radius, distance);
    });
    if (!finite || sphere.radius > 1e9 || glm::length(sphere.centre) > 1e9)
        throw Refusal{"it is larger than 1e9 m or lies further away; scale it down"};
    if (sphere.radius < 1e-6) throw Refusal{"all its vertices are at one point; export it again"};
    return sphere;
}

void fitPlanes(Scene& scene, const Sphere& bounds, double nearest, double farthest) {
    scene.farPlane = farthest * 1.1 + bounds.radius * 0.1;
    scene.nearPlane = std::max(nearest * 0.5, scene.farPlane * 1e-4);
}

// A quarter of a turn in six seconds, a little nearer and back; the sphere stays in view at the nearest.
void orbit(Scene& scene, const Sphere& bounds) {
    const double distance = bounds.radius / std::sin(scene.verticalFov * 0.5) * 1.09;
    scene.worldToView = [bounds, distance](double seconds) {
        const double angle = 0.6 + 0.26 * seconds, away = distance * (1.0 - 0.08 * std::sin(0.5 * seconds));
        const glm::dvec3 direction(std::cos(0.35) * std::sin(angle), std::sin(0.35),
                                   std::cos(0.35) * std::cos(angle));
        return lookAt(bounds.centre + direction * away, bounds.centre);
    };
    fitPlanes(scene, bounds, distance * 0.9 - bounds.radius, distance * 1.1 + bounds.radius);
}

// The file's own camera, if it is a perspective one, sound, and sees some of the model.
bool useCamera(const aiCamera& camera, const TreePointer& tree, const Sphere& bounds, Scene& scene) {
    const int node = tree->find(camera.mName.C_Str());
    const double aspect = camera.mAspect > 0.0f ? camera.mAspect : 1.0;
    const double fov = 2.0 * std::atan(std::tan(camera.mHorizontalFOV * 0.5) / aspect);
    if (camera.mOrthographicWidth > 0.0f || !std::isfinite(fov) || fov < 0.05 || fov > 2.6) return false;
    const glm::dvec3 forward(camera.mLookAt.x, camera.mLookAt.y, camera.mLookAt.z),
        up(camera.mUp.x, camera.mUp.y, camera.mUp.z);
    if (!(glm::length(glm::cross(forward, up)) > 1e-6)) return false;
    const auto view = [=](double seconds) {
        const glm::dmat4 world = node >= 0 ? tree->toWorld(size_t(node), seconds) : glm::dmat4(1.0);
        // mPosition repeats the node's translation for some files: a glTF camera is at the origin of its
        // node.
        const glm::dvec3 eye(world[3]);
        return lookAt(eye, eye + glm::normalize(glm::dvec3(world * glm::dvec4(forward, 0.0))),
                      glm::dvec3(world * glm::dvec4(up, 0.0)));
    };
    const glm::dmat4 start = view(0.0);
    for (int column = 0; column < 4; ++column)
        if (!std::isfinite(glm::dot(start[column], start[column]))) return false;
    const glm::dvec3 centre(start * glm::dvec4(bounds.centre, 1.0));
    const double sideways = glm::length(glm::dvec2(centre)) - bounds.radius;
    if (centre.z + bounds.radius <= 0.0 || sideways > std::max(centre.z, 0.0) * std::tan(fov * 0.5) * 2.0)
        return false;
    scene.worldToView = view;
    scene.verticalFov = fov;
    scene.cameraMoves = node >= 0 && tree->nodes[size_t(node)].animated;
    fitPlanes(scene, bounds, std::max(centre.z - bounds.radius, 0.0), centre.z + bounds.radius);
    return true;
}

void placeCamera(const aiScene& source, const TreePointer& tree, Scene& scene) {
    const Sphere bounds = boundsOf(scene, tree->duration);
    for (unsigned i = 0; i < source.mNumCameras; ++i)
        if (useCamera(*source.mCameras[i], tree, bounds, scene)) return;
    if (source.mNumCameras > 0)
        scene.notes.emplace_back(
            "The file has no perspective camera that sees the model; it is orbited instead.");
    orbit(scene, bounds);
}

Scene load(const std::filesystem::path& file) {
    const std::string extension = lowerExtension(file);
    if (extension == ".obj")
        checkObj(file);
    else if (extension == ".gltf" || extension == ".glb")
        checkGltf(file);
    else
        throw Refusal{"it is none of the formats that can be read; use glTF, GLB or OBJ"};
    Assimp::Importer importer;
    const aiScene& source = import(importer, file);
    Scene scene;
    scene.name = file.stem().string();
    scene.shows = "The model file " + file.filename().string() + ".";
    size_t elements = 0;
    for (unsigned i = 0; i < source.mNumMeshes; ++i) {
        scene.meshes.push_back(convertMesh(*source.mMeshes[i]));
        elements += scene.meshes.back().vertices.size() + scene.meshes.back().indices.size();
        if (source.mMeshes[i]->mNumAnimMeshes > 0)
            scene.notes.emplace_back("Morph targets are left out: the mesh keeps its rest shape.");
    }
    if (elements > 4 * maxElements) throw Refusal{"it has too many vertices and indices; simplify it"};
    convertMaterials(source, file.parent_path(), scene);
    const TreePointer tree = makeNodeTree(source);
    size_t number = 0;
    addInstances(source, *source.mRootNode, number, tree, scene);
    if (scene.instances.empty()) throw Refusal{"it shows no triangles; export a scene that contains a mesh"};
    placeCamera(source, tree, scene);
    return scene;
}

} // namespace

reprise::Result<Scene> loadScene(const std::filesystem::path& file) {
    const auto failure = [&](const std::string& reason) {
        return reprise::Error{reprise::ErrorCode::fileError,
                              "Cannot load " + file.string() + ": " + oneLine(reason) + "."};
    };
    try {
        return load(file);
    } catch (const Refusal& refusal) {
        return failure(refusal.reason);
    } catch (const std::bad_alloc&) {
        return reprise::Error{reprise::ErrorCode::outOfMemory,
                              "Cannot load " + file.string() + ": it does not fit into memory; simplify it."};
    } catch (const std::exception& error) {
        return failure(std::string(error.what()) + "; export it again");
    }
}

} // namespace scenes
