// A flight that nobody disturbs: frames, lanes, views, and that nobody waits for it.
#include "viewer/flight.h"

#include <gtest/gtest.h>

#include <set>

#include "flying.h"
#include "forces/wind.h"
#include "support/sanitized.h"
#include "weft/error.h"

namespace weft::viewer {
namespace {

TEST(Flight, BeginsAtRestAtFrameZero) {
    const Flight flight(small_flag());
    const View view = flight.view();
    ASSERT_EQ(view->lanes.size(), 1U);
    const LaneView& lane = view->lanes[0];
    EXPECT_FALSE(view->playing);
    EXPECT_TRUE(view->pristine);
    EXPECT_EQ(view->reached_speed, 0.0);
    EXPECT_EQ(lane.frame.index, 0U);
    EXPECT_EQ(lane.state_hash, Simulation(small_flag()).state_hash());
    EXPECT_EQ(lane.method, "symplectic-euler");
    EXPECT_EQ(view->scene.name, "Flag in the wind");
}

TEST(Flight, TellsWhatTheClothIs) {
    const SceneDescription scene = small_flag();
    const Flight flight(scene);
    const Simulation simulation(scene);
    const ClothShape& shape = *flight.view()->lanes[0].shape;
    const auto springs = simulation.spring_counts();
    EXPECT_EQ(shape.surface.particle_count, 117U);
    EXPECT_EQ(shape.springs.size(), springs[0] + springs[1] + springs[2]);
    EXPECT_EQ(shape.pinned.size(), simulation.pinned_count());
    EXPECT_EQ(shape.edges.size(), 12U * 9U + 13U * 8U);
    EXPECT_DOUBLE_EQ(shape.mass, simulation.total_mass());
    for (const DrawnSpring& spring : shape.springs) {
        const auto& x = flight.view()->lanes[0].frame.positions;
        EXPECT_NEAR(length(x[spring.p] - x[spring.q]), spring.rest_length, 1e-5);
    }
}

TEST(Flight, OneStepIsOneFrame) {
    Flight flight(small_flag());
    for (std::size_t n = 1; n <= 3; ++n) {
        const View view = fly(flight, 1);
        EXPECT_EQ(view->lanes[0].frame.index, n);
        EXPECT_FALSE(view->playing);
    }
}

TEST(Flight, PlaysUntilItIsPaused) {
    Flight flight(small_flag());
    flight.set_speed(50.0);
    flight.play(true);
    const View playing = wait_for_frame(flight, 5);
    EXPECT_TRUE(playing->playing);
    EXPECT_GT(playing->reached_speed, 0.0);
    EXPECT_LE(playing->reached_speed, 50.0);
    flight.play(false);
    const View paused = wait_for(flight, [](const FlightView& view) { return !view.playing; });
    EXPECT_EQ(paused->reached_speed, 0.0);
    EXPECT_EQ(fly(flight, 1)->lanes[0].frame.index, paused->lanes[0].frame.index + 1);
}

TEST(Flight, AStepPauses) {
    Flight flight(small_flag());
    flight.play(true);
    wait_for_frame(flight, 1);
    flight.step();
    wait_for(flight, [](const FlightView& view) { return !view.playing; });
}

/// Scenes of every kind, and how many of their frames are compared.
struct Case {
    const char* scene;
    std::size_t frames;
};

class PristineFlight : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Scenes, PristineFlight,
                         testing::Values(Case{"flag", 20}, Case{"sheet", 6}, Case{"curtain", 6},
                                         Case{"mesh-cape", 6}),
                         [](const auto& one) {
                             std::string name = one.param.scene;
                             std::erase(name, '-');
                             return name;
                         });

TEST_P(PristineFlight, HasTheBitsOfARunInEveryLane) {
    const SceneDescription scene = load_scene(GetParam().scene);
    const std::size_t frames = test::sanitized ? 2 : GetParam().frames;
    Flight flight(scene, {by("implicit-euler", 1.0 / 60.0)});
    flight.set_speed(100.0);
    flight.play(true);
    wait_for_frame(flight, frames);
    flight.play(false);
    const View view = wait_for(flight, [](const FlightView& one) { return !one.playing; });
    EXPECT_TRUE(view->pristine);
    for (const LaneView& lane : view->lanes) {
        SceneDescription flown = view->scene;
        if (&lane != &view->lanes[0]) flown.integrator = by("implicit-euler", 1.0 / 60.0);
        EXPECT_EQ(lane.state_hash, hash_after(flown, lane.frame.index)) << lane.method;
    }
}

TEST(Flight, LanesFlyInStep) {
    Flight flight(small_flag(), {by("rk4"), by("verlet"), by("implicit-euler")});
    flight.set_speed(100.0);
    flight.play(true);
    for (std::size_t n = 1; n < 40; n += 3) {
        const View view = wait_for_frame(flight, n);
        ASSERT_EQ(view->lanes.size(), 4U);
        for (const LaneView& lane : view->lanes) {
            EXPECT_EQ(lane.frame.index, view->lanes[0].frame.index);
            EXPECT_EQ(lane.frame.time, view->lanes[0].frame.time);
            EXPECT_EQ(lane.shape, view->lanes[0].shape);
            EXPECT_GT(lane.milliseconds, 0.0);
        }
        EXPECT_EQ(view->lanes[1].method, "rk4");
        EXPECT_EQ(view->lanes[3].method, "implicit-euler");
    }
}

TEST(Flight, MeasuresBelongToTheFrameTheyStandBeside) {
    SceneDescription scene = small_flag();
    Flight flight(scene);
    flight.set_speed(100.0);
    flight.play(true);
    Simulation simulation(scene);
    for (std::size_t n = 3; n < 60; n += 7) {
        const View view = wait_for_frame(flight, n);
        const LaneView& lane = view->lanes[0];
        while (simulation.frame() < lane.frame.index) (void)simulation.advance_frame();
        EXPECT_EQ(lane.state_hash, simulation.state_hash());
        EXPECT_EQ(lane.energy.total(), simulation.energy().total());
        EXPECT_EQ(lane.largest_strain.strain, simulation.largest_strain().strain);
        EXPECT_EQ(lane.step_count, simulation.step_count());
        const Vec3d wind = wind_velocity(*scene.wind, simulation.time());
        EXPECT_EQ(view->wind, wind);
    }
}

TEST(Flight, AtRestTheStableStepIsThatOfTheStretchedCloth) {
    SceneDescription scene = small_flag();
    scene.forces.gravity.y = -500.0;  // stretched springs are stiffer: "auto" follows them
    Flight flight(scene);
    Simulation simulation(scene);
    EXPECT_EQ(flight.view()->lanes[0].stable_step, simulation.stable_step("symplectic-euler"));
    const View view = fly(flight, 40);
    for (int n = 0; n < 40; ++n) (void)simulation.advance_frame();
    EXPECT_EQ(view->lanes[0].stable_step, simulation.stable_step("symplectic-euler"));
    EXPECT_LT(view->lanes[0].stable_step, Simulation(scene).stable_step("symplectic-euler"));
}

TEST(Flight, AViewThatIsHeldIsNeverWritten) {
    Flight flight(small_flag());
    const View held = fly(flight, 2);
    const std::vector<Vec3d> positions = held->lanes[0].frame.positions;
    const std::uint64_t number = held->number;
    fly(flight, 20);
    EXPECT_EQ(held->lanes[0].frame.positions, positions);
    EXPECT_EQ(held->number, number);
}

TEST(Flight, ViewsThatAreLetGoAreFilledAgain) {
    Flight flight(small_flag());
    std::set<const void*> memory;
    for (int n = 0; n < 50; ++n) memory.insert(fly(flight, 1)->lanes[0].frame.positions.data());
    EXPECT_LE(memory.size(), 5U);
}

TEST(Flight, AViewOutlivesItsFlight) {
    View view;
    {
        Flight flight(small_flag());
        view = fly(flight, 1);
    }
    EXPECT_EQ(view->lanes[0].frame.index, 1U);
    EXPECT_EQ(view->lanes[0].frame.positions.size(), 117U);
}

// By design: no lock is held while a frame is made. Every call returns within one and the same
// frame, which is of thousands of steps.
TEST(Flight, NoCallWaitsForAFrame) {
    SceneDescription scene = small_flag();
    scene.cloth.grid.resolution = {30, 30};
    scene.integrator = by("symplectic-euler", test::sanitized ? 4e-6 : 2e-7);
    Flight flight(scene);
    flight.play(true);
    const View before = wait_for_frame(flight, 1);
    for (int n = 0; n < 50; ++n) {
        flight.set_speed(1.0);
        flight.set_grips(0, {{.particle = 20, .point = {}, .stiffness = 1.0}});
        flight.set_grips(0, {});
        flight.set_scene(scene);
        flight.set_lanes({});
        flight.reset();
        flight.step();
        flight.play(true);
        flight.start_recording({});
        flight.stop_recording();
        EXPECT_EQ(flight.view()->number, before->number);
    }
}

TEST(Flight, FourLanesAreTheMost) {
    const std::vector<IntegratorDescription> four(4, by("rk4"));
    try {
        const Flight flight(small_flag(), four);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("at most 4"), std::string::npos) << error.what();
    }
}

TEST(Flight, ASceneThatCannotBeIsTheConstructorsError) {
    SceneDescription scene = small_flag();
    scene.material.mass_per_area = -1.0;
    EXPECT_THROW(const Flight flight(scene), Error);
    EXPECT_THROW(const Flight flight(small_flag(), {by("no-such-method")}), Error);
}

TEST(Flight, SpeedsThatCannotBeAreRefused) {
    Flight flight(small_flag());
    for (const double speed : {0.0, -1.0, 100.1, std::nan("")}) {
        flight.set_speed(speed);
        const View view =
            wait_for(flight, [](const FlightView& one) { return !one.refusal.empty(); });
        EXPECT_NE(view->refusal.find("at most 100"), std::string::npos) << view->refusal;
        EXPECT_EQ(view->speed, 1.0);
        flight.set_speed(1.0);
        wait_for(flight, [](const FlightView& one) { return one.refusal.empty(); });
    }
}

}  // namespace
}  // namespace weft::viewer
