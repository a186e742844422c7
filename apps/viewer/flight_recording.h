// The recordings of a flight: one that runs, and those that are being put in place.
#pragma once

#include <functional>
#include <list>
#include <memory>

#include "io/recording_queue.h"
#include "viewer/flight.h"

namespace weft::viewer {

/// For the flight's thread. A recording ends on a thread of its own, as an encoder may take its
/// time over the last pictures.
class FlightRecording {
public:
    /// @param ended called, on another thread, when a recording has ended; collect() then tells.
    explicit FlightRecording(std::function<void()> ended);
    ~FlightRecording();  ///< stops, and waits for the files
    FlightRecording(const FlightRecording&) = delete;
    FlightRecording& operator=(const FlightRecording&) = delete;

    /// Begins with the simulation's present frame; ends another that runs. What is in the way
    /// stands in view().error.
    /// @param shape of the simulation's cloth.
    void start(const RecordingRequest& request, const SceneDescription& scene,
               const Simulation& simulation, const std::shared_ptr<const ClothShape>& shape);
    void add(const Simulation& simulation);  ///< its present frame; nothing where none runs
    /// The flight goes on with an edited scene: pictures do not follow its obstacles.
    void scene_changed(const SceneDescription& scene);
    void stop();
    void collect();  ///< takes note of the recordings that have ended

    [[nodiscard]] const RecordingView& view() const { return view_; }

private:
    struct Running;
    struct Ending;

    void begin(const RecordingRequest& request, const SceneDescription& scene,
               const Simulation& simulation, const std::shared_ptr<const ClothShape>& shape);
    [[nodiscard]] std::string free_stem(const RecordingRequest& request) const;

    std::function<void()> ended_;
    std::unique_ptr<Running> running_;
    std::list<Ending> endings_;
    RecordingView view_;
};

}  // namespace weft::viewer
