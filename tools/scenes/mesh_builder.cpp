// SPDX-License-Identifier: Apache-2.0
#include "mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/gtc/constants.hpp>

namespace scenes::build {
namespace {

// A grid of (rows + 1) × (columns + 1) vertices; rows run against columns so that the outside is
// counter-clockwise.
Mesh grid(uint32_t rows, uint32_t columns, const std::function<Vertex(float row, float column)>& vertexAt) {
    Mesh mesh;
    for (uint32_t row = 0; row <= rows; ++row)
        for (uint32_t column = 0; column <= columns; ++column)
            mesh.vertices.push_back(vertexAt(float(row) / float(rows), float(column) / float(columns)));
    for (uint32_t row = 0; row < rows; ++row) {
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t a = row * (columns + 1) + column, b = a + columns + 1;
            for (uint32_t index : {a, b, a + 1, a + 1, b, b + 1})
                mesh.indices.push_back(index);
        }
    }
    return mesh;
}

void addQuad(Mesh& mesh, glm::vec3 centre, glm::vec3 halfU, glm::vec3 halfV, glm::vec2 uvSize) {
    const auto first = uint32_t(mesh.vertices.size());
    const glm::vec3 normal = glm::normalize(glm::cross(halfU, halfV));
    for (glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        const glm::vec2 uv = glm::vec2(corner.x * 0.5f + 0.5f, 0.5f - corner.y * 0.5f) * uvSize;
        mesh.vertices.push_back({centre + halfU * corner.x + halfV * corner.y, normal, uv});
    }
    for (uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u})
        mesh.indices.push_back(first + index);
}

// Two unit vectors that make a right-handed frame with `axis`.
void frameAround(glm::vec3 axis, glm::vec3& side, glm::vec3& other) {
    const glm::vec3 helper = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    side = glm::normalize(glm::cross(helper, axis));
    other = glm::cross(axis, side);
}

void addCap(Mesh& mesh, glm::vec3 centre, glm::vec3 normal, glm::vec3 side, glm::vec3 other, uint32_t sides) {
    const auto first = uint32_t(mesh.vertices.size());
    for (uint32_t i = 0; i < sides; ++i) {
        const float angle = glm::two_pi<float>() * float(i) / float(sides);
        const glm::vec3 offset = side * std::cos(angle) + other * std::sin(angle);
        mesh.vertices.push_back({centre + offset, normal, {0.5f, 0.5f}});
    }
    for (uint32_t i = 2; i < sides; ++i)
        for (uint32_t index : {0u, i - 1, i})
            mesh.indices.push_back(first + index);
}

} // namespace

void append(Mesh& into, const Mesh& part, const glm::mat4& transform) {
    const auto first = uint32_t(into.vertices.size());
    const glm::mat3 normalMatrix = glm::transpose(glm::inverse(glm::mat3(transform)));
    for (const Vertex& vertex : part.vertices)
        into.vertices.push_back({glm::vec3(transform * glm::vec4(vertex.position, 1.0f)),
                                 glm::normalize(normalMatrix * vertex.normal), vertex.uv});
    for (uint32_t index : part.indices)
        into.indices.push_back(first + index);
}

Mesh box(glm::vec3 size, float uvScale) {
    Mesh mesh;
    const glm::vec3 half = size * 0.5f;
    const glm::vec3 x(half.x, 0, 0), y(0, half.y, 0), z(0, 0, half.z);
    addQuad(mesh, z, x, y, glm::vec2(size.x, size.y) * uvScale);
    addQuad(mesh, -z, -x, y, glm::vec2(size.x, size.y) * uvScale);
    addQuad(mesh, x, -z, y, glm::vec2(size.z, size.y) * uvScale);
    addQuad(mesh, -x, z, y, glm::vec2(size.z, size.y) * uvScale);
    addQuad(mesh, y, x, -z, glm::vec2(size.x, size.z) * uvScale);
    addQuad(mesh, -y, x, z, glm::vec2(size.x, size.z) * uvScale);
    return mesh;
}

Mesh floor(glm::vec2 size, float uvScale) {
    Mesh mesh;
    addQuad(mesh, {0, 0, 0}, {size.x * 0.5f, 0, 0}, {0, 0, -size.y * 0.5f}, size * uvScale);
    return mesh;
}

Mesh card(glm::vec2 size) {
    Mesh mesh;
    addQuad(mesh, {0, size.y * 0.5f, 0}, {size.x * 0.5f, 0, 0}, {0, size.y * 0.5f, 0}, {1, 1});
    return mesh;
}

Mesh sphere(float radius, uint32_t rings, uint32_t segments, float uvScale) {
    return grid(rings, segments, [=](float row, float column) {
        const float polar = row * glm::pi<float>(), azimuth = column * glm::two_pi<float>();
        const glm::vec3 normal(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                               std::sin(polar) * std::cos(azimuth));
        return Vertex{normal * radius, normal, glm::vec2(column * 2.0f, row) * uvScale};
    });
}

Mesh torus(float radius, float tube, uint32_t rings, uint32_t segments, float uvScale) {
    return grid(segments, rings, [=](float row, float column) {
        // Against the sphere's polar angle: the tube is walked downwards on its outside.
        const float around = column * glm::two_pi<float>(),
                    across = glm::half_pi<float>() - row * glm::two_pi<float>();
        const glm::vec3 outwards(std::sin(around), 0, std::cos(around));
        const glm::vec3 normal = outwards * std::cos(across) + glm::vec3(0, std::sin(across), 0);
        return Vertex{outwards * radius + normal * tube, normal,
                      glm::vec2(column * 6.0f, row * 2.0f) * uvScale};
    });
}

Mesh rod(glm::vec3 from, glm::vec3 to, float radius, uint32_t sides) {
    glm::vec3 side, other;
    const glm::vec3 axis = glm::normalize(to - from);
    frameAround(axis, side, other);
    Mesh mesh = grid(1, sides, [&](float row, float column) {
        const float angle = column * glm::two_pi<float>();
        const glm::vec3 normal = side * std::cos(angle) + other * std::sin(angle);
        return Vertex{
            glm::mix(to, from, row) + normal * radius, normal, {column, row * glm::length(to - from)}};
    });
    addCap(mesh, to, axis, side * radius, other * radius, sides);
    addCap(mesh, from, -axis, other * radius, side * radius, sides);
    return mesh;
}

Mesh wire(glm::vec3 from, glm::vec3 to, float sag, float radius, uint32_t segments) {
    Mesh mesh;
    const auto pointAt = [&](uint32_t i) {
        const float t = float(i) / float(segments);
        return glm::mix(from, to, t) - glm::vec3(0, sag * 4.0f * t * (1.0f - t), 0);
    };
    for (uint32_t i = 0; i < segments; ++i)
        append(mesh, rod(pointAt(i), pointAt(i + 1), radius, 5));
    return mesh;
}

Mesh bendingColumn(float radius, float height, uint32_t sides, uint32_t rings, uint32_t joints) {
    Mesh mesh = grid(rings, sides, [=](float row, float column) {
        const float angle = column * glm::two_pi<float>();
        const glm::vec3 normal(std::sin(angle), 0, std::cos(angle));
        const float up = 1.0f - row, taper = 1.0f - 0.5f * up;
        return Vertex{normal * radius * taper + glm::vec3(0, up * height, 0), normal, {column * 3, row * 6}};
    });
    for (const Vertex& vertex : mesh.vertices) {
        // The two joints around the vertex share it linearly in height.
        const float along = vertex.position.y / height * float(joints - 1);
        const auto lower = std::min(uint32_t(along), joints - 2);
        const float upper = along - float(lower);
        mesh.joints.push_back({lower, lower + 1, 0, 0});
        mesh.weights.push_back({1.0f - upper, upper, 0.0f, 0.0f});
    }
    return mesh;
}

} // namespace scenes::build
