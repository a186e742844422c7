// Order of every integrator on a whole cloth: 6 x 6 particles, one corner held, one moved, with and
// without damping and wind, against a reference that shares neither forces nor integrators with
// weft.
#include <gtest/gtest.h>

#include "forces/wind.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "support/cloth_scenes.h"
#include "support/extrapolation.h"
#include "support/methods.h"
#include "support/naive_cloth.h"
#include "support/order_fit.h"

namespace weft::test {
namespace {

constexpr double end_time = 0.37;    // [s]
constexpr double motion_time = 1.0;  // one keyframe to the next: smooth within
constexpr Vec3d motion_offset{0.3, 0.1, -0.2};
constexpr std::size_t held = 0, moved = 5;

SceneDescription moving_sheet(bool damped) {
    SceneDescription scene = bare_sheet(6, 6);
    scene.material.mass_per_area = 2.0;
    scene.material.structural.stiffness = 120.0;
    scene.material.shear.stiffness = 50.0;
    scene.material.bend.stiffness = 10.0;
    scene.forces.gravity = {0.5, -9.81, 1.0};
    scene.pins = {{ParticleSelection{{held}}, {}},
                  {ParticleSelection{{moved}}, {{0.0, {}}, {motion_time, motion_offset}}}};
    if (damped) {
        scene.forces.damping = 0.02;
        add_dashpots(scene, 0.01);
        // Thin air and heavy cloth: the relative wind never turns, as |v| v is not smooth at 0.
        scene.wind = WindDescription{};
        scene.wind->air_density = 0.3;
        scene.wind->velocity = {3.0, 1.5, 8.0};
        scene.wind->gust.period = 5.0;  // one draw to the next: smooth within
    }
    return scene;
}

// What the same scene is to the reference: a slope for all x, then all v.
class NaiveSlope {
public:
    explicit NaiveSlope(const SceneDescription& scene)
        : scene_(scene), cloth_(scene), masses_(cloth_.masses()) {}

    void operator()(double t, const Values& y, Values& out) const {
        const std::size_t n = masses_.size();
        std::vector<Vec3d> x(n), v(n), f(n);
        for (std::size_t p = 0; p < n; ++p) {
            x[p] = {y[3 * p], y[3 * p + 1], y[3 * p + 2]};
            v[p] = {y[3 * (n + p)], y[3 * (n + p) + 1], y[3 * (n + p) + 2]};
        }
        const double s = t / motion_time;
        x[moved] = Vec3d{1.0, 0.0, 0.0} + (3 * s * s - 2 * s * s * s) * motion_offset;
        v[moved] = ((6 * s - 6 * s * s) / motion_time) * motion_offset;
        cloth_.add_springs(x, v, f);
        if (scene_.wind) cloth_.add_air(wind_velocity(*scene_.wind, t), x, v, f);
        for (std::size_t p = 0; p < n; ++p) {
            Vec3d a = scene_.forces.gravity + (f[p] - scene_.forces.damping * v[p]) / masses_[p];
            if (p == held) a = {};
            if (p == moved) a = ((6 - 12 * s) / (motion_time * motion_time)) * motion_offset;
            put(out, p, v[p]);
            put(out, n + p, a);
        }
    }

private:
    static void put(Values& out, std::size_t at, Vec3d value) {
        out[3 * at] = value.x;
        out[3 * at + 1] = value.y;
        out[3 * at + 2] = value.z;
    }

    SceneDescription scene_;
    NaiveCloth cloth_;
    std::vector<double> masses_;
};

class ClothOrder : public ::testing::TestWithParam<bool> {
protected:
    ClothOrder() : scene_(moving_sheet(GetParam())), cloth_(build_cloth(scene_)) {
        Values start(6 * cloth_.particle_count, 0.0);
        for (std::size_t p = 0; p < cloth_.particle_count; ++p) {
            start[3 * p] = cloth_.rest_position(p).x;
            start[3 * p + 1] = cloth_.rest_position(p).y;
        }
        end_ = extrapolate(NaiveSlope(scene_), 0.0, end_time, start, 40);
        const Values check = extrapolate(NaiveSlope(scene_), 0.0, end_time, start, 50, 6);
        double difference = 0.0;
        for (std::size_t n = 0; n < end_.size(); ++n) {
            difference = std::max(difference, std::abs(end_[n] - check[n]));
        }
        EXPECT_LT(difference, 1e-10);
    }

    [[nodiscard]] double error_after(std::string_view method, int steps) const {
        ClothSystem<double> system(cloth_, scene_);
        IntegratorSettings settings;
        settings.tolerance = 1e-12;  // of implicit stages [m]
        const auto integrator = make_integrator<double>(method, settings);
        integrator->prepare(system);
        ParticleState<double> state = rest_state<double>(cloth_);
        for (int n = 0; n < steps; ++n) integrator->step(system, end_time / steps, state);
        double sum = 0.0;
        const std::size_t n = cloth_.particle_count;
        for (std::size_t p = 0; p < n; ++p) {
            const Vec3d x{end_[3 * p], end_[3 * p + 1], end_[3 * p + 2]};
            const Vec3d v{end_[3 * (n + p)], end_[3 * (n + p) + 1], end_[3 * (n + p) + 2]};
            const Vec3d dx = state.x[cloth_.slot(p)] - x, dv = state.v[cloth_.slot(p)] - v;
            sum += dot(dx, dx) + dot(dv, dv);
        }
        return std::sqrt(sum);
    }

    SceneDescription scene_;
    ClothModel cloth_;
    Values end_;
};

TEST_P(ClothOrder, IsAsStated) {
    for (const IntegratorInfo& info :
         methods_of({IntegratorKind::explicit_steps, IntegratorKind::implicit})) {
        const int stated = GetParam() ? info.damped_order : info.order;
        std::vector<ErrorAtStep> errors;
        const int first = stated == 1 ? 400 : stated == 2 ? 100 : 40;
        for (int steps = first; steps <= 8 * first; steps *= 2) {
            errors.push_back({end_time / steps, error_after(info.name, steps)});
        }
        EXPECT_NEAR(fitted_order(errors), stated, 0.15) << info.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Undamped, ClothOrder, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(DampedInWind, ClothOrder, ::testing::Values(true));

}  // namespace
}  // namespace weft::test
