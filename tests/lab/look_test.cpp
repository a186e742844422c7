// Flights kept for pictures, the sets that are flown, and what is made of them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "lab/look/look_show.h"
#include "support/cloth_scenes.h"
#include "support/temporary_study.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::lab {
namespace {

using test::no_watch;

namespace fs = std::filesystem;
SceneDescription swinging_sheet() {
    SceneDescription scene = test::bare_sheet(6, 5);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    scene.integrator.method = "velocity-verlet";
    scene.integrator.time_step = 1.0 / 512;
    scene.output.frames_per_second = 32.0;
    scene.output.duration = 0.5;
    scene.render.mast = false;
    return scene;
}

TEST(ShapeText, IsReadBackWithinAPartOfItsBox) {
    const Shape shape{{-1.5, 0.25, 7.0}, {2.5, 0.25, -9.0}, {0.1, 0.25, 1e-3}};
    const Shape back = shape_from_text(shape_to_text(shape));
    ASSERT_EQ(back.size(), 3u);
    for (std::size_t p = 0; p < 3; ++p) {
        EXPECT_NEAR(back[p].x, shape[p].x, 4.0 / (1 << 18));
        EXPECT_EQ(back[p].y, 0.25);
        EXPECT_NEAR(back[p].z, shape[p].z, 16.0 / (1 << 18));
    }
    EXPECT_EQ(back[1].x, 2.5);
    EXPECT_EQ(shape_to_text(shape).find(' '), 4u);  // "-1.5 "
}

TEST(ShapeText, RefusesWhatIsNoShape) {
    const std::string good = shape_to_text(Shape{{0.0, 1.0, 2.0}, {1.0, 2.0, 3.0}});
    EXPECT_EQ(shape_from_text(good).size(), 2u);
    for (const std::string& bad : {std::string("nonsense"), good.substr(0, good.size() - 1),
                                   good.substr(0, good.size() - 1) + "*", std::string()}) {
        EXPECT_THROW((void)shape_from_text(bad), Error) << bad;
    }
}

TEST(LookFlight, KeepsWhatASimulationShows) {
    const SceneDescription scene = swinging_sheet();
    Specimen specimen(scene);
    const LookPlan plan{"velocity-verlet", 1.0 / 32, 16, {0, 3, 8}};
    const LookFlight flight =
        look_flight_from_json(to_json(fly_for_look(specimen, plan, no_watch)));
    ASSERT_EQ(flight.shapes.size(), 3u);
    EXPECT_FALSE(flight.failed);
    Simulation simulation(scene);
    FrameBuffer frame;
    for (int n = 0; n < 8; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
    simulation.capture(frame);
    for (std::size_t p = 0; p < specimen.particle_count(); ++p) {
        EXPECT_LT(length(flight.shapes[2][p] - frame.positions[p]), 1e-5);
    }
    EXPECT_EQ(flight.wrinkles[0], 0.0);
    EXPECT_GT(flight.wrinkles[2], 0.0);
    EXPECT_NEAR(rms_distance(flight.shapes[0], flight.shapes[0]), 0.0, 0.0);
    EXPECT_GT(rms_distance(flight.shapes[0], flight.shapes[2]), 0.01);
}

TEST(LookFlight, EndsWhereItBlowsUpWithTheLastShapeThatWasACloth) {
    Specimen specimen(swinging_sheet());
    const LookPlan plan{"forward-euler", 1.0 / 32, 2, {0, 1, 100, 1000}};
    const LookFlight flight =
        look_flight_from_json(to_json(fly_for_look(specimen, plan, no_watch)));
    ASSERT_TRUE(flight.failed);
    EXPECT_EQ(flight.failure, blown_up);
    EXPECT_LT(flight.shapes.size(), 4u);
    ASSERT_EQ(flight.last.size(), specimen.particle_count());
    const double size = std::sqrt(2.0);
    for (const Vec3d& x : flight.last) EXPECT_LT(length(x), 3.0 * size + size);
}

TEST(LookSets, OwnSceneIsFlownByEveryMethodAtAStepOfItsOwn) {
    std::vector<std::string_view> all;
    for (const IntegratorInfo& info : integrator_catalogue()) all.push_back(info.name);
    const LookSet set = own_look(swinging_sheet(), all, false);
    EXPECT_EQ(set.flights.size(), all.size());
    EXPECT_NEAR(set.end(), 0.5, 1e-12);
    EXPECT_EQ(set.cut, "");
    ASSERT_EQ(set.columns.size(), 5u);
    for (std::size_t c = 0; c < 5; ++c) {
        EXPECT_NEAR(set.time(set.columns[c].shape), 0.1 * static_cast<double>(c + 1), 1e-12);
    }
    EXPECT_EQ(set.columns[4].title, "0.5 s");
    for (const LookSpec& spec : set.flights) {
        EXPECT_EQ(spec.plan.frames, set.frames);
        EXPECT_EQ(spec.note.empty(),
                  spec.plan.method != "forward-euler" && spec.plan.method != "rk2")
            << spec.plan.method;
    }
    ASSERT_TRUE(set.reference);
    EXPECT_GT(set.reference->plan.steps_per_frame, set.flights[7].plan.steps_per_frame);
}

TEST(LookSets, ManyParticlesShortenTheFlightsAndSaySo) {
    SceneDescription scene = swinging_sheet();
    scene.cloth.grid.resolution = {200, 200};
    scene.output.duration = 8.0;
    const LookSet set = own_look(scene, {"velocity-verlet"}, true);
    EXPECT_LT(set.end(), 0.1);
    EXPECT_NE(set.cut.find("cut from 2 s"), std::string::npos) << set.cut;
    EXPECT_EQ(set.columns.size(), 5u);
    EXPECT_LE(set.frames.size(), 6u);
    EXPECT_EQ(set.frames.back(), 50u);
}

TEST(LookSets, ThePapersScenesAreTheirs) {
    const LookSet flag = flag_look(true);
    ASSERT_EQ(flag.flights.size(), 3u);
    EXPECT_EQ(flag.flights[0].plan.method, "forward-euler");
    EXPECT_EQ(flag.flights[0].plan.time_step(), flag.flights[2].plan.time_step());
    EXPECT_LT(flag.flights[1].plan.time_step(), 1e-4);
    EXPECT_EQ(flag.flights[2].plan.method, "verlet");
    const LookSet sheet = sheet_look();
    ASSERT_EQ(sheet.flights.size(), 7u);
    for (const LookSpec& spec : sheet.flights) {
        EXPECT_NEAR(spec.plan.time_step(), spec.plan.method == "rk4" ? 0.001 : 0.016, 1e-15);
    }
    EXPECT_TRUE(sheet.flights[1].compared);
    EXPECT_FALSE(sheet.flights[5].compared);  // other forces than the reference's
}

class LookTest : public ::testing::Test {
protected:
    LookTest()
        : directory_(
              fs::temp_directory_path() /
              ("weft-look-" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(directory_);
    }
    ~LookTest() override { fs::remove_all(directory_); }

    [[nodiscard]] Laboratory laboratory(std::function<bool()> stop = {}) const {
        LabOptions options;
        options.quick = true;
        options.stop = std::move(stop);
        Laboratory made(swinging_sheet(), directory_, options);
        made.begin_experiment("look", 1.0, 1);
        return made;
    }

    fs::path directory_;
};

TEST_F(LookTest, MakesStripVideoPlotsAndTable) {
    Laboratory lab = laboratory();
    std::vector<Flown> all =
        fly_all(lab, {own_look(swinging_sheet(), {"forward-euler", "verlet", "rk4"}, true)});
    ASSERT_EQ(all.size(), 1u);
    const Flown& flown = all.front();
    EXPECT_LT(flown.last_distance(2), flown.last_distance(1));  // rk4 is nearer than verlet
    const Media strip = film_strip(flown, {64, 48}, lab);
    EXPECT_EQ(strip.file, directory_ / "look" / "scene-strip.png");
    const Image picture = load_texture(strip.file.string());
    EXPECT_EQ(picture.width, 5 * 68 + 4);
    EXPECT_EQ(picture.height, 3 * (48 + 22 + 4) + 26);
    EXPECT_NE(strip.text.find("Film strip of 3 flights"), std::string::npos);
    const Media video = flight_video(flown, {64, 48}, lab);
    EXPECT_EQ(video.file.extension(), ".mp4");
    EXPECT_GT(fs::file_size(video.file), 1000u);
    const Table table = flight_table(flown);
    EXPECT_EQ(table.rows.size(), 3u);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(distance_plot(flown).series.size(), 3u);
    EXPECT_EQ(wrinkle_plot(flown).series.size(), 4u);  // with the reference
    for (const Plot& plot : {distance_plot(flown), wrinkle_plot(flown)}) {
        EXPECT_NE(plot.x_label.find("[s]"), std::string::npos);
        EXPECT_FALSE(plot.text.empty());
    }
}

TEST_F(LookTest, StopsBetweenTwoPicturesAndLeavesNoHalfFile) {
    Laboratory lab = laboratory();
    std::vector<Flown> all = fly_all(lab, {own_look(swinging_sheet(), {"verlet"}, true)});
    int asked = 0;
    const Laboratory stopping = laboratory([&] { return ++asked > 2; });
    EXPECT_THROW((void)film_strip(all.front(), {64, 48}, stopping), Interrupted);
    asked = 0;
    EXPECT_THROW((void)flight_video(all.front(), {64, 48}, stopping), Interrupted);
    EXPECT_TRUE(!fs::exists(directory_ / "look") || fs::is_empty(directory_ / "look"));
}

TEST_F(LookTest, AFlightThatSeveralSetsNeedIsMadeOnce) {
    Laboratory lab = laboratory();
    LookSet set = own_look(swinging_sheet(), {"verlet"}, true);
    set.reference = set.flights.front();
    const std::vector<Flown> all = fly_all(lab, {set, set});
    EXPECT_EQ(all[1].last_distance(0), 0.0);
    std::size_t kept = 0;
    for (const auto& entry : fs::directory_iterator(directory_ / "trials" / "look")) {
        kept += entry.is_regular_file() ? 1 : 0;
    }
    EXPECT_EQ(kept, 1u);
}

}  // namespace
}  // namespace weft::lab
