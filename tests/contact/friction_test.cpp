// Coulomb's friction on an inclined plane, by every kind of method. The plane stays level and
// gravity is inclined, so that the sheet can lie on it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact_scenes.h"
#include "support/test_name.h"

namespace weft::test {
namespace {

constexpr double g = 9.81;  // [m/s2]

struct Slide {
    Vec3d way;          // of the sheet's middle [m]
    Vec3d speed;        // likewise [m/s]
    double fastest{};   // of any particle [m/s]
    double farthest{};  // that any particle went [m]
};

Slide slide(const std::string& method, Precision precision, double degrees, double friction,
            double seconds) {
    SceneDescription scene = level_sheet(6, 0.0);
    const double angle = degrees * std::numbers::pi / 180.0;
    scene.forces.gravity = {g * std::sin(angle), -g * std::cos(angle), 0.0};
    scene.obstacles = {floor_with(friction)};
    scene.integrator.method = method;
    scene.integrator.precision = precision;
    Simulation simulation(scene);
    FrameBuffer start, end;
    simulation.capture(start);
    while (simulation.time() < seconds - 1e-9) EXPECT_TRUE(simulation.advance_frame().ok());
    simulation.capture(end);
    Slide found{mean(end.positions) - mean(start.positions), mean(end.velocities),
                longest(end.velocities), 0.0};
    for (std::size_t p = 0; p < end.positions.size(); ++p) {
        found.farthest = std::max(found.farthest, length(end.positions[p] - start.positions[p]));
    }
    return found;
}

class Friction : public testing::TestWithParam<std::string> {};

// tan 25 degrees = 0.466 < 0.5
TEST_P(Friction, HoldsASheetOnASlopeThatIsNotSteep) {
    for (const Precision precision : {Precision::f64, Precision::f32}) {
        const Slide held = slide(GetParam(), precision, 25.0, 0.5, 3.0);
        EXPECT_LT(held.farthest, precision == Precision::f64 ? 1e-6 : 1e-4);
        EXPECT_LT(held.fastest, 1e-3);
    }
}

// a = g (sin 40 - 0.5 cos 40) = 2.548 m/s2, and without friction g sin 40
TEST_P(Friction, LetsItSlideDownASteepOneAsCoulombSays) {
    for (const Precision precision : {Precision::f64, Precision::f32}) {
        for (const double friction : {0.5, 0.0}) {
            const double angle = 40.0 * std::numbers::pi / 180.0;
            const double a = g * (std::sin(angle) - friction * std::cos(angle));
            const Slide slid = slide(GetParam(), precision, 40.0, friction, 1.0);
            EXPECT_NEAR(slid.speed.x, a, 0.01 * a) << friction;
            EXPECT_NEAR(slid.way.x, a / 2, 0.03 * a / 2) << friction;
            EXPECT_NEAR(slid.way.y, 0.0, 1e-5);
            EXPECT_NEAR(slid.speed.y, 0.0, 1e-2);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Friction, testing::ValuesIn(methods_in_contact()), test_name);

}  // namespace
}  // namespace weft::test
