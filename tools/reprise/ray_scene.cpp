// SPDX-License-Identifier: Apache-2.0
#include "ray_scene.hpp"

#include "frame_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using scenes::Instance;
using scenes::Mesh;
using scenes::Texture;

bool isMoving(const Instance& instance) {
    return instance.moves || instance.palette;
}

// Joints that a palette lacks are the identity, as the renderer has it.
glm::mat4 skinMatrix(const Mesh& mesh, size_t vertex, const std::vector<glm::mat4>& palette) {
    glm::mat4 skin(0.0f);
    for (int i = 0; i < 4; ++i) {
        const size_t joint = mesh.joints[vertex][i];
        skin += mesh.weights[vertex][i] * (joint < palette.size() ? palette[joint] : glm::mat4(1.0f));
    }
    return skin;
}

std::vector<glm::vec3> worldPositions(const Instance& instance, const Mesh& mesh, const glm::dmat4& world,
                                      double seconds) {
    const bool skinned = instance.palette && !mesh.joints.empty();
    const std::vector<glm::mat4> palette = skinned ? instance.palette(seconds) : std::vector<glm::mat4>();
    std::vector<glm::vec3> positions(mesh.vertices.size());
    for (size_t i = 0; i < positions.size(); ++i) {
        glm::vec4 position(mesh.vertices[i].position, 1.0f);
        if (skinned) position = skinMatrix(mesh, i, palette) * position;
        positions[i] = glm::vec3(world * glm::dvec4(position));
    }
    return positions;
}

float alphaAt(const Texture& texture, int64_t x, int64_t y) {
    const int64_t width = texture.width, height = texture.height;
    const int64_t column = (x % width + width) % width, row = (y % height + height) % height;
    return static_cast<float>(texture.texels[static_cast<size_t>(row * width + column) * 4 + 3]) / 255.0f;
}

// Between texels, repeated beyond the borders.
float alphaAt(const Texture& texture, glm::vec2 uv) {
    const glm::dvec2 place = glm::dvec2(uv) * glm::dvec2(texture.width, texture.height) - 0.5;
    if (!(std::abs(place.x) < 1e9 && std::abs(place.y) < 1e9)) return 1.0f;
    const glm::dvec2 whole = glm::floor(place);
    const glm::vec2 part(place - whole);
    const auto x = static_cast<int64_t>(whole.x), y = static_cast<int64_t>(whole.y);
    return glm::mix(glm::mix(alphaAt(texture, x, y), alphaAt(texture, x + 1, y), part.x),
                    glm::mix(alphaAt(texture, x, y + 1), alphaAt(texture, x + 1, y + 1), part.x), part.y);
}

bool passesAlphaTest(const RayGeometry& geometry, uint32_t triangle, float u, float v) {
    float alpha = geometry.material->baseColour.a;
    if (geometry.texture) {
        const uint32_t* index = geometry.mesh->indices.data() + size_t{3} * triangle;
        const auto uv = [&](int corner) { return geometry.mesh->vertices[index[corner]].uv; };
        alpha *= alphaAt(*geometry.texture, (1.0f - u - v) * uv(0) + u * uv(1) + v * uv(2));
    }
    return !(alpha < geometry.material->alphaCutoff);
}

void alphaTest(const RTCFilterFunctionNArguments* arguments) {
    const auto& geometry = *static_cast<const RayGeometry*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const unsigned n = arguments->N;
        if (!passesAlphaTest(geometry, RTCHitN_primID(arguments->hit, n, i), RTCHitN_u(arguments->hit, n, i),
                             RTCHitN_v(arguments->hit, n, i)))
            arguments->valid[i] = 0;
    }
}

void requireNoError(RTCDevice device) {
    if (const RTCError error = embree().getDeviceError(device); error != RTC_ERROR_NONE)
        throw std::runtime_error(
            error == RTC_ERROR_OUT_OF_MEMORY
                ? "There is not enough memory for the scene's ray casting; free some"
                : fmt::format("Embree failed with error {}; is the scene finite?", static_cast<int>(error)));
}

void attach(RTCDevice device, RTCScene scene, RayGeometry& geometry, unsigned id) {
    const Embree& e = embree();
    RTCGeometry handle = e.newGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t vertices = geometry.positions.size(), triangles = geometry.mesh->indices.size() / 3;
    void* const positions = e.setNewGeometryBuffer(handle, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                   sizeof(glm::vec3), vertices);
    void* const indices = e.setNewGeometryBuffer(handle, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                 3 * sizeof(uint32_t), triangles);
    if (!positions || !indices) {
        e.releaseGeometry(handle);
        throw std::runtime_error("There is not enough memory for the scene's ray casting; free some");
    }
    std::memcpy(positions, geometry.positions.data(), vertices * sizeof(glm::vec3));
    std::memcpy(indices, geometry.mesh->indices.data(), triangles * 3 * sizeof(uint32_t));
    if (geometry.material->alphaCutoff > 0.0f) {
        e.setGeometryUserData(handle, &geometry);
        e.setGeometryIntersectFilterFunction(handle, alphaTest);
        e.setGeometryOccludedFilterFunction(handle, alphaTest);
    }
    e.commitGeometry(handle);
    e.attachGeometryByID(scene, handle, id);
    e.releaseGeometry(handle); // the scene keeps it
}

RTCIntersectContext context() {
    RTCIntersectContext made;
    rtcInitIntersectContext(&made);
    return made;
}

RTCRay rayOf(glm::vec3 origin, glm::vec3 direction, float from, float to) {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = from;
    ray.tfar = to;
    ray.mask = ~0u;
    return ray;
}

RTCRayHit rayHitOf(const RTCRay& ray) {
    RTCRayHit made{};
    made.ray = ray;
    made.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return made;
}

RayHit describe(const RayGeometry& geometry, const RTCRayHit& found, glm::dvec3 origin,
                glm::dvec3 direction) {
    const uint32_t* index = geometry.mesh->indices.data() + size_t{3} * found.hit.primID;
    const auto corner = [&](int i) { return glm::dvec3(geometry.positions[index[i]]); };
    const glm::dvec3 outside = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    const bool behind = glm::dot(outside, direction) > 0.0;
    RayHit hit;
    // On the triangle's plane in double precision, for Embree's distance is single; not where the ray all but
    // lies in the plane.
    const double distance = glm::dot(outside, corner(0) - origin) / glm::dot(outside, direction);
    const auto nearby = static_cast<double>(found.ray.tfar);
    hit.position = origin + direction * (std::abs(distance - nearby) < 1e-3 * nearby ? distance : nearby);
    hit.normal = behind ? -outside : outside;
    hit.backFace = !geometry.material->twoSided && behind != geometry.mirrored;
    hit.distance = found.ray.tfar;
    return hit;
}

} // namespace

struct RayScene::Part {
    RTCScene scene = nullptr;
    std::vector<RayGeometry> geometries; // by Embree's geometry ID; never resized while the scene lives
    ~Part() {
        if (scene) embree().releaseScene(scene);
    }
    void build(RTCDevice device, const scenes::Scene& from, bool moving, double seconds);
};

void RayScene::Part::build(RTCDevice device, const scenes::Scene& from, bool moving, double seconds) {
    const Embree& e = embree();
    for (const Instance& instance : from.instances) {
        if (isMoving(instance) != moving) continue;
        const glm::dmat4 world = instance.objectToWorld(seconds);
        const Mesh& mesh = from.meshes[instance.mesh];
        if (!scenes::isPresent(world) || mesh.indices.empty()) continue;
        const scenes::Material& material = from.materials[instance.material];
        const Texture* texture =
            material.texture >= 0 ? &from.textures[static_cast<size_t>(material.texture)] : nullptr;
        geometries.push_back({&mesh, &material, texture, worldPositions(instance, mesh, world, seconds),
                              glm::determinant(glm::dmat3(world)) < 0.0});
    }
    if (geometries.empty()) return;
    scene = e.newScene(device);
    // Robust: no ray slips between two triangles that share an edge.
    e.setSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!moving) e.setSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    for (unsigned id = 0; id < geometries.size(); ++id)
        attach(device, scene, geometries[id], id);
    e.commitScene(scene);
    requireNoError(device);
}

RayScene::RayScene(const scenes::Scene& scene) : scene_(scene) {
    device_ = embree().newDevice("verbose=0");
    if (!device_) throw std::runtime_error("Embree does not run on this processor; it needs SSE2 or better");
    try {
        parts_[0] = std::make_unique<Part>();
        parts_[0]->build(device_, scene_, false, 0.0);
    } catch (...) {
        parts_[0].reset();
        embree().releaseDevice(device_);
        throw;
    }
}

RayScene::~RayScene() {
    for (auto& part : parts_)
        part.reset();
    embree().releaseDevice(device_);
}

void RayScene::setFrame(int frame) {
    if (frame < 0) throw std::runtime_error("The frame of a ground truth must be 0 or more");
    if (frame == frame_) return;
    auto moving = std::make_unique<Part>();
    moving->build(device_, scene_, true, frame / scene_.framesPerSecond);
    parts_[1] = std::move(moving);
    frame_ = frame;
}

bool RayScene::nearest(glm::dvec3 origin, glm::dvec3 direction, float from, float to, RayHit& hit) const {
    bool found = false;
    for (const auto& part : parts_) {
        if (!part || !part->scene) continue;
        RTCIntersectContext state = context();
        RTCRayHit ray =
            rayHitOf(rayOf(glm::vec3(origin), glm::vec3(direction), from, found ? hit.distance : to));
        embree().intersect1(part->scene, &state, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        hit = describe(part->geometries[ray.hit.geomID], ray, origin, direction);
        found = true;
    }
    return found;
}

float RayScene::nearestDistance(glm::vec3 origin, glm::vec3 direction, float to) const {
    RTCIntersectContext state = context();
    RTCRayHit ray = rayHitOf(rayOf(origin, direction, 0.0f, to));
    for (const auto& part : parts_) // the second one finds only what is nearer
        if (part && part->scene) embree().intersect1(part->scene, &state, &ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : ray.ray.tfar;
}

bool RayScene::isBlocked(glm::vec3 origin, glm::vec3 direction, float to) const {
    RTCIntersectContext state = context();
    RTCRay ray = rayOf(origin, direction, 0.0f, to);
    for (const auto& part : parts_) {
        if (part && part->scene) embree().occluded1(part->scene, &state, &ray);
        if (ray.tfar < 0.0f) return true; // Embree's sign of a hit
    }
    return false;
}

} // namespace report
