// SPDX-License-Identifier: Apache-2.0
#include "bilateral_filter_case.hpp"

#include <cmath>

namespace passes {

namespace {

using oracle::CachePass;

double unit(uint64_t seed, int x, int y, uint64_t what) {
    return unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), what);
}

float randomDepth(uint64_t seed, int x, int y, bool hasSky) {
    const double surface = unit(seed, x / 5, y / 5, 1);
    if (surface < 0.1 && hasSky) return 65504.0f;
    return static_cast<float>((surface < 0.4   ? 2.0
                               : surface < 0.7 ? 2.5
                                               : 20.0) +
                              0.05 * unit(seed, x, y, 2));
}

// Between two whole numbers of a packed channel a rounding chooses either.
bool isHalfway(CachePass::Values values, glm::dvec4 both, double error) {
    if (!oracle::isPacked(values)) return false;
    const double whole = values == CachePass::Values::occlusionInInteger ? both.x : both.y;
    return std::abs(glm::fract(31.0 * whole) - 0.5) < 31.0 * error + 1e-4;
}

// What the linear filter's weights, and coordinates that are rounded, move the value by. Across the direction
// too: a millionth of the sky beside a tap is centimetres, which may take the tap its weight, or give it one.
// What several such taps change is more than the sum of what each does: so the worst places of all taps are
// looked for together, tap after tap, three times, upwards and downwards. One of a tap's places is that where
// its depth is the centre's, and its weight the largest.
double filterErrorOf(const oracle::FilterPass& pass, const oracle::Unpacked& unpacked, int x, int y,
                     int channel, double value) {
    if (!pass.linear) return 0.0;
    // Roundings of a coordinate: 1 / extent, its product with the pixel's place, the tap's offset in two, the
    // sampler's product with the extent and its half texel.
    const double error =
        linearFilterError() + 6.0 * 0x1p-24 * std::max(unpacked.values.width, unpacked.values.height);
    const glm::dvec2 along(pass.direction), across(along.y, along.x);
    const auto footprint = oracle::linearFootprint();
    const auto depthAt = [&](size_t tap, glm::dvec2 away) {
        const glm::dvec2 place = glm::dvec2(x, y) + 0.5 + footprint[tap].first * along + away;
        return oracle::sampleLinear(unpacked.state, place / unpacked.state.extent()).y;
    };
    // Shares of the error across: its ends, the middle, and where the depth is the centre's.
    const auto sharesOf = [&](size_t tap) {
        std::vector<double> shares{-1.0, 0.0, 1.0};
        for (const double end : {-1.0, 1.0}) {
            const double here = depthAt(tap, glm::dvec2(0.0)), there = depthAt(tap, end * error * across);
            const double share = (unpacked.state.at(x, y).y - here) / (there - here);
            if (share > 0.0 && share < 1.0) shares.push_back(end * share);
        }
        return shares;
    };
    double largest = 0.0;
    for (const double sign : {-1.0, 1.0}) {
        std::vector<glm::dvec2> away(5, glm::dvec2(0.0));
        double most = 0.0;
        for (size_t step = 0; step < 3 * away.size(); ++step) {
            glm::dvec2& place = away[step % away.size()];
            glm::dvec2 best = place;
            for (const double u : {-1.0, 0.0, 1.0})
                for (const double v : sharesOf(step % away.size())) {
                    place = error * (u * along + v * across);
                    const double moved = oracle::filteredValues(pass, unpacked, x, y, away)[channel];
                    if (sign * (moved - value) <= most) continue;
                    most = sign * (moved - value);
                    best = place;
                }
            place = best;
        }
        largest = std::max(largest, most);
    }
    return largest;
}

} // namespace

CachePass::Values cachedValuesOf(const Variant& variant) {
    const auto value = reprise::switchValue(variant, "VALUES");
    return value == "one"                    ? CachePass::Values::one
           : value == "two"                  ? CachePass::Values::two
           : value == "four"                 ? CachePass::Values::four
           : value == "with_frames"          ? CachePass::Values::withFrames
           : value == "occlusion_in_integer" ? CachePass::Values::occlusionInInteger
                                             : CachePass::Values::shadowInInteger;
}

Texel randomCached(CachePass::Values values, uint64_t seed, int x, int y, double depth) {
    glm::dvec4 each;
    for (int i = 0; i < 4; ++i)
        each[i] = unit(seed, x, y, 10 + static_cast<uint64_t>(i));
    const glm::vec4 texel(oracle::packedValues(values, each, depth));
    return {texel.x, texel.y, texel.z, texel.w};
}

BilateralFilterCase bilateralFilterCase(const Variant& variant, int width, int height, glm::ivec2 direction,
                                        uint64_t seed) {
    BilateralFilterCase made;
    oracle::FilterPass& pass = made.pass;
    pass.values = cachedValuesOf(variant);
    pass.linear = reprise::switchValue(variant, "TAPS") == "linear";
    pass.direction = direction;
    // In a large image under a linear filter a rounded coordinate beside the sky decides over a tap's whole
    // weight, and nothing is left to compare; the page names it as a limit.
    const bool hasSky = !pass.linear || width <= 64;
    const auto depth = [&](int x, int y) { return randomDepth(seed, x, y, hasSky); };
    made.cache = makePixels(rgba32f, width, height,
                            [&](int x, int y) { return randomCached(pass.values, seed, x, y, depth(x, y)); });
    made.state = makePixels(rg32f, width, height, [&](int x, int y) {
        return Texel{static_cast<float>(12.0 * unit(seed, x, y, 5)), depth(x, y)};
    });
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    made.parameters = {.gOutputSize = {w, h, 1.0f / w, 1.0f / h},
                       .gDirection = {static_cast<float>(direction.x), static_cast<float>(direction.y)},
                       .gDepthAmplitude = {1.0f, 4.0f},
                       .gConverged = 8.0f,
                       .gMaxSmoothing = 4.0f,
                       .gMinSmoothing = 0.7f,
                       .pad0 = {}};
    return made;
}

std::vector<Pixels> run(Pass& pass, const BilateralFilterCase& frame) {
    const NamedPixels inputs[] = {{"gInCache", &frame.cache},
                                  {"gInCacheFiltered", &frame.cache},
                                  {"gInCacheState", &frame.state},
                                  {"gInCacheStateFiltered", &frame.state}};
    return pass(inputs, frame.parameters, frame.cache.width, frame.cache.height);
}

Comparison compareWithOracle(const BilateralFilterCase& frame, const Pixels& filtered) {
    const oracle::FilterPass& pass = frame.pass;
    const oracle::Unpacked unpacked =
        oracle::unpackedCache(oracleImage(frame.cache), oracleImage(frame.state), pass.values);
    const bool apart = oracle::isDepthApart(pass.values);
    // Two channels at a time.
    const auto part = [&](int first) {
        const Pixels got = makePixels(rgba32f, filtered.width, filtered.height, [&](int x, int y) {
            return Texel{filtered.at(x, y, first), filtered.at(x, y, first + 1)};
        });
        return compare(
            got,
            [&](int x, int y, bool careful) {
                const glm::dvec4 values = oracle::filteredValues(pass, unpacked, x, y);
                const double depth =
                    std::min(oracle::held(unpacked.state.at(x, y).y, 0.0, 1e36), oracle::skyDepth);
                const glm::dvec4 texel = oracle::packedValues(pass.values, values, depth);
                Expected expected;
                for (int c = 0; c < 2; ++c) {
                    expected.value[c] = texel[first + c];
                    expected.bound[c] = storeError(filtered.format, texel[first + c]);
                    if (!careful || (c == 1 && !apart)) continue;
                    // Weights of nine taps, each rounded some ten times; a packed integer may be the next.
                    const double error =
                        4e-6 + filterErrorOf(pass, unpacked, x, y, first + c, values[first + c]);
                    expected.bound[c] += isHalfway(pass.values, values, error) ? 1.0 + error : error;
                }
                return expected;
            },
            2);
    };
    const Comparison result = part(0);
    return result.holds() && pass.values == CachePass::Values::four ? part(2) : result;
}

} // namespace passes
