// Runs that diverge: named with step, time and place; the last good frame stays; halving goes on.
#include <gtest/gtest.h>

#include <limits>

#include "forces/energy.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "support/cloth_scenes.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

// Pulled out of its plane by a corner, so that something moves from the start.
SceneDescription hanging_sheet(const char* method, double time_step) {
    SceneDescription scene = bare_sheet(6, 5);
    scene.forces.gravity = {0.0, -9.81, 2.0};
    scene.pins = {{EdgeSelection::top_edge, {}}};
    scene.integrator.method = method;
    scene.integrator.time_step = time_step;
    return scene;
}

double step_beyond(const char* method, double factor) {
    return factor * Simulation(hanging_sheet(method, 1e-3)).stable_step(method);
}

// The first step after which a spring is more than 100 times its length longer than at rest or a
// place is not finite: found by stepping by hand.
std::size_t first_bad_step(const SceneDescription& scene, double dt) {
    const ClothModel cloth = build_cloth(scene);
    ClothSystem<double> system(cloth, scene);
    const auto integrator = make_integrator<double>(scene.integrator.method);
    integrator->prepare(system);
    ParticleState<double> state = rest_state<double>(cloth);
    for (std::size_t step = 1; step < 1'000'000; ++step) {
        integrator->step(system, dt, state);
        const double strain = largest_strain<double>(cloth, state.x.view()).strain;
        if (!(std::abs(strain) <= 100.0)) return step;
    }
    return 0;
}

TEST(Divergence, IsNamedByStepTimeAndSpring) {
    for (const auto& [method, dt] : {std::pair{"forward-euler", 0.004},
                                     {"velocity-verlet", step_beyond("velocity-verlet", 1.3)},
                                     {"verlet", step_beyond("verlet", 1.3)},
                                     {"time-corrected-verlet", step_beyond("verlet", 1.3)},
                                     {"rk4", step_beyond("rk4", 1.2)}}) {
        const SceneDescription scene = hanging_sheet(method, dt);
        Simulation simulation(scene);
        FrameReport report = simulation.advance_frame();
        std::uint64_t good = simulation.state_hash();
        double good_time = simulation.time();
        for (int n = 0; n < 10'000 && report.ok(); ++n) {
            good = simulation.state_hash();
            good_time = simulation.time();
            report = simulation.advance_frame();
        }
        ASSERT_FALSE(report.ok()) << method;
        const Divergence& d = *report.divergence;
        EXPECT_EQ(d.step, first_bad_step(scene, simulation.time_step())) << method;
        EXPECT_NEAR(d.time, static_cast<double>(d.step) * simulation.time_step(), 1e-9) << method;
        EXPECT_GT(d.time, good_time);
        EXPECT_LE(d.time, good_time + 1.0 / 30.0 + 1e-12);
        EXPECT_EQ(d.time_step, simulation.time_step());
        EXPECT_EQ(d.stable_step, simulation.stable_step(method));
        ASSERT_TRUE(d.spring.has_value()) << method;
        EXPECT_GT(std::abs(d.spring->strain), 100.0);
        EXPECT_FALSE(d.particle.has_value());
        // What stays is the last good frame.
        EXPECT_EQ(simulation.state_hash(), good) << method;
        EXPECT_EQ(simulation.time(), good_time);
        EXPECT_EQ(simulation.step_count(), simulation.frame() * simulation.steps_per_frame());
    }
}

TEST(Divergence, SaysInWordsWhatHappenedAndWhatToTry) {
    const double dt = step_beyond("velocity-verlet", 1.3);
    Simulation simulation(hanging_sheet("velocity-verlet", dt));
    FrameReport report = simulation.advance_frame();
    for (int n = 0; n < 1000 && report.ok(); ++n) report = simulation.advance_frame();
    ASSERT_FALSE(report.ok());
    const Divergence& d = *report.divergence;
    const std::string spring(d.spring->kind);
    EXPECT_EQ(
        d.message.find("velocity-verlet diverged in step " + std::to_string(d.step) + " at t = "),
        0u)
        << d.message;
    EXPECT_NE(
        d.message.find("the " + spring + " spring between particles " +
                       std::to_string(d.spring->p) + " (column " + std::to_string(d.spring->p % 6) +
                       ", row " + std::to_string(d.spring->p / 6) + ")"),
        std::string::npos)
        << d.message;
    EXPECT_NE(d.message.find("times its length"), std::string::npos);
    EXPECT_EQ(d.message.find('\n'), std::string::npos);
    EXPECT_NE(d.advice.find("would have been stable"), std::string::npos) << d.advice;
    EXPECT_NE(d.advice.find("\"auto\""), std::string::npos);
    EXPECT_NE(d.advice.find("halve-step"), std::string::npos);
}

TEST(Divergence, OfForwardEulerUndampedAdvisesAnotherMethod) {
    Simulation simulation(hanging_sheet("forward-euler", 0.004));
    FrameReport report = simulation.advance_frame();
    for (int n = 0; n < 1000 && report.ok(); ++n) report = simulation.advance_frame();
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.divergence->stable_step, 0.0);
    EXPECT_NE(report.divergence->advice.find("stable at no step without damping"),
              std::string::npos);
    EXPECT_NE(report.divergence->advice.find("velocity-verlet"), std::string::npos);
}

// Below the limit of the cloth at rest, yet torn: something else is at fault, and the advice says
// so.
TEST(Divergence, OfAViolentStartBlamesTheForces) {
    SceneDescription scene = hanging_sheet("velocity-verlet", 1e-3);
    Simulation simulation(scene);
    FrameBuffer frame;
    simulation.capture(frame);
    for (Vec3d& v : frame.velocities) v = {0.0, 0.0, 0.0};
    frame.velocities[20] = {1e5, 0.0, 0.0};
    simulation.set_state(frame.positions, frame.velocities);
    const FrameReport report = simulation.advance_frame();
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.divergence->advice.find("below the limit of the cloth at rest"),
              std::string::npos);
}

TEST(Divergence, CatchesWhatIsNotANumber) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Simulation simulation(hanging_sheet("velocity-verlet", 1e-3));
        FrameBuffer frame;
        simulation.capture(frame);
        frame.velocities[29].z = bad;  // the last particle
        simulation.set_state(frame.positions, frame.velocities);
        const FrameReport report = simulation.advance_frame();
        ASSERT_FALSE(report.ok());
        EXPECT_EQ(report.divergence->step, 1u);
        ASSERT_TRUE(report.divergence->particle.has_value());
        EXPECT_FALSE(report.divergence->spring.has_value());
        EXPECT_GE(*report.divergence->particle, 15u);  // it or a neighbour of it
        EXPECT_NE(report.divergence->message.find("no longer at a finite place"),
                  std::string::npos);
    }
}

TEST(Divergence, CanBeRunAgainFromTheGoodFrame) {
    const double dt = step_beyond("verlet", 1.3);
    Simulation simulation(hanging_sheet("verlet", dt));
    FrameReport first = simulation.advance_frame();
    for (int n = 0; n < 1000 && first.ok(); ++n) first = simulation.advance_frame();
    ASSERT_FALSE(first.ok());
    const FrameReport again = simulation.advance_frame();
    ASSERT_FALSE(again.ok());
    EXPECT_EQ(again.divergence->step, first.divergence->step);
    EXPECT_EQ(again.divergence->message, first.divergence->message);
}

TEST(HalveStep, GoesOnFromTheLastGoodFrame) {
    for (const char* method : {"velocity-verlet", "verlet", "time-corrected-verlet", "rk4",
                               "yoshida4", "symplectic-euler"}) {
        SceneDescription scene = hanging_sheet(method, step_beyond(method, 1.6));
        scene.integrator.on_divergence = OnDivergence::halve_step;
        Simulation simulation(scene);
        const std::size_t steps = simulation.steps_per_frame();
        int halvings = 0;
        std::size_t counted = 0;
        for (int n = 0; n < 60; ++n) {
            const FrameReport report = simulation.advance_frame();
            ASSERT_TRUE(report.ok()) << method;
            halvings += report.halvings;
            counted += report.steps;
        }
        EXPECT_EQ(halvings, 1) << method;
        EXPECT_EQ(simulation.steps_per_frame(), 2 * steps) << method;
        EXPECT_EQ(simulation.step_count(), counted) << method;
        EXPECT_EQ(simulation.frame(), 60u);
        // The frame gone back to was violent already: what it rings at, 4 to 12 by the last bits of
        // the start, nothing damps. It does not grow.
        EXPECT_LT(std::abs(simulation.largest_strain().strain), 30.0) << method;
    }
}

// It does not halve for ever: what is not finite stays so at any step.
TEST(HalveStep, GivesUpAfterTwelve) {
    for (const char* method : {"velocity-verlet", "verlet", "time-corrected-verlet", "rk4"}) {
        SceneDescription scene = hanging_sheet(method, 0.01);
        scene.integrator.on_divergence = OnDivergence::halve_step;
        Simulation simulation(scene);
        const std::size_t steps = simulation.steps_per_frame();
        FrameBuffer frame;
        simulation.capture(frame);
        frame.velocities[29].z = std::numeric_limits<double>::quiet_NaN();
        simulation.set_state(frame.positions, frame.velocities);
        const FrameReport report = simulation.advance_frame();
        ASSERT_FALSE(report.ok()) << method;
        EXPECT_EQ(report.halvings, 12) << method;
        EXPECT_EQ(simulation.steps_per_frame(), 4096 * steps) << method;
        EXPECT_EQ(report.divergence->step, 1u);
    }
}

}  // namespace
}  // namespace weft::test
