// What the window does with what is open, without a window: opening, editing, refusing, saving,
// recording and playing back.
#include "viewer/workbench.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "flying.h"
#include "weft/error.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;

// In a directory of its own, as recordings are made in the present one.
class WorkbenchTest : public testing::Test {
protected:
    void SetUp() override {
        before_ = fs::current_path();
        place_ = fs::path(testing::TempDir()) / ("workbench_" + name());
        fs::remove_all(place_);
        fs::create_directories(place_);
        fs::current_path(place_);
    }
    void TearDown() override {
        fs::current_path(before_);
        fs::remove_all(place_);
    }
    static std::string name() {
        return testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    static WindowRequest paused(SceneDescription scene) {
        WindowRequest request;
        request.scene = std::move(scene);
        request.paused = true;
        request.threads = 1;
        return request;
    }
    template <typename Wanted>
    static void refresh_until(Workbench& bench, const Wanted& wanted) {
        const Clock::time_point start = Clock::now();
        while (!wanted()) {
            ASSERT_LT(seconds_between(start, Clock::now()), 120.0);
            bench.refresh();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    static std::size_t frame_of(const Workbench& bench) {
        return bench.view().lanes.front().frame.index;
    }
    static void fly_to(Workbench& bench, std::size_t frame) {
        while (frame_of(bench) < frame) {
            const std::size_t present = frame_of(bench);
            bench.step(1);
            refresh_until(bench, [&] { return frame_of(bench) > present; });
        }
    }

    WindowSettings settings_;
    fs::path place_, before_;
};

TEST_F(WorkbenchTest, ASavedSceneRunsToTheSameState) {
    Workbench bench(paused(small_flag()), settings_);
    bench.set_parameter(*find_parameter("wind.velocity.x"), 7.0);
    bench.end_gesture();
    refresh_until(bench, [&] { return bench.view().scene.wind->velocity.x == 7.0; });
    fly_to(bench, 5);
    EXPECT_TRUE(bench.view().pristine);
    EXPECT_TRUE(bench.unsaved());
    bench.save("mine.toml", false);
    EXPECT_FALSE(bench.unsaved());
    EXPECT_EQ(bench.suggested_file(), "mine.toml");
    Simulation again(load_scene("mine.toml"));
    for (int n = 0; n < 5; ++n) ASSERT_TRUE(again.advance_frame().ok());
    EXPECT_EQ(again.state_hash(), bench.view().lanes.front().state_hash);
    ASSERT_EQ(bench.files().size(), 1U);
}

TEST_F(WorkbenchTest, ASceneSavedWithItsStateBeginsThere) {
    Workbench bench(paused(small_flag()), settings_);
    fly_to(bench, 4);
    bench.save("held.toml", true);
    EXPECT_EQ(Simulation(load_scene("held.toml")).state_hash(),
              bench.view().lanes.front().state_hash);
    EXPECT_EQ(bench.files().size(), 2U);
}

TEST_F(WorkbenchTest, AValueThatIsNotAllowedIsRefusedAndForgotten) {
    Workbench bench(paused(small_flag()), settings_);
    const Parameter& parameter = *find_parameter("material.structural.stiffness");
    bench.set_parameter(parameter, -1.0);
    EXPECT_FALSE(bench.history().can_undo());
    const Refusal* refusal = bench.refusal(std::string(parameter.label));
    ASSERT_NE(refusal, nullptr);
    EXPECT_NE(refusal->text.find("material.structural.stiffness"), std::string::npos);
    bench.set_parameter(parameter, -1.0);
    EXPECT_EQ(bench.messages.all().size(), 1U);
}

TEST_F(WorkbenchTest, WhatTheFlightRefusesIsTakenBack) {
    SceneDescription scene = small_flag();
    scene.integrator.time_step = 1e-4;
    Workbench bench(paused(scene), settings_);
    SceneDescription changed = scene;
    changed.pins.front().select = BoxSelection{{50.0, 50.0, 50.0}, {51.0, 51.0, 51.0}};
    bench.edit(changed, "pins");  // a box with nothing in it: only the cloth can tell
    bench.end_gesture();
    refresh_until(bench, [&] { return bench.refusal("pins") != nullptr; });
    EXPECT_FALSE(bench.history().can_undo());
    EXPECT_TRUE(std::holds_alternative<EdgeSelection>(bench.scene().pins.front().select));
    refresh_until(bench, [&] { return bench.view().refusal.empty(); });
}

TEST_F(WorkbenchTest, ADragThatTheFlightRefusesLeavesTheEditBefore) {
    Workbench bench(paused(small_flag()), settings_);
    bench.set_parameter(*find_parameter("wind.velocity.x"), 7.0);
    bench.end_gesture();
    for (const double x : {50.0, 51.0, 52.0}) {
        SceneDescription changed = bench.scene();
        changed.pins.front().select = BoxSelection{{x, 50.0, 50.0}, {x + 0.5, 51.0, 51.0}};
        bench.edit(changed, "pins");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that each is refused
    }
    refresh_until(bench, [&] { return bench.refusal("pins") != nullptr; });
    refresh_until(bench, [&] { return bench.view().refusal.empty(); });
    EXPECT_EQ(bench.scene().wind->velocity.x, 7.0);
    EXPECT_EQ(bench.view().scene.wind->velocity.x, 7.0);
    EXPECT_TRUE(std::holds_alternative<EdgeSelection>(bench.scene().pins.front().select));
}

TEST_F(WorkbenchTest, ARecordingOverBeforeItWasSeenIsToldOf) {
    Workbench bench(paused(small_flag()), settings_);
    bench.start_recording("pc2", bench.render());
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    bench.stop_recording();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    refresh_until(bench, [&] { return !bench.playable().empty(); });
    EXPECT_FALSE(bench.busy());
}

TEST_F(WorkbenchTest, LanesThatCannotFlyAreTakenBack) {
    SceneDescription scene = small_flag();
    scene.material.structural.damping = scene.material.shear.damping = 0.0;
    scene.material.bend.damping = 0.0;
    Workbench bench(paused(scene), settings_);
    bench.set_lanes({lane_of(scene, "forward-euler")});  // is stable at no step, so has no "auto"
    refresh_until(bench, [&] { return bench.refusal("lanes") != nullptr; });
    EXPECT_TRUE(bench.lanes().empty());
    bench.set_lanes({lane_of(scene, "rk4")});
    refresh_until(bench, [&] { return bench.view().lanes.size() == 2; });
    EXPECT_EQ(bench.view().lanes[1].method, "rk4");
}

TEST_F(WorkbenchTest, ADivergenceIsNotedOnceAndMended) {
    SceneDescription scene = small_flag();
    scene.integrator.time_step = 0.02;
    Workbench bench(paused(scene), settings_);
    bench.toggle_play();
    refresh_until(bench, [&] { return bench.view().lanes.front().divergence.has_value(); });
    for (int n = 0; n < 5; ++n) bench.refresh();
    EXPECT_EQ(bench.messages.all().size(), 1U);
    EXPECT_EQ(bench.remedy(), Remedy::stable_step);
    bench.apply_remedy();
    refresh_until(bench,
                  [&] { return !bench.view().lanes.front().divergence && frame_of(bench) >= 3; });
    EXPECT_LE(bench.view().lanes.front().time_step, bench.view().lanes.front().stable_step);
    EXPECT_TRUE(bench.view().pristine);
    EXPECT_EQ(bench.history().undo_what(), "time step");
}

TEST_F(WorkbenchTest, ARecordingIsPlayedBackAndTheSceneWaits) {
    Workbench bench(paused(small_flag()), settings_);
    bench.set_parameter(*find_parameter("wind.velocity.x"), 7.0);
    bench.start_recording("pc2", bench.render());
    refresh_until(bench, [&] { return bench.recording(); });
    fly_to(bench, 3);
    bench.stop_recording();
    refresh_until(bench, [&] { return !bench.playable().empty(); });
    EXPECT_EQ(bench.playable().filename(), "flag.pc2");
    ASSERT_EQ(bench.messages.present().size(), 1U);
    EXPECT_EQ(bench.messages.present()[0].text.substr(0, 18), "Recorded 4 frames:");
    bench.open(bench.playable().string());
    ASSERT_TRUE(bench.plays_recording());
    EXPECT_EQ(bench.playback().frame_count(), 4U);
    EXPECT_EQ(bench.title(), "flag.pc2");
    EXPECT_TRUE(bench.unsaved());
    bench.return_to_scene();
    EXPECT_FALSE(bench.plays_recording());
    EXPECT_EQ(bench.scene().wind->velocity.x, 7.0);
    EXPECT_EQ(frame_of(bench), 3U);
}

TEST_F(WorkbenchTest, ARecordingThatCannotBeginIsSaid) {
    Workbench bench(paused(small_flag()), settings_);
    RenderDescription render = bench.render();
    render.texture = "none.png";
    bench.start_recording("mp4", render);
    refresh_until(bench, [&] { return !bench.messages.present().empty(); });
    EXPECT_EQ(bench.messages.present()[0].kind, MessageKind::trouble);
    EXPECT_FALSE(bench.busy());
}

TEST_F(WorkbenchTest, WhatCannotBeOpenedLeavesWhatIsOpen) {
    Workbench bench(paused(small_flag()), settings_);
    fly_to(bench, 2);
    EXPECT_THROW(bench.open("none.toml"), Error);
    EXPECT_THROW(bench.open("none.pc2"), Error);
    std::ofstream("bad.toml") << "version = 1\n[cloth]\nsize = 3\n";
    EXPECT_THROW(bench.open("bad.toml"), Error);
    EXPECT_EQ(frame_of(bench), 2U);
    EXPECT_FALSE(bench.plays_recording());
    EXPECT_TRUE(settings_.recent.empty());
    bench.save("good.toml", false);
    bench.open("good.toml");
    EXPECT_EQ(settings_.recent.front(), (fs::current_path() / "good.toml").string());
    EXPECT_EQ(bench.stem(), "good");
}

TEST_F(WorkbenchTest, NeverSuggestsToReplaceAShippedScene) {
    SceneDescription scene = load_scene("flag");
    scene.cloth.grid.resolution = {9, 7};
    EXPECT_EQ(Workbench(paused(scene), settings_).suggested_file(), "./flag-edited.toml");
}

}  // namespace
}  // namespace weft::viewer
