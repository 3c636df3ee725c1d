// SPDX-License-Identifier: Apache-2.0
#include "combine_lighting_case.hpp"

#include <cmath>

namespace passes {

namespace {

double unit(uint64_t seed, int x, int y, uint64_t what) {
    return unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), what);
}

Pixels randomLight(int width, int height, uint64_t seed) {
    return makePixels(rgba32f, width, height, [&](int x, int y) {
        Texel texel{};
        for (size_t c = 0; c < 3; ++c)
            texel[c] = static_cast<float>(std::pow(10.0, 5.0 * unit(seed, x, y, c) - 3.0));
        texel[3] = static_cast<float>(unit(seed, x, y, 3));
        return texel;
    });
}

} // namespace

CombineLightingCase combineLightingCase(const Variant& variant, int width, int height, uint64_t seed) {
    CombineLightingCase made;
    const auto lighting = reprise::switchValue(variant, "LIGHTING");
    made.pass.occluded = lighting != "shadow";
    made.pass.shadowed = lighting != "occlusion";
    made.pass.addsOther = reprise::switchValue(variant, "OTHER_LIGHT") == "on";
    made.lighting = makePixels(rg32f, width, height, [&](int x, int y) {
        const auto visibility = [&](uint64_t what) {
            return static_cast<float>(1.2 * unit(seed, x, y, what) - 0.1);
        };
        return Texel{visibility(4), visibility(5)};
    });
    made.ambient = randomLight(width, height, seed + 1);
    made.sun = randomLight(width, height, seed + 2);
    made.other = randomLight(width, height, seed + 3);
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const float size[] = {w, h, 1.0f / w, 1.0f / h};
    std::copy(std::begin(size), std::end(size), made.parameters.gOutputSize);
    return made;
}

std::vector<Pixels> run(Pass& pass, const CombineLightingCase& frame) {
    const NamedPixels inputs[] = {{"gInLighting", &frame.lighting},
                                  {"gInAmbientLight", &frame.ambient},
                                  {"gInSunLight", &frame.sun},
                                  {"gInOtherLight", &frame.other}};
    return pass(inputs, frame.parameters, frame.lighting.width, frame.lighting.height);
}

Comparison compareWithOracle(const CombineLightingCase& frame, const Pixels& lit) {
    const oracle::Image lighting = oracleImage(frame.lighting), ambient = oracleImage(frame.ambient);
    const oracle::Image sun = oracleImage(frame.sun), other = oracleImage(frame.other);
    oracle::CombinePass pass = frame.pass;
    pass.lighting = &lighting;
    pass.ambient = &ambient;
    pass.sun = &sun;
    pass.other = &other;
    Comparison colours = compare(
        lit,
        [&](int x, int y, bool) {
            const glm::dvec3 value = oracle::litColour(pass, x, y);
            // Two products and two sums of positive numbers, each rounded once: four of 2^-24.
            return Expected{value, 0x1p-22 * value};
        },
        3);
    const Pixels alpha =
        makePixels(lit.format, lit.width, lit.height, [&](int x, int y) { return Texel{lit.at(x, y, 3)}; });
    join(colours,
         compare(
             alpha,
             [](int, int, bool) {
                 return Expected{{1.0, 0.0, 0.0}, {}};
             },
             1),
         "alpha");
    return colours;
}

} // namespace passes
