// glb recordings, read with tinygltf: structure, bytes, every frame's vertices.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>

#include "render/image.h"
#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::file_text;
using test::little_at;
using test::record;
using test::ScratchDirectory;

/// Keeps the picture's file instead of decoding it.
bool keep_picture(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + size);
    return true;
}

tinygltf::Model load(const std::filesystem::path& path) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_picture, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(loader.LoadBinaryFromFile(&model, &error, &warning, path.string())) << error;
    EXPECT_TRUE(warning.empty()) << warning;
    return model;
}

/// Components of a float or uint32 accessor, one after the other; sparse ones filled in.
template <typename T>
std::vector<T> values(const tinygltf::Model& model, int index) {
    const auto& accessor = model.accessors.at(static_cast<std::size_t>(index));
    const auto width = static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    std::vector<T> result(accessor.count * width);
    const auto copy = [&](int view_index, std::size_t offset, std::size_t count, void* to) {
        const auto& view = model.bufferViews.at(static_cast<std::size_t>(view_index));
        EXPECT_LE(offset + count, view.byteLength);
        std::memcpy(to, model.buffers[0].data.data() + view.byteOffset + offset, count);
    };
    if (accessor.bufferView >= 0)
        copy(accessor.bufferView, accessor.byteOffset, result.size() * sizeof(T), result.data());
    if (!accessor.sparse.isSparse) return result;
    const auto changed = static_cast<std::size_t>(accessor.sparse.count);
    std::vector<std::uint32_t> places(changed);
    std::vector<T> numbers(changed);
    EXPECT_EQ(width, 1U);
    copy(accessor.sparse.indices.bufferView, 0, 4 * changed, places.data());
    copy(accessor.sparse.values.bufferView, 0, sizeof(T) * changed, numbers.data());
    for (std::size_t i = 0; i < changed; ++i) result.at(places[i]) = numbers[i];
    return result;
}

/// Greatest difference between rest + target and a frame's positions, over all vertices [m].
double difference(const tinygltf::Model& model, std::size_t target, const Surface& surface,
                  const Frame& frame) {
    const auto& primitive = model.meshes.at(0).primitives.at(0);
    const auto rest = values<float>(model, primitive.attributes.at("POSITION"));
    const auto moves = target == 0
                           ? std::vector<float>(rest.size())
                           : values<float>(model, primitive.targets.at(target - 1).at("POSITION"));
    EXPECT_EQ(rest.size(), 3 * surface.vertex_count());
    EXPECT_EQ(moves.size(), rest.size());
    double greatest = 0.0;
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
        const Vec3d& q = frame.positions[surface.particle(v)];
        const std::array expected{q.x, q.y, q.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double got = double{rest[3 * v + axis]} + double{moves[3 * v + axis]};
            greatest = std::max(greatest, std::abs(got - expected[axis]));
        }
    }
    return greatest;
}

TEST(GlbRecorder, ContainerSizesAgreeWithTheFile) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(5, 4);
    EXPECT_EQ(record("glb", cloth, scratch.path(), 6, 6), std::vector{scratch / "wave.glb"});
    EXPECT_EQ(scratch.names(), std::set<std::string>{"wave.glb"});
    const std::string bytes = file_text(scratch / "wave.glb");
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(little_at<std::uint32_t>(bytes, 4), 2U);
    EXPECT_EQ(little_at<std::uint32_t>(bytes, 8), bytes.size());
    const std::uint32_t json = little_at<std::uint32_t>(bytes, 12);
    EXPECT_EQ(json % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::uint32_t binary = little_at<std::uint32_t>(bytes, 20 + json);
    EXPECT_EQ(bytes.substr(24 + json, 4), std::string("BIN\0", 4));
    EXPECT_EQ(28 + json + binary, bytes.size());
    const tinygltf::Model model = load(scratch / "wave.glb");
    EXPECT_EQ(model.buffers.at(0).data.size(), binary);
}

TEST(GlbRecorder, EveryFrameIsAMorphTarget) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    record("glb", cloth, scratch.path(), 12, 12);
    const tinygltf::Model model = load(scratch / "wave.glb");
    const auto& primitive = model.meshes.at(0).primitives.at(0);
    ASSERT_EQ(primitive.targets.size(), 11U);
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_LE(difference(model, i, cloth.surface, cloth.frame(i)), 2e-7) << i;
}

TEST(GlbRecorder, WeightsSelectOneTargetAtEachKeyframe) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("glb", cloth, scratch.path(), 5, 5);
    const tinygltf::Model model = load(scratch / "wave.glb");
    ASSERT_EQ(model.animations.size(), 1U);
    const auto& animation = model.animations[0];
    EXPECT_EQ(animation.channels.at(0).target_path, "weights");
    EXPECT_EQ(animation.samplers.at(0).interpolation, "LINEAR");
    const auto& output = model.accessors.at(static_cast<std::size_t>(animation.samplers[0].output));
    EXPECT_EQ(output.bufferView, -1);
    EXPECT_TRUE(output.sparse.isSparse);
    EXPECT_EQ(output.sparse.count, 4);
    EXPECT_EQ(values<float>(model, animation.samplers[0].output),
              (std::vector<float>{0, 0, 0, 0,  //
                                  1, 0, 0, 0,  //
                                  0, 1, 0, 0,  //
                                  0, 0, 1, 0,  //
                                  0, 0, 0, 1}));
    const auto times = values<float>(model, animation.samplers[0].input);
    ASSERT_EQ(times.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(times[i], static_cast<float>(static_cast<double>(i) / 30.0));
    const auto& input = model.accessors.at(static_cast<std::size_t>(animation.samplers[0].input));
    EXPECT_EQ(input.minValues, std::vector<double>{times.front()});
    EXPECT_EQ(input.maxValues, std::vector<double>{times.back()});
}

TEST(GlbRecorder, SurfaceHasNormalsTextureCoordinatesAndTriangles) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    record("glb", cloth, scratch.path(), 3, 3);
    const tinygltf::Model model = load(scratch / "wave.glb");
    const auto& primitive = model.meshes.at(0).primitives.at(0);
    const Surface& surface = cloth.surface;
    const auto corners = values<std::uint32_t>(model, primitive.indices);
    ASSERT_EQ(corners.size(), 3 * surface.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(corners[i], surface.triangles[i / 3][i % 3]);
    const auto uvs = values<float>(model, primitive.attributes.at("TEXCOORD_0"));
    const auto normals = values<float>(model, primitive.attributes.at("NORMAL"));
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
        EXPECT_EQ(uvs[2 * v], surface.uvs[v][0]);
        EXPECT_EQ(uvs[2 * v + 1], 1.0F - surface.uvs[v][1]);
    }
    const auto vertex_normal = [](const std::vector<float>& numbers, std::size_t v) {
        return Vec3f{numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Frame frame = cloth.frame(i);
        const auto turns = i == 0 ? std::vector<float>(normals.size())
                                  : values<float>(model, primitive.targets.at(i - 1).at("NORMAL"));
        ASSERT_EQ(turns.size(), normals.size());
        for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
            const Vec3f got = vertex_normal(normals, v) + vertex_normal(turns, v);
            EXPECT_LE(length(got - frame.normals[surface.particle(v)]), i == 0 ? 0.0F : 2e-7F);
        }
    }
}

TEST(GlbRecorder, BoundsOfEveryPositionAccessorAreExact) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(5, 4);
    record("glb", cloth, scratch.path(), 4, 4);
    const tinygltf::Model model = load(scratch / "wave.glb");
    const auto& primitive = model.meshes.at(0).primitives.at(0);
    std::vector<int> accessors{primitive.attributes.at("POSITION")};
    for (const auto& target : primitive.targets) accessors.push_back(target.at("POSITION"));
    for (const int index : accessors) {
        const auto points = values<float>(model, index);
        const auto& accessor = model.accessors.at(static_cast<std::size_t>(index));
        ASSERT_EQ(accessor.minValues.size(), 3U);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float low = points[axis], high = points[axis];
            for (std::size_t i = axis; i < points.size(); i += 3) {
                low = std::min(low, points[i]);
                high = std::max(high, points[i]);
            }
            EXPECT_EQ(accessor.minValues[axis], double{low});
            EXPECT_EQ(accessor.maxValues[axis], double{high});
        }
    }
}

TEST(GlbRecorder, MaterialShowsTheTextureOnBothSides) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("glb", cloth, scratch.path(), 2, 2);
    const tinygltf::Model model = load(scratch / "wave.glb");
    EXPECT_TRUE(model.asset.generator.starts_with("weft "));
    EXPECT_EQ(model.asset.version, "2.0");
    const auto& material = model.materials.at(0);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.pbrMetallicRoughness.metallicFactor, 0.0);
    EXPECT_EQ(material.pbrMetallicRoughness.roughnessFactor, 0.8);
    EXPECT_EQ(material.pbrMetallicRoughness.baseColorTexture.index, 0);
    EXPECT_EQ(model.samplers.at(0).minFilter, TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR);
    EXPECT_EQ(model.samplers.at(0).wrapS, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE);
    EXPECT_EQ(model.images.at(0).mimeType, "image/png");
    EXPECT_EQ(model.images.at(0).image, encode_png(load_texture(test::small_texture())));
}

TEST(GlbRecorder, TextureBeyondTheUnitSquareRepeats) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    cloth.surface.uvs[4] = {1.5F, 0.5F};
    record("glb", cloth, scratch.path(), 2, 2);
    EXPECT_EQ(load(scratch / "wave.glb").samplers.at(0).wrapS, TINYGLTF_TEXTURE_WRAP_REPEAT);
}

TEST(GlbRecorder, OneFrameHasNoAnimation) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("glb", cloth, scratch.path(), 300, 1);
    const tinygltf::Model model = load(scratch / "wave.glb");
    EXPECT_TRUE(model.animations.empty());
    EXPECT_TRUE(model.meshes.at(0).primitives.at(0).targets.empty());
    EXPECT_LE(difference(model, 0, cloth.surface, cloth.frame(0)), 0.0);
}

TEST(GlbRecorder, FewerFramesThanPlannedMakeAWholeFile) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("glb", cloth, scratch.path(), 200, 7);
    const tinygltf::Model model = load(scratch / "wave.glb");
    ASSERT_EQ(model.meshes.at(0).primitives.at(0).targets.size(), 6U);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_LE(difference(model, i, cloth.surface, cloth.frame(i)), 2e-7) << i;
}

/// What of `came` of `planned` frames a glb keeps.
struct Thinned {
    tinygltf::Model model;
    std::vector<float> times;
    std::vector<std::string> warnings;
};

Thinned record_thinned(test::WavingCloth& cloth, const ScratchDirectory& scratch,
                       std::size_t planned, std::size_t came) {
    const auto recorder = make_recorder("glb");
    recorder->begin(test::plan_of(cloth, scratch.path(), planned));
    for (std::size_t i = 0; i < came; ++i) recorder->frame(cloth.frame(i));
    recorder->finish();
    Thinned result{load(scratch / "wave.glb"), {}, recorder->warnings()};
    result.times = values<float>(result.model, result.model.animations.at(0).samplers.at(0).input);
    for (std::size_t key = 0; key < result.times.size(); ++key) {
        const auto frame = static_cast<std::size_t>(std::lround(double{result.times[key]} * 30.0));
        EXPECT_EQ(result.times[key], static_cast<float>(cloth.frame(frame).time));
        EXPECT_LE(difference(result.model, key, cloth.surface, cloth.frame(frame)), 1e-6) << key;
    }
    return result;
}

TEST(GlbRecorder, TwoHundredFiftyTargetsAreNotThinned) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    const Thinned result = record_thinned(cloth, scratch, 251, 251);
    EXPECT_EQ(result.model.meshes.at(0).primitives.at(0).targets.size(), 250U);
    EXPECT_TRUE(result.warnings.empty());
}

TEST(GlbRecorder, LongerRecordingsAreThinnedWithTrueTimesAndAWarning) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    const Thinned result = record_thinned(cloth, scratch, 600, 600);
    EXPECT_EQ(result.model.meshes.at(0).primitives.at(0).targets.size(), 250U);
    EXPECT_EQ(result.times.front(), 0.0F);
    EXPECT_EQ(result.times.back(), static_cast<float>(599.0 / 30.0));
    EXPECT_EQ(
        result.warnings,
        std::vector<std::string>{"wave.glb: 600 frames thinned to 251 (at most 250 morph targets, "
                                 "4 GiB)"});
}

TEST(GlbRecorder, ThinnedAndInterruptedKeepsTheLastFrameThatCame) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    // 2501 planned frames are thinned to every tenth; 58 is none of those.
    const Thinned result = record_thinned(cloth, scratch, 2501, 59);
    ASSERT_EQ(result.times.size(), 7U);
    EXPECT_EQ(result.times[5], static_cast<float>(50.0 / 30.0));
    EXPECT_EQ(result.times[6], static_cast<float>(58.0 / 30.0));
    EXPECT_EQ(result.warnings.size(), 1U);
}

TEST(GlbRecorder, ZeroNormalsBecomeUnit) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    for (Vec3d& q : cloth.rest) q = {0.0, 1.0, 0.0};
    record("glb", cloth, scratch.path(), 2, 2);
    const tinygltf::Model model = load(scratch / "wave.glb");
    const auto normals =
        values<float>(model, model.meshes.at(0).primitives.at(0).attributes.at("NORMAL"));
    for (std::size_t v = 0; v < 9; ++v) {
        EXPECT_EQ(normals[3 * v], 0.0F);
        EXPECT_EQ(normals[3 * v + 1], 1.0F);
        EXPECT_EQ(normals[3 * v + 2], 0.0F);
    }
}

TEST(GlbRecorder, UnreadableTextureIsAFileErrorAndLeavesNothing) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    auto plan = test::plan_of(cloth, scratch.path(), 3);
    plan.render.texture = scratch / "none.png";
    try {
        make_recorder("glb")->begin(plan);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
    }
    EXPECT_TRUE(scratch.names().empty());
}

}  // namespace
}  // namespace weft
