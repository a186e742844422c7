// A cloth in the wind against a reference that shares nothing with weft: forces written out as
// lists and loops (support/naive_cloth.h), integrated by SUNDIALS' CVODE.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "support/cloth_scenes.h"
#include "support/cvode.h"
#include "support/naive_cloth.h"

namespace weft::test {
namespace {

constexpr double end_time = 0.5;  // [s]
constexpr double frame = end_time / 30;

// 12 x 12 particles, hung at two corners: gravity, dashpots, drag, wind.
SceneDescription hung_in_wind() {
    SceneDescription scene = bare_sheet(12, 12);
    scene.material.structural.stiffness = 200.0;
    scene.material.shear.stiffness = 80.0;
    scene.material.bend.stiffness = 10.0;
    add_dashpots(scene, 0.002);
    scene.forces = {{0.0, -9.81, 0.0}, 1e-4};
    scene.pins = {{ParticleSelection{{0, 11}}, {}}};
    scene.wind = WindDescription{};
    scene.wind->velocity = {1.5, 0.5, 4.0};
    scene.wind->gust.model = GustModel::none;
    return scene;
}

// All x, then all v.
Values start_of(const ClothModel& cloth) {
    Values y(6 * cloth.particle_count, 0.0);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3d x = cloth.rest_position(p);
        y[3 * p] = x.x;
        y[3 * p + 1] = x.y;
        y[3 * p + 2] = x.z;
    }
    return y;
}

Slope naive_slope(const SceneDescription& scene) {
    const NaiveCloth cloth(scene);
    return [scene, cloth, masses = cloth.masses()](double, const Values& y, Values& out) {
        const std::size_t n = masses.size();
        std::vector<Vec3d> x(n), v(n), f(n);
        const auto at = [&](std::size_t k) { return Vec3d{y[3 * k], y[3 * k + 1], y[3 * k + 2]}; };
        for (std::size_t p = 0; p < n; ++p) {
            x[p] = at(p);
            v[p] = at(n + p);
        }
        cloth.add_springs(x, v, f);
        cloth.add_air(scene.wind->velocity, x, v, f);
        for (std::size_t p = 0; p < n; ++p) {
            const bool held = p == 0 || p == 11;
            const Vec3d a = scene.forces.gravity + (f[p] - scene.forces.damping * v[p]) / masses[p];
            const Vec3d slopes[] = {v[p], held ? Vec3d{} : a};
            for (std::size_t half = 0; half < 2; ++half) {
                out[3 * (half * n + p)] = slopes[half].x;
                out[3 * (half * n + p) + 1] = slopes[half].y;
                out[3 * (half * n + p) + 2] = slopes[half].z;
            }
        }
    };
}

// The largest distance of a particle from where CVODE has it [m].
double distance(const ClothModel& cloth, const ParticleState<double>& state, const Values& end) {
    double largest = 0.0;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3d x{end[3 * p], end[3 * p + 1], end[3 * p + 2]};
        largest = std::max(largest, length(state.x[cloth.slot(p)] - x));
    }
    return largest;
}

struct Contender {
    std::string_view method;
    double time_step;                 ///< [s]
    std::optional<double> tolerance;  ///< as of IntegratorSettings [m]
    double agreement;                 ///< at end_time, of every particle [m]
};

// With steps or tolerances that leave each method less than `agreement` of error.
const std::vector<Contender> contenders{
    {"rk4", frame / 100, {}, 1e-8},
    {"dopri5", frame, 1e-10, 1e-9},
    {"bosh3", frame, 1e-10, 5e-8},
    {"implicit-midpoint", frame / 600, 1e-11, 1e-6},
    {"trapezoidal", frame / 600, 1e-11, 1e-6},
    {"bdf2", frame / 1600, 1e-11, 1e-6},
    {"tr-bdf2", frame / 600, 1e-11, 1e-6},
    {"sdirk2", frame / 600, 1e-11, 1e-6},
};

class SlowSundials : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        const SceneDescription scene = hung_in_wind();
        start_ = start_of(build_cloth(scene));
        end_ = Cvode(naive_slope(scene), 1e-12)(0.0, end_time, start_);
    }
    static inline Values start_, end_;
};

TEST_F(SlowSundials, IsSureOfItsSolution) {
    const Values looser = Cvode(naive_slope(hung_in_wind()), 1e-10)(0.0, end_time, start_);
    double difference = 0.0, way = 0.0;
    for (std::size_t n = 0; n < start_.size() / 2; ++n) {
        difference = std::max(difference, std::abs(looser[n] - end_[n]));
        way = std::max(way, std::abs(end_[n] - start_[n]));
    }
    EXPECT_LT(difference, 1e-8);
    EXPECT_GT(way, 0.3);  // [m]: the cloth has moved
}

TEST_F(SlowSundials, HasTheSameClothInTheWind) {
    const SceneDescription scene = hung_in_wind();
    const ClothModel cloth = build_cloth(scene);
    for (const Contender& contender : contenders) {
        ClothSystem<double> system(cloth, scene);
        IntegratorSettings settings;
        settings.tolerance = contender.tolerance;
        const auto integrator = make_integrator<double>(contender.method, settings);
        integrator->prepare(system);
        ParticleState<double> state = rest_state<double>(cloth);
        const auto steps = static_cast<int>(std::lround(end_time / contender.time_step));
        for (int n = 0; n < steps; ++n) {
            ASSERT_TRUE(integrator->step(system, end_time / steps, state).ok()) << contender.method;
        }
        EXPECT_LT(distance(cloth, state, end_), contender.agreement) << contender.method;
    }
}

}  // namespace
}  // namespace weft::test
