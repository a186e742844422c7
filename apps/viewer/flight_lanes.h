// The simulations of a flight: one scene, up to four integrators.
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/flight.h"

namespace weft::viewer {

/// For the flight's thread. Functions that throw leave all as it was.
class FlightLanes {
public:
    /// What a new scene came to.
    enum class Change { none, went_on, began_anew };

    /// As Flight's constructor.
    FlightLanes(const SceneDescription& scene, std::vector<IntegratorDescription> others,
                int threads);

    /// By one frame, every lane that has not diverged.
    /// @return whether lane 0 has.
    bool advance();
    [[nodiscard]] bool all_diverged() const;

    /// @throws Error as Simulation's constructor and change_scene().
    Change set_scene(const SceneDescription& scene);
    void set_others(std::vector<IntegratorDescription> others);  ///< @throws Error (usage).
    void reset();                                                ///< @throws Error.
    void set_grips(std::size_t lane, std::vector<Grip> grips);   ///< @throws Error (usage).

    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    [[nodiscard]] const Simulation& first() const { return lanes_.front().simulation; }
    [[nodiscard]] const std::shared_ptr<const ClothShape>& shape() const { return shape_; }

    /// Fills in scene, lanes, wind and `pristine`.
    /// @param at_rest all is to be exact: there is time to look for the stable step.
    void describe(FlightView& view, bool at_rest);

private:
    /// Simulation::stable_step() searches for milliseconds, many times a frame of a small cloth.
    class StableStep {
    public:
        /// The one kept, unless the cloth's frequencies are others and the last search is long ago.
        double of(const Simulation& simulation, bool at_rest);

    private:
        double step_ = 0.0, omega_ = -1.0;
        std::string method_;
        std::chrono::steady_clock::time_point searched_{};
    };

    struct Lane {
        Simulation simulation;
        std::vector<Grip> grips{};
        std::optional<Divergence> divergence{};
        std::deque<double> milliseconds{};  ///< of the last frames
        StableStep stable_step{};
    };

    [[nodiscard]] SceneDescription scene_of(std::size_t lane, const SceneDescription& scene) const;
    void begin(const SceneDescription& scene, std::vector<IntegratorDescription> others,
               std::shared_ptr<const ClothShape> shape);
    void change_all(const SceneDescription& scene);
    [[nodiscard]] bool at_start() const;
    bool advance(Lane& lane);
    void describe(Lane& lane, LaneView& view, bool at_rest) const;

    SceneDescription scene_;
    std::vector<IntegratorDescription> others_;  ///< of lanes 1, 2, ...
    int threads_ = 1;
    std::vector<Lane> lanes_;
    std::shared_ptr<const ClothShape> shape_;
    bool pristine_ = true;
};

}  // namespace weft::viewer
