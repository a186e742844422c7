// Recordings of a flight while it goes on.
#include <gtest/gtest.h>

#include "flying.h"
#include "io/recording_file.h"
#include "support/file_size_limit.h"

namespace weft::viewer {
namespace {

class FlightRecorded : public testing::Test {
protected:
    [[nodiscard]] RecordingRequest request(const std::string& format) const {
        return {.format = format,
                .directory = scratch_.path(),
                .stem = "wave",
                .render = small_flag().render};
    }
    /// From the present frame, `frames` further ones.
    View record(Flight& flight, const std::string& format, std::size_t frames) {
        flight.start_recording(request(format));
        wait_for(flight, [](const FlightView& view) {
            return view.recording.active || !view.recording.error.empty();
        });
        fly(flight, frames);
        return stop(flight);
    }
    static View stop(Flight& flight) {
        flight.stop_recording();
        return ended(flight);
    }
    static View ended(const Flight& flight) {
        return wait_for(flight, [](const FlightView& view) {
            return !view.recording.active && !view.recording.ending &&
                   (!view.recording.files.empty() || !view.recording.error.empty());
        });
    }

    test::ScratchDirectory scratch_;
};

/// Apart, as ThreadSanitizer does not understand the OpenGL driver.
class FlightPictures : public FlightRecorded {};

class FlightRecordedAs : public FlightRecorded, public testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, FlightRecordedAs, testing::Values("pc2", "mdd", "glb"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(FlightRecordedAs, HasTheFramesFromThePresentOneOn) {
    Flight flight(small_flag());
    fly(flight, 7);
    const View view = record(flight, GetParam(), 5);
    EXPECT_EQ(view->recording.error, "");
    EXPECT_EQ(view->recording.frames, 6U);
    ASSERT_FALSE(view->recording.files.empty());
    RecordingFile file(view->recording.files[0]);
    ASSERT_EQ(file.frame_count(), 6U);
    EXPECT_NEAR(file.frames_per_second(), 30.0, 1e-4);
    Simulation simulation(small_flag());
    FrameBuffer buffer;
    for (int n = 0; n < 7; ++n) (void)simulation.advance_frame();
    for (std::size_t n = 0; n < 6; ++n) {
        simulation.capture(buffer);
        const Frame frame = file.frame(n);
        for (std::size_t p = 0; p < buffer.positions.size(); ++p)
            EXPECT_LT(length(frame.positions[p] - buffer.positions[p]), 1e-6);
        (void)simulation.advance_frame();
    }
}

// Byte for byte what a run of so many frames would have written.
TEST_P(FlightRecordedAs, IsTheFileOfARunOfThatLength) {
    Flight flight(small_flag());
    const View view = record(flight, GetParam(), 4);
    ASSERT_FALSE(view->recording.files.empty()) << view->recording.error;
    const test::ScratchDirectory run;
    Simulation simulation(small_flag());
    RecordingPlan plan;
    plan.directory = run.path();
    plan.stem = "wave";
    plan.title = small_flag().name;
    plan.surface = &simulation.surface();
    plan.frame_count = 5;
    plan.render = small_flag().render;
    const auto recorder = make_recorder(GetParam());
    recorder->begin(plan);
    FrameBuffer buffer;
    for (int n = 0; n < 5; ++n) {
        simulation.capture(buffer);
        recorder->frame(buffer.view());
        (void)simulation.advance_frame();
    }
    const auto files = recorder->finish();
    ASSERT_EQ(files.size(), view->recording.files.size());
    for (std::size_t n = 0; n < files.size(); ++n)
        EXPECT_EQ(test::file_text(files[n]), test::file_text(view->recording.files[n])) << files[n];
}

TEST_P(FlightRecordedAs, NeverReplacesARecording) {
    Flight flight(small_flag());
    const std::string format = GetParam();
    const auto first = record(flight, format, 1)->recording.files;
    ASSERT_FALSE(first.empty());
    const std::string bytes = test::file_text(first[0]);
    flight.start_recording(request(format));
    wait_for(flight, [](const FlightView& view) { return view.recording.active; });
    fly(flight, 2);
    const View second = stop(flight);
    EXPECT_EQ(second->recording.files[0].filename(), "wave-2." + format);
    const View third = record(flight, format, 1);
    EXPECT_EQ(third->recording.files[0].filename(), "wave-3." + format);
    EXPECT_EQ(test::file_text(first[0]), bytes);
    EXPECT_EQ(RecordingFile(second->recording.files[0]).frame_count(), 3U);
}

TEST_F(FlightRecorded, LongGlbIsThinnedAndSaysSo) {
    SceneDescription scene = small_flag();
    scene.cloth.grid.resolution = {4, 3};
    Flight flight(scene);
    const View view = record(flight, "glb", 300);
    ASSERT_EQ(view->recording.warnings.size(), 1U);
    EXPECT_NE(view->recording.warnings[0].find("301 frames thinned to 251"), std::string::npos)
        << view->recording.warnings[0];
    EXPECT_EQ(RecordingFile(view->recording.files[0]).frame_count(), 301U);
}

TEST_F(FlightPictures, VideoEndsWhileTheFlightGoesOn) {
    Flight flight(small_flag());
    flight.set_speed(10.0);
    flight.play(true);
    wait_for_frame(flight, 3);
    flight.start_recording(request("mp4"));
    wait_for(flight, [](const FlightView& view) { return view.recording.frames >= 5; });
    const View view = stop(flight);
    EXPECT_EQ(view->recording.error, "");
    ASSERT_EQ(view->recording.files.size(), 1U);
    EXPECT_EQ(view->recording.files[0].filename(), "wave.mp4");
    EXPECT_GT(std::filesystem::file_size(view->recording.files[0]), 500U);
    EXPECT_TRUE(view->playing);
    wait_for_frame(flight, view->lanes[0].frame.index + 2);
}

TEST_F(FlightRecorded, MakesTheDirectory) {
    Flight flight(small_flag());
    RecordingRequest deep = request("pc2");
    deep.directory = scratch_ / "some/where";
    flight.start_recording(deep);
    wait_for(flight, [](const FlightView& view) { return view.recording.active; });
    EXPECT_EQ(stop(flight)->recording.files[0], deep.directory / "wave.pc2");
}

TEST_F(FlightRecorded, WhatCannotBeginSaysWhyAndTheFlightGoesOn) {
    Flight flight(small_flag());
    test::write_text(scratch_ / "file", "in the way");
    RecordingRequest bad = request("pc2");
    bad.directory = scratch_ / "file/folder";
    const std::pair<RecordingRequest, const char*> cases[]{
        {bad, "file/folder"},
        {request("avi"), "avi"},
        {[&] {
             RecordingRequest odd = request("mp4");
             odd.render.size = {63, 47};
             return odd;
         }(),
         "render.size"},
        {[&] {
             RecordingRequest no_texture = request("glb");
             no_texture.render.texture = (scratch_ / "none.png").string();
             return no_texture;
         }(),
         "none.png"}};
    for (const auto& [asked, named] : cases) {
        flight.start_recording(asked);
        const View view = wait_for(flight, [&, text = std::string(named)](const FlightView& one) {
            return one.recording.error.find(text) != std::string::npos;
        });
        EXPECT_FALSE(view->recording.active);
        EXPECT_TRUE(fly(flight, 1)->pristine);
    }
    EXPECT_EQ(scratch_.names(), std::set<std::string>{"file"});
}

TEST_F(FlightRecorded, AFullDiskEndsTheRecordingAndNotTheFlight) {
    for (const char* format : {"pc2", "glb"}) {
        Flight flight(small_flag());
        const test::FileSizeLimit limit(60'000);
        flight.start_recording(request(format));
        wait_for(flight, [](const FlightView& view) { return view.recording.active; });
        for (int n = 0; n < 10 && flight.view()->recording.active; ++n) fly(flight, 10);
        flight.stop_recording();
        const View view =
            wait_for(flight, [](const FlightView& one) { return !one.recording.error.empty(); });
        EXPECT_NE(view->recording.error.find("File too large"), std::string::npos)
            << view->recording.error;
        EXPECT_TRUE(scratch_.names().empty()) << format;
        fly(flight, 2);
    }
}

TEST_F(FlightRecorded, ResetAndAnotherClothEndItProperly) {
    Flight flight(small_flag());
    SceneDescription finer = small_flag();
    finer.cloth.grid.resolution = {25, 17};
    for (int n = 0; n < 2; ++n) {
        flight.start_recording(request("pc2"));
        wait_for(flight, [](const FlightView& view) { return view.recording.active; });
        fly(flight, 3);
        if (n == 0) flight.reset();
        if (n == 1) flight.set_scene(finer);
        const View view = ended(flight);
        EXPECT_EQ(view->recording.error, "");
        EXPECT_EQ(RecordingFile(view->recording.files[0]).frame_count(), 4U);
        EXPECT_EQ(view->lanes[0].frame.index, 0U);
    }
}

TEST_F(FlightRecorded, AnEditDoesNotEndIt) {
    Flight flight(small_flag());
    fly(flight, 1);
    flight.start_recording(request("pc2"));
    wait_for(flight, [](const FlightView& view) { return view.recording.active; });
    SceneDescription scene = small_flag();
    scene.forces.gravity.y = -1.62;
    EXPECT_TRUE(change(flight, scene)->recording.active);
    fly(flight, 2);
    EXPECT_EQ(stop(flight)->recording.frames, 3U);
}

TEST_F(FlightPictures, SayThatTheyLeaveObstaclesBehind) {
    SceneDescription scene = small_flag();
    scene.obstacles.push_back({.shape = SphereObstacle{}});
    Flight flight(scene);
    fly(flight, 1);
    for (const bool moved : {false, true}) {
        flight.start_recording(request("png"));
        wait_for(flight, [](const FlightView& view) { return view.recording.active; });
        scene.forces.gravity.y -= 0.1;
        if (moved) std::get<SphereObstacle>(scene.obstacles[0].shape).centre.x += 0.5;
        change(flight, scene);
        const View view = stop(flight);
        EXPECT_EQ(view->recording.error, "");
        EXPECT_EQ(view->recording.warnings.size(), moved ? 1U : 0U);
    }
}

TEST_F(FlightRecorded, AnotherStartEndsTheFirst) {
    Flight flight(small_flag());
    flight.start_recording(request("pc2"));
    wait_for(flight, [](const FlightView& view) { return view.recording.active; });
    fly(flight, 2);
    flight.start_recording(request("pc2"));
    wait_for(flight, [](const FlightView& view) { return view.recording.frames == 1; });
    EXPECT_EQ(stop(flight)->recording.error, "");
    wait_for(flight, [](const FlightView& view) { return !view.recording.ending; });
    EXPECT_EQ(RecordingFile(scratch_ / "wave.pc2").frame_count(), 3U);
    EXPECT_EQ(RecordingFile(scratch_ / "wave-2.pc2").frame_count(), 1U);
}

TEST_F(FlightRecorded, TheDestructorEndsItProperly) {
    {
        Flight flight(small_flag());
        flight.start_recording(request("pc2"));
        wait_for(flight, [](const FlightView& view) { return view.recording.active; });
        fly(flight, 4);
    }
    EXPECT_EQ(RecordingFile(scratch_ / "wave.pc2").frame_count(), 5U);
    for (const std::string& name : scratch_.names()) EXPECT_FALSE(name.starts_with(".")) << name;
}

}  // namespace
}  // namespace weft::viewer
