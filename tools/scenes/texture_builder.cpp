// SPDX-License-Identifier: Apache-2.0
#include "texture_builder.hpp"

#include <algorithm>
#include <cmath>

namespace scenes::build {
namespace {

Texture paint(uint32_t size, const std::function<glm::vec4(float u, float v)>& colourAt) {
    Texture texture{size, size, std::vector<uint8_t>(size_t(size) * size * 4)};
    for (uint32_t y = 0; y < size; ++y) {
        for (uint32_t x = 0; x < size; ++x) {
            const glm::vec4 colour =
                colourAt((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size));
            for (int channel = 0; channel < 4; ++channel)
                texture.texels[(size_t(y) * size + x) * 4 + size_t(channel)] =
                    uint8_t(std::lround(std::clamp(colour[channel], 0.0f, 1.0f) * 255.0f));
        }
    }
    return texture;
}

int wrap(int value, int period) {
    return ((value % period) + period) % period;
}

float fractal(float u, float v, int period, uint32_t seed) {
    float sum = 0.0f, weight = 0.5f;
    for (int octave = 0; octave < 4; ++octave, weight *= 0.5f, period *= 2)
        sum += weight * noise(u * float(period), v * float(period), period, seed + uint32_t(octave));
    return sum;
}

// A leaf is a lens between two arcs; `along` runs from stem to tip, `across` is signed.
bool insideLeaf(glm::vec2 point, glm::vec2 stem, float angle, float length, float& shade) {
    const glm::vec2 axis(std::cos(angle), std::sin(angle)), offset = point - stem;
    const float along = glm::dot(offset, axis) / length;
    const float across = (offset.y * axis.x - offset.x * axis.y) / length;
    if (along < 0.0f || along > 1.0f) return false;
    const float halfWidth = 0.2f * std::sin(3.14159f * std::pow(along, 0.8f));
    shade = std::abs(across) < 0.02f ? 0.7f : 0.85f + 0.3f * across / 0.2f;
    return std::abs(across) < halfWidth;
}

} // namespace

float hash(int x, int y, uint32_t seed) {
    uint32_t h = uint32_t(x) * 0x8da6b343u ^ uint32_t(y) * 0xd8163841u ^ seed * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    return float(h >> 8) / 16777216.0f;
}

float noise(float x, float y, int period, uint32_t seed) {
    const int cellX = int(std::floor(x)), cellY = int(std::floor(y));
    glm::vec2 f(x - float(cellX), y - float(cellY));
    f = f * f * (3.0f - 2.0f * f);
    const auto at = [&](int dx, int dy) {
        return hash(wrap(cellX + dx, period), wrap(cellY + dy, period), seed);
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), f.x), glm::mix(at(0, 1), at(1, 1), f.x), f.y);
}

Texture checker(uint32_t size, uint32_t cells, glm::vec3 first, glm::vec3 second) {
    return paint(size, [=](float u, float v) {
        const int x = int(u * float(cells)), y = int(v * float(cells));
        const float stain = 0.92f + 0.16f * (fractal(u, v, 8, 3) - 0.5f);
        return glm::vec4(((x + y) & 1 ? first : second) * stain, 1.0f);
    });
}

Texture bricks(uint32_t size, glm::vec3 brick, glm::vec3 mortar) {
    return paint(size, [=](float u, float v) {
        const float row = v * 12.0f, shift = (int(row) & 1) ? 0.5f : 0.0f, column = u * 6.0f + shift;
        const float fx = column - std::floor(column), fy = row - std::floor(row);
        const float grain = 0.8f + 0.4f * fractal(u, v, 32, 7);
        if (fx < 0.05f || fy < 0.1f) return glm::vec4(mortar * grain, 1.0f);
        const float tone = 0.65f + 0.7f * hash(wrap(int(column), 6), int(row), 11);
        return glm::vec4(brick * tone * grain, 1.0f);
    });
}

Texture mosaic(uint32_t size, uint32_t cells) {
    return paint(size, [=](float u, float v) {
        const float x = u * float(cells), y = v * float(cells);
        const float fx = x - std::floor(x), fy = y - std::floor(y);
        if (std::min(fx, fy) < 0.08f) return glm::vec4(0.25f, 0.24f, 0.22f, 1.0f);
        const float pick = hash(int(x), int(y), 21), tone = 0.7f + 0.5f * hash(int(x), int(y), 22);
        const glm::vec3 palette[4] = {
            {0.85f, 0.8f, 0.7f}, {0.2f, 0.35f, 0.55f}, {0.75f, 0.45f, 0.2f}, {0.15f, 0.3f, 0.3f}};
        return glm::vec4(palette[int(pick * 4.0f)] * tone, 1.0f);
    });
}

Texture planks(uint32_t size, glm::vec3 wood) {
    return paint(size, [=](float u, float v) {
        const float column = u * 8.0f;
        const float tone = 0.75f + 0.4f * hash(int(column), 0, 31);
        const float grain = noise(u * 64.0f, v * 4.0f + 7.0f * std::floor(column), 64, 32);
        const float gap = column - std::floor(column) < 0.06f ? 0.35f : 1.0f;
        return glm::vec4(wood * tone * (0.8f + 0.35f * grain) * gap, 1.0f);
    });
}

Texture concrete(uint32_t size, glm::vec3 colour, float contrast) {
    return paint(size, [=](float u, float v) {
        const float stain = fractal(u, v, 6, 41), grit = hash(int(u * float(size)), int(v * float(size)), 42);
        const float joint = std::min(u, v) < 0.008f ? 0.6f : 1.0f;
        return glm::vec4(colour * joint * (1.0f + contrast * (stain + 0.35f * grit - 0.62f)), 1.0f);
    });
}

Texture grassGround(uint32_t size) {
    return paint(size, [=](float u, float v) {
        const float patch = fractal(u, v, 5, 51), fine = noise(u * 96.0f, v * 96.0f, 96, 52);
        const glm::vec3 colour =
            glm::mix(glm::vec3(0.32f, 0.36f, 0.16f), glm::vec3(0.46f, 0.44f, 0.24f), patch);
        return glm::vec4(colour * (0.65f + 0.6f * fine), 1.0f);
    });
}

Texture poster(uint32_t size, uint32_t seed) {
    const glm::vec3 paper(0.9f, 0.87f, 0.78f), ink(0.12f, 0.11f, 0.13f);
    const glm::vec3 accent(0.4f + 0.5f * hash(1, 0, seed), 0.2f + 0.5f * hash(2, 0, seed),
                           0.15f + 0.6f * hash(3, 0, seed));
    return paint(size, [=](float u, float v) {
        if (std::min({u, v, 1.0f - u, 1.0f - v}) < 0.03f) return glm::vec4(ink, 1.0f);
        if (v < 0.45f) { // concentric rings and a sunburst
            const glm::vec2 d(u - 0.5f, v - 0.25f);
            const float rings = std::sin(glm::length(d) * 120.0f),
                        rays = std::sin(std::atan2(d.y, d.x) * 24.0f);
            return glm::vec4(rings * rays > 0.0f ? accent : paper, 1.0f);
        }
        const int row = int(v * 36.0f), column = int(u * 30.0f);
        const float fx = u * 90.0f - std::floor(u * 90.0f), fy = v * 36.0f - float(row);
        const bool mark = fy > 0.25f && fy < 0.8f && fx > 0.3f && hash(int(u * 90.0f), row, seed) > 0.35f;
        return glm::vec4(mark && hash(column, row, seed + 1) > 0.2f ? ink : paper, 1.0f);
    });
}

Texture leaves(uint32_t size, uint32_t seed) {
    return paint(size, [=](float u, float v) {
        const glm::vec2 point(u, 1.0f - v);
        const glm::vec3 green(0.24f, 0.42f, 0.12f);
        glm::vec4 colour(green * 0.8f, 0.0f); // colour outside the shape too: mipmaps must not fade to black
        if (std::abs(point.x - 0.5f) < 0.012f && point.y < 0.8f) colour = {0.3f, 0.22f, 0.12f, 1.0f};
        for (int i = 0; i < 12; ++i) {
            const float height = 0.06f + 0.065f * float(i), side = (i & 1) ? 1.0f : -1.0f;
            const float angle = 1.5708f - side * (0.75f + 0.5f * hash(i, 1, seed));
            float shade = 1.0f;
            if (!insideLeaf(point, {0.5f, height}, angle, 0.24f + 0.14f * hash(i, 2, seed), shade)) continue;
            colour = glm::vec4(green * shade * (0.75f + 0.6f * hash(i, 3, seed)), 1.0f);
        }
        return colour;
    });
}

Texture blades(uint32_t size, uint32_t seed) {
    return paint(size, [=](float u, float v) {
        const float height = 1.0f - v;
        const glm::vec3 green(0.3f, 0.42f, 0.14f);
        glm::vec4 colour(green * 0.8f, 0.0f);
        for (int i = 0; i < 14; ++i) {
            const float top = 0.5f + 0.5f * hash(i, 1, seed), lean = 0.3f * (hash(i, 2, seed) - 0.5f);
            const float along = height / top;
            const float centre = 0.08f + 0.84f * (float(i) + 0.5f) / 14.0f + lean * along * along;
            if (along > 1.0f || std::abs(u - centre) > 0.028f * (1.0f - along)) continue;
            colour = glm::vec4(green * (0.5f + 0.6f * along) * (0.8f + 0.5f * hash(i, 3, seed)), 1.0f);
        }
        return colour;
    });
}

} // namespace scenes::build
