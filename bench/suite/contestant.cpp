#include "bench/suite/contestant.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "bench/suite/scenes.h"
#include "weft/error.h"
#include "weft/simulation.h"

namespace weft::bench {

namespace {

constexpr int two_seconds = 120;  // frames

template <typename Work>
double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void advance(Simulation& simulation) {
    const FrameReport report = simulation.advance_frame();
    if (report.ok()) return;
    throw Error(ErrorKind::diverged, {}, report.divergence->message, report.divergence->advice);
}

class WeftStepping final : public Contestant {
public:
    WeftStepping(const SceneDescription& scene, int threads) : simulation_(scene, threads) {}

    Measurement measure(double least_seconds) override {
        const auto seconds_of_frames = [this](int frames) {
            return seconds_of([&] {
                for (int n = 0; n < frames; ++n) advance(simulation_);
            });
        };
        if (frames_ == 0) frames_ = pieces_lasting(least_seconds, seconds_of_frames);
        const std::size_t before = simulation_.step_count();
        Measurement found;
        found.seconds = seconds_of_frames(frames_);
        found.steps = static_cast<double>(simulation_.step_count() - before);
        return found;
    }

private:
    Simulation simulation_;
    int frames_ = 0;
};

class PeerStepping final : public Contestant {
public:
    explicit PeerStepping(std::unique_ptr<SteppedPeer> peer) : peer_(std::move(peer)) {}

    Measurement measure(double least_seconds) override {
        const auto seconds_of_steps = [this](int steps) {
            return seconds_of([&] { peer_->step(sheet_step, steps); });
        };
        if (steps_ == 0) steps_ = pieces_lasting(least_seconds, seconds_of_steps);
        Measurement found;
        found.seconds = seconds_of_steps(steps_);
        found.steps = steps_;
        return found;
    }

private:
    std::unique_ptr<SteppedPeer> peer_;
    int steps_ = 0;
};

double sag(const PlainSheet& sheet, const std::vector<Vec3d>& positions) {
    const int column = sheet.columns / 2, row = sheet.rows - 1;
    const int middle = row * sheet.columns + column;
    return sheet.rest_position(column, row).y - positions[static_cast<std::size_t>(middle)].y;
}

class WeftTwoSeconds final : public Contestant {
public:
    WeftTwoSeconds(const PlainSheet& sheet, const SceneDescription& scene)
        : sheet_(sheet), scene_(scene) {}

    Measurement measure(double /*least_seconds*/) override {
        Simulation simulation(scene_);
        Measurement found;
        found.seconds = seconds_of([&] {
            for (int n = 0; n < two_seconds; ++n) advance(simulation);
        });
        found.steps = static_cast<double>(simulation.step_count());
        found.frames = two_seconds;
        FrameBuffer buffer;
        simulation.capture(buffer);
        found.sag = sag(sheet_, buffer.positions);
        return found;
    }

private:
    PlainSheet sheet_;
    SceneDescription scene_;
};

class PeerTwoSeconds final : public Contestant {
public:
    PeerTwoSeconds(const PlainSheet& sheet, std::unique_ptr<SteppedPeer> (*make)(const PlainSheet&))
        : sheet_(sheet), make_(make) {}

    Measurement measure(double /*least_seconds*/) override {
        const std::unique_ptr<SteppedPeer> peer = make_(sheet_);
        Measurement found;
        found.seconds = seconds_of([&] { peer->step(1.0 / 60.0, two_seconds); });
        found.frames = two_seconds;
        std::vector<Vec3d> positions(sheet_.particle_count());
        peer->copy_positions(positions);
        found.sag = sag(sheet_, positions);
        return found;
    }

private:
    PlainSheet sheet_;
    std::unique_ptr<SteppedPeer> (*make_)(const PlainSheet&);
};

}  // namespace

int pieces_lasting(double least_seconds, const std::function<double(int pieces)>& seconds_of) {
    constexpr double near_enough = 0.8, most_growth = 100.0, most_pieces = 1e9;
    double pieces = 1.0, seconds = seconds_of(1);
    while (seconds < near_enough * least_seconds && pieces < most_pieces) {
        const double growth = seconds > 0.0 ? least_seconds / seconds : most_growth;
        pieces = std::min(std::ceil(pieces * std::clamp(growth, 1.25, most_growth)), most_pieces);
        seconds = seconds_of(static_cast<int>(pieces));
    }
    return static_cast<int>(pieces);
}

std::unique_ptr<Contestant> make_stepping(const SceneDescription& scene, int threads) {
    return std::make_unique<WeftStepping>(scene, threads);
}
std::unique_ptr<Contestant> make_stepping(std::unique_ptr<SteppedPeer> peer) {
    return std::make_unique<PeerStepping>(std::move(peer));
}
std::unique_ptr<Contestant> make_two_seconds(const PlainSheet& sheet,
                                             const SceneDescription& scene) {
    return std::make_unique<WeftTwoSeconds>(sheet, scene);
}
std::unique_ptr<Contestant> make_two_seconds(
    const PlainSheet& sheet, std::unique_ptr<SteppedPeer> (*make)(const PlainSheet&)) {
    return std::make_unique<PeerTwoSeconds>(sheet, make);
}

}  // namespace weft::bench
