// Flights of small cloths, and waiting for what they come to.
#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "support/recording.h"
#include "viewer/flight.h"

namespace weft::viewer {

using View = std::shared_ptr<const FlightView>;

/// The flag with few particles, by a method of one fixed step a frame or few.
inline SceneDescription small_flag() {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.integrator.method = "symplectic-euler";
    scene.render.texture = test::small_texture();
    scene.render.size = {64, 48};
    return scene;
}

inline IntegratorDescription by(const std::string& method, std::optional<double> step = {}) {
    IntegratorDescription integrator;
    integrator.method = method;
    integrator.time_step = step;
    return integrator;
}

/// The first view that is as wanted. Flights that never come to it fail after two minutes.
template <typename Wanted>
View wait_for(const Flight& flight, const Wanted& wanted) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (std::chrono::steady_clock::now() < end) {
        View view = flight.view();
        if (wanted(*view)) return view;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    throw std::runtime_error("the flight does not come to what is waited for");
}

inline View wait_for_frame(const Flight& flight, std::size_t frame) {
    return wait_for(
        flight, [&](const FlightView& view) { return view.lanes.front().frame.index >= frame; });
}

/// Makes `count` steps.  @return the view after them.
inline View fly(Flight& flight, std::size_t count) {
    const std::size_t before = flight.view()->lanes.front().frame.index;
    for (std::size_t n = 0; n < count; ++n) flight.step();
    return wait_for_frame(flight, before + count);
}

/// Asks for a scene.  @return the first view that answers.
inline View change(Flight& flight, const SceneDescription& scene) {
    const std::uint64_t before = flight.view()->number;
    flight.set_scene(scene);
    return wait_for(flight, [&](const FlightView& view) { return view.number > before; });
}

inline std::uint64_t hash_after(const SceneDescription& scene, std::size_t frames) {
    Simulation simulation(scene);
    for (std::size_t n = 0; n < frames; ++n) (void)simulation.advance_frame();
    return simulation.state_hash();
}

}  // namespace weft::viewer
