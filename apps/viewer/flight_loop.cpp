#include "viewer/flight_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "weft/error.h"

namespace weft::viewer {

namespace {

constexpr double greatest_speed = 100.0;

// A view with all its measures costs more than a frame of some cloths: while it flies, views take a
// tenth of the time, come at most 120 times a second, and at least 30 times where frames do.
FlightPace::Clock::duration rest_after_view(FlightPace::Clock::duration took) {
    using namespace std::chrono_literals;
    return std::clamp<FlightPace::Clock::duration>(10 * took, 8ms, 33ms);
}

}  // namespace

FlightLoop::FlightLoop(const SceneDescription& scene, std::vector<IntegratorDescription> others,
                       int threads)
    : lanes_(scene, std::move(others), threads),
      recording_([this] { mailbox_.post([](FlightRequests&) {}); }) {
    publish();
}

std::shared_ptr<const FlightView> FlightLoop::view() const {
    const std::scoped_lock lock(view_mutex_);
    return view_;
}

void FlightLoop::run() {
    while (true) {
        FlightRequests requests = mailbox_.wait(next_deed());
        if (requests.quit) return;
        obey(requests);
        if (steps_ > 0 || (playing_ && Clock::now() >= pace_.due())) advance();
        if (news_ && (rests() || Clock::now() >= publish_due_)) publish();
    }
}

// When to wake without being asked; none: never.
std::optional<FlightLoop::Clock::time_point> FlightLoop::next_deed() const {
    if (steps_ > 0) return Clock::time_point{};  // long ago
    if (!playing_) return std::nullopt;
    return news_ ? std::min(pace_.due(), publish_due_) : pace_.due();
}

void FlightLoop::obey(FlightRequests& requests) {
    const RecordingView before = recording_.view();
    recording_.collect();
    if (requests.stop_recording) recording_.stop();
    news_ = obey_changes(requests) || news_;
    obey_controls(requests);
    if (requests.start_recording)
        recording_.start(*requests.start_recording, lanes_.scene(), lanes_.first(), lanes_.shape());
    const RecordingView& now = recording_.view();
    news_ = news_ || before.active != now.active || before.ending != now.ending ||
            requests.start_recording;
}

/// @return whether there were any.
bool FlightLoop::obey_changes(FlightRequests& requests) {
    bool asked = requests.scene || requests.lanes || requests.reset;
    if (asked) refusal_.clear();
    const std::size_t particles = lanes_.first().particle_count();
    const auto begin_anew = [&] {
        recording_.stop();
        steps_ = 0;
        if (playing_) pace_.begin(Clock::now());
    };
    if (requests.scene) {
        attempt([&] {
            const FlightLanes::Change change = lanes_.set_scene(*requests.scene);
            if (change == FlightLanes::Change::began_anew) begin_anew();
            if (change == FlightLanes::Change::went_on) recording_.scene_changed(lanes_.scene());
            pace_.set(speed_, 1.0 / lanes_.scene().output.frames_per_second);
        });
    }
    if (requests.lanes || requests.reset) {
        attempt([&] {
            if (requests.lanes) {
                lanes_.set_others(std::move(*requests.lanes));
            } else {
                lanes_.reset();
            }
            begin_anew();
        });
    }
    const bool same_cloth = lanes_.first().particle_count() == particles;
    for (std::size_t n = 0; n < most_lanes; ++n) {
        if (!requests.grips[n] || !same_cloth) continue;
        asked = asked || rests();  // else the next frame tells of them
        attempt([&] { lanes_.set_grips(n, std::move(*requests.grips[n])); });
    }
    return asked;
}

void FlightLoop::obey_controls(const FlightRequests& requests) {
    news_ = news_ || requests.speed || requests.play || requests.steps > 0;
    if (requests.speed) {
        refusal_.clear();
        attempt([&] { set_speed(*requests.speed); });
    }
    if (requests.play) set_playing(*requests.play);
    steps_ += requests.steps;
}

template <typename Change>
void FlightLoop::attempt(const Change& change) {
    try {
        change();
    } catch (const std::exception& problem) {
        refusal_ = problem.what();
        ++refusals_;
    }
}

void FlightLoop::set_speed(double speed) {
    if (!(speed > 0.0 && speed <= greatest_speed)) {
        throw Error(ErrorKind::usage, {},
                    fmt::format("a speed of {} is not allowed: above 0, at most {}", speed,
                                greatest_speed));
    }
    speed_ = speed;
    pace_.set(speed_, 1.0 / lanes_.scene().output.frames_per_second);
}

void FlightLoop::set_playing(bool playing) {
    if (playing == playing_) return;
    playing_ = playing;
    if (playing_) {
        pace_.begin(Clock::now());
    } else {
        pace_.rest();
    }
}

void FlightLoop::advance() {
    if (lanes_.advance()) recording_.add(lanes_.first());
    if (steps_ > 0) {
        --steps_;
    } else {
        pace_.frame_done(Clock::now());
    }
    if (lanes_.all_diverged()) {
        set_playing(false);
        steps_ = 0;
    }
    news_ = true;
}

void FlightLoop::publish() {
    const Clock::time_point start = Clock::now();
    const std::shared_ptr<FlightView> next = pool_.take();
    lanes_.describe(*next, rests());
    next->number = ++views_;
    next->playing = playing_;
    next->speed = speed_;
    next->reached_speed = playing_ ? pace_.reached_speed() : 0.0;
    next->refusal = refusal_;
    next->refusals = refusals_;
    next->recording = recording_.view();
    std::shared_ptr<const FlightView> earlier = next;
    {
        const std::scoped_lock lock(view_mutex_);
        view_.swap(earlier);
    }
    news_ = false;
    const Clock::time_point now = Clock::now();
    publish_due_ = now + rest_after_view(now - start);
}

}  // namespace weft::viewer
