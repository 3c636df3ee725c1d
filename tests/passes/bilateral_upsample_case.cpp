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
        return Texel{randomCached(made.pass.values, seed, x, y), 0.0f, 3.0f, made.coarseDepth.at(x, y, 0)};
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
    const oracle::Image filtered = oracle::unpackedImage(oracleImage(frame.filtered), frame.pass.values);
    const oracle::Image coarseDepth = oracleImage(frame.coarseDepth), normal = oracleImage(frame.normal);
    oracle::UpsamplePass pass = frame.pass;
    pass.filtered = &filtered;
    pass.coarseDepth = &coarseDepth;
    pass.normal = &normal;
    return compare(
        upsampled,
        [&](int x, int y, bool careful) {
            const double depth = oracle::knownDepth(frame.depths.pass, frame.depths.depth.at(x, y, 0));
            const oracle::Upsampled expected = oracle::upsampledValues(pass, x, y, depth);
            const glm::dvec2 values = expected.values;
            if (!careful) return Expected{{values, 0.0}, {}};
            // Normals at right angles to within a rounding: whether any weighs decides between two ways.
            if (pass.normalWeights && expected.totalWeight < 1e-20)
                return Expected{{values, 0.0}, glm::dvec3(1.0)};
            // Of samples in [0,1] the function errs by 6.7e-6 (bilateral_upsampling_test.cpp); the depth that
            // this pass makes from device depth moves the weights besides.
            glm::dvec2 most(1e-5);
            const double error = linearDepthBound(frame.depths, depth);
            for (const double away : {-error, error}) {
                const auto moved = oracle::upsampledValues(pass, x, y, depth + away).values;
                most = glm::max(most, 1e-5 + glm::abs(moved - values));
            }
            return Expected{{values, 0.0}, {most, 0.0}};
        },
        2);
}

} // namespace passes
