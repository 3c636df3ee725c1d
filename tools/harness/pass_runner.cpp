// SPDX-License-Identifier: Apache-2.0
#include "context.hpp"

#include <algorithm>

namespace harness {

struct PassRunner::State {
    State(Gpu& owner, reprise::PassPipeline made) : gpu(owner), pipeline(std::move(made)) {}

    Gpu& gpu;
    reprise::PassPipeline pipeline;
    // Arenas of doubling size: a submission may record the pass any number of times.
    std::vector<reprise::FrameArena> arenas;
    size_t current = 0;
    uint32_t recordsLeft = 0;
    uint64_t submission = 0;
};

namespace {

constexpr uint32_t firstArenaRecords = 64;

void orThrow(const reprise::Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().message);
}

uint32_t recordsOf(size_t arena) {
    return firstArenaRecords << arena;
}

} // namespace

PassRunner::PassRunner(Gpu& gpu, const reprise::Variant& variant, reprise::Stage stage,
                       std::span<const uint32_t> spirv, std::span<const uint32_t> fullscreenVertex,
                       std::span<const VkFormat> outputFormats) {
    auto pipeline =
        reprise::PassPipeline::create(gpu.device(), variant, stage, spirv, fullscreenVertex, outputFormats);
    if (!pipeline) throw std::runtime_error(pipeline.error().message);
    state_ = std::make_shared<State>(gpu, std::move(*pipeline));
}

const reprise::PassPipeline& PassRunner::pipeline() const {
    return state_->pipeline;
}

reprise::FrameArena& PassRunner::arena() {
    State& state = *state_;
    const bool freshSubmission = state.submission != state.gpu.submissions() || state.arenas.empty();
    if (!freshSubmission && state.recordsLeft > 0) {
        --state.recordsLeft;
        return state.arenas[state.current];
    }
    state.current = freshSubmission ? 0 : state.current + 1;
    const uint32_t records = recordsOf(state.current);
    if (state.current == state.arenas.size()) {
        const uint32_t bytes = records * state.pipeline.variant().pass->parameterBytes;
        auto made = reprise::FrameArena::create(state.gpu.device(), 1, records, bytes);
        if (!made) throw std::runtime_error(made.error().message);
        state.arenas.push_back(std::move(*made));
    }
    orThrow(state.arenas[state.current].begin(0));
    state.submission = state.gpu.submissions();
    state.recordsLeft = records - 1;
    return state.arenas[state.current];
}

void PassRunner::record(VkCommandBuffer commands, std::span<const Binding> images,
                        std::span<const std::byte> parameters,
                        std::span<const reprise::NamedBuffer> buffers) {
    const reprise::PassPipeline& pass = state_->pipeline;
    const reprise::ImageState& written =
        pass.stage() == reprise::Stage::fragment ? reprise::attachmentState : reprise::storageState;
    const auto outputs = pass.variant().pass->outputs;
    std::vector<Gpu::Use> uses;
    std::vector<reprise::NamedImage> named;
    for (const Binding& binding : images) {
        const auto isOutput =
            std::any_of(outputs.begin(), outputs.end(),
                        [&](const reprise::ImageInfo& info) { return info.name == binding.name; });
        uses.push_back({binding.image, isOutput ? written : reprise::sampledState});
        named.push_back({binding.name, binding.image->ref});
    }
    state_->gpu.use(commands, uses);
    orThrow(pass.record(commands, arena(), named, buffers, parameters));
}

} // namespace harness
