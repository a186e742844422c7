// What the thread of a flight does: obeys, advances, publishes.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "viewer/flight_lanes.h"
#include "viewer/flight_pace.h"
#include "viewer/flight_recording.h"
#include "viewer/flight_requests.h"
#include "viewer/view_pool.h"

namespace weft::viewer {

/// Made, with its first view, on any thread; then run() belongs to one thread, and mailbox() and
/// view() to all. No lock is held while a frame is made, a scene is built or a view is filled.
class FlightLoop {
public:
    /// As Flight's constructor.
    FlightLoop(const SceneDescription& scene, std::vector<IntegratorDescription> others,
               int threads);

    void run();  ///< until a request to quit
    [[nodiscard]] FlightMailbox& mailbox() { return mailbox_; }
    [[nodiscard]] std::shared_ptr<const FlightView> view() const;

private:
    using Clock = FlightPace::Clock;

    [[nodiscard]] bool rests() const { return !playing_ && steps_ == 0; }
    [[nodiscard]] std::optional<Clock::time_point> next_deed() const;
    void obey(FlightRequests& requests);
    bool obey_changes(FlightRequests& requests);
    void obey_controls(const FlightRequests& requests);
    template <typename Change>
    void attempt(const Change& change);
    void set_speed(double speed);
    void set_playing(bool playing);
    void advance();
    void publish();

    FlightMailbox mailbox_;  // outlives the recordings, whose threads post to it
    mutable std::mutex view_mutex_;
    std::shared_ptr<const FlightView> view_;
    ViewPool pool_;
    FlightLanes lanes_;
    FlightPace pace_;
    bool playing_ = false;
    std::size_t steps_ = 0;  ///< asked for and not made yet
    double speed_ = 1.0;
    std::string refusal_;
    std::uint64_t refusals_ = 0;
    std::uint64_t views_ = 0;
    bool news_ = true;                 ///< since the last view
    Clock::time_point publish_due_{};  ///< not before
    FlightRecording recording_;        // destroyed first
};

}  // namespace weft::viewer
