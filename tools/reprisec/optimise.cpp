// SPDX-License-Identifier: Apache-2.0
// SPIRV-Tools: the optimiser and the validator.
#include "internal.hpp"

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

namespace reprisec {

namespace {

constexpr spv_target_env environment = SPV_ENV_VULKAN_1_3;

spvtools::MessageConsumer collectInto(std::string& text) {
    return [&text](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
        if (level <= SPV_MSG_ERROR && text.empty()) text = message;
    };
}

void registerPasses(spvtools::Optimizer& optimizer) {
    // glslang's HLSL front end leaves textures in structs and parameters; legalising inlines them away and
    // unrolls the loops marked [unroll].
    optimizer.RegisterLegalizationPasses();
    optimizer.RegisterPerformancePasses();
    optimizer.RegisterPass(spvtools::CreateLoopUnrollPass(true));
    optimizer.RegisterPass(spvtools::CreateSimplificationPass());
    optimizer.RegisterPass(spvtools::CreateRedundancyEliminationPass());
    optimizer.RegisterPass(spvtools::CreateVectorDCEPass());
    optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
    optimizer.RegisterPass(spvtools::CreateDeadVariableEliminationPass());
    optimizer.RegisterPass(spvtools::CreateEliminateDeadConstantPass());
    optimizer.RegisterPass(spvtools::CreateRemoveDuplicatesPass());
    optimizer.RegisterPass(spvtools::CreateCompactIdsPass());
}

} // namespace

Result<Words> optimise(const Words& module) {
    spvtools::Optimizer optimizer(environment);
    std::string message;
    optimizer.SetMessageConsumer(collectInto(message));
    registerPasses(optimizer);
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // before legalisation the module need not be valid; afterwards we check
    Words result;
    if (!optimizer.Run(module.data(), module.size(), &result, options))
        return badShader("the SPIR-V optimiser failed: " + message);
    return result;
}

Result<void> validate(const Words& module) {
    spvtools::SpirvTools checker(environment);
    std::string message;
    checker.SetMessageConsumer(collectInto(message));
    if (!checker.Validate(module)) {
        if (const size_t end = message.find('\n'); end != std::string::npos) message.resize(end);
        return badShader("glslang made SPIR-V that is not valid (" + message +
                         "); the HLSL uses something its front end does not support");
    }
    return {};
}

} // namespace reprisec
