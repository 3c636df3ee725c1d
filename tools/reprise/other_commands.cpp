// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"
#include "truth.hpp"

#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Stage;

double mebibytes(uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

void printSwitch(const reprise::SwitchInfo& info) {
    fmt::print("    {:<21}", info.name);
    for (size_t i = 0; i < info.values.size(); ++i)
        fmt::print(" {}{}", info.values[i], i == info.defaultValue ? "*" : "");
    fmt::print("\n");
}

void printPass(const reprisec::Pack& pack, const reprise::PassInfo& pass) {
    fmt::print("  {}: {}\n", pass.name, pass.summary);
    for (const auto& info : pass.switches)
        printSwitch(info);
    for (const auto& preset : pack.presets(pass.name))
        fmt::print("    preset {}: {}\n", preset.name, preset.summary);
    fmt::print("    variants committed: {}; others are compiled on demand\n",
               pack.committedVariants(pass).size());
}

// The stages in which a planned pass is compiled: a pass with geometry of its own has two.
std::vector<Stage> stagesOf(const reprise::PlannedPass& planned) {
    if (planned.variant.pass->fullscreen) return {planned.stage};
    return {Stage::vertex, Stage::fragment};
}

// Passes that draw geometry write where it is: they count as if it were everywhere.
double shareOfFrame(const reprise::FramePlan& plan, const reprise::PlannedPass& planned, Size size) {
    const auto& output = plan.images[static_cast<size_t>(planned.writeImages.front())];
    return double(output.extent.width) * output.extent.height / (double(size.width) * size.height);
}

// Passes differ in what they need for as many samples.
uint32_t defaultSamples(Shaders& shaders, const std::string& pass) {
    const auto variant = reprise::makeVariant(shaders.pack().passes(), pass);
    const auto value = variant ? reprise::switchValue(*variant, "SAMPLES") : std::string_view{};
    if (value.empty())
        throw std::runtime_error(
            fmt::format("--occlusion {} is not one of ambient_occlusion, scalable_obscurance", pass));
    return static_cast<uint32_t>(std::stoul(std::string(value)));
}

reprise::Settings settingsOf(const PlanOptions& options) {
    const auto stages = parseStages(options.stage);
    if (stages.size() != 1)
        throw std::runtime_error("--stage must be fragment or compute here: a plan has one");
    reprise::Settings settings;
    settings.stage = stages.front();
    settings.preset = options.preset;
    return settings;
}

void printPlan(const reprise::FramePlan& plan) {
    for (const auto& pass : plan.passes)
        fmt::print("  {}{}{}\n", reprise::variantName(pass.variant), pass.run.empty() ? "" : ", ", pass.run);
    for (const auto& image : plan.images) {
        const std::string extent = image.extent.width == 0
                                       ? "of an extent of its own"
                                       : fmt::format("{}x{}  {:.2f} MiB", image.extent.width,
                                                     image.extent.height, mebibytes(image.bytes));
        fmt::print("    {:<28} {:<8} {}{}{}\n", image.name, image.format, extent,
                   image.history ? ", history" : "", image.external ? ", the engine's" : "");
    }
    for (const auto& dropped : plan.dropped)
        fmt::print("  without {}: {}\n", dropped.pass, dropped.reason);
}

void printCosts(const reprise::FramePlan& all, const PlanCost& allCost, const reprise::FramePlan& scene,
                const PlanCost& sceneCost) {
    fmt::print("{:<28} {:>14} {:>14}\n", "", "everything on", "this scene");
    fmt::print("{:<28} {:>14} {:>14}\n", "passes", all.passes.size(), scene.passes.size());
    fmt::print("{:<28} {:>14.2f} {:>14.2f}\n", "images, MiB", mebibytes(all.bytes), mebibytes(scene.bytes));
    fmt::print("{:<28} {:>14.2f} {:>14.2f}\n", "images unaliased, MiB", mebibytes(all.bytesWithoutAliasing),
               mebibytes(scene.bytesWithoutAliasing));
    fmt::print("{:<28} {:>14} {:>14}\n", "SPIR-V, bytes", allCost.spirvBytes, sceneCost.spirvBytes);
    fmt::print("{:<28} {:>14.2f} {:>14.2f}\n", "reads per pixel of the frame", allCost.readsPerPixel,
               sceneCost.readsPerPixel);
    fmt::print("A pass's texture reads count by its output's share of the frame's pixels: at half resolution "
               "by a quarter.\n");
}

struct Instance {
    VkInstance handle = VK_NULL_HANDLE;
    Instance() {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_3;
        VkInstanceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        info.pApplicationInfo = &application;
        if (vkCreateInstance(&info, nullptr, &handle) != VK_SUCCESS) handle = VK_NULL_HANDLE;
    }
    ~Instance() {
        if (handle) vkDestroyInstance(handle, nullptr);
    }
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
};

Picture greyPicture(Size size, const std::vector<float>& values) {
    Picture picture{size.width, size.height, {}};
    for (float value : values)
        picture.rgb.insert(picture.rgb.end(), 3, value);
    return picture;
}

Picture castPicture(const RenderOptions& options, const scenes::Scene& scene, Size size) {
    if (options.show != "occlusion" && options.show != "sun")
        throw std::runtime_error(fmt::format("--show {} is not one of colour, occlusion, sun", options.show));
    RayTruth truth(scene);
    const PixelGrid grid{size.width, size.height};
    Progress progress(1.0);
    const auto onPart = [&](double part) { progress.step(part, scene.name + ", " + options.show); };
    const auto values =
        options.show == "sun"
            ? truth.sun(options.frame, grid, {.rays = options.rays}, onPart).visibility
            : truth.occlusion(options.frame, grid, {.radius = options.radius, .rays = options.rays}, onPart);
    progress.finish();
    return greyPicture(size, values);
}

Picture renderedPicture(const RenderOptions& options, const scenes::Scene& scene, Size size) {
    harness::Gpu gpu({.device = options.device});
    scenes::Renderer renderer(gpu, scene, size.width, size.height);
    if (options.truth) return {size.width, size.height, renderer.groundTruth(options.frame, 64)};
    auto frames =
        renderFrames(gpu, renderer, static_cast<uint32_t>(options.frame), 1, reprise::JitterSequence::none);
    return displayPicture(gpu, frames.front().colour);
}

} // namespace

reprise::FramePlan makeFramePlan(Shaders& shaders, const reprise::SceneNeeds& needs,
                                 const reprise::Settings& settings, Size size) {
    auto plan = reprise::plan(shaders.pack().passes(), shaders.pack().presets("temporal_aa"), needs, settings,
                              {size.width, size.height});
    if (!plan) throw std::runtime_error(plan.error().message);
    return std::move(*plan);
}

reprise::FramePlan planFor(Shaders& shaders, const reprise::SceneNeeds& needs, const PlanOptions& options) {
    reprise::Settings settings = settingsOf(options);
    settings.cache = options.cache;
    settings.cache.occlusion = options.occlusion;
    settings.cache.packing = options.packing;
    const uint32_t usual = defaultSamples(shaders, options.occlusion);
    settings.cache.samples = options.samples ? options.samples : usual;
    return makeFramePlan(shaders, needs, settings, parseSize(options.size));
}

reprise::FramePlan planOfEverything(Shaders& shaders, const PlanOptions& options) {
    reprise::SceneNeeds needs;
    needs.skinnedMeshes = needs.fastMotion = needs.ambientOcclusion = needs.sunShadows = true;
    needs.normals = needs.combinesLighting = needs.otherLight = true;
    return makeFramePlan(shaders, needs, settingsOf(options), parseSize(options.size));
}

PlanCost costOf(Shaders& shaders, const reprise::FramePlan& plan, Size size) {
    PlanCost cost;
    std::set<std::string> counted;
    const auto count = [&](const std::string& file, const std::vector<uint32_t>& words) {
        if (counted.insert(file).second) cost.spirvBytes += words.size() * sizeof(uint32_t);
    };
    for (const auto& planned : plan.passes)
        for (Stage stage : stagesOf(planned)) {
            const auto& compiled = shaders.get(planned.variant, stage);
            count(reprise::spirvFileName(planned.variant, stage), compiled.spirv);
            cost.readsPerPixel += shareOfFrame(plan, planned, size) *
                                  readsPerPixel(planned.variant, stage, compiled.reflection);
            if (stage == Stage::fragment && planned.variant.pass->fullscreen)
                count("fullscreen", shaders.fullscreenVertex());
        }
    return cost;
}

std::vector<std::string> deviceLines() {
    const Instance instance;
    if (!instance.handle) return {"none: no Vulkan driver was found"};
    uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance.handle, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    vkEnumeratePhysicalDevices(instance.handle, &count, devices.data());
    std::vector<std::string> lines;
    for (uint32_t i = 0; i < count; ++i) {
        VkPhysicalDeviceProperties p{};
        vkGetPhysicalDeviceProperties(devices[i], &p);
        lines.push_back(fmt::format("{}: {}, Vulkan {}.{}", i, p.deviceName,
                                    VK_API_VERSION_MAJOR(p.apiVersion), VK_API_VERSION_MINOR(p.apiVersion)));
    }
    return lines;
}

void listCommand() {
    Shaders shaders(findAssets());
    fmt::print("Passes (* default):\n");
    for (const auto& pass : shaders.pack().passes())
        printPass(shaders.pack(), pass);
    fmt::print("Scenes:\n");
    for (const scenes::Scene& scene : scenes::allScenes())
        fmt::print("  {}: {}\n", scene.name, scene.shows);
    fmt::print("Devices:\n");
    for (const std::string& line : deviceLines())
        fmt::print("  {}\n", line);
}

void planCommand(const PlanOptions& options) {
    Shaders shaders(findAssets());
    const Size size = parseSize(options.size);
    const reprise::FramePlan all = planOfEverything(shaders, options);
    const reprise::FramePlan scene = planFor(shaders, options.needs, options);
    printPlan(scene);
    fmt::print("\n");
    printCosts(all, costOf(shaders, all, size), scene, costOf(shaders, scene, size));
}

void renderCommand(const RenderOptions& options) {
    if (options.frame < 0) throw std::runtime_error("--frame must be 0 or more");
    const Size size = parseSize(options.size);
    const scenes::Scene scene = findScene(options.scene);
    printNotes(scene);
    const Picture picture =
        options.show == "colour" ? renderedPicture(options, scene, size) : castPicture(options, scene, size);
    const auto png = pngOf(picture);
    writeFile(options.out, {reinterpret_cast<const char*>(png.data()), png.size()});
}

} // namespace report
