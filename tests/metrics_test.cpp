// SPDX-License-Identifier: Apache-2.0
// FLIP against a direct form in double precision, and what every measure must do.
#include "metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace {

using report::Picture;
using Image = std::vector<std::array<double, 3>>; // row by row
constexpr double pi = std::numbers::pi;

// The oracle: two-dimensional convolutions as the paper writes them, no separation, no tables.
struct Oracle {
    int width, height;
    double ppd = report::flipPixelsPerDegree;

    double at(const std::vector<double>& plane, int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return plane[static_cast<size_t>(y * width + x)];
    }

    std::vector<double> convolve(const std::vector<double>& in, int radius,
                                 const std::function<double(int, int)>& weight) const {
        std::vector<double> out(in.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double sum = 0.0;
                for (int j = -radius; j <= radius; ++j)
                    for (int i = -radius; i <= radius; ++i)
                        sum += weight(i, j) * at(in, x + i, y + j);
                out[static_cast<size_t>(y * width + x)] = sum;
            }
        return out;
    }

    std::vector<double> sensitivity(const std::vector<double>& in, std::array<double, 4> p) const {
        const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi * pi)) * ppd));
        const auto raw = [&](int i, int j) {
            const double d2 = (i * i + j * j) / (ppd * ppd);
            return p[0] * std::sqrt(pi / p[1]) * std::exp(-pi * pi * d2 / p[1]) +
                   p[2] * std::sqrt(pi / p[3]) * std::exp(-pi * pi * d2 / p[3]);
        };
        double total = 0.0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i)
                total += raw(i, j);
        return convolve(in, radius, [&](int i, int j) { return raw(i, j) / total; });
    }

    // Magnitude of the derivative of order 1 (edges) or 2 (points).
    std::vector<double> feature(const std::vector<double>& in, int order) const {
        const double sd = 0.5 * 0.082 * ppd;
        const int radius = static_cast<int>(std::ceil(3.0 * sd));
        const auto raw = [&](int i, int j) {
            const double g = std::exp(-(i * i + j * j) / (2.0 * sd * sd));
            return order == 1 ? -i * g : (i * i / (sd * sd) - 1.0) * g;
        };
        double positive = 0.0, negative = 0.0;
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i)
                (raw(i, j) > 0.0 ? positive : negative) += std::abs(raw(i, j));
        const auto weight = [&](int i, int j) { return raw(i, j) / (raw(i, j) > 0.0 ? positive : negative); };
        const auto x = convolve(in, radius, weight);
        const auto y = convolve(in, radius, [&](int i, int j) { return weight(j, i); });
        std::vector<double> out(in.size());
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = std::hypot(x[i], y[i]);
        return out;
    }

    // Rounded to seven digits in the standard's later form; the metric derives its own from the primaries.
    static std::array<double, 3> xyz(const std::array<double, 3>& c) {
        return {(0.4123908 * c[0] + 0.3575843 * c[1] + 0.1804808 * c[2]) / 0.9504559,
                0.2126390 * c[0] + 0.7151687 * c[1] + 0.0721923 * c[2],
                (0.0193308 * c[0] + 0.1191948 * c[1] + 0.9505322 * c[2]) / 1.0890578};
    }
    static std::array<double, 3> rgb(std::array<double, 3> c) {
        c[0] *= 0.9504559;
        c[2] *= 1.0890578;
        return {3.2409699 * c[0] - 1.5373832 * c[1] - 0.4986108 * c[2],
                -0.9692436 * c[0] + 1.8759675 * c[1] + 0.0415551 * c[2],
                0.0556301 * c[0] - 0.2039770 * c[1] + 1.0569715 * c[2]};
    }
    static double curve(double t) {
        const double d = 6.0 / 29.0;
        return t > d * d * d ? std::cbrt(t) : t / (3.0 * d * d) + 4.0 / 29.0;
    }
    static std::array<double, 3> huntLab(const std::array<double, 3>& colour) {
        const auto c = xyz(colour);
        const double l = 116.0 * curve(c[1]) - 16.0;
        return {l, 0.01 * l * 500.0 * (curve(c[0]) - curve(c[1])),
                0.01 * l * 200.0 * (curve(c[1]) - curve(c[2]))};
    }
    static double hyab(const std::array<double, 3>& p, const std::array<double, 3>& q) {
        return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
    }

    struct Side {
        Image lab;
        std::vector<double> edge, point;
    };
    Side side(const Picture& picture) const {
        const size_t n = picture.rgb.size() / 3;
        std::vector<double> y(n), cx(n), cz(n), achromatic(n);
        for (size_t i = 0; i < n; ++i) {
            const auto c = xyz({picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]});
            y[i] = 116.0 * c[1] - 16.0;
            cx[i] = 500.0 * (c[0] - c[1]);
            cz[i] = 200.0 * (c[1] - c[2]);
            achromatic[i] = c[1];
        }
        y = sensitivity(y, {1.0, 0.0047, 0.0, 1e-5});
        cx = sensitivity(cx, {1.0, 0.0053, 0.0, 1e-5});
        cz = sensitivity(cz, {34.1, 0.04, 13.5, 0.025});
        Side result{Image(n), feature(achromatic, 1), feature(achromatic, 2)};
        for (size_t i = 0; i < n; ++i) {
            const double fy = (y[i] + 16.0) / 116.0;
            auto c = rgb({fy + cx[i] / 500.0, fy, fy - cz[i] / 200.0});
            for (double& v : c)
                v = std::clamp(v, 0.0, 1.0);
            result.lab[i] = huntLab(c);
        }
        return result;
    }

    std::vector<double> map(const Picture& reference, const Picture& test) const {
        const Side r = side(reference), t = side(test);
        const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7),
                     knee = 0.4 * largest;
        std::vector<double> out(r.edge.size());
        for (size_t i = 0; i < out.size(); ++i) {
            const double c = std::pow(hyab(r.lab[i], t.lab[i]), 0.7);
            const double e = c < knee ? 0.95 / knee * c : 0.95 + (c - knee) / (largest - knee) * 0.05;
            const double f = std::max(std::abs(r.edge[i] - t.edge[i]), std::abs(r.point[i] - t.point[i]));
            out[i] = std::pow(e, 1.0 - std::sqrt(std::min(f / std::sqrt(2.0), 1.0)));
        }
        return out;
    }
};

Picture noise(uint32_t width, uint32_t height, uint32_t seed, float scale = 1.0f) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, scale);
    Picture p{width, height, std::vector<float>(3u * width * height)};
    for (float& v : p.rgb)
        v = value(random);
    return p;
}

Picture flat(uint32_t width, uint32_t height, float r, float g, float b) {
    Picture p{width, height, {}};
    for (uint32_t i = 0; i < width * height; ++i)
        p.rgb.insert(p.rgb.end(), {r, g, b});
    return p;
}

// A picture with edges, thin lines and a ramp: what rendering errors look like.
Picture drawing(uint32_t width, uint32_t height, uint32_t shift) {
    Picture p = flat(width, height, 0.02f, 0.05f, 0.1f);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            float* c = &p.rgb[3 * (y * width + x)];
            if (x > width / 2 + shift) c[0] = static_cast<float>(y) / static_cast<float>(height);
            if ((x + y + shift) % 7 == 0) c[1] = 0.9f;
            if (y == height / 3 + shift) c[2] = 1.0f;
        }
    return p;
}

double meanFlip(const Picture& a, const Picture& b) {
    return report::flipMean(report::flipSide(a), report::flipSide(b));
}

void expectLikeOracle(const Picture& reference, const Picture& test) {
    const Oracle oracle{static_cast<int>(reference.width), static_cast<int>(reference.height)};
    const auto expected = oracle.map(reference, test);
    const auto measured = report::flipMap(report::flipSide(reference), report::flipSide(test));
    ASSERT_EQ(expected.size(), measured.size());
    // Float filters of unit weight keep 1e-6 of the planes' range of 100; 0.7th powers and the feature's
    // square root magnify that near zero: 1e-3 bounds a pixel, and the mean has to agree far better.
    double mean = 0.0, expectedMean = 0.0;
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(expected[i], static_cast<double>(measured[i]), 1e-3) << "pixel " << i;
        mean += static_cast<double>(measured[i]);
        expectedMean += expected[i];
    }
    const auto n = static_cast<double>(expected.size());
    EXPECT_NEAR(expectedMean / n, mean / n, 2e-5);
}

TEST(Flip, agreesWithTheDirectFormOnNoise) {
    expectLikeOracle(noise(33, 27, 1), noise(33, 27, 2));
}
TEST(Flip, agreesWithTheDirectFormOnDarkNoise) {
    expectLikeOracle(noise(29, 31, 3, 0.02f), noise(29, 31, 4, 0.02f));
}
TEST(Flip, agreesWithTheDirectFormOnEdgesAndPoints) {
    expectLikeOracle(drawing(40, 25, 0), drawing(40, 25, 1));
}
TEST(Flip, agreesWithTheDirectFormOnPicturesSmallerThanTheFilter) {
    expectLikeOracle(noise(1, 1, 5), noise(1, 1, 6));
    expectLikeOracle(noise(2, 7, 5), noise(2, 7, 6));
}

TEST(Flip, isZeroForEqualPictures) {
    const Picture p = drawing(64, 48, 0);
    EXPECT_EQ(0.0, meanFlip(p, p));
}

TEST(Flip, isNearOneForBlackAgainstWhite) {
    // By hand: (100^0.7 - knee) / (largest - knee) * 0.05 + 0.95 with largest = 41.28, knee = 16.51.
    EXPECT_NEAR(0.967, meanFlip(flat(32, 32, 0, 0, 0), flat(32, 32, 1, 1, 1)), 1e-3);
}

TEST(Flip, isOneForTheFarthestPairOfTheDisplay) {
    EXPECT_NEAR(1.0, meanFlip(flat(16, 16, 0, 1, 0), flat(16, 16, 0, 0, 1)), 1e-5);
}

TEST(Flip, isSymmetric) {
    const Picture a = drawing(40, 30, 0), b = noise(40, 30, 9);
    EXPECT_NEAR(meanFlip(a, b), meanFlip(b, a), 1e-9);
}

TEST(Flip, growsWithTheError) {
    const Picture reference = drawing(64, 48, 0), other = noise(64, 48, 7);
    double previous = 0.0;
    for (float t : {0.02f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        Picture mixed = reference;
        for (size_t i = 0; i < mixed.rgb.size(); ++i)
            mixed.rgb[i] += t * (other.rgb[i] - reference.rgb[i]);
        const double error = meanFlip(reference, mixed);
        EXPECT_GT(error, previous) << "share of the other picture " << t;
        previous = error;
    }
}

TEST(Metrics, countsWhatIsNotFinite) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> values{0.0f, nan, 1.0f, inf, -inf, 3e38f};
    EXPECT_EQ(3u, report::countNotFinite(values));
}

TEST(Metrics, differenceIsRootMeanSquareAndMaximum) {
    const std::vector<float> a{0.0f, 0.5f, 1.0f, 0.25f}, b{0.0f, 0.0f, 1.0f, 0.5f};
    const auto d = report::difference(a, b);
    EXPECT_DOUBLE_EQ(std::sqrt((0.25 + 0.0625) / 4.0), d.rmse);
    EXPECT_DOUBLE_EQ(0.5, d.max);
}

TEST(Metrics, flickerIgnoresTheChangeOfTheReferenceAndAConstantError) {
    report::Flicker flicker;
    const std::vector<float> r0{0.1f, 0.2f}, r1{0.6f, 0.2f}, t0{0.35f, 0.2f}, t1{0.85f, 0.2f};
    flicker.add(r0, r1, t0, t1);
    EXPECT_NEAR(0.0, flicker.value(), 1e-7);
    const std::vector<float> t2{0.85f, 0.4f};
    flicker.add(r1, r1, t1, t2); // one value of four changed by 0.2
    EXPECT_NEAR(0.1, flicker.value(), 1e-6);
}

TEST(Metrics, flickerOfNoFramesIsZero) {
    EXPECT_EQ(0.0, report::Flicker().value());
}

} // namespace
