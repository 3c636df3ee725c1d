// SPDX-License-Identifier: Apache-2.0
// Renders a scene to what a temporal pass takes: lit HDR colour, device depth, normals, motion, IDs.
// Failures are std::runtime_error with one sentence, as the harness's.
#pragma once

#include "harness.hpp"
#include "reprise/frame.hpp"
#include "reprise/sun_shadow.hpp"
#include "scenes.hpp"

namespace scenes {

// Where scene.hlsl and its companions are. Without a call: ../share/reprise/scenes beside the program, then
// the source tree that it was built from.
void setShaderDirectory(std::filesystem::path directory);

struct FrameTargets {
    harness::Image colour;    // RGBA16F linear scene-referred; alpha 1
    harness::Image depth;     // R32F copy of device depth, what passes read
    harness::Image depthTest; // D32F
    harness::Image normal;    // RGBA16F world space
    harness::Image motion;    // RG16F UV, curr - prev, unjittered
    harness::Image ids;       // RG32UI instance, primitive (+1; 0 is sky)
};

// What sun_shadow takes of a frame.
struct ShadowMap {
    harness::Image* image; // D32F, standard depth, cascades side by side; of the frame rendered last
    std::vector<reprise::ShadowCascade> cascades;
    std::vector<double> texelMetres; // side of a texel of each cascade
};

class Renderer {
public:
    Renderer(harness::Gpu& gpu, const Scene& scene, uint32_t width, uint32_t height,
             DepthKind depth = DepthKind::standard);
    ~Renderer();
    FrameTargets targets() const; // new ones
    // Renders frame `frame` (time frame / framesPerSecond, previous is frame - 1 except at frame 0) with the
    // jitter. Leaves depthTest in DEPTH_READ_ONLY_OPTIMAL and the others in SHADER_READ_ONLY_OPTIMAL. At most
    // `framesInFlight` different frames may be recorded and not yet finished on the GPU.
    static constexpr uint32_t framesInFlight = 32;
    void render(VkCommandBuffer commands, int frame, glm::dvec2 jitterPx, FrameTargets& targets);
    // Display-referred ground truth: mean of displayColour() over `samples` (>= 64) jittered renderings of
    // the frame, stratified over the pixel's square. RGB float, rows top to bottom, display-linear in [0,1].
    std::vector<float> groundTruth(int frame, uint32_t samples);
    // Moving instances in view as the runtime's object velocity pass takes them. Valid until framesInFlight
    // other frames have been rendered. Alpha-tested ones are drawn whole by that pass.
    std::vector<reprise::ObjectDraw> movingObjects(int frame);
    // The cascades of a frame, and the renderer's one shadow map, which render() leaves in
    // SHADER_READ_ONLY_OPTIMAL and draws again for each frame.
    ShadowMap shadowMap(int frame);
    const Scene& scene() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// The tone curve of the report: Reinhard, x / (1 + x), per channel of linear scene-referred colour.
// The report's error is measured after it; the picture's sRGB encoding comes after that.
inline float displayColour(float linear) {
    return linear <= 0.0f ? 0.0f : linear / (1.0f + linear);
}

} // namespace scenes
