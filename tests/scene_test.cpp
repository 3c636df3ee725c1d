// SPDX-License-Identifier: Apache-2.0
// Scenes and loader, without a device. The loader must end every damaged file in one sentence: run it with
// REPRISE_SANITIZE=address,undefined too.
#include "frame_data.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace {

using scenes::DepthKind;
using scenes::Scene;

const std::filesystem::path models = "/usr/share/assimp/models"; // Debian's assimp-testmodels

size_t drawnTriangles(const Scene& scene) {
    size_t count = 0;
    for (const auto& instance : scene.instances)
        count += scene.meshes[instance.mesh].indices.size() / 3;
    return count;
}

// Everything that the renderer indexes with.
void expectSound(const Scene& scene) {
    SCOPED_TRACE(scene.name);
    ASSERT_FALSE(scene.instances.empty());
    std::set<uint32_t> ids;
    for (const auto& instance : scene.instances) {
        ASSERT_LT(instance.mesh, scene.meshes.size());
        ASSERT_LT(instance.material, scene.materials.size());
        EXPECT_TRUE(ids.insert(instance.id).second) << "id " << instance.id << " is used twice";
    }
    for (const auto& material : scene.materials) {
        ASSERT_GE(material.texture, -1);
        ASSERT_LT(material.texture, int(scene.textures.size()));
    }
    for (const auto& texture : scene.textures)
        ASSERT_EQ(texture.texels.size(), size_t(texture.width) * texture.height * 4);
    for (const auto& mesh : scene.meshes) {
        ASSERT_EQ(mesh.indices.size() % 3, 0u);
        for (uint32_t index : mesh.indices)
            ASSERT_LT(index, mesh.vertices.size());
        for (const auto& vertex : mesh.vertices) {
            ASSERT_TRUE(std::isfinite(glm::dot(vertex.position, vertex.position)));
            // 1e-4: unit length in single precision after one transform.
            ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
        }
        ASSERT_TRUE(mesh.joints.empty() || mesh.joints.size() == mesh.vertices.size());
        ASSERT_EQ(mesh.joints.size(), mesh.weights.size());
    }
}

std::string refusal(const std::filesystem::path& file) {
    const auto loaded = scenes::loadScene(file);
    return loaded ? "" : loaded.error().message;
}

void expectOneSentence(const std::string& message, const std::filesystem::path& file) {
    ASSERT_FALSE(message.empty()) << file << " was accepted";
    EXPECT_NE(message.find(file.filename().string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
    EXPECT_NE(message.find(';'), std::string::npos) << "it does not say what to do: " << message;
}

// Writes a file that lives as long as the object.
struct TemporaryFile {
    std::filesystem::path path;
    TemporaryFile(const std::string& name, const std::string& content)
        : path(std::filesystem::temp_directory_path() / ("reprise_scene_test_" + name)) {
        std::ofstream(path, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::filesystem::remove(path); }
};

TEST(BuiltInScenes, areSixSoundOnesOfAtMostSixtyThousandTriangles) {
    const std::vector<Scene> all = scenes::builtInScenes();
    std::vector<std::string> names;
    for (const Scene& scene : all) {
        names.push_back(scene.name);
        expectSound(scene);
        EXPECT_LE(drawnTriangles(scene), 60000u) << scene.name;
        EXPECT_FALSE(scene.shows.empty());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"thin_geometry", "fast_object", "hdr_emitters", "foliage",
                                               "static_camera", "camera_cut"}));
}

TEST(LightingScenes, areFiveSoundHallsOfAtMostSixtyThousandTriangles) {
    std::vector<std::string> names;
    for (const Scene& scene : scenes::lightingScenes()) {
        names.push_back(scene.name);
        expectSound(scene);
        EXPECT_LE(drawnTriangles(scene), 60000u) << scene.name;
        EXPECT_FALSE(scene.shows.empty());
        EXPECT_EQ(scene.eventFrame, scene.name == "hall_removed" ? 12 : -1);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"hall_static", "hall_slow_pan", "hall_fast_pan", "hall_moving",
                                               "hall_removed"}));
    EXPECT_EQ(scenes::allScenes().size(), scenes::builtInScenes().size() + names.size());
}

TEST(LightingScenes, loseOneObjectAtTheFrameTheyName) {
    for (const Scene& scene : scenes::lightingScenes()) {
        int lost = 0;
        for (const auto& instance : scene.instances) {
            for (int frame = 1; frame < 64; ++frame) {
                const auto isThere = [&](int at) {
                    return scenes::isPresent(instance.objectToWorld(at / scene.framesPerSecond));
                };
                if (isThere(frame - 1) == isThere(frame)) continue;
                EXPECT_EQ(frame, scene.eventFrame);
                EXPECT_TRUE(isThere(0)) << "it appears instead";
                ++lost;
            }
        }
        EXPECT_EQ(lost, scene.eventFrame < 0 ? 0 : 1) << scene.name;
    }
}

TEST(BuiltInScenes, windTheirTrianglesAroundTheirNormals) {
    for (const Scene& scene : scenes::allScenes()) {
        if (scene.name == "foliage") continue; // its normals are bent on purpose
        for (const auto& mesh : scene.meshes) {
            for (size_t i = 0; i < mesh.indices.size(); i += 3) {
                const auto& a = mesh.vertices[mesh.indices[i]];
                const auto& b = mesh.vertices[mesh.indices[i + 1]];
                const auto& c = mesh.vertices[mesh.indices[i + 2]];
                const glm::dvec3 face = glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position),
                                                   glm::dvec3(c.position) - glm::dvec3(a.position));
                // Poles of spheres have triangles without area, whose normal is rounding alone.
                if (glm::length(face) < 1e-7) continue;
                ASSERT_GT(glm::dot(face, glm::dvec3(a.normal + b.normal + c.normal)), 0.0) << scene.name;
            }
        }
    }
}

TEST(BuiltInScenes, moveFastObjectsEightToTwentyFivePixelsAFrameAtTheirPeak) {
    const std::vector<Scene> all = scenes::builtInScenes();
    const Scene& scene = all[1];
    const auto pixel = [&](const scenes::Instance& instance, int frame) {
        const auto camera = scenes::cameraAt(scene, frame, 640.0 / 360.0);
        const glm::dvec4 clip =
            camera.viewToClip * camera.worldToView * instance.objectToWorld(frame / 60.0)[3];
        return glm::dvec2(clip) / clip.w * glm::dvec2(320, 180);
    };
    double fastest = 0.0;
    for (const auto& instance : scene.instances) {
        if (!instance.moves || instance.palette) continue;
        double peak = 0.0;
        for (int frame = 1; frame < 28; ++frame)
            peak = std::max(peak, glm::length(pixel(instance, frame) - pixel(instance, frame - 1)));
        EXPECT_LE(peak, 25.0);
        fastest = std::max(fastest, peak);
    }
    EXPECT_GE(fastest, 15.0);
}

TEST(BuiltInScenes, cutTheCameraAtTheFrameTheyName) {
    for (const Scene& scene : scenes::builtInScenes()) {
        for (int frame = 1; frame < 24; ++frame) {
            const glm::dmat4 change = scenes::cameraAt(scene, frame, 1.0).worldToView -
                                      scenes::cameraAt(scene, frame - 1, 1.0).worldToView;
            double largest = 0.0;
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r)
                    largest = std::max(largest, std::abs(change[c][r]));
            // Between frames the slow cameras move by centimetres, the cut by metres.
            if (frame == scene.cutFrame)
                EXPECT_GT(largest, 0.5) << scene.name;
            else
                EXPECT_LT(largest, 0.05) << scene.name << " frame " << frame;
        }
    }
}

TEST(Projection, mapsTheNearAndFarPlanesToTheirDepths) {
    const auto depthAt = [](const glm::dmat4& projection, double z) {
        const glm::dvec4 clip = projection * glm::dvec4(0, 0, z, 1);
        return clip.z / clip.w;
    };
    for (bool perspective : {true, false}) {
        const auto make = [&](DepthKind kind) {
            return perspective ? scenes::perspective(0.9, 1.7, 0.1, 50.0, kind)
                               : scenes::orthographic(4.0, 1.7, 0.1, 50.0, kind);
        };
        // 1e-12: a handful of double roundings.
        EXPECT_NEAR(depthAt(make(DepthKind::standard), 0.1), 0.0, 1e-12);
        EXPECT_NEAR(depthAt(make(DepthKind::standard), 50.0), 1.0, 1e-12);
        EXPECT_NEAR(depthAt(make(DepthKind::reversed), 0.1), 1.0, 1e-12);
        EXPECT_NEAR(depthAt(make(DepthKind::reversed), 50.0), 0.0, 1e-12);
    }
    const glm::dmat4 infinite = scenes::perspective(0.9, 1.7, 0.1, 50.0, DepthKind::reversedInfinite);
    EXPECT_NEAR(depthAt(infinite, 0.1), 1.0, 1e-12);
    EXPECT_NEAR(depthAt(infinite, 1e9), 0.0, 1e-9); // 0.1 / 1e9
}

TEST(Loader, refusesEveryMalformedTestModelInOneSentence) {
    size_t refused = 0;
    for (const char* folder :
         {"glTF2/IndexOutOfRange", "glTF2/MissingBin", "glTF2/RecursiveNodes", "glTF2/SchemaFailures",
          "glTF2/TestNoRootNode", "glTF2/wrongTypes", "glTF2/IncorrectVertexArrays",
          "glTF2/BoxWithInfinites-glTF-Binary", "glTF2/issue_3269", "invalid"}) {
        for (const auto& entry : std::filesystem::directory_iterator(models / folder)) {
            expectOneSentence(refusal(entry.path()), entry.path());
            ++refused;
        }
    }
    EXPECT_GE(refused, 30u) << "are the test models installed?";
}

TEST(Loader, refusesDamageThatTheTestModelsDoNotHave) {
    const std::string head = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],)";
    const std::pair<const char*, std::string> cases[] = {
        {"empty.gltf", ""},
        {"nested.gltf", std::string(200000, '[')},
        {"cut.glb", std::string("glTF\2\0\0\0\xff\0\0\0\xff\0\0\0JSON", 20)},
        {"twice.gltf", head + R"("nodes":[{"children":[],"children":[0]}]})"},
        {"parents.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],)"
                         R"("nodes":[{"children":[2]},{"children":[2]},{}]})"},
        {"negative.gltf", head + R"("nodes":[{"mesh":-1}]})"},
        {"huge.gltf", head + R"("nodes":[{}],"buffers":[{"byteLength":1e300}]})"},
        {"kind.gltf", head + R"("nodes":[{}],"images":[{"uri":"a.png","mimeType":"png"}]})"},
        {"quat.gltf", head + R"("nodes":[{"rotation":[0,0,0]}]})"},
        {"nan.obj", "v nan 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n"},
        {"point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"},
        {"zero.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nf 0 1 2\n"},
        {"far.obj", "v 1e30 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n"}};
    for (const auto& [name, content] : cases) {
        const TemporaryFile file(name, content);
        expectOneSentence(refusal(file.path), file.path);
    }
    expectOneSentence(refusal("no_such_file.glb"), "no_such_file.glb");
}

// The importer would make 2^32 - 1 triangles of them: 64 GiB, which a large machine grants.
TEST(Loader, refusesStripsWithoutATriangleBeforeTheImporterCountsThem) {
    for (const char* mode : {"5", "6"})
        for (const int corners : {1, 2}) {
            const TemporaryFile file(
                "strip.gltf",
                R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" +
                    std::string(mode) + R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
                    std::to_string(corners) +
                    R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":24}],)"
                    R"("buffers":[{"byteLength":24,"uri":"data:application/octet-stream;base64,)" +
                    std::string(32, 'A') + R"("}]})");
            EXPECT_NE(refusal(file.path).find("fewer corners than a triangle"), std::string::npos)
                << mode << ", " << corners << ": " << refusal(file.path);
        }
}

TEST(Loader, loadsSoundModels) {
    const std::tuple<const char*, size_t, size_t> files[] = {
        {"glTF2/BoxTextured-glTF/BoxTextured.gltf", 12, 1},
        {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 12, 1},
        {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", 12, 1},
        {"glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf", 12, 1},
        {"glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf", 12,
         0}, // its texture is in a GLSL technique
        {"glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", 12, 0},
        {"glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf", 12, 0},
        {"glTF2/simple_skin/simple_skin.gltf", 8, 0},
        {"glTF2/cameras/Cameras.gltf", 2, 0},
        {"OBJ/spider.obj", 1368, 5}};
    for (const auto& [name, triangles, textures] : files) {
        const auto loaded = scenes::loadScene(models / name);
        ASSERT_TRUE(loaded) << loaded.error().message;
        expectSound(*loaded);
        EXPECT_EQ(drawnTriangles(*loaded), triangles) << name;
        EXPECT_EQ(loaded->textures.size(), textures) << name;
    }
}

TEST(Loader, seesTheWholeModelWithTheOrbitingCamera) {
    const auto loaded = scenes::loadScene(models / "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb");
    ASSERT_TRUE(loaded);
    EXPECT_TRUE(loaded->cameraMoves);
    for (int frame = 0; frame < 600; frame += 60) {
        const auto camera = scenes::cameraAt(*loaded, frame, 1.0);
        for (const auto& vertex : loaded->meshes[0].vertices) {
            const glm::dvec4 world =
                loaded->instances[0].objectToWorld(0.0) * glm::dvec4(vertex.position, 1.0);
            const glm::dvec4 clip = camera.viewToClip * camera.worldToView * world;
            EXPECT_LT(std::max(std::abs(clip.x), std::abs(clip.y)), clip.w) << "frame " << frame;
            EXPECT_TRUE(clip.z > 0.0 && clip.z < clip.w) << "frame " << frame;
        }
    }
}

TEST(Loader, takesTheFilesOwnPerspectiveCamera) {
    const auto loaded = scenes::loadScene(models / "glTF2/cameras/Cameras.gltf");
    ASSERT_TRUE(loaded);
    // The file: at (0.5, 0.5, 3), looking along -z, yfov 0.7. 1e-6: the importer works in single precision.
    EXPECT_NEAR(loaded->verticalFov, 0.7, 1e-6);
    const glm::dvec4 inView = loaded->worldToView(0.0) * glm::dvec4(0.5, 0.5, 0.0, 1.0);
    EXPECT_NEAR(glm::length(inView - glm::dvec4(0, 0, 3, 1)), 0.0, 1e-6);
}

TEST(Loader, playsSkinsInALoop) {
    const auto loaded = scenes::loadScene(models / "glTF2/simple_skin/simple_skin.gltf");
    ASSERT_TRUE(loaded);
    const auto& instance = loaded->instances.at(0);
    ASSERT_TRUE(instance.palette);
    EXPECT_TRUE(instance.moves);
    const auto rest = instance.palette(0.0), bent = instance.palette(1.5),
               again = instance.palette(1.5 + 5.5);
    ASSERT_EQ(rest.size(), 2u);
    // The file turns its second joint by 90 degrees until 1.5 s, over 5.5 s in all.
    EXPECT_NEAR(glm::dot(glm::vec3(rest[1][0]), glm::vec3(bent[1][0])), 0.0f, 1e-4f);
    EXPECT_NEAR(glm::length(bent[1][0] - again[1][0]), 0.0f, 1e-4f);
}

} // namespace
