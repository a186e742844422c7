// Chains: the catenary, stiff and elastic, and the pendulum's period.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "simulation/engine.h"
#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

constexpr double g = 9.81;  // [m/s2]
constexpr std::size_t links = 40;
constexpr double whole = 1.2, span = 1.0;  // of the chain, of its ends [m]
constexpr double link = whole / links, mass = 0.01;

double root_of(const std::function<double(double)>& rising, double low, double high) {
    for (int n = 0; n < 200; ++n) {
        const double middle = (low + high) / 2;
        (rising(middle) < 0.0 ? low : high) = middle;
    }
    return low;
}

// Places at rest of a chain whose links stretch by their tension over `stiffness`.
std::vector<Vec3d> settled_chain(double stiffness) {
    SceneDescription scene = bare_sheet(2, 2);
    scene.forces = {{0.0, -g, 0.0}, 8.0 * mass};
    scene.integrator.time_step = 0.5 * std::sqrt(mass / stiffness);
    ClothModel chain = straight_chain(links + 1, link, mass, stiffness,
                                      1e-3 * stiffness * std::sqrt(mass / stiffness));
    pin_at_rest(chain, 0);
    pin_at_rest(chain, links);
    chain.pins.back().rest = {span, 0.0, 0.0};
    const auto engine = make_engine<double>(chain, scene);
    std::vector<Vec3d> x(links + 1), v(links + 1);
    for (std::size_t n = 0; n <= links; ++n) {
        const double s = static_cast<double>(n) / links;
        x[n] = {span * s, -1.2 * s * (1 - s), 0.0};
    }
    engine->set_state(x, v);
    FrameBuffer frame;
    for (int n = 0; n < 240; ++n) EXPECT_TRUE(engine->advance_frame().ok());
    engine->capture(frame, {});
    for (const Vec3d u : frame.velocities) EXPECT_LT(length(u), 1e-6);
    return frame.positions;
}

// The polygon at rest: link n from the left carries H sideways and the weight up to the middle.
std::vector<Vec3d> polygon(double stiffness) {
    const auto shape = [&](double h) {
        std::vector<Vec3d> x{{0.0, 0.0, 0.0}};
        for (std::size_t n = 0; n < links; ++n) {
            const double v = (static_cast<double>(n) + 0.5 - links / 2.0) * mass * g;
            const double tension = std::hypot(h, v);
            x.push_back(x.back() + ((link + tension / stiffness) / tension) * Vec3d{h, v, 0.0});
        }
        return x;
    };
    return shape(root_of([&](double h) { return shape(h).back().x - span; }, 1e-6, 100.0));
}

double largest_gap(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    double gap = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) gap = std::max(gap, length(a[n] - b[n]));
    return gap;
}

constexpr double weight_per_length = mass * g / link;  // [N/m]
constexpr double chain_weight = weight_per_length * whole;

// Stiff: links stretch by 1e-4. y = a cosh(x / a) with 2 a sinh(span / 2a) = length.
TEST(Chain, HangsAsACatenary) {
    const double stiffness = 1e4 * chain_weight / link;
    const std::vector<Vec3d> x = settled_chain(stiffness);
    EXPECT_LT(largest_gap(x, polygon(stiffness)), 1e-6);
    const double a =
        root_of([](double r) { return whole - 2 * r * std::sinh(span / (2 * r)); }, 0.05, 10.0);
    const double sag = a * (std::cosh(span / (2 * a)) - 1);
    EXPECT_NEAR(-x[links / 2].y, sag, 1e-3 * sag);
    for (const Vec3d place : x) {
        const double y = a * std::cosh((place.x - span / 2) / a) - a - sag;
        EXPECT_NEAR(place.y, y, 2e-3 * sag);
    }
}

// Soft: stretched by several per cent it hangs as the elastic catenary,
//     x = H s / EA + H/w asinh(w s / H),  y = w s^2 / 2EA + H/w (sqrt(1 + (w s / H)^2) - 1),
// s along the unstretched chain from its lowest point.
TEST(Chain, HangsAsAnElasticCatenaryWhenSoft) {
    const double ea = 10.0 * chain_weight, stiffness = ea / link, w = weight_per_length;
    const std::vector<Vec3d> x = settled_chain(stiffness);
    EXPECT_LT(largest_gap(x, polygon(stiffness)), 1e-6);
    const double s = whole / 2;
    const double h =
        root_of([&](double r) { return r * s / ea + r / w * std::asinh(w * s / r) - span / 2; },
                1e-6, 100.0);
    const double sag = w * s * s / (2 * ea) + h / w * (std::hypot(1.0, w * s / h) - 1);
    EXPECT_NEAR(-x[links / 2].y, sag, 1e-3 * sag);
    const double a =
        root_of([](double r) { return whole - 2 * r * std::sinh(span / (2 * r)); }, 0.05, 10.0);
    EXPECT_GT(sag, 1.05 * a * (std::cosh(span / (2 * a)) - 1));  // well apart from the stiff one
}

// T = 4 sqrt(l/g) K(sin(theta/2)): 9 % longer than for small swings at 1.2 rad. The rod is a spring
// of 1e6 N/m, which changes its length, and so the period, by a few millionths.
TEST(Pendulum, SwingsWithThePeriodOfTheEllipticIntegral) {
    const double k = 1e6, rod = 1.0, m = 1.0;
    for (const double angle : {0.1, 1.2, 2.5}) {
        ClothModel pendulum = straight_chain(2, rod, m, k);
        pin_at_rest(pendulum, 0);
        SceneDescription scene = bare_sheet(2, 2);
        scene.forces.gravity = {0.0, -g, 0.0};
        ClothSystem<double> system(pendulum, scene);
        ParticleState<double> state = rest_state<double>(pendulum);
        const double length = rod + m * g * std::cos(angle) / k;
        state.x.set(1, length * Vec3d{std::sin(angle), -std::cos(angle), 0.0});
        const auto integrator = make_integrator<double>("velocity-verlet");
        integrator->prepare(system);
        std::vector<double> crossings;  // of the vertical
        double before = state.x[1].x;
        while (crossings.size() < 5) {
            constexpr double dt = 2e-4;
            integrator->step(system, dt, state);
            const double now = state.x[1].x;
            if ((before < 0.0) != (now < 0.0))
                crossings.push_back(state.time - dt * now / (now - before));
            before = now;
        }
        const double period = (crossings[4] - crossings[0]) / 2;
        const double expected = 4 * std::sqrt(rod / g) * std::comp_ellint_1(std::sin(angle / 2));
        EXPECT_NEAR(period, expected, 3e-5 * expected) << angle;
    }
}

}  // namespace
}  // namespace weft::test
