// weft view: opens the window and, with --json, prints what happened in it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "io/recording_file.h"
#include "viewer/flight.h"
#include "viewer/window.h"
#include "weft/error.h"

namespace weft {

namespace {

void check_compared(const std::vector<std::string>& methods) {
    constexpr std::size_t most_compared = viewer::most_lanes - 1;
    if (methods.size() > most_compared) {
        throw Error(ErrorKind::usage, {.key = "--compare"},
                    fmt::format("{} methods are too many: at most {} fly beside the scene's own",
                                methods.size(), most_compared));
    }
    check_methods("--compare", methods, true);
}

viewer::WindowRequest window_request(const ViewOptions& options) {
    viewer::WindowRequest request;
    request.threads = options.threads;
    request.paused = options.paused;
    request.compare = options.compare;
    request.interrupted = interrupted;
    check_compared(options.compare);
    if (is_recording(options.scene)) {
        if (!options.compare.empty()) {
            throw Error(ErrorKind::usage, {.key = "--compare"},
                        "is for scenes: a recording cannot be flown by another method");
        }
        request.recording = options.scene;
        request.recording_render = render_settings(options.set);
        return request;
    }
    SceneOptions scene = options;
    if (scene.scene.empty()) scene.scene = "flag";
    request.scene = load_scene(scene);
    return request;
}

nlohmann::ordered_json json_of(const viewer::WindowReport& report) {
    return {{"frames_drawn", report.frames_drawn},
            {"seconds", report.seconds},
            {"frames_per_second", report.frames_per_second},
            {"latency_ms",
             {{"median", report.latency_ms_median}, {"largest", report.latency_ms_largest}}},
            {"simulation_frame", report.simulation_frame},
            {"state_hash", fmt::format("{:016x}", report.state_hash)},
            {"pristine", report.pristine},
            {"files", report.files},
            {"messages", report.messages}};
}

}  // namespace

int view_command(const ViewOptions& options) {
    watch_for_interrupt();
    const viewer::WindowReport report = viewer::run_window(window_request(options));
    if (options.json) fmt::print("{}\n", json_of(report).dump(2));
    return exit_done;
}

}  // namespace weft
