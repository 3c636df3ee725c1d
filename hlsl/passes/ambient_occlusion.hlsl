// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of the screen with few samples a frame, for the framework to accumulate. Drobot, 7.3,
// "Screen-Space Ambient Occlusion" (D8): occlusion checks that sample the depth buffer around the point.
//
// gInCoarseDepth   R32F, linear depth in metres of depth_downsample; SKY_DEPTH and beyond, and what is no
//                  depth, is sky
// gInNormal        NORMALS read: view space, towards the camera, of any length but 0; of the whole frame
// gOutOcclusion    RG16F: visibility in [0,1], 1 where nothing occludes and in the sky; linear depth, metres
//
// A sample is a point within gRadius over the surface, directions distributed as the cosine to the normal and
// distances as the root of a uniform number: a blocker at distance d counts 1 - (d / gRadius)^2 in the mean.
// It is occluded where the depth buffer lies in front of it, by gBias and not by more than twice the radius.

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection.hlsli"

BINDING(0) cbuffer AmbientOcclusionParameters {
    float4 gOutputSize;    // width, height, 1 / width, 1 / height
    float4 gViewRay;       // extent and origin of the view rays over this image, see viewPosition()
    float gRadius;         // metres, above 0
    float gFrameIndex;     // whole, see subsetOfFrame()
    float gSubsetCount;    // frames after which the pattern repeats, 1 to 16
    float2 gBias;          // metres, and metres per metre of depth, by which a surface must lie in front
    float2 gFrameToCoarse; // NORMALS read: frame / (ratio * coarse extent), of UV
};

TEXTURE_POINT(gInCoarseDepth, 1);
#if NORMALS_READ
TEXTURE_POINT(gInNormal, 2);
#endif

#if SAMPLES_1
static const int SAMPLE_COUNT = 1;
#elif SAMPLES_2
static const int SAMPLE_COUNT = 2;
#elif SAMPLES_4
static const int SAMPLE_COUNT = 4;
#elif SAMPLES_8
static const int SAMPLE_COUNT = 8;
#elif SAMPLES_12
static const int SAMPLE_COUNT = 12;
#elif SAMPLES_16
static const int SAMPLE_COUNT = 16;
#else
static const int SAMPLE_COUNT = 32;
#endif

// The additive sequence frac(1/2 + k SEQUENCE), k = 0, 1, ...: inverse powers of the root of x^4 = x + 1.
// Every run of it is spread evenly over the cube: the samples of a frame, and those of all frames together.
static const float3 SEQUENCE = float3(0.8191725134, 0.6710436067, 0.5497004779);
static const float TWO_PI = 6.2831853;

float knownDepth(float depth) {
    float positive = depth > 0.0 ? depth : SKY_DEPTH;
    return positive < SKY_DEPTH ? positive : SKY_DEPTH;
}

float readDepth(float2 uv) {
    return knownDepth(SAMPLE(gInCoarseDepth, uv).r);
}

#if !NORMALS_READ

// Depths at the texel and beside it.
struct DepthPlus {
    float centre, left, right, up, down;
};

DepthPlus readDepthPlus(float2 uv) {
    DepthPlus d;
#if HAS_GATHER
    float4 leftUp = GATHER_RED(gInCoarseDepth, uv - 0.5 * gOutputSize.zw);
    float4 rightDown = GATHER_RED(gInCoarseDepth, uv + 0.5 * gOutputSize.zw);
    d.centre = knownDepth(leftUp.y);
    d.left = knownDepth(leftUp.x);
    d.up = knownDepth(leftUp.z);
    d.right = knownDepth(rightDown.z);
    d.down = knownDepth(rightDown.x);
#else
    d.centre = readDepth(uv);
    d.left = readDepth(uv - float2(gOutputSize.z, 0.0));
    d.up = readDepth(uv - float2(0.0, gOutputSize.w));
    d.right = readDepth(uv + float2(gOutputSize.z, 0.0));
    d.down = readDepth(uv + float2(0.0, gOutputSize.w));
#endif
    return d;
}

// The way over the surface to the next texel along step, from the side whose depth is nearer to the centre's:
// the other one may lie on another surface. At a border of the image there is one side alone, and none in an
// image of one texel, which faces the camera.
float3 surfaceStep(float3 positionVS, float2 uv, float2 step, float before, float after) {
    float differenceBefore = isInsideUv(uv - step) ? abs(before - positionVS.z) : 2.0 * SKY_DEPTH;
    float differenceAfter = isInsideUv(uv + step) ? abs(after - positionVS.z) : SKY_DEPTH;
    return differenceBefore < differenceAfter ? positionVS - viewPosition(uv - step, before, gViewRay)
                                              : viewPosition(uv + step, after, gViewRay) - positionVS;
}

float3 reconstructedNormal(float3 positionVS, float2 uv, DepthPlus d) {
    float3 across = surfaceStep(positionVS, uv, float2(gOutputSize.z, 0.0), d.left, d.right);
    float3 down = surfaceStep(positionVS, uv, float2(0.0, gOutputSize.w), d.up, d.down);
    // Towards the camera, whichever way the rays run over the image.
    float3 normal = cross(across, down);
    return normalize(gViewRay.x * gViewRay.y < 0.0 ? normal : -normal);
}

#else

// Of one pixel of the texel: its centre lies on a corner of the frame's texels, and an eighth before it a
// texel is met for any ratio. A normal that is none faces the camera.
float3 readNormal(float2 uv) {
    float3 normal = SAMPLE(gInNormal, (uv - 0.125 * gOutputSize.zw) / gFrameToCoarse).xyz;
    float lengthSquared = dot(normal, normal);
    return lengthSquared > 1e-6 && lengthSquared < 1e6 ? normal * rsqrt(lengthSquared)
                                                       : float3(0.0, 0.0, -1.0);
}

#endif

// The 16 numbers k / 16 over 4x4 pixels, no two of a 2x2 closer than a quarter.
float pixelOffset(float2 pixel) {
    float2 fine = pixel - 2.0 * floor(0.5 * pixel);
    float2 coarse = floor(0.5 * pixel) - 2.0 * floor(0.25 * pixel);
    float2 both = 2.0 * abs(float2(fine.x - fine.y, coarse.x - coarse.y)) + float2(fine.y, coarse.y);
    return (4.0 * both.x + both.y) / 16.0;
}

struct Frame {
    float3 tangent, bitangent, normal;
};

Frame frameOf(float3 normal) {
    float side = normal.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + normal.z);
    float b = normal.x * normal.y * a;
    Frame frame;
    frame.tangent = float3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x);
    frame.bitangent = float3(b, side + normal.y * normal.y * a, -normal.y);
    frame.normal = normal;
    return frame;
}

float2 viewToUv(float3 positionVS) {
#if ORTHOGRAPHIC
    return (positionVS.xy - gViewRay.zw) / gViewRay.xy;
#else
    return (positionVS.xy / positionVS.z - gViewRay.zw) / gViewRay.xy;
#endif
}

// How far the sample is occluded, in [0,1], and 1; or 0 and 0 where the image knows nothing of its place.
float2 checkSample(float3 samplePositionVS, float bias) {
    float2 uv = viewToUv(samplePositionVS);
    bool isKnown = samplePositionVS.z > 0.0 && isInsideUv(uv);
    float inFront = samplePositionVS.z - readDepth(uv);
    float occluded = saturate(inFront / bias - 1.0) * saturate(2.0 - inFront / gRadius);
    return isKnown ? float2(occluded, 1.0) : float2(0.0, 0.0);
}

float visibilityAt(float3 positionVS, float3 normal, float2 positionPx) {
    float2 pixel = floor(positionPx);
    float subset = subsetOfFrame(gFrameIndex, gSubsetCount);
    float3 shift = subset * frac(float(SAMPLE_COUNT) * SEQUENCE);
    float turn = TWO_PI * (shift.x + pixelOffset(pixel));
    float2 turned = float2(cos(turn), sin(turn));
    float distanceShift = shift.z + pixelOffset(float2(pixel.y + 1.0, pixel.x));
    float bias = max(gBias.x + gBias.y * positionVS.z, 1e-6);
    Frame frame = frameOf(normal);

    float2 sum = float2(0.0, 0.0);
    [unroll] for (int tap = 0; tap < SAMPLE_COUNT; ++tap) {
        float3 own = frac(0.5 + float(tap) * SEQUENCE);
        float2 azimuth = float2(cos(TWO_PI * own.x), sin(TWO_PI * own.x));
        azimuth = float2(azimuth.x * turned.x - azimuth.y * turned.y,
                         azimuth.x * turned.y + azimuth.y * turned.x);
        float discRadiusSquared = frac(own.y + shift.y);
        float2 disc = sqrt(discRadiusSquared) * azimuth;
        float distance = gRadius * sqrt(frac(own.z + distanceShift));
        float3 direction = disc.x * frame.tangent + disc.y * frame.bitangent +
                           sqrt(1.0 - discRadiusSquared) * frame.normal;
        sum += checkSample(positionVS + distance * direction, bias);
    }
    return 1.0 - sum.x / max(sum.y, 1.0);
}

// Visibility and linear depth.
float2 ambientOcclusion(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
#if NORMALS_READ
    float depth = readDepth(uv);
    float3 positionVS = viewPosition(uv, depth, gViewRay);
    float3 normal = readNormal(uv);
#else
    DepthPlus depths = readDepthPlus(uv);
    float depth = depths.centre;
    float3 positionVS = viewPosition(uv, depth, gViewRay);
    float3 normal = reconstructedNormal(positionVS, uv, depths);
#endif
    float visibility = visibilityAt(positionVS, normal, positionPx);
    return depth < SKY_DEPTH ? float2(visibility, depth) : float2(1.0, SKY_DEPTH);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutOcclusion;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    gOutOcclusion[thread.xy] = float4(ambientOcclusion(float2(thread.xy) + 0.5), 0.0, 0.0);
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(ambientOcclusion(positionPx.xy), 0.0, 0.0);
}

#endif
