#include "viewer/flight_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>
#include <utility>

#include "forces/wind.h"
#include "viewer/cloth_shape.h"
#include "viewer/scene_difference.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

constexpr std::size_t frames_timed = 16;

int threads_for(int wanted) {
    if (wanted > 0) return wanted;
    // One is the window's.
    return std::max(static_cast<int>(std::thread::hardware_concurrency()) - 1, 1);
}

}  // namespace

FlightLanes::FlightLanes(const SceneDescription& scene, std::vector<IntegratorDescription> others,
                         int threads)
    : threads_(threads_for(threads)) {
    begin(scene, std::move(others), make_cloth_shape(scene, new_surface_number()));
}

// Lanes beside the first differ in their integrator alone.
SceneDescription FlightLanes::scene_of(std::size_t lane, const SceneDescription& scene) const {
    SceneDescription result = scene;
    if (lane > 0) result.integrator = others_[lane - 1];
    return result;
}

void FlightLanes::begin(const SceneDescription& scene, std::vector<IntegratorDescription> others,
                        std::shared_ptr<const ClothShape> shape) {
    if (others.size() >= most_lanes) {
        throw Error(ErrorKind::usage, {},
                    fmt::format("{} integrators side by side are not allowed: at most {}",
                                others.size() + 1, most_lanes));
    }
    std::vector<Lane> lanes;
    SceneDescription changed = scene;
    lanes.push_back({.simulation = Simulation(changed, threads_)});
    for (const IntegratorDescription& other : others) {
        changed.integrator = other;
        lanes.push_back({.simulation = Simulation(changed, threads_)});
    }
    lanes_ = std::move(lanes);
    scene_ = scene;
    others_ = std::move(others);
    shape_ = std::move(shape);
    pristine_ = true;
}

bool FlightLanes::advance(Lane& lane) {
    if (lane.divergence) return false;
    if (!lane.grips.empty()) pristine_ = false;
    const auto start = std::chrono::steady_clock::now();
    FrameReport report = lane.simulation.advance_frame();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    lane.milliseconds.push_back(took.count());
    if (lane.milliseconds.size() > frames_timed) lane.milliseconds.pop_front();
    lane.divergence = std::move(report.divergence);
    return !lane.divergence;
}

bool FlightLanes::advance() {
    const bool first = advance(lanes_.front());
    for (std::size_t n = 1; n < lanes_.size(); ++n) advance(lanes_[n]);
    return first;
}

bool FlightLanes::all_diverged() const {
    return std::ranges::all_of(lanes_,
                               [](const Lane& lane) { return lane.divergence.has_value(); });
}

bool FlightLanes::at_start() const {
    return std::ranges::all_of(lanes_,
                               [](const Lane& lane) { return lane.simulation.frame() == 0; });
}

FlightLanes::Change FlightLanes::set_scene(const SceneDescription& scene) {
    check_scene(scene);
    const SceneDifference differs = difference(scene_, scene);
    std::shared_ptr<const ClothShape> shape = shape_;
    if (differs.cloth || differs.shape) {
        shape =
            make_cloth_shape(scene, differs.cloth ? new_surface_number() : shape_->surface_number);
    }
    if (differs.cloth || (differs.physics && at_start())) {
        begin(scene, others_, std::move(shape));
        return Change::began_anew;
    }
    if (differs.physics) change_all(scene);
    scene_ = scene;
    shape_ = std::move(shape);
    return differs.physics ? Change::went_on : Change::none;
}

// All of them or none: where one refuses, those before it go back.
void FlightLanes::change_all(const SceneDescription& scene) {
    std::size_t changed = 0;
    try {
        for (; changed < lanes_.size(); ++changed)
            lanes_[changed].simulation.change_scene(scene_of(changed, scene));
    } catch (...) {
        if (changed > 0) pristine_ = false;  // what they kept from earlier steps is gone
        for (std::size_t n = 0; n < changed; ++n)
            lanes_[n].simulation.change_scene(scene_of(n, scene_));
        throw;
    }
    pristine_ = false;
    for (Lane& lane : lanes_) {
        lane.divergence.reset();
        lane.milliseconds.clear();
        lane.stable_step = {};
        lane.simulation.set_grips(lane.grips);
    }
}

void FlightLanes::set_others(std::vector<IntegratorDescription> others) {
    begin(scene_, std::move(others), shape_);
}

void FlightLanes::reset() {
    begin(scene_, others_, shape_);
}

void FlightLanes::set_grips(std::size_t lane, std::vector<Grip> grips) {
    if (lane >= lanes_.size()) return;
    Lane& gripped = lanes_[lane];
    const std::size_t count = gripped.simulation.particle_count();
    // Of a cloth that flew before: the window has not seen the new one yet.
    if (std::ranges::any_of(grips, [&](const Grip& grip) { return grip.particle >= count; }))
        grips.clear();
    gripped.simulation.set_grips(grips);
    gripped.grips = std::move(grips);
}

double FlightLanes::StableStep::of(const Simulation& simulation, bool at_rest) {
    using Clock = std::chrono::steady_clock;
    const double omega = simulation.linear_analysis().omega_max;
    const bool same_method = simulation.method() == method_;
    if (same_method && omega == omega_) return step_;
    if (same_method && !at_rest && Clock::now() - searched_ < std::chrono::seconds(1)) return step_;
    method_ = simulation.method();
    omega_ = omega;
    step_ = simulation.stable_step(method_);
    searched_ = Clock::now();
    return step_;
}

void FlightLanes::describe(Lane& lane, LaneView& view, bool at_rest) const {
    const Simulation& simulation = lane.simulation;
    view.shape = shape_;
    simulation.capture(view.frame);
    view.method = simulation.method();
    view.method_reason = simulation.method_reason();
    view.time_step = simulation.time_step();
    view.stable_step = lane.stable_step.of(simulation, at_rest);
    view.steps_per_frame = simulation.steps_per_frame();
    view.step_count = simulation.step_count();
    view.milliseconds = std::accumulate(lane.milliseconds.begin(), lane.milliseconds.end(), 0.0) /
                        static_cast<double>(std::max<std::size_t>(lane.milliseconds.size(), 1));
    view.energy = simulation.energy();
    view.largest_strain = simulation.largest_strain();
    view.state_hash = simulation.state_hash();
    view.grip_force = simulation.grip_force();
    view.divergence = lane.divergence;
    view.warnings = simulation.warnings();
}

void FlightLanes::describe(FlightView& view, bool at_rest) {
    view.scene = scene_;
    view.lanes.resize(lanes_.size());
    for (std::size_t n = 0; n < lanes_.size(); ++n) describe(lanes_[n], view.lanes[n], at_rest);
    const std::vector<std::string>& findings = first().mesh_findings();
    std::vector<std::string>& warnings = view.lanes.front().warnings;
    warnings.insert(warnings.end(), findings.begin(), findings.end());
    view.wind = scene_.wind ? wind_velocity(*scene_.wind, first().time()) : Vec3d{};
    view.pristine = pristine_;
}

}  // namespace weft::viewer
