// SPDX-License-Identifier: Apache-2.0
// A recorder before shading and one after it, as docs/runtime.md has them: what the first hands to the
// second, and what jitter is to either.
#include "runtime_frame_support.hpp"

#include <random>

namespace {

using namespace reprise;

class TwoRecordersTest : public RuntimeTest, public testing::WithParamInterface<Stage> {
protected:
    FrameRecorder::CreateInfo info(const SceneNeeds& needs, Extent extent) const {
        return {.needs = needs, .settings = {.stage = GetParam()}, .extent = extent};
    }
};

// Colour of every pixel at random and a depth that varies, seen by a camera that turns and moves.
void fillNoise(TestFrame& frame) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> colour(0.0f, 1.0f), depth(0.4f, 0.9f);
    const size_t pixels = size_t(frame.extent.width) * frame.extent.height;
    std::vector<float> colours, depths;
    for (size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < 4; ++c)
            colours.push_back(colour(random));
        depths.push_back(depth(random));
    }
    testGpu().uploadFloats(frame.colour, colours);
    testGpu().uploadFloats(frame.depth, depths);
}

FrameInput movingInput(TestFrame& frame, uint64_t index) {
    frame.camera.worldToView[3] = {-0.01 * double(index), 0.002 * double(index), 0.0, 1.0};
    FrameInput input = frame.input(index);
    input.jitterPx = jitterPx(JitterSequence::halton8, index);
    input.motion.reset();
    return input;
}

// Both in one command buffer, frame after frame, where synchronization validation sees what they share. The
// colour is that of one recorder which makes its own motion; without the motion it would not be.
TEST_P(TwoRecordersTest, motionIsMadeOnceForBoth) {
    const Extent extent{33, 17};
    TestFrame frame(extent);
    fillNoise(frame);
    auto lighting = makeRecorder(info({.antiAliasing = false, .ambientOcclusion = true}, extent));
    auto resolve = makeRecorder(info({.engineWritesMotion = true}, extent));
    auto still = makeRecorder(info({.engineWritesMotion = true}, extent));
    auto alone = makeRecorder(info({}, extent));
    EXPECT_EQ(resolve.plan().passes.size(), 1u) << "anti-aliasing alone";
    std::vector<float> resolved, unmoved, expected;
    for (uint64_t index = 0; index < 4; ++index) {
        const FrameInput input = movingInput(frame, index);
        FrameInput zero = input;
        zero.motion = frame.motion.ref;
        Result<FrameOutput> output = Error{};
        testGpu().run([&](VkCommandBuffer commands) {
            const auto lit = lighting.record(commands, input);
            ASSERT_TRUE(lit) << lit.error().message;
            ASSERT_TRUE(lit->motion && lit->lighting);
            FrameInput shaded = input;
            shaded.motion = lit->motion;
            output = resolve.record(commands, shaded);
        });
        ASSERT_TRUE(output) << output.error().message;
        resolved = downloadRef(output->colour);
        output = recordOne(alone, input);
        ASSERT_TRUE(output) << output.error().message;
        expected = downloadRef(output->colour);
        output = recordOne(still, zero);
        ASSERT_TRUE(output) << output.error().message;
        unmoved = downloadRef(output->colour);
    }
    EXPECT_EQ(resolved, expected);
    EXPECT_NE(unmoved, expected);
}

// Lighting is made of depth as it is: the same whatever jitter is said to be in it. Anti-aliasing takes it
// off.
TEST_P(TwoRecordersTest, jitterIsOfAntiAliasingAlone) {
    const Extent extent{33, 17};
    TestFrame frame(extent);
    fillNoise(frame);
    const SceneNeeds needs{.objectsMove = false, .ambientOcclusion = true};
    auto jittered = makeRecorder(info(needs, extent)), plain = makeRecorder(info(needs, extent));
    for (uint64_t index = 0; index < 3; ++index) {
        const FrameInput input = movingInput(frame, index);
        FrameInput without = input;
        without.jitterPx = {};
        const auto a = recordOne(jittered, input), b = recordOne(plain, without);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(downloadRef(*a->lighting), downloadRef(*b->lighting)) << "frame " << index;
        if (index > 0) {
            EXPECT_NE(downloadRef(a->colour), downloadRef(b->colour)) << "frame " << index;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, TwoRecordersTest, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) {
                             return each.param == Stage::fragment ? "fragment" : "compute";
                         });

} // namespace
