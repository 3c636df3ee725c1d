// SPDX-License-Identifier: Apache-2.0
// Every way in which the runtime can be asked for what it cannot do ends in its code and a sentence.
#include "runtime_frame_support.hpp"

#include "device_functions.hpp"
#include "frame_images.hpp"

namespace {

using namespace reprise;

constexpr Extent size{16, 8};

// A sentence says what (a capital first, a stop last) and names what it is about.
template <class T> void expectError(const Result<T>& result, ErrorCode code, std::string_view about) {
    ASSERT_FALSE(result) << "no error about " << about;
    const std::string& message = result.error().message;
    EXPECT_EQ(result.error().code, code) << message;
    EXPECT_NE(message.find(about), std::string::npos) << message;
    if (code == ErrorCode::missingVariant) return; // worded for the end of a compiler's line
    EXPECT_TRUE(message.size() > 20 && std::isupper(message.front()) && message.ends_with('.')) << message;
}

class ErrorTest : public RuntimeTest {
protected:
    static FrameRecorder::CreateInfo info(const SceneNeeds& needs = {}, Stage stage = Stage::compute) {
        return {.needs = needs, .settings = {.stage = stage}, .extent = size};
    }
    static Device without(bool EnabledFeatures::*feature) {
        Device device = testGpu().device();
        device.borrowed.features.*feature = false;
        return device;
    }
};

// --- Borrowing

TEST_F(ErrorTest, borrowedHandlesMustBeSet) {
    const BorrowedDevice whole = testGpu().device().borrowed;
    auto broken = whole;
    broken.instance = VK_NULL_HANDLE;
    expectError(borrow(broken), ErrorCode::invalidArgument, "instance");
    broken = whole;
    broken.physicalDevice = VK_NULL_HANDLE;
    expectError(borrow(broken), ErrorCode::invalidArgument, "physicalDevice");
    broken = whole;
    broken.device = VK_NULL_HANDLE;
    expectError(borrow(broken), ErrorCode::invalidArgument, "device");
    broken = whole;
    broken.getInstanceProcAddr = nullptr;
    expectError(borrow(broken), ErrorCode::invalidArgument, "getInstanceProcAddr");
}

TEST_F(ErrorTest, synchronization2IsAlwaysNeeded) {
    expectError(borrow(without(&EnabledFeatures::synchronization2).borrowed), ErrorCode::missingFeature,
                "synchronization2");
}

TEST_F(ErrorTest, aLoaderThatKnowsNothingIsNamed) {
    BorrowedDevice borrowed = testGpu().device().borrowed;
    borrowed.getInstanceProcAddr = [](VkInstance, const char*) -> PFN_vkVoidFunction { return nullptr; };
    expectError(borrow(borrowed), ErrorCode::missingFeature, "vkGet");
}

// --- Creating a recorder

TEST_F(ErrorTest, featuresAreNeededByStage) {
    const Device noRendering = without(&EnabledFeatures::dynamicRendering);
    const Device noWrite = without(&EnabledFeatures::shaderStorageImageWriteWithoutFormat);
    const SceneNeeds still{.objectsMove = false};
    expectError(tryRecorder(info(still, Stage::fragment), noRendering), ErrorCode::missingFeature,
                "dynamicRendering");
    expectError(tryRecorder(info(still, Stage::compute), noWrite), ErrorCode::missingFeature,
                "shaderStorageImageWriteWithoutFormat");
    EXPECT_TRUE(tryRecorder(info(still, Stage::compute), noRendering)) << "compute alone does without";
    EXPECT_TRUE(tryRecorder(info(still, Stage::fragment), noWrite)) << "fragment alone does without";
    expectError(tryRecorder(info({}, Stage::compute), noRendering), ErrorCode::missingFeature,
                "object_velocity");
}

TEST_F(ErrorTest, formatsAreChecked) {
    auto wanted = info();
    wanted.colourFormat = VK_FORMAT_BC1_RGB_UNORM_BLOCK;
    expectError(tryRecorder(wanted), ErrorCode::unsupportedFormat, "VkFormat 131");
    wanted.colourFormat = VK_FORMAT_R32_UINT; // no device filters integers
    expectError(tryRecorder(wanted), ErrorCode::unsupportedFormat, "r32ui");
    wanted = info();
    wanted.depthFormat = VK_FORMAT_R32_SFLOAT;
    expectError(tryRecorder(wanted), ErrorCode::unsupportedFormat, "depthAttachment");
}

TEST_F(ErrorTest, createInfoIsChecked) {
    auto wanted = info();
    wanted.extent = {0, 8};
    expectError(tryRecorder(wanted), ErrorCode::zeroExtent, "extent");
    wanted = info();
    wanted.extent = {1u << 20, 8};
    expectError(tryRecorder(wanted), ErrorCode::invalidArgument, "larger");
    wanted = info();
    wanted.framesInFlight = 0;
    expectError(tryRecorder(wanted), ErrorCode::invalidArgument, "framesInFlight");
    wanted = info();
    wanted.settings.preset = "nicest";
    expectError(tryRecorder(wanted), ErrorCode::invalidArgument, "nicest");
    expectError(tryRecorder(info({.antiAliasing = false})), ErrorCode::invalidArgument, "antiAliasing");
}

Result<FrameRecorder> recorderWith(const SpirvSource& spirv, Stage stage = Stage::compute) {
    return FrameRecorder::create(testGpu().device(), testPack().passes(), spirv,
                                 {.needs = {}, .settings = {.stage = stage}, .extent = size});
}

TEST_F(ErrorTest, shadersMustBeShaders) {
    expectError(recorderWith([](const Variant&, Stage) -> Result<std::vector<uint32_t>> {
                    return std::vector<uint32_t>{1, 2, 3};
                }),
                ErrorCode::badShader, "SPIR-V");
    expectError(recorderWith([](const Variant& variant, Stage stage) -> Result<std::vector<uint32_t>> {
                    auto words = packSpirv(variant, stage);
                    if (words) words->resize(words->size() - 1);
                    return words;
                }),
                ErrorCode::badShader, "cut short");
    const auto camera = makeVariant(testPack().passes(), "camera_velocity");
    expectError(recorderWith([&](const Variant&, Stage) { return packSpirv(*camera, Stage::compute); },
                             Stage::fragment),
                ErrorCode::badShader, "stage");
    expectError(recorderWith([](const Variant&, Stage) -> Result<std::vector<uint32_t>> {
                    throw std::runtime_error("The engine's archive is closed.");
                }),
                ErrorCode::invalidArgument, "archive");
    expectError(recorderWith(spirvFromDirectory("no/such/directory")), ErrorCode::missingVariant,
                "camera_velocity");
}

TEST_F(ErrorTest, aBindingThatTheTableLacksIsNamed) {
    const auto words = compiled(R"([[vk::binding(21)]] RWTexture2D<float4> gOut;
                                   [numthreads(1, 1, 1)] void mainCompute() { gOut[uint2(0, 0)] = 1.0; })",
                                "mainCompute", Stage::compute);
    const auto variant = makeVariant(testPack().passes(), "camera_velocity");
    expectError(PassPipeline::create(testGpu().device(), *variant, Stage::compute, words, {}, {}),
                ErrorCode::badShader, "binding 21");
}

// A recorder does without; a pass made by hand says so.
TEST_F(ErrorTest, quadOperationsAreNotTakenForGranted) {
    Device device = testGpu().device();
    device.quadOperations = false;
    auto wanted = info();
    wanted.settings.overrides = {{"QUAD_SHARING", "on"}};
    const auto recorder = tryRecorder(wanted, device);
    ASSERT_TRUE(recorder) << recorder.error().message;
    EXPECT_EQ(switchValue(recorder->plan().passes.back().variant, "QUAD_SHARING"), "off");
    auto variant = makeVariant(testPack().passes(), "temporal_aa");
    ASSERT_TRUE(setSwitch(*variant, "QUAD_SHARING", "on"));
    const auto words = packSpirv(*variant, Stage::compute);
    ASSERT_TRUE(words) << words.error().message;
    expectError(PassPipeline::create(device, *variant, Stage::compute, *words, {}, {}),
                ErrorCode::missingFeature, "quad and shuffle operations");
}

// --- Recording

class RecordErrorTest : public ErrorTest {
protected:
    // The error of a frame whose input `spoil` has changed.
    template <class Spoil>
    static Result<FrameOutput> recorded(const FrameRecorder::CreateInfo& wanted, const Spoil& spoil) {
        auto recorder = makeRecorder(wanted);
        const TestFrame frame(size);
        auto input = frame.input(0);
        spoil(input);
        return recordOne(recorder, input);
    }
};

TEST_F(RecordErrorTest, missingInputsAreNamed) {
    expectError(recorded(info(), [](FrameInput& in) { in.colour = {}; }), ErrorCode::missingInput, "colour");
    expectError(recorded(info(), [](FrameInput& in) { in.depth = {}; }), ErrorCode::missingInput, "depth");
    expectError(recorded(info({.engineWritesMotion = true}), [](FrameInput& in) { in.motion.reset(); }),
                ErrorCode::missingInput, "motion");
    const ObjectDraw object;
    expectError(recorded(info(),
                         [&](FrameInput& in) {
                             in.movingObjects = {&object, 1};
                             in.depthAttachment.reset();
                         }),
                ErrorCode::missingInput, "depthAttachment");
}

TEST_F(RecordErrorTest, extentsMustAgree) {
    const auto other = testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, size.width + 1, size.height);
    expectError(recorded(info(), [&](FrameInput& in) { in.colour = other.ref; }), ErrorCode::invalidArgument,
                "17x8");
    expectError(recorded(info(),
                         [](FrameInput& in) {
                             in.depth.extent = {0, 0};
                         }),
                ErrorCode::zeroExtent, "depth");
}

TEST_F(RecordErrorTest, inputsMustBeReadableAsTheyAreRead) {
    const auto integers = testGpu().image(VK_FORMAT_R32_UINT, size.width, size.height);
    expectError(recorded(info(), [&](FrameInput& in) { in.colour = integers.ref; }),
                ErrorCode::unsupportedFormat, "FrameInput::colour");
}

TEST_F(RecordErrorTest, objectsMustBeWholeAndExpected) {
    const auto buffer =
        testGpu().buffer(64, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    ObjectDraw object;
    const auto give = [&](FrameInput& in) { in.movingObjects = {&object, 1}; };
    expectError(recorded(info(), give), ErrorCode::missingInput, "positions");
    object.positions = buffer.buffer;
    expectError(recorded(info(), give), ErrorCode::missingInput, "indices");
    expectError(recorded(info({.objectsMove = false}), give), ErrorCode::invalidArgument, "objectsMove");
    object.indices = object.palette = buffer.buffer;
    expectError(recorded(info(), give), ErrorCode::invalidArgument, "skinnedMeshes");
    const auto skinned = info({.skinnedMeshes = true});
    expectError(recorded(skinned, give), ErrorCode::missingInput, "prevPalette");
    object.prevPalette = buffer.buffer;
    expectError(recorded(skinned, give), ErrorCode::missingInput, "joints");
    object.joints = buffer.buffer;
    expectError(recorded(skinned, give), ErrorCode::missingInput, "weights");
}

TEST_F(RecordErrorTest, theDepthAttachmentHasItsFormat) {
    auto wanted = info();
    wanted.depthFormat = VK_FORMAT_D16_UNORM;
    const ObjectDraw object;
    expectError(recorded(wanted,
                         [&](FrameInput& in) {
                             in.movingObjects = {&object, 1};
                         }),
                ErrorCode::invalidArgument, "depthFormat");
}

TEST_F(RecordErrorTest, anEmptyWindowKeepsTheOldImages) {
    auto recorder = makeRecorder(info());
    expectError(recorder.resize({0, 0}), ErrorCode::zeroExtent, "extent");
    expectError(recorder.resize({1u << 20, 1}), ErrorCode::invalidArgument, "larger");
    const TestFrame frame(size);
    EXPECT_TRUE(recordOne(recorder, frame.input(0)));
    EXPECT_EQ(recordOne(recorder, frame.input(1))->resetReason, "");
}

// --- The pieces alone

TEST_F(ErrorTest, anArenaSaysWhenItIsFull) {
    const auto variant = makeVariant(testPack().passes(), "camera_velocity");
    const auto words = packSpirv(*variant, Stage::compute);
    const auto pass = PassPipeline::create(testGpu().device(), *variant, Stage::compute, *words, {}, {});
    ASSERT_TRUE(pass);
    auto arena = FrameArena::create(testGpu().device(), 2, 1, variant->pass->parameterBytes);
    ASSERT_TRUE(arena);
    expectError(arena->begin(2), ErrorCode::invalidArgument, "slot");
    expectError(FrameArena::create(testGpu().device(), 0, 1, 16), ErrorCode::invalidArgument, "slot");
    const TestFrame frame(size);
    const NamedImage images[] = {{"gInDepth", frame.depth.ref}, {"gOutVelocity", frame.motion.ref}};
    const std::vector<std::byte> parameters(variant->pass->parameterBytes);
    testGpu().run([&](VkCommandBuffer commands) {
        auto motion = frame.motion;
        testGpu().use(commands, motion, storageState);
        for (const uint32_t slot : {0u, 1u, 0u}) {
            ASSERT_TRUE(arena->begin(slot));
            expectError(pass->record(commands, *arena, std::span(images).first(1), {}, parameters),
                        ErrorCode::missingInput, "gOutVelocity");
            expectError(pass->record(commands, *arena, std::span(images).last(1), {}, parameters),
                        ErrorCode::missingInput, "gInDepth");
            expectError(pass->record(commands, *arena, images, {}, std::span(parameters).first(4)),
                        ErrorCode::invalidArgument, "4 were given");
            EXPECT_TRUE(slot == 0 || pass->record(commands, *arena, images, {}, parameters));
        }
        ASSERT_TRUE(arena->begin(0));
        EXPECT_TRUE(pass->record(commands, *arena, images, {}, parameters));
        expectError(pass->record(commands, *arena, images, {}, parameters), ErrorCode::outOfMemory, "arena");
    });
}

// Stands before the driver's allocation: which memory types were asked for, and which one is full.
struct Allocations {
    std::vector<uint32_t> types;
    uint32_t full = ~0u, driversType = 0;
    DeviceFunctions driver;
} allocations;

constexpr VkMemoryPropertyFlags hostWritten =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

// The device as one that has `types`, of which a buffer may take any. Behind each is the same type of the
// driver's, which the host can write.
Device withMemory(std::vector<VkMemoryPropertyFlags> types, uint32_t full = ~0u) {
    Device device = testGpu().device();
    uint32_t driversType = 0;
    while ((device.memory.memoryTypes[driversType].propertyFlags & hostWritten) != hostWritten)
        ++driversType;
    allocations = {{}, full, driversType, *device.vk};
    device.memory.memoryTypeCount = static_cast<uint32_t>(types.size());
    for (size_t i = 0; i < types.size(); ++i)
        device.memory.memoryTypes[i].propertyFlags = types[i];
    DeviceFunctions vk = *device.vk;
    vk.GetBufferMemoryRequirements = [](VkDevice handle, VkBuffer buffer, VkMemoryRequirements* out) {
        allocations.driver.GetBufferMemoryRequirements(handle, buffer, out);
        out->memoryTypeBits = ~0u;
    };
    vk.AllocateMemory = [](VkDevice handle, const VkMemoryAllocateInfo* info,
                           const VkAllocationCallbacks* callbacks, VkDeviceMemory* out) {
        allocations.types.push_back(info->memoryTypeIndex);
        if (info->memoryTypeIndex == allocations.full) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        VkMemoryAllocateInfo real = *info;
        real.memoryTypeIndex = allocations.driversType;
        return allocations.driver.AllocateMemory(handle, &real, callbacks, out);
    };
    device.vk = std::make_shared<const DeviceFunctions>(vk);
    return device;
}

TEST_F(ErrorTest, parametersLieInTheDevicesMemoryWhereTheHostCanWriteIt) {
    constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, host = hostWritten;
    using Types = std::vector<uint32_t>;
    EXPECT_TRUE(FrameArena::create(withMemory({local, host, local | host}), 1, 1, 16));
    EXPECT_EQ(allocations.types, Types{2});
    EXPECT_TRUE(FrameArena::create(withMemory({local, host}), 1, 1, 16));
    EXPECT_EQ(allocations.types, Types{1});
    EXPECT_TRUE(FrameArena::create(withMemory({local, host, local | host}, 2), 1, 1, 16));
    EXPECT_EQ(allocations.types, (Types{2, 1})) << "a small heap that others have filled";
    expectError(FrameArena::create(withMemory({local}), 1, 1, 16), ErrorCode::outOfMemory,
                "parameter buffer");
}

// Two images whose lives do not meet lie in one allocation, the third in another.
TEST_F(ErrorTest, sharedMemoryIsShared) {
    FramePlan plan;
    for (const int pass : {0, 1, 1}) {
        PlannedImage image;
        image.name = "transient";
        image.format = "rgba16f";
        image.extent = size;
        image.firstPass = image.lastPass = pass;
        image.bytes = 8ull * size.width * size.height;
        plan.images.push_back(image);
    }
    shareMemory(plan);
    const auto made = makeFrameImages(testGpu().device(), plan);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->memory.size(), 2u);
    EXPECT_EQ(plan.images[0].memory, plan.images[1].memory);
    EXPECT_NE(plan.images[1].memory, plan.images[2].memory);
}

// The control of every test here: the layer that must stay silent does speak.
TEST_F(ErrorTest, validationSpeaksOfAHazard) {
    const auto a = testGpu().buffer(64, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    const auto b = testGpu().buffer(64, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    testGpu().run([&](VkCommandBuffer commands) {
        const VkBufferCopy copy{0, 0, 64};
        for (int i = 0; i < 2; ++i)
            vkCmdCopyBuffer(commands, a.buffer, b.buffer, 1, &copy);
    });
    EXPECT_NE(joined(testGpu().takeValidationMessages()).find("SYNC-HAZARD-WRITE"), std::string::npos);
}

} // namespace
