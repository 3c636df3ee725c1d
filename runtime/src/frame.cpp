// SPDX-License-Identifier: Apache-2.0
// A frame is prepared as a whole, then recorded: what can fail comes before the first command.
#include "reprise/frame.hpp"

#include "frame_images.hpp"
#include "frame_parameters.hpp"
#include "object_velocity.hpp"
#include "pass_access.hpp"
#include "plan_images.hpp"
#include "plan_switches.hpp"
#include "reprise/format.hpp"

#include <algorithm>

namespace reprise {
namespace {

// The pipeline of one planned pass.
struct Step {
    std::optional<PassPipeline> fullscreen;
    std::optional<ObjectPipeline> objects;
};

struct Slot {
    std::optional<FrameArena> arena;
    uint32_t records = 0;
};

struct Recorder {
    Device device;
    SceneNeeds needs;
    VkFormat colourFormat = VK_FORMAT_UNDEFINED, depthFormat = VK_FORMAT_UNDEFINED;
    FramePlan plan;
    std::vector<Step> steps;
    std::vector<Slot> slots; // one a frame in flight
    FrameImages images;
    bool imagesAreNew = true, resized = false;
    uint64_t recorded = 0;      // calls that succeeded
    uint64_t lastFrame = 0;     // of the last of them
    uint64_t historyFrames = 0; // since the last reset
    TaaTuning tuning;           // of the preset
    CameraFrame lastCamera;
};

struct PreparedStep {
    PreparedPass pass;
    std::vector<PreparedDraw> draws;
};

// --- Creation

Result<Step> makeStep(const Recorder& recorder, const PlannedPass& planned, std::span<const PassInfo> passes,
                      const SpirvSource& spirv) {
    std::vector<VkFormat> formats;
    for (const int image : planned.writeImages)
        formats.push_back(*formatByName(recorder.plan.images[static_cast<size_t>(image)].format));
    Step step;
    if (!planned.variant.pass->fullscreen) {
        auto made = makeObjectPipeline(recorder.device, planned.variant, spirv,
                                       {formats.front(), recorder.depthFormat, recorder.needs.reversedDepth});
        if (!made) return made.error();
        step.objects = std::move(*made);
        return step;
    }
    auto words = spirv(planned.variant, planned.stage);
    if (!words) return words.error();
    std::vector<uint32_t> triangle;
    if (planned.stage == Stage::fragment) {
        auto variant = makeVariant(passes, "fullscreen");
        if (!variant) return variant.error();
        auto loaded = spirv(*variant, Stage::vertex);
        if (!loaded) return loaded.error();
        triangle = std::move(*loaded);
    }
    auto made =
        PassPipeline::create(recorder.device, planned.variant, planned.stage, *words, triangle, formats);
    if (!made) return made.error();
    step.fullscreen = std::move(*made);
    return step;
}

Result<FramePlan> planFor(const Device& device, std::span<const PassInfo> passes,
                          const FrameRecorder::CreateInfo& info) {
    const std::string_view format = formatName(info.colourFormat);
    if (!formatByName(format))
        return Error{ErrorCode::unsupportedFormat, "The runtime does not know VkFormat " +
                                                       std::to_string(static_cast<int>(info.colourFormat)) +
                                                       " for history; choose one of reprise/format.hpp."};
    Settings settings = info.settings;
    settings.colourFormat = format;
    settings.quadOperations = device.quadOperations;
    auto made = plan(passes, packPresets(temporalPass), info.needs, settings, info.extent);
    if (made && made->passes.empty())
        return Error{ErrorCode::invalidArgument,
                     "SceneNeeds asks for nothing, so that there is no pass to record; set antiAliasing or "
                     "ambientOcclusion."};
    return made;
}

Result<Recorder> makeRecorder(const Device& device, std::span<const PassInfo> passes,
                              const SpirvSource& spirv, const FrameRecorder::CreateInfo& info) {
    if (info.framesInFlight == 0)
        return Error{ErrorCode::invalidArgument, "CreateInfo::framesInFlight must be at least 1."};
    auto planned = planFor(device, passes, info);
    if (!planned) return planned.error();
    Recorder recorder;
    recorder.device = device;
    recorder.needs = info.needs;
    recorder.colourFormat = info.colourFormat;
    recorder.depthFormat = info.depthFormat;
    recorder.plan = std::move(*planned);
    const auto presets = packPresets(temporalPass);
    const auto preset = std::ranges::find(presets, info.settings.preset, &PresetInfo::name);
    if (preset != presets.end()) recorder.tuning = tuningOf(*preset);
    recorder.slots.resize(info.framesInFlight);
    auto images = makeFrameImages(device, recorder.plan);
    if (!images) return images.error();
    recorder.images = std::move(*images);
    for (const PlannedPass& pass : recorder.plan.passes) {
        auto step = makeStep(recorder, pass, passes, spirv);
        if (!step) return step.error();
        recorder.steps.push_back(std::move(*step));
    }
    return recorder;
}

// --- Checks of a frame's input

struct External {
    std::string_view name, field;
    const ImageRef* image;
};

std::array<External, 9> externals(const FrameInput& input) {
    const auto given = [](const std::optional<ImageRef>& image) { return image ? &*image : nullptr; };
    return {{{"gInColour", "FrameInput::colour", &input.colour},
             {"gInDepth", "FrameInput::depth", &input.depth},
             {"gInVelocity", "FrameInput::motion", given(input.motion)},
             {"gInFresh", "FrameInput::fresh", given(input.fresh)},
             {"gInShadowMap", "FrameInput::shadowMap", given(input.shadowMap)},
             {"gInNormal", "FrameInput::normal", given(input.normal)},
             {"gInAmbientLight", "FrameInput::ambientLight", given(input.ambientLight)},
             {"gInSunLight", "FrameInput::sunLight", given(input.sunLight)},
             {"gInOtherLight", "FrameInput::otherLight", given(input.otherLight)}}};
}

const ImageRef* externalImage(const FrameInput& input, std::string_view name) {
    for (const External& external : externals(input))
        if (external.name == name) return external.image;
    return nullptr;
}

Result<void> checkImage(const ImageRef* image, std::string_view field, VkExtent2D extent) {
    if (image == nullptr || image->view == VK_NULL_HANDLE)
        return Error{ErrorCode::missingInput,
                     "The plan needs " + std::string(field) + ", which was not given."};
    const auto text = [](VkExtent2D e) { return std::to_string(e.width) + "x" + std::to_string(e.height); };
    if (image->extent.width == 0 || image->extent.height == 0)
        return Error{ErrorCode::zeroExtent,
                     std::string(field) + " has no texels; give it a width and a height."};
    if (image->extent.width == extent.width && image->extent.height == extent.height) return {};
    return Error{ErrorCode::invalidArgument, std::string(field) + " is " + text(image->extent) +
                                                 ", but the recorder takes " + text(extent) +
                                                 "; call resize()."};
}

VkExtent2D outputExtent(const Recorder& recorder) {
    const auto image = static_cast<size_t>(recorder.plan.passes.back().writeImages.back());
    return recorder.images.images[image][0].ref.extent;
}

Result<void> checkObjects(const Recorder& recorder, const FrameInput& input) {
    if (input.movingObjects.empty() || recorder.needs.engineWritesMotion) return {};
    if (!recorder.needs.objectsMove)
        return Error{
            ErrorCode::invalidArgument,
            "Moving objects were given, but the recorder was made with SceneNeeds::objectsMove off."};
    for (const ObjectDraw& object : input.movingObjects)
        if (object.palette != VK_NULL_HANDLE && !recorder.needs.skinnedMeshes)
            return Error{ErrorCode::invalidArgument,
                         "A moving object has a palette, but the recorder was made with "
                         "SceneNeeds::skinnedMeshes off."};
    const ImageRef* depth = input.depthAttachment ? &*input.depthAttachment : nullptr;
    auto checked = checkImage(depth, "FrameInput::depthAttachment", outputExtent(recorder));
    if (checked && depth->format != recorder.depthFormat)
        return Error{ErrorCode::invalidArgument,
                     "FrameInput::depthAttachment is not of the format in CreateInfo::depthFormat."};
    return checked;
}

Result<void> checkExternal(const Recorder& recorder, int index, const External& external) {
    const PlannedImage& planned = recorder.plan.images[static_cast<size_t>(index)];
    const bool ownExtent = planned.extent.width == 0 && external.image != nullptr;
    auto checked = checkImage(external.image, external.field,
                              ownExtent ? external.image->extent
                                        : VkExtent2D{planned.extent.width, planned.extent.height});
    if (!checked) return checked;
    return checkFormat(recorder.device, external.image->format, readFeatures(recorder.plan, index),
                       external.field);
}

Result<void> checkInput(const Recorder& recorder, const FrameInput& input) {
    for (size_t i = 0; i < recorder.plan.images.size(); ++i)
        for (const External& external : externals(input))
            if (recorder.plan.images[i].external && recorder.plan.images[i].name == external.name)
                if (auto checked = checkExternal(recorder, static_cast<int>(i), external); !checked)
                    return checked;
    const uint32_t cascades = recorder.plan.cache.cascades;
    if (recorder.needs.sunShadows && input.cascades.size() != cascades)
        return Error{ErrorCode::invalidArgument,
                     "FrameInput::cascades has " + std::to_string(input.cascades.size()) +
                         " entries, but CacheSettings::cascades is " + std::to_string(cascades) +
                         "; give one for each column."};
    return checkObjects(recorder, input);
}

std::string_view resetReason(const Recorder& recorder, const FrameInput& input) {
    if (recorder.recorded == 0) return "first frame";
    if (recorder.resized) return "resize";
    if (input.resetHistory) return "request";
    return input.frameIndex == recorder.lastFrame + 1 ? "" : "frame gap";
}

// --- Images of this frame

size_t writtenCopy(const Recorder& recorder, size_t image) {
    return recorder.plan.images[image].history ? recorder.recorded % 2 : 0;
}

bool readsHistory(const PassInfo& pass, std::string_view input) {
    const auto found = std::ranges::find(pass.inputs, input, &ImageInfo::name);
    return found != pass.inputs.end() && isHistory(*found);
}

// An image that the runtime owns, one of its copies.
struct Place {
    size_t image = 0, copy = 0;
};

Place readPlace(const Recorder& recorder, const PlannedPass& pass, size_t read) {
    const auto image = static_cast<size_t>(pass.readImages[read]);
    const size_t written = writtenCopy(recorder, image);
    return {image, readsHistory(*pass.variant.pass, pass.reads[read]) ? 1 - written : written};
}

Place writePlace(const Recorder& recorder, int image) {
    const auto index = static_cast<size_t>(image);
    return {index, writtenCopy(recorder, index)};
}

const ImageRef& refOf(const Recorder& recorder, Place place) {
    return recorder.images.images[place.image][place.copy].ref;
}

std::vector<NamedImage> imagesOf(const Recorder& recorder, const PlannedPass& pass, const FrameInput& input) {
    std::vector<NamedImage> images;
    for (size_t i = 0; i < pass.reads.size(); ++i) {
        if (pass.readImages[i] < 0) continue;
        const Place place = readPlace(recorder, pass, i);
        const PlannedImage& planned = recorder.plan.images[place.image];
        images.push_back(
            {pass.reads[i], planned.external ? *externalImage(input, planned.name) : refOf(recorder, place)});
    }
    for (size_t i = 0; i < pass.writes.size(); ++i)
        images.push_back({pass.writes[i], refOf(recorder, writePlace(recorder, pass.writeImages[i]))});
    return images;
}

// --- Preparation

// The slot's arena, with room for every pass and every object of this frame. Its last use is over.
Result<FrameArena*> beginArena(Recorder& recorder, size_t objects) {
    Slot& slot = recorder.slots[recorder.recorded % recorder.slots.size()];
    const auto needed = static_cast<uint32_t>(recorder.steps.size() + objects);
    if (slot.records < needed) {
        uint32_t largest = 0;
        for (const PlannedPass& pass : recorder.plan.passes)
            largest = std::max(largest, pass.variant.pass->parameterBytes);
        const uint32_t records = std::max(needed, 2 * slot.records);
        auto arena = FrameArena::create(recorder.device, 1, records, records * largest);
        if (!arena) return arena.error();
        slot.arena = std::move(*arena);
        slot.records = records;
    }
    if (auto begun = slot.arena->begin(0); !begun) return begun.error();
    return &*slot.arena;
}

// A frame in preparation.
struct Frame {
    const FrameInput& input;
    CameraFrame previous;
    uint64_t historyFrames = 0;
    VkExtent2D extent{};
};

Result<PreparedPass> preparePass(const Recorder& recorder, size_t step, FrameArena& arena,
                                 const FrameInput& input, std::span<const std::byte> parameters) {
    const auto images = imagesOf(recorder, recorder.plan.passes[step], input);
    return PassAccess::prepare(*recorder.steps[step].fullscreen, arena, {images, {}, parameters});
}

Result<PreparedPass> prepareFullscreen(const Recorder& recorder, size_t index, FrameArena& arena,
                                       const Frame& frame) {
    const PlannedPass& planned = recorder.plan.passes[index];
    const std::string_view name = planned.variant.pass->name;
    const auto prepare = [&](const auto& parameters) {
        return preparePass(recorder, index, arena, frame.input, std::as_bytes(std::span(&parameters, 1)));
    };
    const SceneNeeds& needs = recorder.needs;
    if (name == temporalPass)
        return prepare(temporalParameters(frame.input, frame.previous,
                                          frame.input.tuning.value_or(recorder.tuning), frame.extent,
                                          frame.historyFrames, needs.engineWritesMotion));
    if (name == "camera_velocity")
        return prepare(cameraParameters(frame.input, frame.previous, frame.extent, needs.linearDepth));
    const CacheFrame cache{frame.previous,          frame.extent,        recorder.plan.cache,
                           frame.historyFrames > 0, needs.reversedDepth, needs.linearDepth,
                           needs.engineWritesMotion};
    const auto parameters = cacheParameters(planned, frame.input, cache);
    if (!parameters) return parameters.error();
    return preparePass(recorder, index, arena, frame.input, *parameters);
}

Result<PreparedStep> prepareStep(const Recorder& recorder, size_t index, FrameArena& arena,
                                 const Frame& frame) {
    PreparedStep prepared;
    const Step& step = recorder.steps[index];
    if (step.objects) {
        auto draws =
            prepareDraws(recorder.device, *step.objects, arena, frame.input, frame.previous, frame.extent);
        if (!draws) return draws.error();
        prepared.draws = std::move(*draws);
        return prepared;
    }
    auto pass = prepareFullscreen(recorder, index, arena, frame);
    if (!pass) return pass.error();
    prepared.pass = std::move(*pass);
    return prepared;
}

// --- Recording

const ImageState clearState{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                            VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

// Content does not matter, but earlier reads, the engine's copies among them, must be over.
const ImageState discardedState{sampledState.stage | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE,
                                VK_IMAGE_LAYOUT_UNDEFINED};

// Knows the state of every image within the frame and gathers the transitions before each pass.
class Tracker {
public:
    Tracker(const Recorder& recorder, VkCommandBuffer commands) : recorder_(recorder), commands_(commands) {
        for (size_t i = 0; i < recorder.plan.images.size(); ++i) {
            const size_t written = writtenCopy(recorder, i);
            states_.push_back({discardedState, discardedState});
            if (!recorder.imagesAreNew) states_[i][1 - written] = sampledState;
        }
    }

    void need(Place place, const ImageState& to) {
        if (recorder_.plan.images[place.image].external) return;
        ImageState& state = states_[place.image][place.copy];
        if (&to == &sampledState && state.layout == sampledState.layout) return;
        pending_.push_back({refOf(recorder_, place), state, to});
        state = to;
    }

    void flush() {
        transition(recorder_.device, commands_, pending_);
        pending_.clear();
    }

    // What the engine is handed: everything that was written, ready to be sampled.
    void finish() {
        for (size_t i = 0; i < states_.size(); ++i)
            need({i, writtenCopy(recorder_, i)}, sampledState);
        flush();
    }

private:
    const Recorder& recorder_;
    VkCommandBuffer commands_;
    std::vector<std::array<ImageState, 2>> states_;
    std::vector<ImageTransition> pending_;
};

void clearImages(const Recorder& recorder, VkCommandBuffer commands, Tracker& tracker, int pass) {
    for (size_t i = 0; i < recorder.plan.images.size(); ++i) {
        if (!recorder.plan.images[i].cleared || recorder.plan.images[i].firstPass != pass) continue;
        const Place place = writePlace(recorder, static_cast<int>(i));
        tracker.need(place, clearState);
        tracker.flush();
        const VkClearColorValue zero{};
        const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        recorder.device.vk->CmdClearColorImage(commands, refOf(recorder, place).image, clearState.layout,
                                               &zero, 1, &range);
    }
}

void emitStep(const Recorder& recorder, size_t index, VkCommandBuffer commands, const PreparedStep& prepared,
              const FrameInput& input, Tracker& tracker) {
    clearImages(recorder, commands, tracker, static_cast<int>(index));
    const PlannedPass& pass = recorder.plan.passes[index];
    const Step& step = recorder.steps[index];
    if (step.objects && prepared.draws.empty()) return;
    for (size_t i = 0; i < pass.reads.size(); ++i)
        if (pass.readImages[i] >= 0) tracker.need(readPlace(recorder, pass, i), sampledState);
    const ImageState& written = pass.stage == Stage::compute ? storageState : attachmentState;
    for (const int image : pass.writeImages)
        tracker.need(writePlace(recorder, image), written);
    tracker.flush();
    if (step.objects)
        emitDraws(recorder.device, *step.objects, commands, prepared.draws,
                  refOf(recorder, writePlace(recorder, pass.writeImages.front())), *input.depthAttachment);
    else
        PassAccess::emit(*step.fullscreen, commands, prepared.pass);
}

FrameOutput outputOf(const Recorder& recorder, const FrameInput& input, std::string_view reason) {
    FrameOutput output;
    const PlannedPass& last = recorder.plan.passes.back();
    // In table order the last output of the last pass is the one to show.
    if (last.variant.pass->name == temporalPass)
        output.colour = refOf(recorder, writePlace(recorder, last.writeImages.back()));
    const auto owned = [&](std::string_view name) -> std::optional<ImageRef> {
        const auto found = std::ranges::find(recorder.plan.images, name, &PlannedImage::name);
        if (found == recorder.plan.images.end()) return {};
        return refOf(recorder, writePlace(recorder, static_cast<int>(found - recorder.plan.images.begin())));
    };
    output.motion = owned(velocityImage);
    if (!output.motion) output.motion = input.motion;
    if (cachesAnything(recorder.needs))
        for (const std::string& name : lightingImages(recorder.plan.cache))
            if (!output.lighting) output.lighting = owned(name);
    output.lit = owned("gOutLit");
    output.historyWasReset = !reason.empty();
    output.resetReason = reason;
    return output;
}

Result<FrameOutput> recordFrame(Recorder& recorder, VkCommandBuffer commands, const FrameInput& input) {
    if (auto checked = checkInput(recorder, input); !checked) return checked.error();
    const std::string_view reason = resetReason(recorder, input);
    const Frame frame{input, reason.empty() ? recorder.lastCamera : input.camera,
                      reason.empty() ? recorder.historyFrames : 0, outputExtent(recorder)};
    auto arena = beginArena(recorder, input.movingObjects.size());
    if (!arena) return arena.error();
    std::vector<PreparedStep> prepared;
    for (size_t step = 0; step < recorder.steps.size(); ++step) {
        auto made = prepareStep(recorder, step, **arena, frame);
        if (!made) return made.error();
        prepared.push_back(std::move(*made));
    }
    Tracker tracker(recorder, commands);
    for (size_t step = 0; step < prepared.size(); ++step)
        emitStep(recorder, step, commands, prepared[step], input, tracker);
    tracker.finish();
    const FrameOutput output = outputOf(recorder, input, reason);
    ++recorder.recorded;
    recorder.lastFrame = input.frameIndex;
    recorder.lastCamera = input.camera;
    recorder.historyFrames = frame.historyFrames + 1;
    recorder.imagesAreNew = recorder.resized = false;
    return output;
}

Result<void> resizeImages(Recorder& recorder, Extent extent) {
    if (extent.width == 0 || extent.height == 0)
        return Error{ErrorCode::zeroExtent,
                     "The new extent is zero; keep the old one until the window has a width and a height."};
    FramePlan plan = recorder.plan;
    planImages(plan, recorder.needs.engineWritesMotion, formatName(recorder.colourFormat), extent);
    auto images = makeFrameImages(recorder.device, plan);
    if (!images) return images.error();
    recorder.plan = std::move(plan);
    recorder.images = std::move(*images);
    recorder.imagesAreNew = recorder.resized = true;
    return {};
}

} // namespace

struct FrameRecorder::State : Recorder {};

FrameRecorder::FrameRecorder(std::unique_ptr<State> state) : state_(std::move(state)) {}
FrameRecorder::FrameRecorder(FrameRecorder&&) noexcept = default;
FrameRecorder& FrameRecorder::operator=(FrameRecorder&&) noexcept = default;
FrameRecorder::~FrameRecorder() = default;

const FramePlan& FrameRecorder::plan() const {
    return state_->plan;
}

Result<FrameRecorder> FrameRecorder::create(const Device& device, std::span<const PassInfo> passes,
                                            const SpirvSource& spirv, const CreateInfo& info) {
    return guarded([&]() -> Result<FrameRecorder> {
        auto recorder = makeRecorder(device, passes, spirv, info);
        if (!recorder) return recorder.error();
        return FrameRecorder(std::make_unique<State>(State{std::move(*recorder)}));
    });
}

Result<void> FrameRecorder::resize(Extent extent) {
    return guarded([&] { return resizeImages(*state_, extent); });
}

Result<FrameOutput> FrameRecorder::record(VkCommandBuffer commands, const FrameInput& input) {
    return guarded([&] { return recordFrame(*state_, commands, input); });
}

} // namespace reprise
