// Recordings read back: whole ones give their frames, bad ones an error that says why.
#include "io/recording_file.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::file_text;
using test::record;
using test::ScratchDirectory;

double difference(std::span<const Vec3d> a, std::span<const Vec3d> b) {
    EXPECT_EQ(a.size(), b.size());
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, length(a[i] - b[i]));
    return greatest;
}

class ReadBack : public testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] std::filesystem::path file(const ScratchDirectory& scratch) const {
        return scratch / ("wave." + std::string(GetParam()));
    }
};

INSTANTIATE_TEST_SUITE_P(Formats, ReadBack, testing::Values("pc2", "mdd", "glb"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(ReadBack, GridHasItsFramesAndRate) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(7, 5);
    cloth.frames_per_second = 24.0;
    record(GetParam(), cloth, scratch.path(), 10, 10);
    RecordingFile recording(file(scratch));
    EXPECT_EQ(recording.frame_count(), 10U);
    EXPECT_EQ(recording.frames_per_second(), 24.0);
    EXPECT_EQ(recording.surface().particle_count, 35U);
    EXPECT_EQ(recording.surface().vertex_count(), 35U);
    EXPECT_EQ(recording.surface().triangles.size(), 48U);
    for (std::size_t i = 0; i < 10; ++i) {
        const Frame frame = recording.frame(i), expected = cloth.frame(i);
        EXPECT_EQ(frame.index, i);
        EXPECT_EQ(frame.time, expected.time);
        EXPECT_LE(difference(frame.positions, expected.positions), 2e-7);
        EXPECT_EQ(frame.velocities.size(), 35U);
        for (std::size_t p = 0; p < 35; ++p)
            EXPECT_LE(length(frame.normals[p] - expected.normals[p]), 1e-5F);
    }
}

TEST_P(ReadBack, SeamIsOneParticleWithTwoTextureCoordinates) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    record(GetParam(), cloth, scratch.path(), 2, 2);
    RecordingFile recording(file(scratch));
    const Surface& surface = recording.surface();
    EXPECT_EQ(surface.particle_count, 24U);
    ASSERT_EQ(surface.vertex_count(), 28U);
    ASSERT_EQ(surface.triangles.size(), cloth.surface.triangles.size());
    const Frame frame = recording.frame(1), expected = cloth.frame(1);
    // Vertices may be numbered anew: compare what stands at each triangle's corners.
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t got = surface.triangles[t][k];
            const std::uint32_t want = cloth.surface.triangles[t][k];
            EXPECT_NEAR(surface.uvs[got][0], cloth.surface.uvs[want][0], 1e-6);
            EXPECT_NEAR(surface.uvs[got][1], cloth.surface.uvs[want][1], 1e-6);
            EXPECT_LE(length(frame.positions[surface.particle(got)] -
                             expected.positions[cloth.surface.particle(want)]),
                      3e-7);
        }
}

TEST_P(ReadBack, OneFrameIsEnough) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record(GetParam(), cloth, scratch.path(), 1, 1);
    RecordingFile recording(file(scratch));
    EXPECT_EQ(recording.frame_count(), 1U);
    EXPECT_LE(difference(recording.frame(0).positions, cloth.frame(0).positions), 2e-7);
}

TEST_P(ReadBack, FrameOutOfRangeIsAUsageError) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record(GetParam(), cloth, scratch.path(), 4, 4);
    RecordingFile recording(file(scratch));
    try {
        recording.frame(4);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.message(), "has no frame 4: frames 0 to 3 are there");
    }
}

TEST_P(ReadBack, EveryTruncationIsAFileError) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record(GetParam(), cloth, scratch.path(), 3, 3);
    const std::string whole = file_text(file(scratch));
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 300);
    for (std::size_t size = 0; size < whole.size(); size += step) {
        test::write_text(file(scratch), std::string_view(whole).substr(0, size));
        try {
            RecordingFile recording(file(scratch));
            FAIL() << "no error at " << size << " bytes";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            EXPECT_EQ(error.place().file, file(scratch).string());
        }
    }
}

TEST_P(ReadBack, TrailingBytesAreAFileError) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record(GetParam(), cloth, scratch.path(), 3, 3);
    test::write_text(file(scratch), file_text(file(scratch)) + "more");
    EXPECT_THROW(RecordingFile(file(scratch)), Error);
}

TEST_P(ReadBack, AlteredBytesNeverDoHarm) {
    // Each byte of the head or JSON, and some of the data: an error or frames, never a crash.
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(2, 2);
    record(GetParam(), cloth, scratch.path(), 2, 2);
    const std::string whole = file_text(file(scratch));
    const std::size_t end = std::min<std::size_t>(whole.size(), 3000);
    for (std::size_t at = 0; at < end; ++at) {
        std::string altered = whole;
        altered[at] = std::array{'\xff', '\x01', '9'}[at % 3];
        test::write_text(file(scratch), altered);
        try {
            RecordingFile recording(file(scratch));
            recording.frame(recording.frame_count() - 1);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file) << error.what();
        }
    }
}

TEST_P(ReadBack, MissingFileAndDirectoryAreFileErrors) {
    ScratchDirectory scratch;
    EXPECT_THROW(RecordingFile(file(scratch)), Error);
    std::filesystem::create_directory(file(scratch));
    EXPECT_THROW(RecordingFile(file(scratch)), Error);
}

TEST(ReadBackGlb, ThinnedRecordingGivesItsFramesBlended) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(4, 4);
    record("glb", cloth, scratch.path(), 501, 501);  // keeps every second
    RecordingFile recording(scratch / "wave.glb");
    ASSERT_EQ(recording.frame_count(), 501U);
    for (const std::size_t i : {0U, 2U, 250U, 498U, 500U})
        EXPECT_LE(difference(recording.frame(i).positions, cloth.frame(i).positions), 1e-6) << i;
    for (const std::size_t i : {1U, 251U, 499U}) {
        const Frame before = cloth.frame(i - 1);
        const std::vector<Vec3d> first(before.positions.begin(), before.positions.end());
        const Frame after = cloth.frame(i + 1);
        std::vector<Vec3d> middle;
        for (std::size_t p = 0; p < first.size(); ++p)
            middle.push_back(0.5 * (first[p] + after.positions[p]));
        EXPECT_LE(difference(recording.frame(i).positions, middle), 2e-6) << i;
    }
}

/// Opens `name` in a directory where `spoil` has changed a good recording; the error must say
/// `why`.
void expect_refused(const std::string& format, const std::string& why,
                    const std::function<void(const std::filesystem::path& file)>& spoil) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record(format, cloth, scratch.path(), 2, 2);
    const auto file = scratch / ("wave." + format);
    spoil(file);
    try {
        RecordingFile recording(file);
        for (std::size_t i = 0; i < recording.frame_count(); ++i) recording.frame(i);
        FAIL() << "no error: " << why;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

/// Puts `bytes` at `offset` of a file.
auto put(std::size_t offset, std::string bytes) {
    return [=](const std::filesystem::path& file) {
        std::string text = file_text(file);
        text.replace(offset, bytes.size(), bytes);
        test::write_text(file, text);
    };
}

/// Replaces `from` by `to` in the JSON of a glb, whose padding makes up for the length.
auto replace(const std::string& from, const std::string& to) {
    return [=](const std::filesystem::path& file) {
        const std::string text = file_text(file);
        const std::size_t room = test::little_at<std::uint32_t>(text, 12);
        std::string json = text.substr(20, room);
        const std::size_t at = json.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        json.replace(at, from.size(), to);
        json.resize(json.find_last_not_of(' ') + 1);
        ASSERT_LE(json.size(), room);
        json.resize(room, ' ');
        put(20, json)(file);
    };
}

TEST(BadPointCache, IsRefusedWithTheReason) {
    using namespace std::string_literals;
    expect_refused("pc2", "does not begin with POINTCACHE2", put(0, "POINTCLOUDS"));
    expect_refused("pc2", "PC2 version 2 is not known", put(12, "\2"));
    expect_refused("pc2", "has 248 bytes: 9 particles and 3 frames make 356", put(28, "\3"));
    expect_refused("pc2", "0 particles and 2 frames", put(16, "\0"s));
    expect_refused("pc2", "-1 frames", put(28, "\xff\xff\xff\xff"));
    expect_refused("pc2", "frame 1: the position of particle 0 is not finite",
                   put(32 + 108, "\0\0\xc0\x7f"s));
    expect_refused("mdd", "3 frames make", put(3, "\3"));
    expect_refused("mdd", "-1 frames", put(0, "\xff\xff\xff\xff"));
    expect_refused("mdd", "0 particles", put(7, "\0"s));
    expect_refused("mdd", "frame 0: the position of particle 1 is not finite",
                   put(16 + 12, "\x7f\x80\0\0"s));
}

TEST(BadPointCache, NeedsTheMeshBesideIt) {
    for (const char* format : {"pc2", "mdd"}) {
        expect_refused(format, "wave.obj", [](const std::filesystem::path& file) {
            std::filesystem::remove(std::filesystem::path(file).replace_extension(".obj"));
        });
        expect_refused(format, "moves 9 particles, but", [](const std::filesystem::path& file) {
            auto other = test::waving_grid(3, 4);
            ScratchDirectory elsewhere;
            record("pc2", other, elsewhere.path(), 1, 1);
            std::filesystem::copy_file(elsewhere / "wave.obj",
                                       std::filesystem::path(file).replace_extension(".obj"),
                                       std::filesystem::copy_options::overwrite_existing);
        });
    }
}

TEST(PointCache, OfAnotherProgramTakesItsRateFromMddTimes) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    cloth.frames_per_second = 50.0;
    record("mdd", cloth, scratch.path(), 6, 6);
    record("pc2", cloth, scratch.path(), 6, 6);
    const std::string obj = file_text(scratch / "wave.obj");
    test::write_text(scratch / "wave.obj", obj.substr(obj.find("v ")));
    EXPECT_NEAR(RecordingFile(scratch / "wave.mdd").frames_per_second(), 50.0, 1e-5);
    EXPECT_EQ(RecordingFile(scratch / "wave.pc2").frames_per_second(), 30.0);
}

TEST(BadGlb, IsRefusedWithTheReason) {
    using namespace std::string_literals;
    expect_refused("glb", "does not begin with glTF", put(0, "OBJ!"));
    expect_refused("glb", "glTF version 1 is not known", put(4, "\1"));
    expect_refused("glb", "its first chunk is not JSON", put(16, "BIN\0"s));
    expect_refused("glb", "its JSON cannot be read", put(20, "["));
    expect_refused("glb", "CUBICSPLINE animations are not read", replace("LINEAR", "CUBICSPLINE"));
}

TEST(BadGlb, PartsThatDoNotFitAreRefused) {
    expect_refused("glb", "\"attributes\" is missing", replace("\"attributes\"", "\"attributed\""));
    expect_refused("glb", "\"POSITION\"", replace("\"POSITION\"", "\"POSITIVE\""));
    expect_refused("glb", "has no nodes[7]", replace("{\"node\":0", "{\"node\":7"));
    expect_refused("glb", "must hold SCALAR of floats", replace("\"input\":6", "\"input\":1"));
    expect_refused("glb", "reaches beyond its buffer view",
                   replace("\"count\":24", "\"count\":99"));
    expect_refused("glb", "do not make triangles", replace("\"count\":24", "\"count\":23"));
    expect_refused("glb", "reaches beyond the binary chunk",
                   replace("\"byteLength\":96,", "\"byteLength\":90000000,"));
    expect_refused("glb", "a triangle names vertex", [](const std::filesystem::path& file) {
        const std::string text = file_text(file);
        const std::size_t json = test::little_at<std::uint32_t>(text, 12);
        put(28 + json, "\x63")(file);
    });
}

TEST(Recording, OtherEndingsAreNone) {
    EXPECT_TRUE(is_recording("a/flag.pc2"));
    EXPECT_TRUE(is_recording("flag.mdd"));
    EXPECT_TRUE(is_recording("flag.glb"));
    EXPECT_FALSE(is_recording("flag.toml"));
    EXPECT_FALSE(is_recording("flag"));
    EXPECT_THROW(RecordingFile("flag.toml"), Error);
}

}  // namespace
}  // namespace weft
