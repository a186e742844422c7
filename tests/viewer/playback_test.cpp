#include "viewer/playback.h"

#include <gtest/gtest.h>

#include "weft/error.h"

#include "support/recording.h"

namespace weft::viewer {
namespace {

constexpr std::size_t frames = 12;

class PlaybackOf : public testing::TestWithParam<const char*> {
protected:
    PlaybackOf() : cloth_(test::waving_grid(7, 5)) {
        test::record(GetParam(), cloth_, scratch_.path(), frames, frames);
        render_.texture = test::small_texture();
    }
    [[nodiscard]] Playback open() const {
        return Playback(scratch_ / (std::string("wave.") + GetParam()), render_);
    }
    /// Largest distance between the frame shown and the one that was recorded [m].
    double error(Playback& playback) {
        const Frame shown = playback.frame(), meant = cloth_.frame(playback.frame_index());
        EXPECT_EQ(shown.positions.size(), meant.positions.size());
        double largest = 0.0;
        for (std::size_t p = 0; p < shown.positions.size(); ++p)
            largest = std::max(largest, length(shown.positions[p] - meant.positions[p]));
        return largest;
    }

    test::ScratchDirectory scratch_;
    test::WavingCloth cloth_;
    RenderDescription render_;
};

INSTANTIATE_TEST_SUITE_P(Formats, PlaybackOf, testing::Values("pc2", "mdd", "glb"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(PlaybackOf, ShowsEveryFrameThatWasRecorded) {
    Playback playback = open();
    ASSERT_EQ(playback.frame_count(), frames);
    EXPECT_NEAR(playback.frames_per_second(), 30.0, 1e-4);
    for (std::size_t n = 0; n < frames; ++n) {
        playback.seek(n);
        EXPECT_EQ(playback.frame().index, n);
        EXPECT_LT(error(playback), 1e-6);
    }
}

TEST_P(PlaybackOf, HasAShapeToDraw) {
    Playback playback = open();
    ASSERT_NE(playback.shape(), nullptr);
    EXPECT_EQ(playback.shape()->surface.particle_count, 35U);
    EXPECT_EQ(playback.shape()->surface.triangles.size(), 48U);
    EXPECT_GE(playback.shape()->edges.size(), 58U);  // of quads, or of the triangles they became
    EXPECT_GT(playback.shape()->stage.size, 1.0F);
    EXPECT_NE(playback.shape()->surface_number, open().shape()->surface_number);
}

TEST_P(PlaybackOf, PlaysByTheClock) {
    Playback playback = open();
    EXPECT_TRUE(playback.playing());
    playback.advance(0.9 / 30.0);
    EXPECT_EQ(playback.frame_index(), 0U);
    playback.advance(0.2 / 30.0);
    EXPECT_EQ(playback.frame_index(), 1U);
    playback.set_speed(0.5);
    playback.advance(4.0 / 30.0);
    EXPECT_EQ(playback.frame_index(), 3U);
    playback.play(false);
    playback.advance(1.0);
    EXPECT_EQ(playback.frame_index(), 3U);
    EXPECT_LT(error(playback), 1e-6);
}

TEST_P(PlaybackOf, BeginsAgainOrStopsAtTheEnd) {
    Playback playback = open();
    playback.advance((frames + 2.5) / 30.0);
    EXPECT_EQ(playback.frame_index(), 2U);
    EXPECT_TRUE(playback.playing());
    playback.set_loop(false);
    playback.advance(100.0);
    EXPECT_EQ(playback.frame_index(), frames - 1);
    EXPECT_FALSE(playback.playing());
    playback.play(true);
    EXPECT_EQ(playback.frame_index(), 0U);
    playback.advance(1.5 / 30.0);
    EXPECT_EQ(playback.frame_index(), 1U);
}

TEST_P(PlaybackOf, StepsStayWithinAndPause) {
    Playback playback = open();
    playback.step(1);
    EXPECT_FALSE(playback.playing());
    EXPECT_EQ(playback.frame_index(), 1U);
    playback.step(-5);
    EXPECT_EQ(playback.frame_index(), 0U);
    playback.step(1000);
    EXPECT_EQ(playback.frame_index(), frames - 1);
    playback.step(-1);
    EXPECT_EQ(playback.frame_index(), frames - 2);
    playback.seek(10'000);
    EXPECT_EQ(playback.frame_index(), frames - 1);
}

TEST(Playback, OneFrameIsARecording) {
    const test::ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    test::record("pc2", cloth, scratch.path(), 1, 1);
    Playback playback(scratch / "wave.pc2", {});
    playback.advance(7.3);
    EXPECT_EQ(playback.frame_index(), 0U);
    playback.set_loop(false);
    playback.advance(7.3);
    EXPECT_FALSE(playback.playing());
}

TEST(Playback, WhatIsNoRecordingIsAFileError) {
    const test::ScratchDirectory scratch;
    test::write_text(scratch / "cut.pc2", "POINTCACHE2");
    for (const auto& path : {scratch / "none.pc2", scratch / "cut.pc2", scratch / "wave.toml"}) {
        try {
            const Playback playback(path, {});
            FAIL() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file) << error.what();
        }
    }
}

}  // namespace
}  // namespace weft::viewer
