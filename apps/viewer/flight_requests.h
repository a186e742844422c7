// What the window wants of a flight: its latest wishes, not a queue of them.
#pragma once

#include <array>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "viewer/flight.h"
#include "viewer/flight_pace.h"

namespace weft::viewer {

/// They are obeyed in the order they stand here.
struct FlightRequests {
    bool quit = false;
    bool stop_recording = false;
    std::optional<SceneDescription> scene;
    std::optional<std::vector<IntegratorDescription>> lanes;
    bool reset = false;
    std::array<std::optional<std::vector<Grip>>, most_lanes> grips;  ///< [lane]
    std::optional<double> speed;
    std::optional<bool> play;
    std::size_t steps = 0;
    std::optional<RecordingRequest> start_recording;
};

/// Between the window's thread and the flight's. Its lock is held for a moment only.
class FlightMailbox {
public:
    /// Calls change(FlightRequests&) and wakes the reader.
    template <typename Change>
    void post(const Change& change) {
        {
            const std::scoped_lock lock(mutex_);
            change(requests_);
            news_ = true;
        }
        changed_.notify_one();
    }

    /// Waits for a post or until the time given.
    /// @return what was posted since the last call.
    FlightRequests wait(std::optional<FlightPace::Clock::time_point> until) {
        std::unique_lock lock(mutex_);
        const auto has_news = [this] { return news_; };
        if (until) {
            changed_.wait_until(lock, *until, has_news);
        } else {
            changed_.wait(lock, has_news);
        }
        news_ = false;
        return std::exchange(requests_, {});
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    FlightRequests requests_;
    bool news_ = false;
};

}  // namespace weft::viewer
