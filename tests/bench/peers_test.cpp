// The same forces stand on both sides of a comparison: peers and weft follow one motion.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/peers/built_in.h"
#include "bench/peers/machine.h"
#include "bench/peers/textbook.h"
#include "bench/suite/contestant.h"
#include "bench/suite/flops.h"
#include "bench/suite/scenes.h"
#include "weft/simulation.h"

namespace weft::bench {
namespace {

constexpr double step = 2e-4;  // [s]
constexpr int steps = 200;

// Gravity strong, and off the plane and axes of the sheet, so that all components of all springs
// matter.
PlainSheet slanted_sheet() {
    return {.columns = 9, .rows = 7, .gravity = {20.0, -60.0, 30.0}, .drag = 2e-4};
}

PlainSheet undamped(PlainSheet sheet) {
    for (PlainSheet::Kind* kind : {&sheet.structural, &sheet.shear, &sheet.bend}) {
        kind->damping = 0.0;
    }
    sheet.drag = 0.0;
    return sheet;
}

std::vector<Vec3d> after_steps(SteppedPeer& peer, const PlainSheet& sheet) {
    peer.step(step, steps);
    std::vector<Vec3d> positions(sheet.particle_count());
    peer.copy_positions(positions);
    return positions;
}

std::vector<Vec3d> after_steps_of_weft(const PlainSheet& sheet, std::string_view method) {
    SceneDescription scene = sheet_scene(sheet, {method, Precision::f64, steps});
    scene.integrator.time_step = step;
    scene.output.frames_per_second = 1.0 / (step * steps);
    Simulation simulation(scene);
    const FrameReport report = simulation.advance_frame();
    EXPECT_TRUE(report.ok());
    EXPECT_EQ(report.steps, std::size_t{steps});
    FrameBuffer buffer;
    simulation.capture(buffer);
    return buffer.positions;
}

double farthest(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    EXPECT_EQ(a.size(), b.size());
    double distance = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) distance = std::max(distance, length(a[p] - b[p]));
    return distance;
}

std::vector<Vec3d> at_rest(const PlainSheet& sheet) {
    std::vector<Vec3d> positions;
    for (int j = 0; j < sheet.rows; ++j) {
        for (int i = 0; i < sheet.columns; ++i) positions.push_back(sheet.rest_position(i, j));
    }
    return positions;
}

TEST(Peers, TextbookAndWeftFollowOneMotion) {
    const PlainSheet sheet = slanted_sheet();
    const auto peer = after_steps(*make_textbook(sheet), sheet);
    EXPECT_LT(farthest(peer, after_steps_of_weft(sheet, "symplectic-euler")), 1e-9);
    EXPECT_GT(farthest(peer, at_rest(sheet)), 0.005) << "too calm to tell forces apart";
}

TEST(Peers, TextbookHoldsTheTwoUpperCorners) {
    const PlainSheet sheet = slanted_sheet();
    const auto peer = after_steps(*make_textbook(sheet), sheet), rest = at_rest(sheet);
    EXPECT_EQ(peer[0], rest[0]);
    EXPECT_EQ(peer[8], rest[8]);
    EXPECT_GT(length(peer[9] - rest[9]), 1e-5);
}

TEST(Peers, EverySpringIsWeftsOwn) {
    const PlainSheet sheet{.columns = 6, .rows = 4};
    const auto springs = plain_springs(sheet);
    const auto counts = Simulation(sheet_scene(sheet, {})).spring_counts();
    EXPECT_EQ(springs.size(), counts[0] + counts[1] + counts[2]);
    EXPECT_EQ(springs.size(), plain_spring_count(sheet));
    EXPECT_EQ(springs.front().k, sheet.structural.stiffness);  // kind after kind
    EXPECT_EQ(springs[counts[0]].k, sheet.shear.stiffness);
    EXPECT_EQ(springs.back().k, sheet.bend.stiffness);
}

TEST(Peers, FlopsAreThoseOfEverySpringAndParticle) {
    const PlainSheet sheet{.columns = 6, .rows = 4};
    const auto springs = static_cast<double>(plain_springs(sheet).size());
    EXPECT_EQ(flops_per_step(sheet, 1), 32.0 * springs + 24.0 * 24.0);
    EXPECT_EQ(flops_per_step(sheet, 4), 4.0 * flops_per_step(sheet, 1));
    EXPECT_EQ(flops_per_step(undamped(sheet), 1), 20.0 * springs + 24.0 * 24.0);
    const PlainSheet large{.columns = 2000, .rows = 2000};
    EXPECT_NEAR(flops_per_step(large, 1) / 4e6, 216.0, 0.2);  // but for the borders
}

TEST(Peers, LimitsOfTheMachineAreMeasured) {
    EXPECT_GT(peak_double(), 0.1);
    EXPECT_GT(peak_single(), 0.1);
    EXPECT_GT(update_bandwidth(first_level_cache() / 2), 0.1);
    EXPECT_GE(second_level_cache(), first_level_cache());
}

#ifdef WEFT_BENCH_BOOST
TEST(Peers, OdeintsRungeKuttaAndWeftsFollowOneMotion) {
    const PlainSheet sheet = slanted_sheet();
    const auto peer = after_steps(*odeint_rk4(sheet), sheet);
    EXPECT_LT(farthest(peer, after_steps_of_weft(sheet, "rk4")), 1e-9);
    EXPECT_EQ(peer[0], at_rest(sheet)[0]);
}

TEST(Peers, OdeintsVelocityVerletAndWeftsFollowOneMotionWithoutDamping) {
    const PlainSheet sheet = undamped(slanted_sheet());
    const auto peer = after_steps(*odeint_velocity_verlet(sheet), sheet);
    EXPECT_LT(farthest(peer, after_steps_of_weft(sheet, "velocity-verlet")), 1e-9);
}
#endif

#ifdef WEFT_BENCH_BULLET
TEST(Peers, BulletHangsFromTheSameCorners) {
    const PlainSheet sheet{.columns = 12, .rows = 12, .drag = 1e-3};
    const auto peer = bullet_soft_body(sheet);
    peer->step(1.0 / 60.0, 120);
    std::vector<Vec3d> positions(sheet.particle_count());
    peer->copy_positions(positions);
    EXPECT_LT(length(positions[0] - sheet.rest_position(0, 0)), 1e-6);
    EXPECT_LT(length(positions[11] - sheet.rest_position(11, 0)), 1e-6);
    const double fallen = sheet.rest_position(6, 11).y - positions[11 * 12 + 6].y;
    EXPECT_GT(fallen, 0.0);
    EXPECT_LT(fallen, 12 * sheet.cell);
}

TEST(Peers, BulletsDeformableBodySagsAsWeftsSheet) {
    const PlainSheet sheet = hanging_sheet(12);
    const auto weft = make_two_seconds(sheet, sheet_at_60_hertz(sheet, "implicit-euler", 1.0 / 60));
    const auto bullet = make_two_seconds(sheet, bullet_deformable);
    EXPECT_NEAR(*bullet->measure(0.0).sag, *weft->measure(0.0).sag, 2e-5);
}
#endif

}  // namespace
}  // namespace weft::bench
