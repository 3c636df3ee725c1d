// SPDX-License-Identifier: Apache-2.0
// Opens Vulkan: instance, the device asked for, one queue.
#include "context.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace harness {
namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

VkBool32 VKAPI_PTR collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                           const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto& vulkan = *static_cast<Vulkan*>(user);
    const std::lock_guard lock(vulkan.mutex);
    vulkan.messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

bool hasValidationLayer() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, validationLayer) == 0;
    });
}

void makeMessenger(Vulkan& vulkan) {
    auto info = structure<VkDebugUtilsMessengerCreateInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = collect;
    info.pUserData = &vulkan;
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(vulkan.instance, "vkCreateDebugUtilsMessengerEXT"));
    check(create(vulkan.instance, &info, nullptr, &vulkan.messenger), "create the validation messenger");
}

void makeInstance(Vulkan& vulkan, bool validation) {
    if (validation && !hasValidationLayer())
        throw std::runtime_error("The Vulkan validation layer is missing; install vulkan-validationlayers.");
    auto application = structure<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "reprise";
    application.apiVersion = VK_API_VERSION_1_3;
    const VkValidationFeatureEnableEXT synchronization =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    auto features = structure<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;
    const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    auto info = structure<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    if (validation) {
        info.pNext = &features;
        info.enabledLayerCount = info.enabledExtensionCount = 1;
        info.ppEnabledLayerNames = &validationLayer;
        info.ppEnabledExtensionNames = extensions;
    }
    if (vkCreateInstance(&info, nullptr, &vulkan.instance) != VK_SUCCESS)
        throw std::runtime_error(
            "No Vulkan driver was found; install one (on Debian without a graphics card: "
            "mesa-vulkan-drivers).");
    if (validation) makeMessenger(vulkan);
}

VkPhysicalDeviceProperties propertiesOf(VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    return properties;
}

std::vector<VkPhysicalDevice> devicesOf(VkInstance instance) {
    uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (count > 0) check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "list its devices");
    return devices;
}

size_t defaultDevice(const std::vector<VkPhysicalDevice>& devices) {
    for (size_t i = 0; i < devices.size(); ++i)
        if (propertiesOf(devices[i]).deviceType == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU) return i;
    return 0;
}

// An index, or a part of the name.
size_t deviceNamed(const std::vector<VkPhysicalDevice>& devices, const std::string& wanted) {
    size_t index = 0;
    const auto [end, failed] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    const bool isIndex = failed == std::errc() && end == wanted.data() + wanted.size();
    if (isIndex && index < devices.size()) return index;
    std::string names;
    for (size_t i = 0; i < devices.size(); ++i) {
        const std::string name = propertiesOf(devices[i]).deviceName;
        if (!isIndex && name.find(wanted) != std::string::npos) return i;
        names += (i > 0 ? ", " : "") + std::to_string(i) + " " + name;
    }
    throw std::runtime_error("There is no Vulkan device '" + wanted + "'; choose one of: " + names + ".");
}

void chooseDevice(Vulkan& vulkan, const std::string& wanted) {
    const auto devices = devicesOf(vulkan.instance);
    if (devices.empty())
        throw std::runtime_error(
            "The Vulkan drivers offer no device; check that the graphics card is visible or "
            "install mesa-vulkan-drivers.");
    vulkan.physicalDevice = devices[wanted.empty() ? defaultDevice(devices) : deviceNamed(devices, wanted)];
    auto driver =
        structure<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto properties = structure<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    properties.pNext = &driver;
    vulkan.properties = propertiesOf(vulkan.physicalDevice);
    if (vulkan.properties.apiVersion < VK_API_VERSION_1_3)
        throw std::runtime_error(std::string("The device ") + vulkan.properties.deviceName +
                                 " offers less than Vulkan 1.3; update its driver or choose another device.");
    vkGetPhysicalDeviceProperties2(vulkan.physicalDevice, &properties);
    vulkan.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    vkGetPhysicalDeviceMemoryProperties(vulkan.physicalDevice, &vulkan.memory);
}

void chooseQueue(Vulkan& vulkan) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(vulkan.physicalDevice, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(vulkan.physicalDevice, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t family = 0; family < count; ++family) {
        if ((families[family].queueFlags & wanted) != wanted) continue;
        vulkan.queueFamily = family;
        vulkan.timestampBits = families[family].timestampValidBits;
        return;
    }
    throw std::runtime_error(std::string("The device ") + vulkan.properties.deviceName +
                             " has no queue for both graphics and compute; choose another device.");
}

// What passes and scenes use, where the device has it: SV_PrimitiveID needs geometryShader, the discard of
// SPIR-V 1.6 shaderTerminateInvocation.
struct Features {
    VkPhysicalDeviceFeatures2 core =
        structure<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan13Features v13 =
        structure<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
};

void enableWhatExists(const Features& available, Features& wanted) {
    const auto& has = available.core.features;
    auto& core = wanted.core.features;
    core.geometryShader = has.geometryShader;
    core.sampleRateShading = has.sampleRateShading;
    core.samplerAnisotropy = has.samplerAnisotropy;
    core.shaderStorageImageWriteWithoutFormat = has.shaderStorageImageWriteWithoutFormat;
    wanted.v13.synchronization2 = available.v13.synchronization2;
    wanted.v13.dynamicRendering = available.v13.dynamicRendering;
    wanted.v13.maintenance4 = available.v13.maintenance4;
    wanted.v13.shaderTerminateInvocation = available.v13.shaderTerminateInvocation;
    wanted.v13.shaderDemoteToHelperInvocation = available.v13.shaderDemoteToHelperInvocation;
}

void makeDevice(Vulkan& vulkan) {
    Features available, wanted;
    available.core.pNext = &available.v13;
    wanted.core.pNext = &wanted.v13;
    vkGetPhysicalDeviceFeatures2(vulkan.physicalDevice, &available.core);
    enableWhatExists(available, wanted);
    vulkan.enabled = {.synchronization2 = wanted.v13.synchronization2 == VK_TRUE,
                      .dynamicRendering = wanted.v13.dynamicRendering == VK_TRUE,
                      .shaderStorageImageWriteWithoutFormat =
                          wanted.core.features.shaderStorageImageWriteWithoutFormat == VK_TRUE};
    const float priority = 1.0f;
    auto queue = structure<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = vulkan.queueFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto info = structure<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &wanted.core;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(vulkan.physicalDevice, &info, nullptr, &vulkan.device),
          std::string("open the device ") + vulkan.properties.deviceName);
    vkGetDeviceQueue(vulkan.device, vulkan.queueFamily, 0, &vulkan.queue);
}

} // namespace

Vulkan::~Vulkan() {
    if (device != VK_NULL_HANDLE) vkDestroyDevice(device, nullptr);
    if (messenger != VK_NULL_HANDLE) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance, messenger, nullptr);
    }
    if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
}

std::shared_ptr<Vulkan> openVulkan(const DeviceOptions& options) {
    auto vulkan = std::make_shared<Vulkan>();
    makeInstance(*vulkan, options.validation);
    chooseDevice(*vulkan, options.device);
    chooseQueue(*vulkan);
    makeDevice(*vulkan);
    return vulkan;
}

} // namespace harness
