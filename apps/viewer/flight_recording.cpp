#include "viewer/flight_recording.h"

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>
#include <utility>

#include "viewer/scene_difference.h"
#include "viewer/spooled_recorder.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

/// The files that a format writes for a stem, from the row of `weft list formats`.
std::vector<std::string> names_of(std::string_view format, const std::string& stem) {
    constexpr std::string_view name = "NAME", separator = ", ";
    std::vector<std::string> names;
    for (const FormatInfo& info : format_catalogue()) {
        if (info.name != format) continue;
        std::string_view rest = info.files;
        while (!rest.empty()) {
            const std::string_view file = rest.substr(0, rest.find(separator));
            rest.remove_prefix(std::min(rest.size(), file.size() + separator.size()));
            if (file.starts_with(name)) names.push_back(stem + std::string(file.substr(4)));
        }
    }
    return names;
}

bool draws(std::string_view format) {
    return format == "mp4" || format == "webm" || format == "gif" || format == "png";
}

bool stands(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::symlink_status(file, ignored).type() !=
           std::filesystem::file_type::not_found;
}

void make_directory(const std::filesystem::path& directory) {
    std::error_code problem;
    std::filesystem::create_directories(directory, problem);
    if (problem) throw file_error(directory.string(), "cannot make: " + problem.message());
}

}  // namespace

struct FlightRecording::Running {
    std::shared_ptr<const ClothShape> shape;  ///< whose surface the recorders look at
    std::filesystem::path name;               ///< directory and stem
    std::unique_ptr<RecordingQueue> queue;
    double frames_per_second = 30.0;
    SceneDescription scene;  ///< at the beginning
    bool draws = false;      ///< pictures, with the obstacles in them
    bool obstacles_changed = false;
};

struct FlightRecording::Ending {
    std::unique_ptr<Running> recording;
    std::vector<std::filesystem::path> files;
    std::vector<std::string> warnings;
    std::string error;
    std::atomic<bool> done{false};  ///< the thread touches nothing above any more
    std::thread thread;

    void finish() {
        try {
            recording->queue->finish();
        } catch (const std::exception& problem) {
            error = problem.what();
        }
        files = recording->queue->files();
        warnings = recording->queue->warnings();
        if (recording->obstacles_changed)
            warnings.emplace_back("pictures show the obstacles where they were at the beginning");
        recording->queue.reset();
        done = true;
    }
};

FlightRecording::FlightRecording(std::function<void()> ended) : ended_(std::move(ended)) {}

FlightRecording::~FlightRecording() {
    stop();
    for (Ending& ending : endings_) ending.thread.join();
}

void FlightRecording::start(const RecordingRequest& request, const SceneDescription& scene,
                            const Simulation& simulation,
                            const std::shared_ptr<const ClothShape>& shape) {
    stop();
    view_.files.clear();
    view_.warnings.clear();
    view_.error.clear();
    view_.frames = 0;
    ++view_.number;
    try {
        begin(request, scene, simulation, shape);
        add(simulation);
    } catch (const std::exception& problem) {
        view_.error = problem.what();
    }
}

void FlightRecording::begin(const RecordingRequest& request, const SceneDescription& scene,
                            const Simulation& simulation,
                            const std::shared_ptr<const ClothShape>& shape) {
    SceneDescription drawn = scene;
    drawn.render = request.render;
    check_scene(drawn);
    std::vector<std::unique_ptr<Recorder>> recorders;
    recorders.push_back(make_open_ended_recorder(request.format));
    make_directory(request.directory);
    RecordingPlan plan;
    plan.directory = request.directory;
    plan.stem = free_stem(request);
    plan.title = scene.name;
    plan.surface = &shape->surface;
    plan.frames_per_second = scene.output.frames_per_second;
    plan.precision = simulation.scene().integrator.precision;
    plan.render = request.render;
    plan.obstacles = scene.obstacles;
    auto running = std::make_unique<Running>();
    running->shape = shape;
    running->name = plan.directory / plan.stem;
    running->scene = scene;
    running->draws = draws(request.format);
    running->frames_per_second = plan.frames_per_second;
    running->queue = std::make_unique<RecordingQueue>(std::move(recorders), plan);
    running_ = std::move(running);
    view_.active = true;
}

// Names of recordings that are still ending are taken, though their files do not stand yet.
std::string FlightRecording::free_stem(const RecordingRequest& request) const {
    const auto is_free = [&](const std::string& stem) {
        for (const Ending& ending : endings_)
            if (ending.recording->name == request.directory / stem) return false;
        for (const std::string& name : names_of(request.format, stem))
            if (stands(request.directory / name)) return false;
        return true;
    };
    std::string stem = request.stem;
    for (int number = 2; !is_free(stem); ++number)
        stem = request.stem + "-" + std::to_string(number);
    return stem;
}

void FlightRecording::add(const Simulation& simulation) {
    if (!running_) return;
    FrameBuffer& buffer = running_->queue->next();
    simulation.capture(buffer, running_->queue->needs());
    buffer.index = view_.frames;
    buffer.time = static_cast<double>(view_.frames) / running_->frames_per_second;
    ++view_.frames;
    if (!running_->queue->push()) stop();  // a recorder has failed, and says why when it ends
}

void FlightRecording::scene_changed(const SceneDescription& scene) {
    if (!running_ || !running_->draws || running_->obstacles_changed) return;
    running_->obstacles_changed = difference(running_->scene, scene).obstacles;
}

void FlightRecording::stop() {
    if (!running_) return;
    view_.active = false;
    view_.ending = true;
    Ending& ending = endings_.emplace_back();
    ending.recording = std::move(running_);
    ending.thread = std::thread([&ending, this] {
        ending.finish();
        ended_();
    });
}

void FlightRecording::collect() {
    for (auto ending = endings_.begin(); ending != endings_.end();) {
        if (!ending->done) {
            ++ending;
            continue;
        }
        ending->thread.join();
        view_.files = std::move(ending->files);
        view_.warnings = std::move(ending->warnings);
        view_.error = std::move(ending->error);
        ending = endings_.erase(ending);
    }
    view_.ending = !endings_.empty();
}

}  // namespace weft::viewer
