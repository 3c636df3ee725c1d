// SPDX-License-Identifier: Apache-2.0
#include "assimp_convert.hpp"

#include <algorithm>
#include <cmath>

namespace scenes {
namespace {

glm::vec3 convert(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Area-weighted normals of the faces around each vertex, for files that have none or bad ones.
void computeNormals(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices)
        vertex.normal = glm::vec3(0.0f);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex* corner[3];
        for (size_t c = 0; c < 3; ++c)
            corner[c] = &mesh.vertices[mesh.indices[i + c]];
        const glm::vec3 normal =
            glm::cross(corner[1]->position - corner[0]->position, corner[2]->position - corner[0]->position);
        for (Vertex* vertex : corner)
            vertex->normal += normal;
    }
    for (Vertex& vertex : mesh.vertices) {
        const float length = glm::length(vertex.normal);
        vertex.normal = length > 0.0f && std::isfinite(length) ? vertex.normal / length : glm::vec3(0, 1, 0);
    }
}

bool readVertices(const aiMesh& source, Mesh& mesh) {
    bool normals = source.HasNormals();
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        Vertex vertex{convert(source.mVertices[i]), {0, 1, 0}, {0, 0}};
        // 1e9 m: beyond it single precision is too coarse for a picture, and squares overflow.
        if (!isFinite(vertex.position) ||
            glm::any(glm::greaterThan(glm::abs(vertex.position), glm::vec3(1e9f))))
            throw Refusal{"a vertex position is infinite, not a number or beyond 1e9; export it again"};
        if (source.HasTextureCoords(0)) {
            vertex.uv = glm::vec2(convert(source.mTextureCoords[0][i]));
            if (!std::isfinite(vertex.uv.x) || !std::isfinite(vertex.uv.y)) vertex.uv = {0, 0};
        }
        if (normals) {
            vertex.normal = convert(source.mNormals[i]);
            const float length = glm::length(vertex.normal);
            normals = std::isfinite(length) && length > 1e-6f;
            if (normals) vertex.normal /= length;
        }
        mesh.vertices.push_back(vertex);
    }
    return normals;
}

void readFaces(const aiMesh& source, Mesh& mesh) {
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices != 3) continue;
        for (unsigned c = 0; c < 3; ++c) {
            if (face.mIndices[c] >= source.mNumVertices)
                throw Refusal{"a triangle uses a vertex that does not exist; export it again"};
            mesh.indices.push_back(face.mIndices[c]);
        }
    }
}

// The four heaviest joints of each vertex, scaled to sum to one.
void readSkin(const aiMesh& source, Mesh& mesh) {
    if (source.mNumBones == 0) return;
    if (source.mNumBones > 256) throw Refusal{"a mesh hangs on more than 256 joints; split it"};
    mesh.joints.assign(mesh.vertices.size(), glm::u8vec4(0));
    mesh.weights.assign(mesh.vertices.size(), glm::vec4(0.0f));
    for (unsigned joint = 0; joint < source.mNumBones; ++joint) {
        const aiBone& bone = *source.mBones[joint];
        for (unsigned i = 0; i < bone.mNumWeights; ++i) {
            const auto [vertex, weight] = std::pair(bone.mWeights[i].mVertexId, bone.mWeights[i].mWeight);
            if (vertex >= mesh.vertices.size() || !std::isfinite(weight))
                throw Refusal{"a joint moves a vertex that does not exist or by no number; export it again"};
            int lightest = 0;
            for (int c = 1; c < 4; ++c)
                if (mesh.weights[vertex][c] < mesh.weights[vertex][lightest]) lightest = c;
            if (weight <= mesh.weights[vertex][lightest]) continue;
            mesh.weights[vertex][lightest] = weight;
            mesh.joints[vertex][lightest] = uint8_t(joint);
        }
    }
    for (glm::vec4& weights : mesh.weights) {
        const float sum = weights.x + weights.y + weights.z + weights.w;
        weights = sum > 0.0f ? weights / sum : glm::vec4(1, 0, 0, 0);
    }
}

} // namespace

Mesh convertMesh(const aiMesh& source) {
    Mesh mesh;
    if (source.mNumVertices == 0 || source.mVertices == nullptr) return mesh;
    const bool normals = readVertices(source, mesh);
    readFaces(source, mesh);
    if (!normals) computeNormals(mesh);
    readSkin(source, mesh);
    return mesh;
}

} // namespace scenes
