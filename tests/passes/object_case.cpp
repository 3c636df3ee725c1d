// SPDX-License-Identifier: Apache-2.0
#include "object_case.hpp"

#include <cstring>

namespace passes {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

// In object space, or in the bind pose. Its corners lie at depths of 3 to 6 m.
const Triangle corners = {{{-1.9, -1.2, 3.1}, {2.3, -0.7, 4.2}, {0.2, 2.4, 5.9}}};
// Two joints a corner take part, so that weights, indices and both palettes matter.
constexpr uint8_t joints[3][4] = {{0, 1, 2, 3}, {3, 0, 1, 2}, {2, 2, 1, 0}};
constexpr float weights[3][4] = {
    {0.5f, 0.25f, 0.125f, 0.125f}, {0.75f, 0.25f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.25f, 0.25f}};

oracle::Camera cameraOf(const ObjectCase& object, bool previous) {
    const double aspect = static_cast<double>(object.width) / object.height;
    const glm::dvec3 eye = previous ? glm::dvec3(0.1, -0.05, -0.2) : glm::dvec3(0.0);
    return {viewOf(eye, previous ? glm::dvec3(0.02, 0.01, 0.0) : glm::dvec3(0.0, 0.0, 0.03)),
            projectionOf(object.kind, aspect, previous ? 1.02 : 1.0)};
}

// Object to world of the rigid object, or of joint `joint`.
glm::mat4 placement(int joint, bool previous) {
    const double move = (previous ? -0.15 : 0.1) * (1.0 + 0.3 * joint);
    const glm::dmat4 toView = viewOf({move, 0.4 * move, -0.5 * move}, {0.5 * move, -0.3 * move, 0.2 * move});
    return glm::mat4(glm::inverse(toView));
}

glm::dvec4 toWorld(const ObjectCase& object, size_t corner, bool previous) {
    const glm::dvec4 position(glm::vec3(corners[corner]), 1.0);
    if (!object.skinned) return glm::dmat4(placement(0, previous)) * position;
    glm::dvec4 sum(0.0);
    for (int i = 0; i < 4; ++i)
        sum += double{weights[corner][i]} * (glm::dmat4(placement(joints[corner][i], previous)) * position);
    return sum;
}

oracle::MovingTriangle triangleOf(const ObjectCase& object) {
    const oracle::Camera current = cameraOf(object, false), previous = cameraOf(object, true);
    oracle::MovingTriangle triangle;
    for (size_t i = 0; i < 3; ++i) {
        triangle.clip[i] = current.viewToClip * (current.worldToView * toWorld(object, i, false));
        triangle.prevClip[i] = previous.viewToClip * (previous.worldToView * toWorld(object, i, true));
    }
    return triangle;
}

// --- Buffers

template <class T> harness::Buffer filledBuffer(std::span<const T> values, VkBufferUsageFlags usage) {
    harness::Buffer buffer = gpu().buffer(values.size_bytes(), usage);
    std::memcpy(buffer.mapped, values.data(), values.size_bytes());
    return buffer;
}

struct DrawBuffers {
    std::vector<harness::Buffer> kept;
    reprise::ObjectDraw draw;

    template <class T> VkBuffer add(std::span<const T> values, VkBufferUsageFlags usage) {
        kept.push_back(filledBuffer(values, usage));
        return kept.back().buffer;
    }
};

// placement(), or what the case has in its place.
glm::mat4 placementOf(const ObjectCase& object, int joint, bool previous) {
    if (!previous || !object.brokenPrevPlacement) return placement(joint, previous);
    const glm::vec4 column(*object.brokenPrevPlacement);
    return {column, column, column, column};
}

void addSkin(DrawBuffers& buffers, const ObjectCase& object) {
    std::vector<glm::mat4> palette, prevPalette;
    for (int joint = 0; joint < 4; ++joint) {
        palette.push_back(placementOf(object, joint, false));
        prevPalette.push_back(placementOf(object, joint, true));
    }
    buffers.draw.joints =
        buffers.add(std::span<const uint8_t>(&joints[0][0], 12), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    buffers.draw.weights =
        buffers.add(std::span<const float>(&weights[0][0], 12), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    buffers.draw.palette =
        buffers.add(std::span<const glm::mat4>(palette), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    buffers.draw.prevPalette =
        buffers.add(std::span<const glm::mat4>(prevPalette), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

DrawBuffers makeDraw(const ObjectCase& object) {
    DrawBuffers buffers;
    std::vector<float> positions;
    for (const glm::dvec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis)
            positions.push_back(static_cast<float>(corner[axis]));
    constexpr uint32_t indices[] = {0, 1, 2};
    buffers.draw.positions =
        buffers.add(std::span<const float>(positions), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    buffers.draw.indices = buffers.add(std::span<const uint32_t>(indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    buffers.draw.indexCount = 3;
    if (object.skinned)
        addSkin(buffers, object);
    else {
        buffers.draw.objectToWorld = placementOf(object, 0, false);
        buffers.draw.prevObjectToWorld = placementOf(object, 0, true);
    }
    return buffers;
}

// --- Recording

float backgroundDepth(const ObjectCase& object, int x) {
    const double linear = x < object.occludedColumns ? 1.0 : 30.0;
    return static_cast<float>(oracle::deviceDepth(linear, cameraOf(object, false).viewToClip));
}

harness::Image depthImage(const ObjectCase& object, VkFormat format) {
    const Pixels depth = makePixels(format, object.width, object.height,
                                    [&](int x, int) { return Texel{backgroundDepth(object, x)}; });
    auto image =
        gpu().image(format, static_cast<uint32_t>(object.width), static_cast<uint32_t>(object.height));
    gpu().uploadFloats(image, depth.values);
    return image;
}

reprise::FrameRecorder makeRecorder(const ObjectCase& object, const reprisec::Pack& from,
                                    const PlatformSwitches& platform) {
    reprise::FrameRecorder::CreateInfo info;
    info.needs.skinnedMeshes = object.skinned;
    info.needs.reversedDepth = object.kind.depth != Depth::standard;
    info.needs.orthographic = object.kind.projection == Projection::orthographic;
    info.settings.stage = object.stage;
    info.extent = {static_cast<uint32_t>(object.width), static_cast<uint32_t>(object.height)};
    auto made = reprise::FrameRecorder::create(
        gpu().device(), from.passes(),
        [&](const Variant& variant, Stage stage) -> reprise::Result<std::vector<uint32_t>> {
            const bool isObject = variant.pass->name == "object_velocity";
            return spirvOf(from, variant, stage, isObject ? platform : PlatformSwitches{});
        },
        info);
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
}

reprise::FrameOutput recordFrame(reprise::FrameRecorder& recorder, const reprise::FrameInput& input) {
    reprise::Result<reprise::FrameOutput> output = reprise::Error{};
    gpu().run([&](VkCommandBuffer commands) { output = recorder.record(commands, input); });
    if (!output) throw std::runtime_error(output.error().message);
    return *output;
}

// The camera's motion at a pixel, with the depth that the image holds.
glm::dvec2 cameraMotion(const ObjectCase& object, int x, int y) {
    const oracle::CameraVelocity camera{cameraOf(object, false),
                                        cameraOf(object, true),
                                        object.jitterPx,
                                        glm::dvec2(object.width, object.height),
                                        false,
                                        false};
    return oracle::cameraVelocity(camera, x, y, backgroundDepth(object, x));
}

} // namespace

ObjectDrawData drawDataOf(const ObjectCase& object) {
    ObjectDrawData data;
    for (size_t corner = 0; corner < 3; ++corner) {
        data.positions[corner] = corners[corner];
        for (int i = 0; i < 4; ++i) {
            data.joints[corner][i] = joints[corner][i];
            data.weights[corner][i] = weights[corner][i];
        }
    }
    const auto toClip = [&](bool previous) {
        const oracle::Camera camera = cameraOf(object, previous);
        const glm::dmat4 toWorld = object.skinned ? glm::dmat4(1.0) : glm::dmat4(placement(0, previous));
        return glm::mat4(camera.viewToClip * camera.worldToView * toWorld);
    };
    const glm::mat4 current = toClip(false), previous = toClip(true);
    std::memcpy(data.parameters.gObjectToClip, &current, sizeof(current));
    std::memcpy(data.parameters.gPrevObjectToClip, &previous, sizeof(previous));
    const glm::dvec2 jitterNdc = object.jitterPx * glm::dvec2(2.0 / object.width, -2.0 / object.height);
    data.parameters.gJitterNdc[0] = static_cast<float>(jitterNdc.x);
    data.parameters.gJitterNdc[1] = static_cast<float>(jitterNdc.y);
    for (int joint = 0; object.skinned && joint < 4; ++joint) {
        data.palette.push_back(placement(joint, false));
        data.prevPalette.push_back(placement(joint, true));
    }
    return data;
}

Pixels backgroundMotion(const ObjectCase& object, VkFormat format) {
    return makePixels(format, object.width, object.height, [&](int x, int y) {
        const glm::dvec2 motion = cameraMotion(object, x, y);
        return Texel{static_cast<float>(motion.x), static_cast<float>(motion.y)};
    });
}

Pixels recordedMotion(const ObjectCase& object, const reprisec::Pack& from,
                      const PlatformSwitches& platform) {
    reprise::FrameRecorder recorder = makeRecorder(object, from, platform);
    const DrawBuffers buffers = makeDraw(object);
    harness::Image depth = depthImage(object, r32f), depthTest = depthImage(object, VK_FORMAT_D32_SFLOAT);
    harness::Image colour =
        gpu().image(rgba16f, static_cast<uint32_t>(object.width), static_cast<uint32_t>(object.height));
    gpu().uploadFloats(colour,
                       std::vector<float>(static_cast<size_t>(object.width * object.height * 4), 0.5f));
    gpu().run([&](VkCommandBuffer commands) { gpu().use(commands, depthTest, harness::depthReadState); });

    reprise::FrameInput input;
    input.colour = colour.ref;
    input.depth = depth.ref;
    input.depthAttachment = depthTest.ref;
    input.jitterPx = object.jitterPx;
    input.camera = {cameraOf(object, true).worldToView, cameraOf(object, true).viewToClip};
    recordFrame(recorder, input);
    input.frameIndex = 1;
    input.camera = {cameraOf(object, false).worldToView, cameraOf(object, false).viewToClip};
    input.movingObjects = std::span(&buffers.draw, 1);
    const reprise::FrameOutput output = recordFrame(recorder, input);
    if (!output.motion) throw std::runtime_error("The recorder gave no motion image.");

    harness::Image motion;
    motion.ref = *output.motion;
    motion.state = reprise::sampledState;
    return {motion.ref.format, object.width, object.height, 2, gpu().downloadFloats(motion)};
}

// Bound: half-float store, and 1/256 px of interpolation. Within 1/16 px of an edge, the snapping of vertices
// decides which of the two motions is seen: either is right.
Comparison compareWithOracle(const ObjectCase& object, const Pixels& motion) {
    const oracle::MovingTriangle triangle = triangleOf(object);
    const glm::dvec2 extent(object.width, object.height);
    const auto ndcAt = [&](glm::dvec2 px) { return oracle::uvToNdc((px - object.jitterPx) / extent); };
    return compare(
        motion,
        [&](int x, int y, bool) {
            const glm::dvec2 px(x + 0.5, y + 0.5);
            const bool visible = x >= object.occludedColumns && oracle::covers(triangle, ndcAt(px));
            glm::dvec2 expected =
                visible ? oracle::objectVelocity(triangle, ndcAt(px)) : cameraMotion(object, x, y);
            glm::dvec2 bound = glm::dvec2(1.0 / 256.0) / extent;
            for (const glm::dvec2 side :
                 {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
                if (oracle::covers(triangle, ndcAt(px + side / 16.0)) != oracle::covers(triangle, ndcAt(px)))
                    bound = glm::dvec2(1e9);
            return Expected{{expected, 0.0}, {bound, 0.0}};
        },
        2);
}

} // namespace passes
