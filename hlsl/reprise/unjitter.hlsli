// SPDX-License-Identifier: Apache-2.0
// The current colour at the unjittered pixel centre, from the 3x3 already read. INSIDE, c_in' of the final
// blend.
#ifndef REPRISE_UNJITTER_HLSLI
#define REPRISE_UNJITTER_HLSLI

#include "reprise/neighbourhood.hlsli"

// Weights of the texels at -1, 0 and +1 along one axis when the image is moved by jitterPx in [-0.5, 0.5].
// The bilinear filter: what sampling at uv + jitter would give.
float3 unjitterWeightsBilinear(float jitterPx) {
    return float3(max(-jitterPx, 0.0), 1.0 - abs(jitterPx), max(jitterPx, 0.0));
}

// A Gaussian of UNJITTER_SIGMA_PX around the pixel centre: it also weighs the samples that fell into
// neighbours. A jitter of more than a pixel, which no sequence has, counts as one: farther out all three
// weights would be 0, and their quotient NaN.
static const float UNJITTER_SIGMA_PX = 0.47;
float3 unjitterWeightsGaussian(float jitterPx) {
    float3 distancePx = float3(-1.0, 0.0, 1.0) - clamp(jitterPx, -1.0, 1.0);
    float3 weights = exp2(distancePx * distancePx * (-0.72134752 / (UNJITTER_SIGMA_PX * UNJITTER_SIGMA_PX)));
    return weights / (weights.x + weights.y + weights.z);
}

// Separable weights over the neighbourhood; x of each is the texel at -1 (left, up).
float3 weighNeighbourhood(Neighbourhood n, float3 weightsX, float3 weightsY) {
    return weightsY.x * (weightsX.x * n.leftUp + weightsX.y * n.up + weightsX.z * n.rightUp) +
           weightsY.y * (weightsX.x * n.left + weightsX.y * n.centre + weightsX.z * n.right) +
           weightsY.z * (weightsX.x * n.leftDown + weightsX.y * n.down + weightsX.z * n.rightDown);
}

#endif
