// SPDX-License-Identifier: Apache-2.0
#include "depth_downsample_case.hpp"

#include <cmath>
#include <limits>

namespace passes {

namespace {

bool isOn(const Variant& variant, std::string_view name) {
    return reprise::switchValue(variant, name) == "on";
}

CameraKind kindOf(const Variant& variant, bool infinite) {
    CameraKind kind;
    if (isOn(variant, "ORTHOGRAPHIC")) kind.projection = Projection::orthographic;
    if (isOn(variant, "DEPTH_REVERSED"))
        kind.depth = infinite && kind.projection == Projection::perspective ? Depth::reversedInfinite
                                                                            : Depth::reversed;
    return kind;
}

// In [0,1] only; what lies outside is no device depth.
double linearOfDevice(double device, const glm::dmat4& viewToClip) {
    const bool isDepth = device >= 0.0 && device <= 1.0;
    return isDepth ? oracle::linearDepth(device, viewToClip) : std::numeric_limits<double>::quiet_NaN();
}

float storedDepth(const DepthDownsampleCase& frame, bool linear, double metres) {
    return static_cast<float>(linear ? metres : oracle::deviceDepth(metres, frame.viewToClip));
}

} // namespace

// The share by which linear depth = 1 / (device x + y) or device x + y is off: both coefficients are rounded
// to float32, and product, sum and division are, each by 2^-24.
double linearDepthBound(const DepthDownsampleCase& frame, double linear) {
    if (linear >= oracle::skyDepth) return 0.0;
    const glm::dvec2 k = reprise::linearDepthCoefficients(frame.viewToClip);
    const double device = oracle::deviceDepth(linear, frame.viewToClip);
    const double affine = 4.0 * 0x1p-24 * (std::abs(device * k.x) + std::abs(k.y));
    if (oracle::isOrthographic(frame.viewToClip)) return affine + linear * 0x1p-23;
    return linear * linear * affine + linear * 0x1p-22;
}

DepthDownsampleCase randomDepthDownsampleCase(const Variant& variant, int width, int height, uint64_t seed,
                                              bool infinite) {
    DepthDownsampleCase frame;
    const CameraKind kind = kindOf(variant, infinite);
    const bool linear = isOn(variant, "DEPTH_LINEAR");
    frame.viewToClip = projectionOf(kind, static_cast<double>(width) / height);
    frame.pass.ratio = reprise::switchValue(variant, "RATIO").front() - '0';
    frame.pass.checkerboard = isOn(variant, "CHECKERBOARD");
    frame.pass.skyFromM = kind.depth == Depth::reversedInfinite ? 1e5 : 0.999 * farPlane;
    frame.pass.linearDepth = [linear, viewToClip = frame.viewToClip](double stored) {
        return linear ? stored : linearOfDevice(stored, viewToClip);
    };
    frame.depth = makePixels(r32f, width, height, [&](int x, int y) {
        const auto ux = static_cast<uint64_t>(x), uy = static_cast<uint64_t>(y);
        const bool isInfinite = kind.depth == Depth::reversedInfinite && !linear;
        // Whole blocks of it, so that some coarse texels are sky.
        if (unitHash(seed, ux / 8, uy / 8, 1) < 0.3 || unitHash(seed, ux, uy, 2) < 0.1)
            return Texel{isInfinite ? 0.0f : storedDepth(frame, linear, farPlane)};
        return Texel{storedDepth(frame, linear, 0.4 * std::pow(100.0, unitHash(seed, ux, uy)))};
    });
    const glm::ivec2 coarse = frame.coarse();
    const auto setSize = [](float(&target)[4], glm::ivec2 size) {
        for (int i = 0; i < 2; ++i) {
            target[i] = static_cast<float>(size[i]);
            target[i + 2] = 1.0f / static_cast<float>(size[i]);
        }
    };
    setSize(frame.parameters.gInputSize, {width, height});
    setSize(frame.parameters.gOutputSize, coarse);
    const glm::dvec2 coefficients = reprise::linearDepthCoefficients(frame.viewToClip);
    for (int i = 0; i < 2; ++i)
        frame.parameters.gLinearDepth[i] = static_cast<float>(coefficients[i]);
    frame.parameters.gSkyDepth = static_cast<float>(frame.pass.skyFromM);
    return frame;
}

std::vector<Pixels> run(Pass& pass, const DepthDownsampleCase& frame) {
    const NamedPixels inputs[] = {{"gInDepth", &frame.depth}};
    return pass(inputs, frame.parameters, frame.coarse().x, frame.coarse().y);
}

Comparison compareWithOracle(const DepthDownsampleCase& frame, const Pixels& coarseDepth) {
    const oracle::Image depth = oracleImage(frame.depth);
    return compare(
        coarseDepth,
        [&](int x, int y, bool) {
            const double linear = oracle::coarseDepth(frame.pass, depth, x, y);
            return Expected{{linear, 0.0, 0.0}, {linearDepthBound(frame, linear), 0.0, 0.0}};
        },
        1);
}

} // namespace passes
