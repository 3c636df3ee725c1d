// SPDX-License-Identifier: Apache-2.0
// depth.hlsli and closest_fragment.hlsli.
#include "cases.hpp"
#include "images.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::Projection;

const std::string depth = "reprise/depth.hlsli", closest = "reprise/closest_fragment.hlsli";

// in0: linear or device depth, the two coefficients, the number of the projection.
Sweep depthSweep(const std::vector<Projection>& projections, const Effort& effort, bool device,
                 const std::function<Right(const Row&, const Projection&)>& oracle) {
    std::vector<Row> rows;
    for (size_t number = 0; number < projections.size(); ++number) {
        const Projection& projection = projections[number];
        const dvec2 coefficients = linearDepthCoefficients(projection);
        std::vector<float> values;
        for (double linear : depthsOf(projection, effort.of(5000)))
            values.push_back(
                static_cast<float>(device ? oracle::deviceDepth(linear, projection.matrix) : linear));
        if (device) values = values + std::vector{0.0f, 1e-40f, 1e-30f, 0.99999994f, 1.0f};
        for (float value : values)
            rows.push_back({vec4(value, coefficients.x, coefficients.y, number)});
    }
    return {rows, [projections, oracle](const Row& in) {
                return std::vector{oracle(in, projections[static_cast<size_t>(in[0].w)])};
            }};
}

// 1 / (device x + y): both coefficients are rounded and so are product and sum. Where that may make up the
// whole sum, any depth is right; where the sum is less than 1e-30, 1e30 is.
Right linearFrom(const Row& in, const Projection& projection) {
    const double product = std::abs(static_cast<double>(in[0].x) * in[0].y), y = std::abs(in[0].z);
    double linear = oracle::linearDepth(in[0].x, projection.matrix);
    if (projection.orthographic) return right(linear, 2.0 * product + y + std::abs(linear));
    if (linear > 1e30) linear = 1e30;
    const double sum = 1.0 / linear, size = 2.0 * product + y + std::abs(sum);
    const double rest = sum - 2.0 * 2.0 * roundoff * size;
    if (!(rest > 0.0)) return open(1);
    return right(linear, linear * size / rest + 2.5 * linear);
}

// (1/linear - y) / x
Right deviceFrom(const Row& in, const Projection& projection) {
    const double linear = in[0].x, x = std::abs(in[0].y), y = std::abs(in[0].z);
    const double device = oracle::deviceDepth(linear, projection.matrix);
    const double term = projection.orthographic ? linear : 1.0 / linear;
    return right(device, (term + y) / x + std::abs(device));
}

// What the device depth errs by, times x, is what the way back sees of it.
Right roundTrip(const Row& in, const Projection& projection) {
    const double linear = in[0].x, x = std::abs(in[0].y), y = std::abs(in[0].z);
    const double device = std::abs(oracle::deviceDepth(linear, projection.matrix));
    const double term = projection.orthographic ? linear : 1.0 / linear;
    const double size = term + y + x * device;
    if (projection.orthographic) return right(linear, size);
    const double rest = term - 2.0 * 8.0 * roundoff * size;
    return rest > 0.0 ? right(linear, linear * size / rest + linear) : open(1);
}

const std::string toLinear = "out0.x = linearDepthFromDevice(in0.x, in0.yz);";
const std::string toDevice = "out0.x = deviceDepthFromLinear(in0.x, in0.yz);";
const std::string thereAndBack =
    "out0.x = linearDepthFromDevice(deviceDepthFromLinear(in0.x, in0.yz), in0.yz);";

std::vector<Case> ofKind(const std::string& kind, const std::vector<Projection>& projections) {
    const Defines defines{{"ORTHOGRAPHIC", projections.front().orthographic}};
    const std::string range = projections.front().orthographic ? "" : ", 1e-4 to 1e7 m, near:far to 1e11";
    return {
        {kind + range,
         {"linearDepthFromDevice", {depth}, toLinear, 1, 1, defines},
         {Unit::roundings, 2.0,
          "coefficients, product and sum, times the square of the depth that the reciprocal turns them into; "
          "open where they may make up the whole sum"},
         [=](const Effort& effort) { return depthSweep(projections, effort, true, linearFrom); }},
        {kind + range,
         {"deviceDepthFromLinear", {depth}, toDevice, 1, 1, defines},
         {Unit::roundings, 6.0, "two divisions, and the difference of the terms that they are rounded at"},
         [=](const Effort& effort) { return depthSweep(projections, effort, false, deviceFrom); }},
        {kind + ", there and back",
         {"linearDepthFromDevice", {depth}, thereAndBack, 1, 1, defines},
         {Unit::roundings, 8.0, "both ways; open where the way there has lost the depth"},
         [=](const Effort& effort) { return depthSweep(projections, effort, false, roundTrip); }}};
}

// Places that no depth buffer has: before the near plane, behind the camera, beyond the far plane.
Case outOfRange(const std::string& function, const std::string& body) {
    return {"outside of [0, 1] and of the frustum, to ±1e30",
            {function, {depth}, body},
            {Unit::finite, 0.0, "no depth there is right, but none may be NaN or infinite"},
            [](const Effort& effort) {
                std::vector<Row> rows;
                const auto values =
                    beyondMarks + ofBothSigns(logarithmic(1e-11, 1e11, effort.quick ? 40 : 400));
                for (const auto& family : {standardDepth(), reversedDepth(), infiniteDepth()})
                    for (const Projection& projection : family)
                        for (float value : values) {
                            const dvec2 coefficients = linearDepthCoefficients(projection);
                            rows.push_back({vec4(value, coefficients.x, coefficients.y, 0.0f)});
                        }
                return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
            }};
}

Case closer(bool reversed) {
    return {std::string(reversed ? "reversed" : "standard") + ", NaN and infinity too",
            {"isCloser",
             {depth},
             "out0.x = isCloser(in0.x, in0.y) ? 1.0 : 0.0;",
             1,
             1,
             Defines{{"DEPTH_REVERSED", reversed}}},
            {Unit::exact, 0.0, "one comparison, false for NaN"},
            [reversed](const Effort& effort) {
                const auto values = logarithmic(1e-11, 1.0, effort.quick ? 60 : 200) +
                                    std::vector{0.0f,  -0.0f,    1.0000001f, 0.5f,      0.50000006f,
                                                -1.0f, infinity, -infinity,  notANumber};
                std::vector<Row> rows;
                for (float a : values)
                    for (float b : values)
                        rows.push_back({vec4(a, b, 0, 0)});
                return Sweep{rows, [reversed](const Row& in) {
                                 return std::vector{
                                     right(oracle::isCloser(in[0].x, in[0].y, reversed) ? 1.0 : 0.0)};
                             }};
            }};
}

// --- closest_fragment

const std::string fillSquare = "DepthSquare d = depthSquareOf(in0.xyz, in1.xyz, in2.xyz);\n";

oracle::DepthSquare squareOf(const Row& in) {
    oracle::DepthSquare square;
    for (size_t i = 0; i < 9; ++i)
        square[i] = in[i / 3][static_cast<int>(i % 3)];
    return square;
}

// Device depths on a few levels, so that equals occur, or over all magnitudes; NaN where asked.
std::vector<Row> depthSquares(const Effort& effort, bool withNaN) {
    Random random(1);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        Row row(3, vec4(0.0f));
        for (int k = 0; k < 9; ++k)
            row[static_cast<size_t>(k / 3)][k % 3] =
                i % 2 == 0 ? 0.25f * static_cast<float>(random.below(5)) : std::exp2(random.in(-36.5f, 0.0f));
        if (withNaN) row[random.below(3)][static_cast<int>(random.below(3))] = notANumber;
        rows.push_back(row);
    }
    return rows;
}

// Of equals any may be chosen, so the depth at the offset is what is compared, and the one that comes with
// it.
const std::string depthAtOffset =
    fillSquare + "float2 offset = closestFragment(d, float2(1.0, 1.0), out0.y);\n"
                 "float3 line3 = offset.y < -0.5 ? in0.xyz : offset.y > 0.5 ? in2.xyz : in1.xyz;\n"
                 "out0.x = offset.x < -0.5 ? line3.x : offset.x > 0.5 ? line3.z : line3.y;\n";

Case closestOfNine(bool reversed) {
    return {reversed ? "reversed, equals too" : "standard, equals too",
            {"closestFragment", {closest}, depthAtOffset, 3, 1, Defines{{"DEPTH_REVERSED", reversed}}},
            {Unit::exact, 0.0, "comparisons and copies: the depth at the offset"},
            [reversed](const Effort& effort) {
                return Sweep{depthSquares(effort, false), [reversed](const Row& in) {
                                 const oracle::DepthSquare square = squareOf(in);
                                 const glm::ivec2 o = oracle::closestFragment(square, reversed);
                                 const double found = square[static_cast<size_t>((o.y + 1) * 3 + o.x + 1)];
                                 return std::vector{right(dvec2(found))};
                             }};
            }};
}

// In a row of three.
std::vector<Right> rowOracle(const Row& in) {
    oracle::DepthSquare square;
    square.fill(2.0);
    for (size_t i = 0; i < 3; ++i)
        square[3 + i] = in[0][static_cast<int>(i)];
    return {right(square[static_cast<size_t>(oracle::closestFragment(square, false).x + 4)])};
}

std::vector<Case> closestFragmentCases() {
    const auto copied = [](const Row& in) {
        return std::vector{right(xyz(in[0])), right(xyz(in[1])), right(xyz(in[2]))};
    };
    const oracle::Image image = functions::randomImage(37, 23, 2);
    return {
        {"nine depths",
         {"depthSquareOf",
          {closest},
          fillSquare + "out0.xyz = float3(d.leftUp, d.up, d.rightUp);"
                       "out1.xyz = float3(d.left, d.centre, d.right);"
                       "out2.xyz = float3(d.leftDown, d.down, d.rightDown);",
          3,
          3},
         {Unit::exact, 0.0, "copies"},
         [copied](const Effort& effort) {
             return Sweep{depthSquares(effort, false), copied};
         }},
        {"three depths, equals too",
         {"closestInRow", {closest}, "out0.x = closestInRow(in0.x, in0.y, in0.z, 1.0).x;", 3},
         {Unit::exact, 0.0, "comparisons and copies"},
         [](const Effort& effort) {
             return Sweep{depthSquares(effort, false), rowOracle};
         }},
        closestOfNine(false),
        closestOfNine(true),
        {"one NaN: the offset",
         {"closestFragment", {closest}, fillSquare + "out0.xy = closestFragment(d, float2(1.0, 1.0));", 3},
         {Unit::finite, 0.0, "NaN compares as no closer"},
         [](const Effort& effort) {
             return Sweep{depthSquares(effort, true), [](const Row&) { return std::vector{open(2)}; }};
         }},
        {"places in and around an image of 37x23",
         {"readDepthSquare",
          {closest},
          "DepthSquare d = readDepthSquare(TEXTURE_ARGUMENT(gTexture0), (in0.xy + 0.5) / float2(37.0, 23.0),"
          " 1.0 / float2(37.0, 23.0));"
          "out0.xyz = float3(d.leftUp, d.up, d.rightUp); out1.xyz = float3(d.left, d.centre, d.right);"
          "out2.xyz = float3(d.leftDown, d.down, d.rightDown);",
          1,
          3,
          {},
          reprise::Stage::compute,
          {{image, false}}},
         {Unit::exact, 0.0, "point reads copy"},
         [image](const Effort&) {
             std::vector<Row> rows;
             for (int y = 0; y < image.height; ++y)
                 for (int x = 0; x < image.width; ++x)
                     rows.push_back({vec4(x, y, 0, 0)});
             return Sweep{rows, [image](const Row& in) {
                              const auto s = oracle::depthSquareAt(image, static_cast<int>(in[0].x),
                                                                   static_cast<int>(in[0].y));
                              return std::vector{right(dvec3(s[0], s[1], s[2])),
                                                 right(dvec3(s[3], s[4], s[5])),
                                                 right(dvec3(s[6], s[7], s[8]))};
                          }};
         }}};
}

} // namespace

std::vector<Case> depthCases() {
    std::vector<Case> all = ofKind("standard", standardDepth());
    for (const auto& more :
         {ofKind("reversed", reversedDepth()), ofKind("reversed infinite", infiniteDepth()),
          ofKind("orthographic, 1e-4 to 1e7 m", parallelDepth()), closestFragmentCases()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(outOfRange("linearDepthFromDevice", toLinear));
    all.push_back(outOfRange("deviceDepthFromLinear", toDevice));
    all.push_back(closer(false));
    all.push_back(closer(true));
    return all;
}

} // namespace check
