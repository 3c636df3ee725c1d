// SPDX-License-Identifier: Apache-2.0
#include "context.hpp"

#include <algorithm>

namespace harness {

struct PassRunner::State {
    State(Gpu& owner, reprise::PassPipeline made) : gpu(owner), pipeline(std::move(made)) {}

    Gpu& gpu;
    reprise::PassPipeline pipeline;
};

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
    reprise::FrameArena& arena = state_->gpu.arena();
    if (auto recorded = pass.record(commands, arena, named, buffers, parameters); !recorded)
        throw std::runtime_error(recorded.error().message);
}

} // namespace harness
