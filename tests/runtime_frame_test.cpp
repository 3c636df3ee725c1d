// SPDX-License-Identifier: Apache-2.0
// The frame recorder: when history holds, what is drawn, and every way to fail.
#include "runtime_frame_support.hpp"

#include <cmath>
#include <cstring>

namespace {

using namespace reprise;

constexpr Extent size{32, 24};

struct Quad {
    explicit Quad(float z)
        : positions(testGpu().buffer(12 * sizeof(float), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
          indices(testGpu().buffer(6 * sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT)) {
        const float corners[] = {-0.5f * z, -0.5f * z, z, 0.5f * z,  -0.5f * z, z,
                                 0.5f * z,  0.5f * z,  z, -0.5f * z, 0.5f * z,  z};
        const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
        std::memcpy(positions.mapped, corners, sizeof(corners));
        std::memcpy(indices.mapped, triangles, sizeof(triangles));
    }

    ObjectDraw draw() const {
        ObjectDraw object;
        object.positions = positions.buffer;
        object.indices = indices.buffer;
        object.indexCount = 6;
        return object;
    }

    harness::Buffer positions, indices;
};

// The middle half of the image, moved right by a tenth of it and up by a twentieth.
ObjectDraw movedQuad(const Quad& quad, float z) {
    ObjectDraw object = quad.draw();
    object.prevObjectToWorld[3] = {-0.2f * z, -0.1f * z, 0.0f, 1.0f};
    return object;
}

class FrameTest : public RuntimeTest, public testing::WithParamInterface<Stage> {
protected:
    FrameRecorder::CreateInfo info(const SceneNeeds& needs = {}) const {
        return {.needs = needs,
                .settings = {.stage = GetParam(), .preset = "inside", .overrides = plainBlend()},
                .extent = size};
    }

    // The colour of the middle pixel after a frame of one colour.
    static float shown(FrameRecorder& recorder, TestFrame& frame, float colour, const FrameInput& input,
                       std::string_view expectedReason) {
        frame.fill(frame.colour, colour);
        const auto output = recordOne(recorder, input);
        EXPECT_TRUE(output) << output.error().message;
        EXPECT_EQ(output->resetReason, expectedReason);
        EXPECT_EQ(output->historyWasReset, !expectedReason.empty());
        const auto texels = downloadRef(output->colour);
        return texels[4 * (size.width * (size.height / 2) + size.width / 2)];
    }
};

// Weight 0.97 of binary16 colours: 1e-3 is two units in the last place of 0.75.
constexpr float tolerance = 1e-3f, weight = 0.97f;
float blended(float history, float current) {
    return current + (history - current) * weight;
}

TEST_P(FrameTest, historyIsKeptFromFrameToFrame) {
    auto recorder = makeRecorder(info());
    TestFrame frame(size);
    EXPECT_NEAR(shown(recorder, frame, 0.25f, frame.input(7), "first frame"), 0.25f, tolerance);
    const float second = blended(0.25f, 0.75f);
    EXPECT_NEAR(shown(recorder, frame, 0.75f, frame.input(8), ""), second, tolerance);
    EXPECT_NEAR(shown(recorder, frame, 0.75f, frame.input(9), ""), blended(second, 0.75f), tolerance);
}

TEST_P(FrameTest, aGapInTheFramesResetsHistory) {
    auto recorder = makeRecorder(info());
    TestFrame frame(size);
    shown(recorder, frame, 0.25f, frame.input(0), "first frame");
    EXPECT_NEAR(shown(recorder, frame, 0.75f, frame.input(2), "frame gap"), 0.75f, tolerance);
    EXPECT_NEAR(shown(recorder, frame, 0.5f, frame.input(2), "frame gap"), 0.5f, tolerance)
        << "the same frame again";
    EXPECT_NEAR(shown(recorder, frame, 0.75f, frame.input(3), ""), blended(0.5f, 0.75f), tolerance);
}

TEST_P(FrameTest, aRequestResetsHistory) {
    auto recorder = makeRecorder(info());
    TestFrame frame(size);
    shown(recorder, frame, 0.25f, frame.input(0), "first frame");
    auto cut = frame.input(1);
    cut.resetHistory = true;
    EXPECT_NEAR(shown(recorder, frame, 0.75f, cut, "request"), 0.75f, tolerance);
}

TEST_P(FrameTest, aResizeResetsHistory) {
    auto recorder = makeRecorder(info());
    TestFrame frame(size);
    shown(recorder, frame, 0.25f, frame.input(0), "first frame");
    ASSERT_TRUE(recorder.resize({17, 9}));
    TestFrame small({17, 9});
    small.fill(small.colour, 0.75f);
    const auto output = recordOne(recorder, small.input(1));
    ASSERT_TRUE(output) << output.error().message;
    EXPECT_EQ(output->resetReason, "resize");
    EXPECT_EQ(output->colour.extent.width, 17u);
    const auto texels = downloadRef(output->colour);
    for (size_t i = 0; i < texels.size(); ++i)
        ASSERT_NEAR(texels[i], i % 4 == 3 ? 1.0f : 0.75f, tolerance) << "texel " << i / 4;
    small.fill(small.colour, 0.25f);
    const auto next = recordOne(recorder, small.input(2));
    EXPECT_EQ(next->resetReason, "");
    EXPECT_NEAR(downloadRef(next->colour)[0], blended(0.75f, 0.25f), tolerance);
    EXPECT_EQ(recorder.plan().images.front().extent.width, 17u);
}

TEST_P(FrameTest, aFailedCallLeavesHistoryAsItWas) {
    auto recorder = makeRecorder(info());
    TestFrame frame(size);
    shown(recorder, frame, 0.25f, frame.input(0), "first frame");
    auto incomplete = frame.input(1);
    incomplete.depth = {};
    EXPECT_FALSE(recordOne(recorder, incomplete));
    EXPECT_NEAR(shown(recorder, frame, 0.75f, frame.input(1), ""), blended(0.25f, 0.75f), tolerance);
}

// Every combination of needs runs three frames in one command buffer, where synchronization validation sees
// hazards between frames too; validation says nothing.
TEST_P(FrameTest, everyNeedRecords) {
    const Quad quad(2.0f);
    TestFrame frame(size);
    for (int bits = 0; bits < 128; ++bits) {
        const auto bit = [&](int i) { return (bits >> i & 1) != 0; };
        auto wanted = info({.cameraMoves = bit(0),
                            .objectsMove = bit(1),
                            .engineWritesMotion = bit(2),
                            .fastMotion = bit(3),
                            .reversedDepth = bit(4),
                            .orthographic = bit(5),
                            .linearDepth = bit(6)});
        wanted.framesInFlight = 3;
        auto recorder = makeRecorder(wanted);
        if (bit(1))
            frame.objects = {movedQuad(quad, 2.0f)};
        else
            frame.objects.clear();
        testGpu().run([&](VkCommandBuffer commands) {
            for (uint64_t i = 0; i < 3; ++i) {
                const auto output = recorder.record(commands, frame.input(i));
                EXPECT_TRUE(output) << output.error().message;
            }
        });
        ASSERT_EQ(joined(testGpu().takeValidationMessages()), "") << "needs " << bits;
    }
}

TEST_P(FrameTest, everyColourFormatOfTheDeviceRecords) {
    for (const VkFormat format : {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_B10G11R11_UFLOAT_PACK32,
                                  VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R8G8B8A8_UNORM}) {
        auto wanted = info();
        wanted.colourFormat = format;
        auto recorder = tryRecorder(wanted);
        if (!recorder) { // a device may lack one, and says so
            EXPECT_EQ(recorder.error().code, ErrorCode::unsupportedFormat) << recorder.error().message;
            continue;
        }
        const TestFrame frame(size);
        const auto output = recordOne(*recorder, frame.input(0));
        ASSERT_TRUE(output) << output.error().message;
        EXPECT_EQ(output->colour.format, format);
    }
}

// --- The camera's motion

// Three frames of a camera that turns, moves and is jittered: with MOTION camera, which the plan takes,
// history comes from where the vectors of camera_velocity lead. A binary16 vector of a texel of 32 is off by
// up to 1/1024 of it, on both axes and in two frames, among texels of 0 and 1.
TEST_P(FrameTest, theCamerasOwnMotionIsThatOfTheVectors) {
    const SceneNeeds cameraAlone{.objectsMove = false};
    auto own = makeRecorder(info(cameraAlone));
    auto withVectors = info(cameraAlone);
    withVectors.settings.overrides.push_back({"MOTION", "vectors"});
    auto given = makeRecorder(withVectors);
    ASSERT_EQ(own.plan().passes.size() + 1, given.plan().passes.size());
    TestFrame frame(size);
    std::vector<float> checker(size_t(4) * size.width * size.height, 0.0f);
    for (size_t i = 0; i < checker.size(); ++i)
        checker[i] = (i / 4 + i / 4 / size.width) % 2 == 0 ? 1.0f : 0.0f;
    testGpu().uploadFloats(frame.colour, checker);
    frame.fill(frame.depth, 1.001f - 0.1f / 2.0f); // 2 m
    for (uint64_t i = 0; i < 3; ++i) {
        const double t = static_cast<double>(i);
        const double yaw = 0.01 * t;
        frame.camera.worldToView = glm::dmat4(1.0);
        frame.camera.worldToView[0] = {std::cos(yaw), 0.0, -std::sin(yaw), 0.0};
        frame.camera.worldToView[2] = {std::sin(yaw), 0.0, std::cos(yaw), 0.0};
        frame.camera.worldToView[3] = {0.03 * t, -0.02 * t * t, 0.01 * t, 1.0};
        FrameInput input = frame.input(i);
        input.jitterPx = {0.25 - 0.125 * t, 0.125 * t};
        const auto a = recordOne(own, input), b = recordOne(given, input);
        ASSERT_TRUE(a) << a.error().message;
        ASSERT_TRUE(b) << b.error().message;
        ASSERT_TRUE(b->motion);
        const auto shown = downloadRef(a->colour), expected = downloadRef(b->colour);
        for (size_t k = 0; k < shown.size(); ++k)
            ASSERT_NEAR(shown[k], expected[k], 1.0f / 256.0f) << "frame " << i << " value " << k;
        if (i == 0) continue;
        const auto motion = downloadRef(*b->motion); // something moved
        EXPECT_GT(std::abs(motion[0]) * size.width + std::abs(motion[1]) * size.height, 0.2f) << i;
    }
}

// --- Moving objects

glm::vec2 motionAt(const std::vector<float>& motion, uint32_t x, uint32_t y) {
    return {motion[2 * (y * size.width + x)], motion[2 * (y * size.width + x) + 1]};
}

// Binary16 near 0.1 has units of 6e-5.
constexpr float motionTolerance = 1e-4f;

TEST_P(FrameTest, movingObjectsAreDrawnOverTheCamerasMotion) {
    for (const bool cameraMoves : {true, false}) {
        auto recorder = makeRecorder(info({.cameraMoves = cameraMoves}));
        const Quad quad(2.0f);
        TestFrame frame(size);
        frame.objects = {movedQuad(quad, 2.0f)};
        ASSERT_TRUE(recordOne(recorder, frame.input(0)));
        const auto output = recordOne(recorder, frame.input(1));
        ASSERT_TRUE(output) << output.error().message;
        ASSERT_TRUE(output->motion);
        const auto motion = downloadRef(*output->motion);
        const glm::vec2 inside = motionAt(motion, 16, 12), outside = motionAt(motion, 2, 2);
        EXPECT_NEAR(inside.x, 0.1f, motionTolerance);
        EXPECT_NEAR(inside.y, -0.05f, motionTolerance) << "v points down";
        EXPECT_NEAR(outside.x, 0.0f,
                    1e-6f); // the still camera reprojects to where it was, to float's precision
        EXPECT_NEAR(outside.y, 0.0f, 1e-6f);
    }
}

// Depth of the quad: (1.001 z - 0.1) / z. The scene's depth hides it, is it, or lies behind it.
TEST_P(FrameTest, hiddenObjectsLeaveTheMotionAlone) {
    constexpr float z = 2.0f;
    const float own = 1.001f - 0.1f / z;
    for (const bool reversed : {false, true}) {
        for (const float scene : {own - 0.01f, own, own + 0.01f}) {
            auto recorder = makeRecorder(info({.cameraMoves = false, .reversedDepth = reversed}));
            const Quad quad(z);
            TestFrame frame(size);
            frame.objects = {movedQuad(quad, z)};
            frame.fill(frame.depthTest, scene);
            testGpu().run([&](VkCommandBuffer commands) {
                testGpu().use(commands, frame.depthTest, harness::depthReadState);
            });
            const auto output = recordOne(recorder, frame.input(0));
            ASSERT_TRUE(output) << output.error().message;
            const bool visible = reversed ? scene <= own : scene >= own;
            EXPECT_NEAR(motionAt(downloadRef(*output->motion), 16, 12).x, visible ? 0.1f : 0.0f,
                        motionTolerance)
                << "scene " << scene << (reversed ? " reversed" : "");
        }
    }
}

TEST_P(FrameTest, skinnedAndRigidObjectsMoveInOneFrame) {
    auto recorder = makeRecorder(info({.skinnedMeshes = true}));
    const Quad quad(2.0f), far(4.0f);
    const auto joints = testGpu().buffer(16, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    const auto weights = testGpu().buffer(64, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    const auto palette = testGpu().buffer(128, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const auto prevPalette = testGpu().buffer(128, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const uint8_t indices[16] = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    float halves[16];
    for (int i = 0; i < 16; ++i)
        halves[i] = i % 4 < 2 ? 0.5f : 0.0f;
    glm::mat4 now[2] = {glm::mat4(1.0f), glm::mat4(1.0f)}, before[2] = {glm::mat4(1.0f), glm::mat4(1.0f)};
    before[0][3].x = -0.8f; // half of it: 0.4 m at 2 m is a tenth of the image
    std::memcpy(joints.mapped, indices, sizeof(indices));
    std::memcpy(weights.mapped, halves, sizeof(halves));
    std::memcpy(palette.mapped, now, sizeof(now));
    std::memcpy(prevPalette.mapped, before, sizeof(before));
    ObjectDraw skinned = quad.draw();
    skinned.joints = joints.buffer;
    skinned.weights = weights.buffer;
    skinned.palette = palette.buffer;
    skinned.prevPalette = prevPalette.buffer;
    ObjectDraw rigid = far.draw();
    rigid.objectToWorld[3].x = rigid.prevObjectToWorld[3].x = 3.2f; // to the right edge
    rigid.prevObjectToWorld[3].y = 0.8f;
    TestFrame frame(size);
    frame.objects = {rigid, skinned};
    const auto output = recordOne(recorder, frame.input(0));
    ASSERT_TRUE(output) << output.error().message;
    const auto motion = downloadRef(*output->motion);
    EXPECT_NEAR(motionAt(motion, 12, 12).x, 0.1f, motionTolerance);
    EXPECT_NEAR(motionAt(motion, 30, 12).y, 0.1f, motionTolerance) << "it came down";
}

// More than any arena begins with, in frames that need more and more.
TEST_P(FrameTest, anyNumberOfObjectsIsDrawn) {
    auto recorder = makeRecorder(info());
    const Quad quad(2.0f);
    TestFrame frame(size);
    for (uint64_t i = 0; i < 6; ++i) {
        frame.objects.assign(size_t(1) << (2 * i), movedQuad(quad, 2.0f));
        const auto output = recordOne(recorder, frame.input(i));
        ASSERT_TRUE(output) << output.error().message;
        EXPECT_NEAR(motionAt(downloadRef(*output->motion), 16, 12).x, 0.1f, motionTolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, FrameTest, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& stage) {
                             return stage.param == Stage::compute ? "compute" : "fragment";
                         });

} // namespace
