// SPDX-License-Identifier: Apache-2.0
// The jitter is alive: over a whole sequence the offsets seen in the rendered depth are the sequence's.
//
// Device depth of a plane is affine over the image, so that a plane tilted in x tells how far it moved in x,
// and one tilted in y how far in y. Vertices are snapped to 1/256 px, so the planes reach far beyond the
// image.
#include "bench.hpp"
#include "renderer.hpp"

namespace passes {
namespace {

constexpr int width = 96, height = 72;
constexpr double tolerancePx = 1.0 / 64.0;

struct TiltedPlane {
    double slopeX, slopeY; // of z, which is 8 m on the axis
    double left, right;    // x of its ends
};
constexpr TiltedPlane tiltedPlanes[] = {{0.5, 0.0, -10.0, 0.0}, {0.0, 0.4, 0.0, 15.0}};

scenes::Mesh meshOf(const TiltedPlane& plane) {
    scenes::Mesh mesh;
    for (const double y : {-12.0, 12.0})
        for (const double x : {plane.left, plane.right})
            mesh.vertices.push_back({glm::vec3(x, y, 8.0 + plane.slopeX * x + plane.slopeY * y),
                                     {0.0f, 0.0f, -1.0f},
                                     {0.0f, 0.0f}});
    mesh.indices = {0, 1, 2, 2, 1, 3};
    return mesh;
}

scenes::Scene tiltedScene() {
    scenes::Scene scene;
    scene.name = "tilted planes";
    scene.materials.push_back({.twoSided = true});
    for (uint32_t i = 0; i < 2; ++i) {
        scene.meshes.push_back(meshOf(tiltedPlanes[i]));
        scenes::Instance instance;
        instance.mesh = i;
        instance.id = i + 1;
        instance.objectToWorld = [](double) { return glm::dmat4(1.0); };
        scene.instances.push_back(instance);
    }
    scene.worldToView = [](double) { return glm::dmat4(1.0); };
    scene.nearPlane = 1.0;
    scene.farPlane = 40.0;
    scene.cameraMoves = false;
    return scene;
}

// Device depth of a plane at a place of the unjittered image.
double depthAt(const TiltedPlane& plane, glm::dvec2 px, const glm::dmat4& viewToClip) {
    const glm::dvec2 ndc = oracle::uvToNdc(px / glm::dvec2(width, height));
    const glm::dvec2 ray(ndc.x / viewToClip[0][0], ndc.y / viewToClip[1][1]);
    const double z = 8.0 / (1.0 - plane.slopeX * ray.x - plane.slopeY * ray.y);
    return oracle::deviceDepth(z, viewToClip);
}

// The offset that explains the depths best: least squares of depth(px) = analytic(px - offset), which is
// linear.
glm::dvec2 offsetSeenIn(const std::vector<float>& depth, const glm::dmat4& viewToClip) {
    glm::dmat2 normal(0.0);
    glm::dvec2 right(0.0);
    for (int i = 0; i < width * height; ++i) {
        const int x = i % width;
        if (x > width * 2 / 5 && x < width * 3 / 5) continue; // near the seam of the planes
        const TiltedPlane& plane = tiltedPlanes[x < width / 2 ? 0 : 1];
        const glm::dvec2 px(x + 0.5, i / width + 0.5);
        const double still = depthAt(plane, px, viewToClip);
        const glm::dvec2 slope(depthAt(plane, px + glm::dvec2(1, 0), viewToClip) - still,
                               depthAt(plane, px + glm::dvec2(0, 1), viewToClip) - still);
        normal += glm::outerProduct(slope, slope);
        right += slope * (still - static_cast<double>(depth[static_cast<size_t>(i)]));
    }
    return glm::inverse(normal) * right;
}

using Sequence = std::function<glm::dvec2(uint64_t frame)>;

std::vector<glm::dvec2> offsetsOf(const Sequence& jitter, int frames, scenes::DepthKind depthKind) {
    const scenes::Scene scene = tiltedScene();
    scenes::Renderer renderer(gpu(), scene, width, height, depthKind);
    scenes::FrameTargets targets = renderer.targets();
    std::vector<glm::dvec2> offsets;
    for (int frame = 0; frame < frames; ++frame) {
        gpu().run([&](VkCommandBuffer commands) {
            renderer.render(commands, frame, jitter(static_cast<uint64_t>(frame)), targets);
        });
        const auto camera = scenes::cameraAt(scene, frame, static_cast<double>(width) / height, depthKind);
        offsets.push_back(offsetSeenIn(gpu().downloadFloats(targets.depth), camera.viewToClip));
    }
    return offsets;
}

// The first frame whose offset is not the sequence's; empty if there is none.
std::string firstDeparture(const std::vector<glm::dvec2>& offsets, const Sequence& expected) {
    for (size_t frame = 0; frame < offsets.size(); ++frame) {
        const glm::dvec2 difference = glm::abs(offsets[frame] - expected(frame));
        if (!(difference.x <= tolerancePx && difference.y <= tolerancePx))
            return "frame " + std::to_string(frame) + " moved by (" + std::to_string(offsets[frame].x) +
                   ", " + std::to_string(offsets[frame].y) + ") px instead of (" +
                   std::to_string(expected(frame).x) + ", " + std::to_string(expected(frame).y) + ")";
    }
    return {};
}

class JitterAlive : public PassTest, public testing::WithParamInterface<scenes::DepthKind> {};
INSTANTIATE_TEST_SUITE_P(DepthKinds, JitterAlive,
                         testing::Values(scenes::DepthKind::standard, scenes::DepthKind::reversed,
                                         scenes::DepthKind::reversedInfinite),
                         [](const auto& each) {
                             return each.param == scenes::DepthKind::standard   ? "standard"
                                    : each.param == scenes::DepthKind::reversed ? "reversed"
                                                                                : "reversedInfinite";
                         });

glm::dvec2 halton16(uint64_t frame) {
    return oracle::haltonJitterPx(frame, 16);
}

TEST_P(JitterAlive, renderedDepthMovesAlongTheSequence) {
    const auto sequenceOf = [](reprise::JitterSequence sequence) {
        return [sequence](uint64_t frame) { return reprise::jitterPx(sequence, frame); };
    };
    EXPECT_EQ(
        firstDeparture(offsetsOf(sequenceOf(reprise::JitterSequence::halton16), 16, GetParam()), halton16),
        "");
    EXPECT_EQ(firstDeparture(offsetsOf(sequenceOf(reprise::JitterSequence::halton8), 16, GetParam()),
                             [](uint64_t frame) { return oracle::haltonJitterPx(frame, 8); }),
              "");
    EXPECT_EQ(firstDeparture(offsetsOf(sequenceOf(reprise::JitterSequence::uniform4Helix), 16, GetParam()),
                             oracle::uniform4HelixJitterPx),
              "");
}

// Controls: what the check above must not take for alive.
TEST_P(JitterAlive, stoppedOrMirroredJitterIsCaught) {
    const Sequence stopped = [](uint64_t) { return glm::dvec2(0.0); };
    const Sequence held = [](uint64_t) { return halton16(0); };
    const Sequence mirrored = [](uint64_t frame) { return halton16(frame) * glm::dvec2(1.0, -1.0); };
    const Sequence late = [](uint64_t frame) { return halton16(frame + 15); };
    for (const Sequence& wrong : {stopped, held, mirrored, late})
        EXPECT_NE(firstDeparture(offsetsOf(wrong, 16, GetParam()), halton16), "");
    const auto still = offsetsOf(stopped, 1, GetParam());
    EXPECT_NEAR(still[0].x, 0.0, tolerancePx);
    EXPECT_NEAR(still[0].y, 0.0, tolerancePx);
}

} // namespace
} // namespace passes
