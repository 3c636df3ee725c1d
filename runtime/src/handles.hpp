// SPDX-License-Identifier: Apache-2.0
// Vulkan objects that destroy themselves, and Vulkan results as sentences.
#pragma once

#include "device_functions.hpp"
#include "guarded.hpp"
#include "reprise/device.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace reprise {

// A Vulkan structure of which all but the type is zero.
template <class T> T structure(VkStructureType type) {
    T info{};
    info.sType = type;
    return info;
}

// `what` completes the sentence "Vulkan could not ...".
Error vulkanError(VkResult result, std::string_view what);

template <class Handle> class Unique {
public:
    using Destroy = void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*);

    Unique() = default;
    Unique(VkDevice device, Handle handle, Destroy destroy)
        : device_(device), handle_(handle), destroy_(destroy) {}
    Unique(Unique&& other) noexcept { swap(other); }
    Unique& operator=(Unique&& other) noexcept {
        Unique(std::move(other)).swap(*this);
        return *this;
    }
    ~Unique() {
        if (handle_ != VK_NULL_HANDLE) destroy_(device_, handle_, nullptr);
    }

    Handle get() const { return handle_; }

private:
    void swap(Unique& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        std::swap(destroy_, other.destroy_);
    }

    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
    Destroy destroy_ = nullptr;
};

// Every vkCreate* of one object has this shape, and so has vkAllocateMemory.
template <class Handle, class Info>
Result<Unique<Handle>>
make(const Device& device,
     VkResult(VKAPI_PTR* create)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*),
     typename Unique<Handle>::Destroy destroy, const Info& info, std::string_view what) {
    Handle handle = VK_NULL_HANDLE;
    const VkResult result = create(device.borrowed.device, &info, nullptr, &handle);
    if (result != VK_SUCCESS) return vulkanError(result, what);
    return Unique<Handle>(device.borrowed.device, handle, destroy);
}

// Bytes of `requirements` in a memory type that has all of `wanted`.
Result<Unique<VkDeviceMemory>> allocate(const Device& device, const VkMemoryRequirements& requirements,
                                        VkMemoryPropertyFlags wanted, std::string_view what);

} // namespace reprise
