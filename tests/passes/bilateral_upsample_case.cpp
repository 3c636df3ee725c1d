// SPDX-License-Identifier: Apache-2.0
#include "bilateral_upsample_case.hpp"

#include <cmath>

namespace passes {

namespace {

DepthDownsampleCase depthsFor(const Variant& variant, int width, int height, uint64_t seed) {
    std::vector<reprise::Condition> switches;
    for (const std::string_view name : {"RATIO", "DEPTH_LINEAR", "ORTHOGRAPHIC"})
        switches.push_back({name, reprise::switchValue(variant, name)});
    return randomDepthDownsampleCase(variantOf(pack(), "depth_downsample", switches), width, height, seed);
}

Pixels randomNormals(int width, int height, uint64_t seed) {
    return makePixels(rgba32f, width, height, [&](int x, int y) {
        glm::dvec3 normal;
        for (int c = 0; c < 3; ++c)
            normal[c] =
                unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), static_cast<uint64_t>(c)) -
                0.5;
        normal = glm::normalize(normal);
        return Texel{static_cast<float>(normal.x), static_cast<float>(normal.y),
                     static_cast<float>(normal.z)};
    });
}

} // namespace

BilateralUpsampleCase bilateralUpsampleCase(const Variant& variant, int width, int height, uint64_t seed) {
    BilateralUpsampleCase made;
    made.pass.values = cachedValuesOf(variant);
    made.pass.normalWeights = reprise::switchValue(variant, "NORMAL_WEIGHTS") == "on";
    made.depths = depthsFor(variant, width, height, seed);
    made.pass.ratio = made.depths.pass.ratio;
    const glm::ivec2 coarse = made.depths.coarse();
    const oracle::Image depth = oracleImage(made.depths.depth);
    made.coarseDepth = makePixels(r32f, coarse.x, coarse.y, [&](int x, int y) {
        return Texel{static_cast<float>(oracle::coarseDepth(made.depths.pass, depth, x, y))};
    });
    made.filtered = makePixels(rgba32f, coarse.x, coarse.y, [&](int x, int y) {
        return randomCached(made.pass.values, seed, x, y, made.coarseDepth.at(x, y, 0));
    });
    made.normal = randomNormals(width, height, seed + 1);
    const auto& from = made.depths.parameters;
    std::copy(std::begin(from.gInputSize), std::end(from.gInputSize), made.parameters.gOutputSize);
    std::copy(std::begin(from.gOutputSize), std::end(from.gOutputSize), made.parameters.gCoarseSize);
    std::copy(std::begin(from.gLinearDepth), std::end(from.gLinearDepth), made.parameters.gLinearDepth);
    made.parameters.gSkyDepth = from.gSkyDepth;
    made.parameters.gContrast = static_cast<float>(made.pass.contrast);
    return made;
}

std::vector<Pixels> run(Pass& pass, const BilateralUpsampleCase& frame) {
    const NamedPixels inputs[] = {{"gInFiltered", &frame.filtered},
                                  {"gInCoarseDepth", &frame.coarseDepth},
                                  {"gInDepth", &frame.depths.depth},
                                  {"gInNormal", &frame.normal}};
    return pass(inputs, frame.parameters, frame.depths.depth.width, frame.depths.depth.height);
}

Comparison compareWithOracle(const BilateralUpsampleCase& frame, const Pixels& upsampled) {
    const oracle::Image coarseDepth = oracleImage(frame.coarseDepth), normal = oracleImage(frame.normal);
    const oracle::Image filtered =
        oracle::unpackedCache(oracleImage(frame.filtered), coarseDepth, frame.pass.values).values;
    oracle::UpsamplePass pass = frame.pass;
    pass.filtered = &filtered;
    pass.coarseDepth = &coarseDepth;
    pass.normal = &normal;
    // Two channels at a time.
    const auto part = [&](int first) {
        const auto shown = [&](const oracle::Upsampled& texel) {
            return glm::dvec3(texel.values[first], texel.values[first + 1], 0.0);
        };
        const Pixels got = makePixels(rgba32f, upsampled.width, upsampled.height, [&](int x, int y) {
            const auto value = [&](int c) { return c < upsampled.channels ? upsampled.at(x, y, c) : 0.0f; };
            return Texel{value(first), value(first + 1)};
        });
        return compare(
            got,
            [&](int x, int y, bool careful) {
                const double depth = oracle::knownDepth(frame.depths.pass, frame.depths.depth.at(x, y, 0));
                const oracle::Upsampled expected = oracle::upsampledValues(pass, x, y, depth);
                const glm::dvec3 values = shown(expected);
                glm::dvec3 bound(0.0);
                for (int c = 0; c < 2; ++c)
                    bound[c] = storeError(upsampled.format, values[c]);
                if (!careful) return Expected{values, bound};
                // Normals at right angles to within a rounding: whether any weighs decides between two ways.
                if (pass.normalWeights && expected.totalWeight < 1e-20)
                    return Expected{values, glm::dvec3(1.0)};
                // Of samples in [0,1] the function errs by 6.7e-6 (bilateral_upsampling_test.cpp); the depth
                // that this pass makes from device depth moves the weights besides.
                glm::dvec3 most(1e-5);
                const double error = linearDepthBound(frame.depths, depth);
                for (const double away : {-error, error})
                    most = glm::max(
                        most,
                        1e-5 + glm::abs(shown(oracle::upsampledValues(pass, x, y, depth + away)) - values));
                return Expected{values, bound + most};
            },
            2);
    };
    const Comparison result = part(0);
    return result.holds() && pass.values == oracle::CachePass::Values::four ? part(2) : result;
}

} // namespace passes
