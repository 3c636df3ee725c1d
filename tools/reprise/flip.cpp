// SPDX-License-Identifier: Apache-2.0
#include "metrics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace report {
namespace {

// A report makes thousands of comparisons, so every loop here is branch-free over plain float arrays, which
// the compiler turns into vector code. The test holds it against a direct form in double precision.

using Plane = std::vector<float>;

// One half of a one-dimensional kernel: symmetric, or antisymmetric with a zero centre.
struct Kernel {
    bool antisymmetric = false;
    float centre = 0.0f;
    std::vector<float> side; // side[i] weighs the texel i + 1 to the right
    int radius() const { return static_cast<int>(side.size()); }
};

struct Size {
    int width, height;
    size_t texels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

// log2 for normal positive numbers, to 2e-7.
inline float log2Fast(float x) {
    const auto bits = std::bit_cast<int32_t>(x);
    // Splits x = 2^e m with m in [sqrt(1/2), sqrt(2)), where the series in t converges fastest.
    const int32_t exponent = (bits - 0x3f3504f3) >> 23;
    const float m = std::bit_cast<float>(bits - (exponent << 23));
    const float t = (m - 1.0f) / (m + 1.0f), t2 = t * t;
    const float series = t * (2.885390082f + t2 * (0.961796694f + t2 * (0.577078016f + t2 * 0.412198583f)));
    return static_cast<float>(exponent) + series;
}

// 2^x for x in [-126, 127], to 2e-7.
inline float exp2Fast(float x) {
    const float shifted = x + 12582912.0f; // 1.5 * 2^23: adding it rounds to an integer in the low bits
    const int32_t whole = std::bit_cast<int32_t>(shifted) - 0x4b400000;
    const float f = x - (shifted - 12582912.0f);
    const float poly =
        1.0f + f * (0.693147181f +
                    f * (0.240226507f + f * (0.0555041087f + f * (0.00961812911f + f * 0.00133335581f))));
    return std::bit_cast<float>(std::bit_cast<int32_t>(poly) + (whole << 23));
}

// x^y for x >= 0 and y > 0; below 1e-37 it is 0.
inline float powFast(float x, float y) {
    const float power = exp2Fast(std::clamp(y * log2Fast(std::max(x, 1e-37f)), -125.0f, 125.0f));
    return x > 1e-37f ? power : 0.0f;
}

// Linear sRGB primaries to XYZ relative to the white point, derived from the chromaticities of IEC 61966-2-1.
struct Matrix3 {
    std::array<std::array<double, 3>, 3> m;
};

double determinant(const Matrix3& a) {
    const auto& m = a.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3 inverse(const Matrix3& a) {
    Matrix3 result{};
    const double d = determinant(a);
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c) {
            const size_t r1 = (c + 1) % 3, r2 = (c + 2) % 3, c1 = (r + 1) % 3, c2 = (r + 2) % 3;
            result.m[r][c] = (a.m[r1][c1] * a.m[r2][c2] - a.m[r1][c2] * a.m[r2][c1]) / d;
        }
    return result;
}

Matrix3 rgbToRelativeXyz() {
    constexpr double x[] = {0.64, 0.30, 0.15}, y[] = {0.33, 0.60, 0.06};
    const std::array<double, 3> white{0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290};
    Matrix3 primaries{};
    for (size_t i = 0; i < 3; ++i) {
        primaries.m[0][i] = x[i];
        primaries.m[1][i] = y[i];
        primaries.m[2][i] = 1.0 - x[i] - y[i];
    }
    const Matrix3 inv = inverse(primaries);
    for (size_t i = 0; i < 3; ++i) {
        const double luminance = inv.m[i][0] * white[0] + inv.m[i][1] * white[1] + inv.m[i][2] * white[2];
        for (size_t row = 0; row < 3; ++row)
            primaries.m[row][i] *= luminance / white[row];
    }
    return primaries;
}

struct Colours {
    std::array<std::array<float, 3>, 3> toXyz, toRgb;
};

const Colours& colours() {
    static const Colours table = [] {
        const Matrix3 forward = rgbToRelativeXyz(), back = inverse(forward);
        Colours result{};
        for (size_t r = 0; r < 3; ++r)
            for (size_t c = 0; c < 3; ++c) {
                result.toXyz[r][c] = static_cast<float>(forward.m[r][c]);
                result.toRgb[r][c] = static_cast<float>(back.m[r][c]);
            }
        return result;
    }();
    return table;
}

inline float row(const std::array<float, 3>& m, float x, float y, float z) {
    return m[0] * x + m[1] * y + m[2] * z;
}

// CIE's cube root with its linear toe.
inline float labCurve(float t) {
    constexpr float delta = 6.0f / 29.0f;
    const float root = powFast(t, 1.0f / 3.0f);
    const float toe = t / (3.0f * delta * delta) + 4.0f / 29.0f;
    return t > delta * delta * delta ? root : toe;
}

struct Planes3 {
    Plane x, y, z;
    explicit Planes3(size_t n) : x(n), y(n), z(n) {}
};

// The opponent space of the paper: achromatic Y, red-green Cx, blue-yellow Cz, all linear in RGB.
Planes3 toOpponent(const Picture& picture) {
    const size_t n = picture.rgb.size() / 3;
    const auto& m = colours().toXyz;
    Planes3 out(n);
    for (size_t i = 0; i < n; ++i) {
        const float r = picture.rgb[3 * i], g = picture.rgb[3 * i + 1], b = picture.rgb[3 * i + 2];
        const float x = row(m[0], r, g, b), y = row(m[1], r, g, b), z = row(m[2], r, g, b);
        out.x[i] = 116.0f * y - 16.0f;
        out.y[i] = 500.0f * (x - y);
        out.z[i] = 200.0f * (y - z);
    }
    return out;
}

// Back to RGB, clamped to the display, then to L*a*b* with the Hunt effect: chroma weighs less in the dark.
void toHuntLab(Planes3& p) {
    const auto& toRgb = colours().toRgb;
    const auto& toXyz = colours().toXyz;
    const size_t n = p.x.size();
    float *px = p.x.data(), *py = p.y.data(), *pz = p.z.data();
    for (size_t i = 0; i < n; ++i) {
        const float y = (px[i] + 16.0f) / 116.0f, x = y + py[i] / 500.0f, z = y - pz[i] / 200.0f;
        const float r = std::clamp(row(toRgb[0], x, y, z), 0.0f, 1.0f);
        const float g = std::clamp(row(toRgb[1], x, y, z), 0.0f, 1.0f);
        const float b = std::clamp(row(toRgb[2], x, y, z), 0.0f, 1.0f);
        const float fx = labCurve(row(toXyz[0], r, g, b)), fy = labCurve(row(toXyz[1], r, g, b));
        const float fz = labCurve(row(toXyz[2], r, g, b));
        const float lightness = 116.0f * fy - 16.0f;
        px[i] = lightness;
        py[i] = 0.01f * lightness * 500.0f * (fx - fy);
        pz[i] = 0.01f * lightness * 200.0f * (fy - fz);
    }
}

void addTap(float* out, const float* left, const float* right, float weight, bool antisymmetric, int n) {
    if (antisymmetric)
        for (int i = 0; i < n; ++i)
            out[i] += weight * (right[i] - left[i]);
    else
        for (int i = 0; i < n; ++i)
            out[i] += weight * (right[i] + left[i]);
}

// Convolutions repeat the border texels, as the paper's do.
Plane filterRows(const Plane& in, Size size, const Kernel& kernel) {
    const int radius = kernel.radius(), width = size.width;
    Plane out(size.texels()), padded(static_cast<size_t>(width + 2 * radius));
    for (int y = 0; y < size.height; ++y) {
        const float* source = in.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
        float* target = out.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
        std::fill_n(padded.begin(), radius, source[0]);
        std::copy_n(source, width, padded.begin() + radius);
        std::fill_n(padded.begin() + radius + width, radius, source[width - 1]);
        const float* centre = padded.data() + radius;
        for (int x = 0; x < width; ++x)
            target[x] = kernel.centre * centre[x];
        for (int i = 1; i <= radius; ++i)
            addTap(target, centre - i, centre + i, kernel.side[static_cast<size_t>(i - 1)],
                   kernel.antisymmetric, width);
    }
    return out;
}

Plane filterColumns(const Plane& in, Size size, const Kernel& kernel) {
    Plane out(size.texels());
    const auto rowAt = [&](int y) {
        return in.data() +
               static_cast<size_t>(std::clamp(y, 0, size.height - 1)) * static_cast<size_t>(size.width);
    };
    for (int y = 0; y < size.height; ++y) {
        float* target = out.data() + static_cast<size_t>(y) * static_cast<size_t>(size.width);
        const float* centre = rowAt(y);
        for (int x = 0; x < size.width; ++x)
            target[x] = kernel.centre * centre[x];
        for (int i = 1; i <= kernel.radius(); ++i)
            addTap(target, rowAt(y - i), rowAt(y + i), kernel.side[static_cast<size_t>(i - 1)],
                   kernel.antisymmetric, size.width);
    }
    return out;
}

// One Gaussian of a contrast sensitivity function in space: a sqrt(pi/b) exp(-pi² d²/b), d in degrees.
struct Gaussian {
    double a, b;
};
// Section 4.1.1 and table 1 of the paper; a Gaussian whose amplitude is zero is left out.
constexpr Gaussian achromatic{1.0, 0.0047}, redGreen{1.0, 0.0053}, blueYellow1{34.1, 0.04},
    blueYellow2{13.5, 0.025};
constexpr double widest = 0.04;

int sensitivityRadius(double ppd) {
    constexpr double pi = std::numbers::pi;
    return static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * ppd));
}

// A two-dimensional Gaussian is the product of two of these; `sum` is that of the unnormalised one.
struct NormalisedKernel {
    Kernel kernel;
    double sum;
};

NormalisedKernel sensitivityKernel(const Gaussian& g, double ppd) {
    constexpr double pi = std::numbers::pi;
    std::vector<double> side;
    double sum = 1.0;
    for (int i = 1; i <= sensitivityRadius(ppd); ++i) {
        const double degrees = i / ppd;
        side.push_back(std::exp(-pi * pi * degrees * degrees / g.b));
        sum += 2.0 * side.back();
    }
    Kernel kernel{.antisymmetric = false, .centre = static_cast<float>(1.0 / sum), .side = {}};
    for (double w : side)
        kernel.side.push_back(static_cast<float>(w / sum));
    return {std::move(kernel), sum};
}

Plane sensitivity(const Plane& in, Size size, const Gaussian& g, double ppd) {
    const Kernel kernel = sensitivityKernel(g, ppd).kernel;
    return filterColumns(filterRows(in, size, kernel), size, kernel);
}

// The blue-yellow function is the sum of two Gaussians: each is separable, their sum is not.
Plane blueYellowSensitivity(const Plane& in, Size size, double ppd) {
    const auto weight = [&](const Gaussian& g) {
        const double sum = sensitivityKernel(g, ppd).sum;
        return g.a * std::sqrt(std::numbers::pi / g.b) * sum * sum;
    };
    const double w1 = weight(blueYellow1), w2 = weight(blueYellow2);
    Plane first = sensitivity(in, size, blueYellow1, ppd);
    const Plane second = sensitivity(in, size, blueYellow2, ppd);
    const auto s1 = static_cast<float>(w1 / (w1 + w2)), s2 = static_cast<float>(w2 / (w1 + w2));
    for (size_t i = 0; i < first.size(); ++i)
        first[i] = s1 * first[i] + s2 * second[i];
    return first;
}

// Section 4.2: edges by the first and points by the second derivative of a Gaussian whose width is that of an
// edge as the eye detects it, gw degrees. Positive and negative weights each sum to one in magnitude.
struct FeatureKernels {
    Kernel smooth, edge, point;
};

FeatureKernels featureKernels(double ppd) {
    constexpr double gw = 0.082;
    const double sd = 0.5 * gw * ppd;
    const int radius = static_cast<int>(std::ceil(3.0 * sd));
    std::vector<double> g, e, p;
    double smoothSum = 1.0, edgeSum = 0.0, positive = 0.0, negative = 1.0; // the point's centre weighs -1
    for (int i = 1; i <= radius; ++i) {
        const double x = i, gauss = std::exp(-x * x / (2.0 * sd * sd));
        g.push_back(gauss);
        e.push_back(-x * gauss);
        p.push_back((x * x / (sd * sd) - 1.0) * gauss);
        smoothSum += 2.0 * gauss;
        edgeSum += x * gauss;
        (p.back() > 0.0 ? positive : negative) += 2.0 * std::abs(p.back());
    }
    FeatureKernels k;
    k.edge.antisymmetric = true;
    k.smooth.centre = static_cast<float>(1.0 / smoothSum);
    k.point.centre = static_cast<float>(-1.0 / negative);
    for (size_t i = 0; i < g.size(); ++i) {
        k.smooth.side.push_back(static_cast<float>(g[i] / smoothSum));
        k.edge.side.push_back(static_cast<float>(e[i] / edgeSum));
        k.point.side.push_back(static_cast<float>(p[i] / (p[i] > 0.0 ? positive : negative)));
    }
    return k;
}

Plane magnitude(const Plane& x, const Plane& y) {
    Plane out(x.size());
    for (size_t i = 0; i < x.size(); ++i)
        out[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
    return out;
}

void addFeatures(const Plane& achromaticPlane, Size size, double ppd, FlipSide& side) {
    const FeatureKernels k = featureKernels(ppd);
    Plane y(achromaticPlane.size());
    for (size_t i = 0; i < y.size(); ++i)
        y[i] = (achromaticPlane[i] + 16.0f) / 116.0f;
    const Plane smooth = filterRows(y, size, k.smooth);
    side.edge = magnitude(filterColumns(filterRows(y, size, k.edge), size, k.smooth),
                          filterColumns(smooth, size, k.edge));
    side.point = magnitude(filterColumns(filterRows(y, size, k.point), size, k.smooth),
                           filterColumns(smooth, size, k.point));
}

constexpr float qc = 0.7f, pc = 0.4f, pt = 0.95f; // section 4.1.3

float largestColourDifference() {
    // Hunt-adjusted green against blue, the farthest pair of the display's gamut.
    Picture ends{2, 1, {0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}};
    Planes3 lab = toOpponent(ends);
    toHuntLab(lab);
    const float da = lab.y[0] - lab.y[1], db = lab.z[0] - lab.z[1];
    return powFast(std::abs(lab.x[0] - lab.x[1]) + std::sqrt(da * da + db * db), qc);
}

} // namespace

FlipSide flipSide(const Picture& picture, double pixelsPerDegree) {
    const Size size{static_cast<int>(picture.width), static_cast<int>(picture.height)};
    Planes3 opponent = toOpponent(picture);
    FlipSide side;
    side.width = picture.width;
    side.height = picture.height;
    addFeatures(opponent.x, size, pixelsPerDegree, side);
    opponent.x = sensitivity(opponent.x, size, achromatic, pixelsPerDegree);
    opponent.y = sensitivity(opponent.y, size, redGreen, pixelsPerDegree);
    opponent.z = blueYellowSensitivity(opponent.z, size, pixelsPerDegree);
    toHuntLab(opponent);
    side.lightness = std::move(opponent.x);
    side.a = std::move(opponent.y);
    side.b = std::move(opponent.z);
    return side;
}

std::vector<float> flipMap(const FlipSide& reference, const FlipSide& test) {
    static const float largest = largestColourDifference();
    const float knee = pc * largest;
    std::vector<float> map(reference.lightness.size());
    for (size_t i = 0; i < map.size(); ++i) {
        const float dl = std::abs(reference.lightness[i] - test.lightness[i]);
        const float da = reference.a[i] - test.a[i], db = reference.b[i] - test.b[i];
        const float colour = powFast(dl + std::sqrt(da * da + db * db), qc);
        const float low = colour * (pt / knee);
        const float high = pt + (colour - knee) / (largest - knee) * (1.0f - pt);
        const float colourError = std::clamp(colour < knee ? low : high, 0.0f, 1.0f);
        const float edge = std::abs(reference.edge[i] - test.edge[i]);
        const float point = std::abs(reference.point[i] - test.point[i]);
        const float feature = std::sqrt(std::min(std::max(edge, point) * 0.707106781f, 1.0f)); // qf = 0.5
        // A difference of features raises the error: the exponent falls from 1 to 0.
        map[i] = powFast(colourError, 1.0f - feature);
    }
    return map;
}

double flipMean(const FlipSide& reference, const FlipSide& test) {
    const std::vector<float> map = flipMap(reference, test);
    double sum = 0.0;
    for (float v : map)
        sum += static_cast<double>(v);
    return map.empty() ? 0.0 : sum / static_cast<double>(map.size());
}

} // namespace report
