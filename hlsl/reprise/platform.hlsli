// SPDX-License-Identifier: Apache-2.0
// One text for Direct3D 9, Direct3D 11 and Vulkan: textures, and what else each spells in its own way.
//
//   TEXTURE_POINT(gInDepth, 2)      a texture in slot 2 that is read with a point filter, clamped to its edge
//   TEXTURE_LINEAR(gInColour, 1)    the same with a bilinear filter
//   SAMPLE(gInColour, uv)           float4, mip level 0
//   SAMPLE_OFFSET(gInColour, uv, texelSize, x, y)   the same, moved by whole texels, constants in [-8, 7]
//   LOAD(gInColour, px)             float4 of the texel px, int2 inside the image, without a filter; not D3D9
//   GATHER_RED(gInDepth, uv)        the four red values around uv: (0,1), (1,1), (1,0), (0,0); only where
//                                   HAS_GATHER; also GATHER_GREEN, GATHER_BLUE and GATHER_ALPHA
//   TEXTURE_PARAMETER(colour)       a texture as parameter of a function
//   TEXTURE_ARGUMENT(gInColour)     the texture at the call
//   PALETTE(gInJoints, Joint, 2)    structures that a vertex stage picks from by index, as binding 2
//   PALETTE_PARAMETER(joints, Joint)   the same as parameter of a function
//   BINDING(0), LOCATION(0), CONSTANT_ID(0)   Vulkan's numbers, before a declaration
//   POSITION_PX                     semantic of a fragment's position in pixels, centres at halves
//   TARGET_SIZE(gOutputSize);       width, height, 1 / width, 1 / height of the target, for halfPixelOffset()
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
// Of the 256 constant registers two palettes of 30 matrices leave 16 to the rest.
#define PALETTE(name, type, slot) type name[30]
#define PALETTE_PARAMETER(name, type) type name[30]
#define BINDING(number)
#define LOCATION(number)
#define CONSTANT_ID(number)

#elif PLATFORM_D3D11

#define TEXTURE_POINT(name, slot) \
    Texture2D<float4> name : register(t##slot); SamplerState name##_sampler : register(s##slot)
#define TEXTURE_LINEAR(name, slot) TEXTURE_POINT(name, slot)
#define BINDING(number)
#define LOCATION(number)
#define CONSTANT_ID(number)

#else

#define TEXTURE_POINT(name, slot) \
    [[vk::binding(slot)]] Texture2D<float4> name; [[vk::binding(slot + 32)]] SamplerState name##_sampler
#define TEXTURE_LINEAR(name, slot) TEXTURE_POINT(name, slot)
#define BINDING(number) [[vk::binding(number)]]
#define LOCATION(number) [[vk::location(number)]]
#define CONSTANT_ID(number) [[vk::constant_id(number)]]

#endif

#if !PLATFORM_D3D9

#define TEXTURE_PARAMETER(name) Texture2D<float4> name, SamplerState name##_sampler
#define TEXTURE_ARGUMENT(name) name, name##_sampler
#define SAMPLE(name, uv) name.SampleLevel(name##_sampler, uv, 0.0)
#define SAMPLE_OFFSET(name, uv, texelSize, x, y) name.SampleLevel(name##_sampler, uv, 0.0, int2(x, y))
#define LOAD(name, px) name.Load(int3(px, 0))
// The fragment form for ES is 3.00, which has no gather.
#if PLATFORM_GLES && !STAGE_COMPUTE
#define HAS_GATHER 0
#else
#define HAS_GATHER 1
#endif
#define GATHER_RED(name, uv) name.GatherRed(name##_sampler, uv)
#define GATHER_GREEN(name, uv) name.GatherGreen(name##_sampler, uv)
#define GATHER_BLUE(name, uv) name.GatherBlue(name##_sampler, uv)
#define GATHER_ALPHA(name, uv) name.GatherAlpha(name##_sampler, uv)
#define PALETTE(name, type, slot) BINDING(slot) StructuredBuffer<type> name
#define PALETTE_PARAMETER(name, type) StructuredBuffer<type> name

#endif

// --- Compute
// Outputs have the extent gOutputSize, and what a thread stores beyond it the image drops, on every platform.
// So none ends early, which costs a CPU driver up to a third of a pass.

// --- Rasterisation

#if PLATFORM_D3D9
// VPOS counts pixels, so its centres lie at whole numbers and it knows no offset: the vertex stage hands over
// the position instead, to be interpolated like every texture coordinate of the screen.
#define POSITION_PX TEXCOORD0
#define TARGET_SIZE(name) float4 name
#else
#define POSITION_PX SV_Position
#define TARGET_SIZE(name) static const float4 name = float4(0.0, 0.0, 0.0, 0.0)
#endif

#endif
