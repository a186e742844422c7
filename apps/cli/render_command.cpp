#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/simulate.h"
#include "io/picture_recorder.h"
#include "io/recording_file.h"
#include "render/image.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::array<std::string_view, 4> picture_endings{".mp4", ".webm", ".gif", ".png"};

std::filesystem::path checked_target(const RenderOptions& options) {
    const std::filesystem::path file = options.file;
    const std::string ending = file.extension().string();
    if (std::find(picture_endings.begin(), picture_endings.end(), ending) ==
        picture_endings.end()) {
        throw Error(ErrorKind::usage, {.key = "--output"},
                    fmt::format("\"{}\" is not allowed: .mp4, .webm, .gif or .png", options.file));
    }
    if (options.frame && ending != ".png") {
        throw Error(ErrorKind::usage, {.key = "--frame"},
                    "is for a single picture: give -o a name ending in .png");
    }
    if (options.frame && options.frames) {
        throw Error(ErrorKind::usage, {.key = "--frame"}, "and --frames cannot be given together");
    }
    return file;
}

// What would only come out after the whole simulation.
void check_before(const std::filesystem::path& target, const RenderDescription& render) {
    const std::filesystem::path directory = target.has_parent_path() ? target.parent_path() : ".";
    if (!std::filesystem::is_directory(directory)) {
        throw file_error(target.string(), "there is no directory " + directory.string());
    }
    load_texture(render.texture);
}

RecordingPlan plan_for(RecordingPlan plan, const std::filesystem::path& target) {
    plan.directory = target.parent_path();
    plan.stem = target.stem().string();
    return plan;
}

std::vector<std::string> format_of(const std::filesystem::path& target) {
    return {target.extension().string().substr(1)};
}

int finish(RecordingQueue& queue, bool quiet) {
    queue.finish();
    for (const std::string& warning : queue.warnings()) {
        fmt::print(stderr, "warning: {}\n", warning);
    }
    if (!quiet) {
        for (const std::filesystem::path& file : queue.files()) fmt::print("{}\n", file.string());
    }
    return interrupted() ? exit_interrupted : exit_done;
}

int render_scene(const RenderOptions& options, const std::filesystem::path& target) {
    SceneDescription scene = load_scene(options);
    const bool picture = target.extension() == ".png";
    if (options.frame) {
        scene.output.duration =
            static_cast<double>(*options.frame) / scene.output.frames_per_second;
    }
    check_before(target, scene.render);
    Simulation simulation(scene, options.threads);
    for (const std::string& warning : warnings_before(simulation)) {
        fmt::print(stderr, "warning: {}\n", warning);
    }
    const RecordingPlan plan = plan_for(recording_plan(simulation, {}, {}), target);
    Progress progress(scene.frame_count(), !options.quiet);
    RunRecord record;
    std::optional<RecordingQueue> queue;
    FrameBuffer first;
    simulation.capture(first);
    if (!picture) queue.emplace(make_recorders(format_of(target)), plan);
    simulate(simulation, queue ? &*queue : nullptr, progress, record);
    int status = record.status == "interrupted" ? exit_interrupted : exit_done;
    if (queue) {
        status = finish(*queue, options.quiet);
    } else {
        FrameBuffer last;
        simulation.capture(last);
        write_picture(target, plan, first.view(), last.view());
        if (!options.quiet) fmt::print("{}\n", target.string());
    }
    if (record.divergence) {
        report_divergence(*record.divergence);
        return exit_diverged;
    }
    return status;
}

int render_recording(const RenderOptions& options, const std::filesystem::path& target) {
    RecordingFile recording(options.scene);
    std::size_t count = recording.frame_count();
    if (options.frames) count = std::min(count, *options.frames + 1);
    RecordingPlan plan;
    plan.title = options.scene;
    plan.surface = &recording.surface();
    plan.frame_count = count;
    plan.frames_per_second = recording.frames_per_second();
    plan.render = render_settings(options.set);
    plan = plan_for(plan, target);
    check_before(target, plan.render);
    if (target.extension() == ".png") {
        const std::size_t index = options.frame.value_or(count - 1);
        if (index >= recording.frame_count()) {
            throw Error(ErrorKind::usage, {.key = "--frame"},
                        fmt::format("{} is not allowed: {} has frames 0 to {}", index,
                                    options.scene, recording.frame_count() - 1));
        }
        RecordingFile start(options.scene);
        write_picture(target, plan, start.frame(0), recording.frame(index));
        if (!options.quiet) fmt::print("{}\n", target.string());
        return exit_done;
    }
    RecordingQueue queue(make_recorders(format_of(target)), plan);
    Progress progress(count - 1, !options.quiet);
    for (std::size_t n = 0; n < count && !interrupted(); ++n) {
        const Frame frame = recording.frame(n);
        FrameBuffer& buffer = queue.next();
        buffer.index = frame.index;
        buffer.time = frame.time;
        buffer.positions.assign(frame.positions.begin(), frame.positions.end());
        buffer.velocities.assign(frame.velocities.begin(), frame.velocities.end());
        buffer.normals.assign(frame.normals.begin(), frame.normals.end());
        if (!queue.push()) break;
        if (n > 0) progress.update(n, frame.time);
    }
    progress.end();
    return finish(queue, options.quiet);
}

}  // namespace

RenderDescription render_settings(const std::vector<std::string>& set) {
    // A recording says nothing of how it is to look: the settings are those of an empty scene.
    std::vector<SceneOverride> overrides{{"render.mast", "false"}, {"render.texture", "linen"}};
    for (const std::string& setting : set) {
        const std::size_t equals = setting.find('=');
        if (setting.rfind("render.", 0) != 0 || equals == std::string::npos) {
            throw Error(ErrorKind::usage, {.key = "--set " + setting},
                        "for a recording, only keys of [render] can be set, as render.KEY=VALUE");
        }
        overrides.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
    return parse_scene("version = 1\n", "recording", overrides).render;
}

int render_command(const RenderOptions& options) {
    const std::filesystem::path target = checked_target(options);
    watch_for_interrupt();
    return is_recording(options.scene) ? render_recording(options, target)
                                       : render_scene(options, target);
}

}  // namespace weft
