#include "viewer/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/recording_file.h"
#include "viewer/file_names.h"
#include "viewer/scene_difference.h"
#include "viewer/scene_edits.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

constexpr std::chrono::seconds refusal_shown{5};
constexpr double slowest = 0.01, fastest = 100.0;

}  // namespace

IntegratorDescription lane_of(const SceneDescription& scene, std::string_view method) {
    IntegratorDescription lane = scene.integrator;
    lane.method = method;
    return lane;
}

Workbench::Workbench(const WindowRequest& request, WindowSettings& settings)
    : settings_(settings), threads_(request.threads), recording_render_(request.recording_render) {
    if (!request.recording.empty()) {
        open_recording(request.recording, !request.paused);
        return;
    }
    const SceneDescription& scene = request.scene.value();
    for (const std::string& method : request.compare) lanes_.push_back(lane_of(scene, method));
    open_scene(scene, !request.paused);
    remember(settings_, scene.file);
}

void Workbench::open(const std::string& path_or_name) {
    if (is_recording(path_or_name)) {
        if (flight_) recording_render_ = scene().render;
        open_recording(path_or_name, true);
    } else {
        const SceneDescription scene = load_scene(path_or_name);
        try {
            open_scene(scene, true);
        } catch (const Error&) {
            if (lanes_.empty()) throw;
            lanes_.clear();  // it may be one of those that cannot fly this scene
            open_scene(scene, true);
        }
        remember(settings_, scene.file);
    }
}

void Workbench::open_scene(const SceneDescription& scene, bool play) {
    auto flight = std::make_unique<Flight>(scene, lanes_, threads_);
    playback_.reset();
    flight_ = std::move(flight);
    history_ = std::make_unique<EditHistory>(scene);
    opened_ = scene;
    speed_ = 1.0;
    refusals_.clear();
    divergences_.clear();
    refusals_taken_ = 0;
    saved_file_.clear();
    measurements.clear();
    was_recording_ = false;
    recording_asked_ = false;
    recording_number_ = 0;
    view_ = flight_->view();
    measurements.add(*view_);
    ask_play(play);
}

void Workbench::open_recording(const std::string& path, bool play) {
    playback_ = std::make_unique<Playback>(path, recording_render_);
    playback_->play(play);
    if (flight_) ask_play(false);
    speed_ = 1.0;
    remember(settings_, path);
}

void Workbench::return_to_scene() {
    playback_.reset();
    set_speed(view_->speed);
}

std::string Workbench::title() const {
    if (plays_recording()) return playback_->path().filename().string();
    const std::string& method = view_->lanes.front().method;
    return fmt::format("{} - {}", scene().name, method);
}

std::string Workbench::stem() const {
    return plays_recording() ? playback_->path().stem().string() : scene().stem;
}

bool Workbench::refresh() {
    const Clock::time_point now = Clock::now();
    const double passed = seconds_between(refreshed_, now);
    refreshed_ = now;
    const bool said_less =
        std::erase_if(refusals_, [now](const Refusal& refusal) { return refusal.until < now; }) > 0;
    const bool moved = plays_recording() && refresh_playback(passed);
    const bool flew = flight_ && refresh_flight();  // also beside a recording: it may be ending one
    return said_less || moved || flew;
}

bool Workbench::refresh_playback(double passed) {
    const bool moving = playback_->playing();
    playback_->advance(std::min(passed, 0.5));
    const bool changed = shown_frame_ != playback_->frame_index() || moving != playing();
    shown_frame_ = playback_->frame_index();
    return changed;
}

bool Workbench::refresh_flight() {
    std::shared_ptr<const FlightView> view = flight_->view();
    const bool is_new = view->number != view_->number;
    view_ = std::move(view);
    if (!is_new) return false;
    measurements.add(*view_);
    note_recording();
    take_refusal();
    note_divergences();
    return true;
}

bool Workbench::busy() const {
    return playing() || was_recording_ || recording_asked_ || !refusals_.empty();
}

bool Workbench::playing() const {
    if (plays_recording()) return playback_->playing();
    return view_->number == asked_at_ ? asked_to_play_ : view_->playing;
}

// What was asked for counts until a view tells, so that a second press undoes the first.
void Workbench::ask_play(bool play) {
    asked_at_ = view_->number;
    asked_to_play_ = play;
    flight_->play(play);
}

const RenderDescription& Workbench::render() const {
    return plays_recording() ? recording_render_ : scene().render;
}

void Workbench::toggle_play() {
    if (plays_recording()) {
        playback_->play(!playback_->playing());
    } else {
        ask_play(!playing());
    }
}

void Workbench::step(int frames) {
    if (plays_recording()) {
        playback_->step(frames);
    } else if (frames > 0) {
        flight_->step();
    }
}

void Workbench::reset() {
    if (plays_recording()) {
        playback_->seek(0);
        return;
    }
    divergences_.clear();
    flight_->reset();
}

void Workbench::set_speed(double speed) {
    speed_ = std::clamp(speed, slowest, fastest);
    if (plays_recording()) {
        playback_->set_speed(speed_);
    } else {
        flight_->set_speed(speed_);
    }
}

void Workbench::edit(const SceneDescription& scene, const std::string& what) {
    try {
        check_scene(scene);
    } catch (const Error& error) {
        refuse(what, error.what());
        return;
    }
    history_->edit(scene, what);
    flight_->set_scene(scene);
    last_edit_ = what;
    lanes_asked_last_ = false;
}

void Workbench::set_parameter(const Parameter& parameter, double value) {
    const std::string what(parameter.label);
    const ParameterChange change = with_parameter(scene(), parameter, value);
    if (change.refusal.empty()) {
        edit(change.scene, what);
    } else {
        refuse(what, change.refusal);
    }
}

void Workbench::end_gesture() {
    if (history_) history_->end_gesture();
}

void Workbench::undo() {
    if (!history_ || !history_->can_undo()) return;
    history_->undo();
    flight_->set_scene(scene());
}

void Workbench::redo() {
    if (!history_ || !history_->can_redo()) return;
    history_->redo();
    flight_->set_scene(scene());
}

void Workbench::set_method(std::string_view method) {
    edit(with_method(scene(), method), "method");
    end_gesture();
}

Remedy Workbench::remedy() const {
    const LaneView& lane = view_->lanes.front();
    if (lane.stable_step <= 0.0) return Remedy::other_method;
    // An automatic step would be no shorter: what diverged was more violent than the limit allows.
    const bool was_stable = lane.divergence && lane.divergence->time_step <= 0.9 * lane.stable_step;
    return was_stable ? Remedy::half_the_step : Remedy::stable_step;
}

void Workbench::apply_remedy() {
    const Remedy chosen = remedy();
    SceneDescription changed = scene();
    changed.integrator.time_step.reset();
    if (chosen == Remedy::other_method) changed = with_method(changed, "auto");
    if (chosen == Remedy::half_the_step) {
        changed.integrator.time_step = 0.5 * view_->lanes.front().divergence->time_step;
    }
    edit(changed, "time step");
    end_gesture();
    reset();
    ask_play(true);
}

void Workbench::refuse(const std::string& what, const std::string& text) {
    const Refusal* before = refusal(what);
    if (before == nullptr || before->text != text) messages.note(text);
    std::erase_if(refusals_, [&](const Refusal& refusal) { return refusal.what == what; });
    refusals_.push_back({what, text, Clock::now() + refusal_shown});
}

const Refusal* Workbench::refusal(const std::string& what) const {
    for (const Refusal& refusal : refusals_) {
        if (refusal.what == what) return &refusal;
    }
    return nullptr;
}

void Workbench::set_lanes(std::vector<IntegratorDescription> lanes) {
    lanes_before_ = std::exchange(lanes_, std::move(lanes));
    lanes_asked_last_ = true;
    divergences_.clear();
    flight_->set_lanes(lanes_);
}

// A refusal is in every view until the next change; it is obeyed once.
void Workbench::take_refusal() {
    if (view_->refusals == refusals_taken_) return;
    refusals_taken_ = view_->refusals;
    if (view_->refusal.empty()) return;  // what came after it was taken
    if (lanes_asked_last_) {
        refuse("lanes", view_->refusal);
        lanes_ = lanes_before_;
        return;
    }
    refuse(last_edit_, view_->refusal);
    // Of several edits of a drag, all may have been refused: what flies already stays.
    const SceneDifference differs = difference(view_->scene, scene());
    const bool flies = !differs.cloth && !differs.physics && !differs.shape && !differs.obstacles;
    if (!flies && history_->can_undo()) undo();
}

void Workbench::note_divergences() {
    divergences_.resize(view_->lanes.size());
    for (std::size_t k = 0; k < view_->lanes.size(); ++k) {
        const LaneView& lane = view_->lanes[k];
        const std::string text = lane.divergence ? lane.divergence->message : std::string{};
        if (text == divergences_[k]) continue;
        divergences_[k] = text;
        if (!text.empty()) messages.note(text);
    }
}

void Workbench::note_recording() {
    const RecordingView& recording = view_->recording;
    const bool running = recording.active || recording.ending;
    const bool began = recording.number != recording_number_;
    const bool is_over = (was_recording_ || began) && !running;
    was_recording_ = running;
    recording_number_ = recording.number;
    if (began) recording_asked_ = false;
    if (!is_over) return;
    if (!recording.error.empty()) messages.add(MessageKind::trouble, recording.error);
    for (const std::string& warning : recording.warnings) {
        messages.add(MessageKind::trouble, warning);
    }
    playable_.clear();
    std::string names;
    for (const std::filesystem::path& file : recording.files) {
        wrote(file);
        names += (names.empty() ? "" : ", ") + file.filename().string();
        if (is_recording(file)) playable_ = file;
    }
    if (!names.empty()) {
        messages.add(MessageKind::done,
                     fmt::format("Recorded {} frames: {}", recording.frames, names));
    }
}

std::string Workbench::suggested_file() const {
    if (!saved_file_.empty()) return saved_file_.string();
    const bool own = !opened_.file.empty() && !is_shipped_scene_file(opened_.file);
    return own ? opened_.file : suggested_scene_file(scene().stem);
}

void Workbench::save(const std::string& file, bool with_state) {
    const FrameBuffer& frame = view_->lanes.front().frame;
    const std::vector<std::filesystem::path> written = save_scene(
        with_state ? with_start(scene(), frame.positions, frame.velocities, frame.time) : scene(),
        file);
    for (const std::filesystem::path& path : written) wrote(path);
    saved_file_ = file;
    history_->mark_saved();
    remember(settings_, file);
    messages.add(MessageKind::done, fmt::format("Saved {}", file));
}

void Workbench::start_recording(const std::string& format, const RenderDescription& render) {
    playable_.clear();
    recording_asked_ = true;
    flight_->start_recording({format, std::filesystem::current_path(), stem(), render});
}

void Workbench::stop_recording() {
    flight_->stop_recording();
}

}  // namespace weft::viewer
