// A flight that is disturbed: other scenes, lanes, grips, resets, divergence.
#include <gtest/gtest.h>

#include "flying.h"

namespace weft::viewer {
namespace {

SceneDescription on_the_moon(SceneDescription scene = small_flag()) {
    scene.forces.gravity.y = -1.62;
    return scene;
}

/// Blows up within a frame or two.
IntegratorDescription far_too_long() {
    return by("symplectic-euler", 1.0 / 60.0);
}

SceneDescription stiff_flag() {
    SceneDescription scene = small_flag();
    for (SpringMaterial* spring : {&scene.material.structural, &scene.material.shear})
        spring->stiffness = 1e5;
    return scene;
}

TEST(FlightChanges, BeforeTheFirstFrameTheRunIsThatOfTheNewScene) {
    Flight flight(small_flag());
    const View changed = change(flight, on_the_moon());
    EXPECT_TRUE(changed->pristine);
    EXPECT_EQ(changed->scene.forces.gravity.y, -1.62);
    const View view = fly(flight, 10);
    EXPECT_TRUE(view->pristine);
    EXPECT_EQ(view->lanes[0].state_hash, hash_after(on_the_moon(), 10));
}

TEST(FlightChanges, InFlightItGoesOnFromWhereItIs) {
    Flight flight(small_flag());
    const View before = fly(flight, 8);
    const View changed = change(flight, on_the_moon());
    EXPECT_EQ(changed->lanes[0].frame.index, 8U);
    EXPECT_EQ(changed->lanes[0].frame.time, before->lanes[0].frame.time);
    EXPECT_EQ(changed->lanes[0].frame.positions, before->lanes[0].frame.positions);
    EXPECT_EQ(changed->lanes[0].shape, before->lanes[0].shape);
    EXPECT_FALSE(changed->pristine);
    EXPECT_EQ(changed->refusal, "");

    Simulation simulation(small_flag());
    for (int n = 0; n < 8; ++n) (void)simulation.advance_frame();
    simulation.change_scene(on_the_moon());
    for (int n = 0; n < 5; ++n) (void)simulation.advance_frame();
    EXPECT_EQ(fly(flight, 5)->lanes[0].state_hash, simulation.state_hash());
}

TEST(FlightChanges, WhatIsNotPhysicsDisturbsNothing) {
    Flight flight(small_flag());
    fly(flight, 4);
    SceneDescription renamed = small_flag();
    renamed.name = "Another flag";
    renamed.output.duration = 99.0;
    renamed.render.mast = false;
    const View changed = change(flight, renamed);
    EXPECT_EQ(changed->scene.name, "Another flag");
    EXPECT_FALSE(changed->lanes[0].shape->stage.mast.has_value());
    const View view = fly(flight, 4);
    EXPECT_TRUE(view->pristine);
    EXPECT_EQ(view->lanes[0].state_hash, hash_after(small_flag(), 8));
}

TEST(FlightChanges, AnotherClothBeginsAnew) {
    Flight flight(small_flag());
    const View before = fly(flight, 4);
    SceneDescription finer = small_flag();
    finer.cloth.grid.resolution = {25, 17};
    const View changed = change(flight, finer);
    EXPECT_EQ(changed->lanes[0].frame.index, 0U);
    EXPECT_EQ(changed->lanes[0].frame.positions.size(), 425U);
    EXPECT_EQ(changed->lanes[0].shape->surface.particle_count, 425U);
    EXPECT_NE(changed->lanes[0].shape->surface_number, before->lanes[0].shape->surface_number);
    EXPECT_TRUE(changed->pristine);
    EXPECT_EQ(fly(flight, 3)->lanes[0].state_hash, hash_after(finer, 3));
}

TEST(FlightChanges, AnotherPrecisionOrFrameRateBeginsAnew) {
    Flight flight(small_flag());
    SceneDescription scene = small_flag();
    scene.integrator.precision = Precision::f64;
    fly(flight, 2);
    EXPECT_EQ(change(flight, scene)->lanes[0].frame.index, 0U);
    fly(flight, 2);
    scene.output.frames_per_second = 50.0;
    EXPECT_EQ(change(flight, scene)->lanes[0].frame.index, 0U);
    EXPECT_EQ(fly(flight, 1)->lanes[0].frame.time, 1.0 / 50.0);
}

TEST(FlightChanges, PinsAndMassMakeAnotherShapeOfTheSameSurface) {
    Flight flight(small_flag());
    const View before = fly(flight, 2);
    SceneDescription scene = small_flag();
    scene.pins = {{.select = EdgeSelection::top_left, .motion = {}}};
    scene.material.mass_per_area *= 2.0;
    const View changed = change(flight, scene);
    const ClothShape &old = *before->lanes[0].shape, &now = *changed->lanes[0].shape;
    EXPECT_EQ(now.pinned, std::vector<std::uint32_t>{0});
    EXPECT_NEAR(now.mass, 2.0 * old.mass, 1e-12);
    EXPECT_EQ(now.surface_number, old.surface_number);
    EXPECT_EQ(changed->lanes[0].frame.index, 2U);
}

TEST(FlightChanges, ARefusedSceneLeavesTheOldOneFlying) {
    Flight flight(small_flag());
    fly(flight, 3);
    SceneDescription bad = small_flag();
    bad.material.mass_per_area = -1.0;
    const View refused = change(flight, bad);
    EXPECT_NE(refused->refusal.find("material.mass_per_area"), std::string::npos)
        << refused->refusal;
    EXPECT_EQ(refused->scene.material.mass_per_area, small_flag().material.mass_per_area);
    bad = small_flag();
    bad.pins = {{.select = ParticleSelection{{100'000}}, .motion = {}}};
    EXPECT_NE(change(flight, bad)->refusal, "");
    bad = small_flag();
    bad.cloth.grid.resolution = {1, 1};
    EXPECT_NE(change(flight, bad)->refusal, "");

    const View view = fly(flight, 3);
    EXPECT_TRUE(view->pristine);
    EXPECT_EQ(view->lanes[0].state_hash, hash_after(small_flag(), 6));
    EXPECT_EQ(change(flight, on_the_moon())->refusal, "");
}

// Forward Euler needs damping: undamped, no step of it is stable.
TEST(FlightChanges, WhatOneLaneRefusesNoLaneTakes) {
    Flight flight(small_flag(), {by("forward-euler")});
    fly(flight, 3);
    SceneDescription undamped = small_flag();
    for (SpringMaterial* spring :
         {&undamped.material.structural, &undamped.material.shear, &undamped.material.bend})
        spring->damping = 0.0;
    const View refused = change(flight, undamped);
    EXPECT_NE(refused->refusal, "");
    EXPECT_GT(refused->scene.material.structural.damping, 0.0);
    const View view = fly(flight, 3);
    EXPECT_EQ(view->lanes[0].frame.index, 6U);
    EXPECT_EQ(view->lanes[1].frame.index, 6U);
}

TEST(FlightChanges, OfManyScenesTheLastCounts) {
    Flight flight(small_flag());
    flight.play(true);
    SceneDescription scene = small_flag();
    for (int n = 1; n <= 100; ++n) {
        scene.forces.gravity.y = -0.1 * n;
        flight.set_scene(scene);
    }
    const View view = wait_for(
        flight, [&](const FlightView& one) { return one.scene.forces.gravity.y == -0.1 * 100; });
    EXPECT_EQ(view->refusal, "");
}

TEST(FlightChanges, ResetBeginsTheSceneAsItNowIs) {
    Flight flight(small_flag(), {by("rk4")});
    fly(flight, 4);
    change(flight, on_the_moon());
    flight.set_grips(1, {{.particle = 116, .point = {0, 0, 1}, .stiffness = 10.0}});
    EXPECT_FALSE(fly(flight, 2)->pristine);
    flight.reset();
    wait_for(flight, [](const FlightView& view) { return view.pristine; });
    const View view = fly(flight, 5);
    EXPECT_EQ(view->lanes[0].frame.index, 5U);
    SceneDescription other = on_the_moon();
    other.integrator = by("rk4");
    EXPECT_EQ(view->lanes[0].state_hash, hash_after(on_the_moon(), 5));
    EXPECT_EQ(view->lanes[1].state_hash, hash_after(other, 5));
    EXPECT_EQ(view->lanes[1].grip_force, Vec3d{});
}

TEST(FlightChanges, NewLanesRestartTogether) {
    Flight flight(small_flag());
    fly(flight, 5);
    flight.set_lanes({by("rk4"), by("implicit-euler")});
    const View view = wait_for(flight, [](const FlightView& one) { return one.lanes.size() == 3; });
    for (const LaneView& lane : view->lanes) EXPECT_EQ(lane.frame.index, 0U);
    EXPECT_TRUE(view->pristine);
    flight.set_lanes({by("no-such-method")});
    const View refused =
        wait_for(flight, [](const FlightView& one) { return !one.refusal.empty(); });
    EXPECT_EQ(refused->lanes.size(), 3U);
    EXPECT_EQ(fly(flight, 2)->lanes[2].frame.index, 2U);
}

TEST(FlightChanges, ALaneThatDivergesStopsAndTheOthersGoOn) {
    Flight flight(stiff_flag(), {far_too_long()});
    flight.set_speed(100.0);
    flight.play(true);
    const View view =
        wait_for(flight, [](const FlightView& one) { return one.lanes[1].divergence.has_value(); });
    const std::size_t last_good = view->lanes[1].frame.index;
    EXPECT_NE(view->lanes[1].divergence->message, "");
    EXPECT_NE(view->lanes[1].divergence->advice, "");
    const View later = wait_for_frame(flight, last_good + 10);
    EXPECT_TRUE(later->playing);
    EXPECT_EQ(later->lanes[1].frame.index, last_good);
    EXPECT_EQ(later->lanes[1].frame.positions, view->lanes[1].frame.positions);
}

TEST(FlightChanges, WhenAllHaveDivergedItPauses) {
    SceneDescription scene = stiff_flag();
    scene.integrator = far_too_long();
    Flight flight(scene);
    flight.play(true);
    const View view =
        wait_for(flight, [](const FlightView& one) { return one.lanes[0].divergence.has_value(); });
    EXPECT_FALSE(view->playing);
    const std::size_t stopped_at = view->lanes[0].frame.index;
    // With a step it can take it goes on from there ...
    scene.integrator.time_step.reset();
    const View changed = change(flight, scene);
    EXPECT_FALSE(changed->lanes[0].divergence.has_value());
    EXPECT_EQ(fly(flight, 3)->lanes[0].frame.index, stopped_at + 3);
    // ... and a reset begins anew, once more into the wall.
    scene.integrator = far_too_long();
    change(flight, scene);
    flight.reset();
    wait_for(flight, [](const FlightView& one) { return one.lanes[0].frame.index == 0; });
    flight.play(true);
    wait_for(flight, [](const FlightView& one) { return one.lanes[0].divergence.has_value(); });
    flight.reset();
    const View again = wait_for(
        flight, [](const FlightView& one) { return !one.lanes[0].divergence.has_value(); });
    EXPECT_EQ(again->lanes[0].frame.index, 0U);
    EXPECT_TRUE(again->pristine);
}

TEST(FlightChanges, AGripPullsUntilItLetsGo) {
    Flight flight(small_flag());
    const View before = fly(flight, 1);
    const Vec3d corner = before->lanes[0].frame.positions[116];
    const Vec3d hand = corner + Vec3d{0.0, 0.0, 1.0};
    flight.set_grips(0, {{.particle = 116, .point = hand, .stiffness = 20.0, .damping = 0.1}});
    const View held =
        wait_for(flight, [](const FlightView& view) { return view.lanes[0].grip_force.z > 0.0; });
    EXPECT_TRUE(held->pristine);  // it has not moved anything yet
    const View pulled = fly(flight, 10);
    EXPECT_FALSE(pulled->pristine);
    EXPECT_LT(length(pulled->lanes[0].frame.positions[116] - hand), 0.5);
    flight.set_grips(0, {});
    const View loose = wait_for(
        flight, [](const FlightView& view) { return view.lanes[0].grip_force == Vec3d{}; });
    EXPECT_FALSE(loose->pristine);
}

TEST(FlightChanges, AGripHoldsOnThroughAnEdit) {
    Flight flight(small_flag());
    fly(flight, 1);
    flight.set_grips(0, {{.particle = 116, .point = {2, 2, 2}, .stiffness = 20.0}});
    fly(flight, 1);
    EXPECT_NE(change(flight, on_the_moon())->lanes[0].grip_force, Vec3d{});
}

TEST(FlightChanges, EmptyGripsAreNone) {
    Flight flight(small_flag());
    flight.set_grips(0, {});
    const View view = fly(flight, 5);
    EXPECT_TRUE(view->pristine);
    EXPECT_EQ(view->lanes[0].state_hash, hash_after(small_flag(), 5));
}

TEST(FlightChanges, GripsOfAClothThatIsGoneAndLanesThatAreNotThereLetGo) {
    Flight flight(small_flag());
    flight.set_grips(0, {{.particle = 100'000, .point = {}, .stiffness = 20.0}});
    flight.set_grips(3, {{.particle = 1, .point = {}, .stiffness = 20.0}});
    flight.set_grips(77, {{.particle = 1, .point = {}, .stiffness = 20.0}});
    const View view = fly(flight, 3);
    EXPECT_EQ(view->refusal, "");
    EXPECT_TRUE(view->pristine);
}

TEST(FlightChanges, AGripThatIsNoNumberIsRefused) {
    Flight flight(small_flag());
    flight.set_grips(0, {{.particle = 5, .point = {}, .stiffness = -1.0}});
    wait_for(flight, [](const FlightView& view) { return !view.refusal.empty(); });
    EXPECT_TRUE(fly(flight, 1)->pristine);
}

}  // namespace
}  // namespace weft::viewer
