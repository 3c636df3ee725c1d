// SPDX-License-Identifier: Apache-2.0
// An engine's own device, with no more than the three features that the runtime asks for.
#include "runtime_frame_support.hpp"

#include <optional>

namespace {

using namespace reprise;

struct OwnDevice {
    OwnDevice() {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_3;
        VkInstanceCreateInfo instanceInfo{};
        instanceInfo.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        instanceInfo.pApplicationInfo = &application;
        EXPECT_EQ(vkCreateInstance(&instanceInfo, nullptr, &borrowed.instance), VK_SUCCESS);
        uint32_t count = 1;
        vkEnumeratePhysicalDevices(borrowed.instance, &count, &borrowed.physicalDevice);
        VkPhysicalDeviceVulkan13Features v13{};
        v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        v13.synchronization2 = v13.dynamicRendering = VK_TRUE;
        VkPhysicalDeviceFeatures core{};
        core.shaderStorageImageWriteWithoutFormat = VK_TRUE;
        const float priority = 1.0f;
        VkDeviceQueueCreateInfo queueInfo{};
        queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queueInfo.queueCount = 1;
        queueInfo.pQueuePriorities = &priority;
        VkDeviceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.pNext = &v13;
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queueInfo;
        info.pEnabledFeatures = &core;
        EXPECT_EQ(vkCreateDevice(borrowed.physicalDevice, &info, nullptr, &borrowed.device), VK_SUCCESS);
        borrowed.getInstanceProcAddr = vkGetInstanceProcAddr;
        borrowed.features = {true, true, true};
    }
    OwnDevice(const OwnDevice&) = delete;
    OwnDevice& operator=(const OwnDevice&) = delete;
    ~OwnDevice() {
        vkDestroyDevice(borrowed.device, nullptr);
        vkDestroyInstance(borrowed.instance, nullptr);
    }

    BorrowedDevice borrowed;
};

// Every module that the plans of both stages need is accepted by a device with just those features.
TEST(OwnDeviceTest, recordersAreMadeAndMovedAndGone) {
    const OwnDevice own;
    const auto device = borrow(own.borrowed);
    ASSERT_TRUE(device) << device.error().message;
    std::optional<FrameRecorder> kept;
    for (const Stage stage : {Stage::fragment, Stage::compute}) {
        for (const auto* preset : {"inside", "best", "lean"}) {
            auto made = FrameRecorder::create(*device, testPack().passes(), packSpirv,
                                              {.needs = {.skinnedMeshes = true},
                                               .settings = {.stage = stage, .preset = preset},
                                               .extent = {64, 64}});
            ASSERT_TRUE(made) << made.error().message;
            kept = std::move(*made);
            EXPECT_EQ(kept->plan().passes.size(), 4u);
        }
    }
}

// Two recorders on one device know nothing of each other: there are no globals.
TEST(OwnDeviceTest, twoRecordersOnOneDeviceKeepTheirOwnHistory) {
    const FrameRecorder::CreateInfo info{.needs = {.objectsMove = false}, .settings = {}, .extent = {8, 8}};
    auto a = makeRecorder(info), b = makeRecorder(info);
    const TestFrame frame({8, 8});
    EXPECT_EQ(recordOne(a, frame.input(5))->resetReason, "first frame");
    EXPECT_EQ(recordOne(b, frame.input(6))->resetReason, "first frame");
    EXPECT_EQ(recordOne(a, frame.input(6))->resetReason, "");
    EXPECT_EQ(joined(testGpu().takeValidationMessages()), "");
}

} // namespace
