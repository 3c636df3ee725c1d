// SPDX-License-Identifier: Apache-2.0
// The device as a whole: submission and timestamps.
#include "gpu_state.hpp"

#include <utility>

namespace harness {
namespace {

void fullBarrier(VkCommandBuffer commands) {
    auto barrier = structure<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    auto dependency = structure<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

reprise::Device borrowFrom(const Vulkan& vulkan, PFN_vkGetInstanceProcAddr getInstanceProcAddr) {
    reprise::BorrowedDevice borrowed;
    borrowed.instance = vulkan.instance;
    borrowed.physicalDevice = vulkan.physicalDevice;
    borrowed.device = vulkan.device;
    borrowed.queueFamilyIndex = vulkan.queueFamily;
    borrowed.getInstanceProcAddr = getInstanceProcAddr ? getInstanceProcAddr : vkGetInstanceProcAddr;
    borrowed.features = vulkan.enabled;
    auto device = reprise::borrow(borrowed);
    if (!device) throw std::runtime_error(device.error().message);
    return *device;
}

struct QueryPool {
    QueryPool(VkDevice owner, uint32_t count) : device(owner) {
        auto info = structure<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = count;
        check(vkCreateQueryPool(device, &info, nullptr, &pool), "create a query pool");
    }
    QueryPool(const QueryPool&) = delete;
    QueryPool& operator=(const QueryPool&) = delete;
    ~QueryPool() { vkDestroyQueryPool(device, pool, nullptr); }

    VkDevice device;
    VkQueryPool pool = VK_NULL_HANDLE;
};

// Without the barrier after the first timestamp a dispatch may be timed as nothing.
void recordTimed(VkCommandBuffer commands, VkQueryPool pool, uint32_t first,
                 const std::function<void(VkCommandBuffer)>& section) {
    fullBarrier(commands);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, first);
    fullBarrier(commands);
    section(commands);
    fullBarrier(commands);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, first + 1);
}

} // namespace

void check(VkResult result, const std::string& what) {
    if (result != VK_SUCCESS)
        throw std::runtime_error("Vulkan could not " + what + " (VkResult " +
                                 std::to_string(static_cast<int>(result)) + ").");
}

Gpu::State::~State() {
    if (!vulkan || vulkan->device == VK_NULL_HANDLE) return;
    vkDeviceWaitIdle(vulkan->device);
    vkDestroyFence(vulkan->device, fence, nullptr);
    vkDestroyCommandPool(vulkan->device, pool, nullptr);
}

Gpu::Gpu(const DeviceOptions& options) : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.vulkan = openVulkan(options);
    state.device = borrowFrom(*state.vulkan, options.getInstanceProcAddr);
    const VkDevice device = state.vulkan->device;
    auto pool = structure<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool.queueFamilyIndex = state.vulkan->queueFamily;
    check(vkCreateCommandPool(device, &pool, nullptr, &state.pool), "create a command pool");
    auto commands = structure<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    commands.commandPool = state.pool;
    commands.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device, &commands, &state.commands), "allocate a command buffer");
    const auto fence = structure<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    check(vkCreateFence(device, &fence, nullptr, &state.fence), "create a fence");
}

Gpu::~Gpu() = default;

const reprise::Device& Gpu::device() const {
    return state_->device;
}
VkDevice Gpu::handle() const {
    return state_->vulkan->device;
}
VkQueue Gpu::queue() const {
    return state_->vulkan->queue;
}
std::string Gpu::name() const {
    return state_->vulkan->properties.deviceName;
}
std::string Gpu::driver() const {
    return state_->vulkan->driver;
}

std::string Gpu::type() const {
    switch (state_->vulkan->properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "cpu";
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual";
    default:
        return "other";
    }
}

std::vector<std::string> Gpu::takeValidationMessages() {
    const std::lock_guard lock(state_->vulkan->mutex);
    return std::exchange(state_->vulkan->messages, {});
}

reprise::FrameArena& Gpu::arena() {
    constexpr uint32_t firstRecords = 64, parameterBytes = 1024; // of a pass; the pack's largest has 896
    State& state = *state_;
    if (state.recordsLeft == 0) {
        const uint32_t records = firstRecords << state.arenasBegun;
        if (state.arenasBegun == state.arenas.size()) {
            auto made = reprise::FrameArena::create(state.device, 1, records, records * parameterBytes);
            if (!made) throw std::runtime_error(made.error().message);
            state.arenas.push_back(std::move(*made));
        }
        if (auto begun = state.arenas[state.arenasBegun].begin(0); !begun)
            throw std::runtime_error(begun.error().message);
        state.recordsLeft = records;
        ++state.arenasBegun;
    }
    --state.recordsLeft;
    return state.arenas[state.arenasBegun - 1];
}

void Gpu::run(const std::function<void(VkCommandBuffer)>& record) {
    State& state = *state_;
    const VkDevice device = state.vulkan->device;
    check(vkResetCommandPool(device, state.pool, 0), "reset a command pool");
    auto begin = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(state.commands, &begin), "begin a command buffer");
    record(state.commands);
    check(vkEndCommandBuffer(state.commands), "end a command buffer");
    auto commands = structure<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
    commands.commandBuffer = state.commands;
    auto submit = structure<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    check(vkQueueSubmit2(state.vulkan->queue, 1, &submit, state.fence), "submit work");
    check(vkWaitForFences(device, 1, &state.fence, VK_TRUE, UINT64_MAX), "finish the work");
    check(vkResetFences(device, 1, &state.fence), "reset a fence");
    state.arenasBegun = 0;
    state.recordsLeft = 0;
}

std::vector<double> Gpu::time(std::span<const std::function<void(VkCommandBuffer)>> sections) {
    const Vulkan& vulkan = *state_->vulkan;
    if (vulkan.timestampBits == 0) throw std::runtime_error("The device " + name() + " has no timestamps.");
    if (sections.empty()) return {};
    const auto count = static_cast<uint32_t>(sections.size());
    const QueryPool queries(vulkan.device, 2 * count);
    run([&](VkCommandBuffer commands) {
        vkCmdResetQueryPool(commands, queries.pool, 0, 2 * count);
        for (uint32_t i = 0; i < count; ++i)
            recordTimed(commands, queries.pool, 2 * i, sections[i]);
    });
    std::vector<uint64_t> ticks(2 * size_t(count));
    check(vkGetQueryPoolResults(vulkan.device, queries.pool, 0, 2 * count, ticks.size() * sizeof(uint64_t),
                                ticks.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "read timestamps");
    // Counters of fewer bits wrap around: the difference modulo their range is right.
    const uint64_t mask = vulkan.timestampBits >= 64 ? ~0ull : (1ull << vulkan.timestampBits) - 1;
    const double msPerTick = static_cast<double>(vulkan.properties.limits.timestampPeriod) * 1e-6;
    std::vector<double> milliseconds;
    for (size_t i = 0; i < count; ++i)
        milliseconds.push_back(static_cast<double>((ticks[2 * i + 1] - ticks[2 * i]) & mask) * msPerTick);
    return milliseconds;
}

} // namespace harness
