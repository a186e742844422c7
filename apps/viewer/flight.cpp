#include "viewer/flight.h"

#include <thread>
#include <utility>

#include "viewer/flight_loop.h"

namespace weft::viewer {

struct Flight::Worker {
    FlightLoop loop;
    std::thread thread;

    Worker(const SceneDescription& scene, std::vector<IntegratorDescription> lanes, int threads)
        : loop(scene, std::move(lanes), threads), thread([this] { loop.run(); }) {}
    ~Worker() {
        loop.mailbox().post([](FlightRequests& requests) { requests.quit = true; });
        thread.join();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
};

Flight::Flight(const SceneDescription& scene, std::vector<IntegratorDescription> lanes, int threads)
    : worker_(std::make_unique<Worker>(scene, std::move(lanes), threads)) {}
Flight::~Flight() = default;

std::shared_ptr<const FlightView> Flight::view() const {
    return worker_->loop.view();
}

void Flight::play(bool playing) {
    worker_->loop.mailbox().post([&](FlightRequests& requests) { requests.play = playing; });
}

void Flight::step() {
    worker_->loop.mailbox().post([](FlightRequests& requests) {
        requests.play = false;
        ++requests.steps;
    });
}

void Flight::reset() {
    worker_->loop.mailbox().post([](FlightRequests& requests) {
        requests.reset = true;
        requests.steps = 0;
        requests.grips = {};
    });
}

void Flight::set_speed(double speed) {
    worker_->loop.mailbox().post([&](FlightRequests& requests) { requests.speed = speed; });
}

void Flight::set_scene(const SceneDescription& scene) {
    std::optional<SceneDescription> copy = scene;  // outside the lock, as is freeing the last one
    worker_->loop.mailbox().post([&](FlightRequests& requests) { requests.scene.swap(copy); });
}

void Flight::set_lanes(std::vector<IntegratorDescription> lanes) {
    worker_->loop.mailbox().post(
        [&](FlightRequests& requests) { requests.lanes = std::move(lanes); });
}

void Flight::set_grips(std::size_t lane, std::vector<Grip> grips) {
    if (lane >= most_lanes) return;
    worker_->loop.mailbox().post(
        [&](FlightRequests& requests) { requests.grips[lane] = std::move(grips); });
}

void Flight::start_recording(const RecordingRequest& request) {
    worker_->loop.mailbox().post(
        [&](FlightRequests& requests) { requests.start_recording = request; });
}

void Flight::stop_recording() {
    worker_->loop.mailbox().post([](FlightRequests& requests) {
        requests.start_recording.reset();
        requests.stop_recording = true;
    });
}

}  // namespace weft::viewer
