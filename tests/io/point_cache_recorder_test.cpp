// PC2 and MDD recordings, byte by byte, with the OBJ and the Blender script beside them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "io/blender_script.h"
#include "support/recording.h"

namespace weft {
namespace {

using test::big_at;
using test::file_text;
using test::little_at;
using test::record;
using test::ScratchDirectory;

/// Every position of every frame, compared with the float nearest to the formula's.
template <typename ReadFloat>
void expect_positions(test::WavingCloth& cloth, std::size_t frames, std::size_t head,
                      const ReadFloat& read) {
    const std::size_t particles = cloth.surface.particle_count;
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const Frame expected = cloth.frame(frame);
        for (std::size_t p = 0; p < particles; ++p) {
            const std::size_t at = head + 12 * (frame * particles + p);
            ASSERT_EQ(read(at), static_cast<float>(expected.positions[p].x));
            ASSERT_EQ(read(at + 4), static_cast<float>(expected.positions[p].y));
            ASSERT_EQ(read(at + 8), static_cast<float>(expected.positions[p].z));
        }
    }
}

void expect_pc2(const std::string& bytes, test::WavingCloth& cloth, std::size_t frames) {
    const std::size_t particles = cloth.surface.particle_count;
    ASSERT_EQ(bytes.size(), 32 + 12 * particles * frames);
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    EXPECT_EQ(little_at<std::int32_t>(bytes, 12), 1);
    EXPECT_EQ(little_at<std::int32_t>(bytes, 16), static_cast<std::int32_t>(particles));
    EXPECT_EQ(little_at<float>(bytes, 20), 0.0F);
    EXPECT_EQ(little_at<float>(bytes, 24), 1.0F);
    EXPECT_EQ(little_at<std::int32_t>(bytes, 28), static_cast<std::int32_t>(frames));
    expect_positions(cloth, frames, 32,
                     [&](std::size_t at) { return little_at<float>(bytes, at); });
}

void expect_mdd(const std::string& bytes, test::WavingCloth& cloth, std::size_t frames) {
    const std::size_t particles = cloth.surface.particle_count;
    ASSERT_EQ(bytes.size(), 8 + 4 * frames + 12 * particles * frames);
    EXPECT_EQ(big_at<std::int32_t>(bytes, 0), static_cast<std::int32_t>(frames));
    EXPECT_EQ(big_at<std::int32_t>(bytes, 4), static_cast<std::int32_t>(particles));
    for (std::size_t i = 0; i < frames; ++i)
        EXPECT_EQ(big_at<float>(bytes, 8 + 4 * i),
                  static_cast<float>(static_cast<double>(i) / cloth.frames_per_second));
    expect_positions(cloth, frames, 8 + 4 * frames,
                     [&](std::size_t at) { return big_at<float>(bytes, at); });
}

TEST(Pc2Recorder, WritesHeadAndSamplesExactly) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(7, 5);
    const auto files = record("pc2", cloth, scratch.path(), 4, 4);
    EXPECT_EQ(files, (std::vector{scratch / "wave.pc2", scratch / "wave.obj",
                                  scratch / "open_in_blender.py"}));
    EXPECT_EQ(scratch.names(),
              (std::set<std::string>{"wave.pc2", "wave.obj", "open_in_blender.py"}));
    EXPECT_EQ(std::filesystem::file_size(scratch / "wave.pc2"), 32U + 12U * 35U * 4U);
    expect_pc2(file_text(scratch / "wave.pc2"), cloth, 4);
}

TEST(Pc2Recorder, FewerFramesThanPlannedCountTruly) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("pc2", cloth, scratch.path(), 100, 2);
    expect_pc2(file_text(scratch / "wave.pc2"), cloth, 2);
}

TEST(Pc2Recorder, SeamedMeshHasOnePointForEachParticle) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    ASSERT_EQ(cloth.surface.particle_count, 24U);
    ASSERT_EQ(cloth.surface.vertex_count(), 28U);
    record("pc2", cloth, scratch.path(), 3, 3);
    expect_pc2(file_text(scratch / "wave.pc2"), cloth, 3);
}

TEST(MddRecorder, WritesHeadTimesAndFramesExactly) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(7, 5);
    const auto files = record("mdd", cloth, scratch.path(), 4, 4);
    EXPECT_EQ(files, (std::vector{scratch / "wave.mdd", scratch / "wave.obj",
                                  scratch / "open_in_blender.py"}));
    expect_mdd(file_text(scratch / "wave.mdd"), cloth, 4);
}

TEST(MddRecorder, FewerFramesThanPlannedShortenTheTable) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(5, 3);
    record("mdd", cloth, scratch.path(), 1000, 3);
    expect_mdd(file_text(scratch / "wave.mdd"), cloth, 3);
}

/// An OBJ as its lines say, in order.
struct ObjLines {
    std::vector<std::array<float, 3>> v;
    std::vector<std::array<float, 2>> vt;
    std::vector<std::vector<std::array<std::uint32_t, 2>>> faces;  ///< corners v/vt, from 0
};

ObjLines read_obj(const std::filesystem::path& path) {
    ObjLines obj;
    std::istringstream lines(file_text(path));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key, word;
        words >> key;
        std::vector<std::string> rest;
        while (words >> word) rest.push_back(word);
        const auto number = [&](std::size_t i) { return std::strtof(rest.at(i).c_str(), nullptr); };
        if (key == "v") obj.v.push_back({number(0), number(1), number(2)});
        if (key == "vt") obj.vt.push_back({number(0), number(1)});
        if (key != "f") continue;
        obj.faces.emplace_back();
        for (const std::string& corner : rest) {
            const std::size_t slash = corner.find('/');
            obj.faces.back().push_back(
                {static_cast<std::uint32_t>(std::stoul(corner.substr(0, slash))) - 1,
                 static_cast<std::uint32_t>(std::stoul(corner.substr(slash + 1))) - 1});
        }
    }
    return obj;
}

TEST(PointCacheMesh, HasTheParticlesOfFrameZeroAndTheFacesOfTheSurface) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    record("pc2", cloth, scratch.path(), 2, 2);
    const ObjLines obj = read_obj(scratch / "wave.obj");
    const Surface& surface = cloth.surface;
    const Frame first = cloth.frame(0);
    ASSERT_EQ(obj.v.size(), 24U);
    for (std::size_t p = 0; p < 24; ++p) {
        const auto expected = vec3_cast<float>(first.positions[p]);
        EXPECT_EQ(obj.v[p], (std::array{expected.x, expected.y, expected.z}));
    }
    EXPECT_EQ(obj.vt, surface.uvs);
    ASSERT_EQ(obj.faces.size(), 24U);  // 6 quads as 12 triangles, then 12 quads
    for (std::size_t f = 0; f < obj.faces.size(); ++f) {
        const bool triangle = surface.faces[f][3] == Surface::no_vertex;
        ASSERT_EQ(obj.faces[f].size(), triangle ? 3U : 4U);
        for (std::size_t corner = 0; corner < obj.faces[f].size(); ++corner) {
            const std::uint32_t vertex = surface.faces[f][corner];
            EXPECT_EQ(obj.faces[f][corner], (std::array{surface.particle(vertex), vertex}));
        }
    }
}

TEST(PointCacheMesh, IsTheSameBesidePc2AndMdd) {
    ScratchDirectory pc2, mdd;
    auto cloth = test::waving_grid(4, 4);
    record("pc2", cloth, pc2.path(), 2, 2);
    record("mdd", cloth, mdd.path(), 2, 2);
    EXPECT_EQ(file_text(pc2 / "wave.obj"), file_text(mdd / "wave.obj"));
}

std::string script_after(std::initializer_list<std::string_view> formats,
                         const std::filesystem::path& directory) {
    auto cloth = test::waving_grid(4, 4);
    std::vector<std::unique_ptr<Recorder>> recorders;
    for (const auto format : formats) {
        recorders.push_back(make_recorder(format));
        recorders.back()->begin(test::plan_of(cloth, directory, 3));
    }
    for (std::size_t i = 0; i < 3; ++i)
        for (const auto& recorder : recorders) recorder->frame(cloth.frame(i));
    for (const auto& recorder : recorders) recorder->finish();
    return file_text(directory / "open_in_blender.py");
}

TEST(BlenderScript, OpensThePc2WhereThisRunWroteOne) {
    ScratchDirectory a, b, c;
    EXPECT_NE(script_after({"pc2", "mdd"}, a.path()).find("CACHE = \"wave.pc2\""),
              std::string::npos);
    EXPECT_NE(script_after({"mdd", "pc2"}, b.path()).find("CACHE = \"wave.pc2\""),
              std::string::npos);
    EXPECT_NE(script_after({"mdd"}, c.path()).find("CACHE = \"wave.mdd\""), std::string::npos);
}

TEST(BlenderScript, DoesNotOpenThePc2OfAnEarlierRun) {
    ScratchDirectory scratch;
    script_after({"pc2"}, scratch.path());
    const auto pc2 = scratch / "wave.pc2";
    std::filesystem::last_write_time(
        pc2, std::filesystem::last_write_time(pc2) - std::chrono::seconds(1));
    EXPECT_NE(script_after({"mdd"}, scratch.path()).find("CACHE = \"wave.mdd\""),
              std::string::npos);
}

TEST(BlenderScript, SaysWhatTheRecordingHas) {
    const std::string script = blender_script({.title = "A \"fine\" flag",
                                               .mesh = "flag.obj",
                                               .cache = "flag.pc2",
                                               .points = 2501,
                                               .frames = 301,
                                               .frames_per_second = 24.0});
    for (const char* line : {"TITLE = \"A \\\"fine\\\" flag\"\n", "MESH = \"flag.obj\"\n",
                             "CACHE = \"flag.pc2\"\n", "POINTS = 2501\n", "FRAMES = 301\n",
                             "FPS = 24 ", "FPS_BASE = 1\n", "cache.frame_start = 1\n"})
        EXPECT_NE(script.find(line), std::string::npos) << line;
}

TEST(BlenderScript, WritesAnyFrameRateAsWholeNumberOverDivisor) {
    for (const double rate : {24.0, 25.0, 29.97, 30.0, 59.94, 12.5, 0.5, 1000.0 / 3.0}) {
        const BlenderFrameRate found = blender_frame_rate(rate);
        EXPECT_GE(found.fps, 1);
        EXPECT_LE(found.fps, 32767);
        EXPECT_NEAR(found.fps / found.base, rate, 1e-12 * rate);
    }
    EXPECT_EQ(blender_frame_rate(29.97).fps, 30);
    EXPECT_NEAR(blender_frame_rate(29.97).base, 1.001001, 1e-6);
    EXPECT_EQ(blender_frame_rate(25.0).base, 1.0);
}

}  // namespace
}  // namespace weft
