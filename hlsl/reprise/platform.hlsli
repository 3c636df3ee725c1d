// SPDX-License-Identifier: Apache-2.0
// One declaration of a texture for Direct3D 9, Direct3D 11 and Vulkan.
//
//   TEXTURE_POINT(gInDepth, 2)      a texture in slot 2 that is read with a point filter, clamped to its edge
//   TEXTURE_LINEAR(gInColour, 1)    the same with a bilinear filter
//   SAMPLE(gInColour, uv)           float4, mip level 0
//   SAMPLE_OFFSET(gInColour, uv, texelSize, x, y)   the same, moved by whole texels, constants in [-8, 7]
//   GATHER_RED(gInDepth, uv)        the four red values around uv: (0,1), (1,1), (1,0), (0,0); only where
//                                   HAS_GATHER
//   TEXTURE_PARAMETER(colour)       a texture as parameter of a function
//   TEXTURE_ARGUMENT(gInColour)     the texture at the call
//
// A Direct3D 9 sampler is texture and filter in one, so the filter belongs to the declaration everywhere: in
// Vulkan the sampler NAME_sampler has binding slot + 32, in Direct3D 11 register s of the same slot. The
// engine (or the runtime, from the table of passes) gives it the filter that the macro names.
#ifndef REPRISE_PLATFORM_HLSLI
#define REPRISE_PLATFORM_HLSLI

#if PLATFORM_D3D9

#define TEXTURE_POINT(name, slot) sampler2D name : register(s##slot)
#define TEXTURE_LINEAR(name, slot) sampler2D name : register(s##slot)
#define TEXTURE_PARAMETER(name) sampler2D name
#define TEXTURE_ARGUMENT(name) name
#define SAMPLE(name, uv) tex2Dlod(name, float4(uv, 0.0, 0.0))
#define SAMPLE_OFFSET(name, uv, texelSize, x, y) SAMPLE(name, (uv) + float2(x, y) * (texelSize))
#define HAS_GATHER 0

#elif PLATFORM_D3D11

#define TEXTURE_POINT(name, slot) \
    Texture2D<float4> name : register(t##slot); SamplerState name##_sampler : register(s##slot)
#define TEXTURE_LINEAR(name, slot) TEXTURE_POINT(name, slot)

#else

#define TEXTURE_POINT(name, slot) \
    [[vk::binding(slot)]] Texture2D<float4> name; [[vk::binding(slot + 32)]] SamplerState name##_sampler
#define TEXTURE_LINEAR(name, slot) TEXTURE_POINT(name, slot)

#endif

#if !PLATFORM_D3D9

#define TEXTURE_PARAMETER(name) Texture2D<float4> name, SamplerState name##_sampler
#define TEXTURE_ARGUMENT(name) name, name##_sampler
#define SAMPLE(name, uv) name.SampleLevel(name##_sampler, uv, 0.0)
#define SAMPLE_OFFSET(name, uv, texelSize, x, y) name.SampleLevel(name##_sampler, uv, 0.0, int2(x, y))
// The fragment form for ES is 3.00, which has no gather.
#if PLATFORM_GLES && !STAGE_COMPUTE
#define HAS_GATHER 0
#else
#define HAS_GATHER 1
#endif
#define GATHER_RED(name, uv) name.GatherRed(name##_sampler, uv)

#endif

#endif
