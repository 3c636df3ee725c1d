// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/platform.hlsli";

// A place within 0.4 of a texel of a centre, also outside of the image: a point filter has no choice there.
std::vector<Row> nearCentres(glm::ivec2 size) {
    Random random(1);
    std::vector<Row> rows;
    for (int y = -2; y < size.y + 2; ++y)
        for (int x = -2; x < size.x + 2; ++x) {
            const glm::vec2 place(static_cast<float>(x) + 0.5f + random.in(-0.4f, 0.4f),
                                  static_cast<float>(y) + 0.5f + random.in(-0.4f, 0.4f));
            rows.push_back({vec4(place / glm::vec2(size), 1.0f / glm::vec2(size))});
        }
    return rows;
}

Comparison pointRead(glm::ivec2 size) {
    const Texture texture{randomImage(size.x, size.y, 2), false};
    return {{"SAMPLE, point",
             {header},
             "out0 = SAMPLE(gTexture0, in0.xy);",
             1,
             1,
             {},
             reprise::Stage::compute,
             {texture}},
            nearCentres(size),
            [texture](const Row& in) {
                return std::vector{near(oracle::samplePoint(texture.image, xy(in[0])), 0.0)};
            }};
}

Comparison linearRead(glm::ivec2 size) {
    const Texture texture{randomImage(size.x, size.y, 3), true};
    std::vector<Row> rows = randomPlaces(size, 4);
    for (Row& row : rows)
        row.resize(1);
    return {{"SAMPLE, linear",
             {header},
             "out0 = SAMPLE(gTexture0, in0.xy);",
             1,
             1,
             {},
             reprise::Stage::compute,
             {texture}},
            rows,
            [texture](const Row& in) {
                // Texels are in [0, 1].
                return std::vector{near(oracle::sampleLinear(texture.image, xy(in[0])), 2.0 * filterStep)};
            }};
}

// (0,1), (1,1), (1,0), (0,0) of the four texels around a place that is clear of their borders.
Comparison gather(glm::ivec2 size) {
    const Texture texture{randomImage(size.x, size.y, 5), false};
    std::vector<Row> rows = nearCentres(size);
    for (Row& row : rows)
        row[0] += vec4(0.5f * row[0].z, 0.5f * row[0].w, 0.0f, 0.0f);
    return {{"GATHER_RED",
             {header},
             "out0 = GATHER_RED(gTexture0, in0.xy);",
             1,
             1,
             {},
             reprise::Stage::compute,
             {texture}},
            rows,
            [texture](const Row& in) {
                const dvec2 texel = dvec2(in[0].z, in[0].w), first = xy(in[0]) - 0.5 * texel;
                const auto red = [&](double x, double y) {
                    return oracle::samplePoint(texture.image, first + dvec2(x, y) * texel).x;
                };
                return std::vector{near(dvec4(red(0, 1), red(1, 1), red(1, 0), red(0, 0)), 0.0)};
            }};
}

Comparison offsetRead(glm::ivec2 size) {
    const Texture texture{randomImage(size.x, size.y, 6), false};
    return {{"SAMPLE_OFFSET",
             {header},
             "out0 = SAMPLE_OFFSET(gTexture0, in0.xy, in0.zw, 1, -1); out1 = SAMPLE_OFFSET(gTexture0, "
             "in0.xy, in0.zw, -1, 0);",
             1,
             2,
             {},
             reprise::Stage::compute,
             {texture}},
            nearCentres(size),
            [texture](const Row& in) {
                const dvec2 texel(in[0].z, in[0].w);
                return std::vector{
                    near(oracle::samplePoint(texture.image, xy(in[0]) + texel * dvec2(1, -1)), 0.0),
                    near(oracle::samplePoint(texture.image, xy(in[0]) + texel * dvec2(-1, 0)), 0.0)};
            }};
}

TEST(Platform, readsAreClampedToTheEdgeAndFilteredAsDeclared) {
    for (glm::ivec2 size : imageSizes) {
        SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y));
        expectAgrees(pointRead(size));
        expectAgrees(linearRead(size));
        expectAgrees(gather(size));
        expectAgrees(offsetRead(size));
    }
}

TEST(Platform, textureAsAParameterIsTheTexture) {
    Comparison direct = pointRead({7, 5});
    Mutation function{header, "#endif\n\n#endif\n",
                      "#endif\nfloat4 readIt(TEXTURE_PARAMETER(colour), float2 uv) { return SAMPLE(colour, "
                      "uv); }\n#endif\n"};
    direct.function.body = "out0 = readIt(TEXTURE_ARGUMENT(gTexture0), in0.xy);";
    EXPECT_EQ(mismatches(direct, function), "");
}

TEST(Platform, readOfAnotherPlaceOrChannelIsCaught) {
    expectCaught(pointRead({7, 5}),
                 {header, "#define SAMPLE(name, uv) name.SampleLevel(name##_sampler, uv, 0.0)",
                  "#define SAMPLE(name, uv) name.SampleLevel(name##_sampler, (uv).yx, 0.0)"});
    expectCaught(gather({7, 5}),
                 {header, "name.GatherRed(name##_sampler, uv)", "name.GatherGreen(name##_sampler, uv)"});
    expectCaught(offsetRead({7, 5}), {header, "uv, 0.0, int2(x, y))", "uv, 0.0, int2(x, -(y)))"});
}

TEST(Platform, gatherIsMissingOnlyInTheFragmentFormForEs) {
    const auto hasGather = [](std::map<std::string, int> defines, reprise::Stage stage) {
        Function function{"HAS_GATHER", {header}, "out0.x = HAS_GATHER;", 0, 1, std::move(defines), stage};
        return run(function, {Row{}}, {.extent = {1, 1}})[0][0].x;
    };
    EXPECT_EQ(hasGather({}, reprise::Stage::compute), 1.0f);
    EXPECT_EQ(hasGather({}, reprise::Stage::fragment), 1.0f);
    EXPECT_EQ(hasGather({{"PLATFORM_GLES", 1}}, reprise::Stage::compute), 1.0f);
    EXPECT_EQ(hasGather({{"PLATFORM_GLES", 1}}, reprise::Stage::fragment), 0.0f);
}

} // namespace
} // namespace functions
