// What the window has open, and everything that may be done to it. Knows no window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/edit_history.h"
#include "viewer/flight.h"
#include "viewer/measurements.h"
#include "viewer/messages.h"
#include "viewer/parameters.h"
#include "viewer/playback.h"
#include "viewer/window.h"
#include "viewer/window_settings.h"

namespace weft::viewer {

/// Why a change was not taken, to be said beside what was to change it.
struct Refusal {
    std::string what;  ///< as given to Workbench::edit()
    std::string text;
    Clock::time_point until;
};

/// What is done about a divergence.
enum class Remedy { stable_step, half_the_step, other_method };

/// A scene flies, or a recording plays; then the scene flown before waits.
class Workbench {
public:
    /// @throws Error as Flight and Playback.
    Workbench(const WindowRequest& request, WindowSettings& settings);

    /// Opens a scene file, shipped scene or recording in place of what is open.
    /// @throws Error; what was open stays.
    void open(const std::string& path_or_name);
    [[nodiscard]] bool has_scene() const { return flight_ != nullptr; }
    void return_to_scene();  ///< from a recording.  @pre has_scene()
    [[nodiscard]] bool plays_recording() const { return playback_ != nullptr; }
    [[nodiscard]] std::string title() const;  ///< of what is open
    [[nodiscard]] std::string stem() const;   ///< for names of files

    /// Takes what has become of the flight or the recording since the last call.
    /// @return whether there is anything new to draw.
    bool refresh();
    /// Whether something may become new by itself.
    [[nodiscard]] bool busy() const;
    [[nodiscard]] bool playing() const;
    /// @pre has_scene()
    [[nodiscard]] const FlightView& view() const { return *view_; }
    [[nodiscard]] Playback& playback() { return *playback_; }  ///< @pre plays_recording()
    [[nodiscard]] const RenderDescription& render() const;

    // Of either
    void toggle_play();
    void step(int frames);  ///< backward only in a recording
    void reset();
    void set_speed(double speed);
    [[nodiscard]] double speed() const { return speed_; }

    // Of a scene. @pre has_scene()
    [[nodiscard]] const SceneDescription& scene() const { return history_->scene(); }
    /// As it was opened.
    [[nodiscard]] const SceneDescription& opened_scene() const { return opened_; }
    [[nodiscard]] const EditHistory& history() const { return *history_; }
    /// @param what names the change to the user, and the refusal where it is not allowed.
    void edit(const SceneDescription& scene, const std::string& what);
    void set_parameter(const Parameter& parameter, double value);
    void end_gesture();
    void undo();
    void redo();
    void set_method(std::string_view method);
    [[nodiscard]] Remedy remedy() const;  ///< of the scene's own method having diverged
    void apply_remedy();                  ///< and start again
    void refuse(const std::string& what, const std::string& text);
    [[nodiscard]] const Refusal* refusal(const std::string& what) const;
    [[nodiscard]] Flight& flight() { return *flight_; }

    [[nodiscard]] const std::vector<IntegratorDescription>& lanes() const { return lanes_; }
    void set_lanes(std::vector<IntegratorDescription> lanes);  ///< beside the scene's own method

    [[nodiscard]] bool unsaved() const { return history_ && !history_->saved(); }
    [[nodiscard]] std::string suggested_file() const;
    /// @param with_state begins the saved scene with what is on the screen.  @throws Error (file).
    void save(const std::string& file, bool with_state);

    [[nodiscard]] bool recording() const { return view_ && view_->recording.active; }
    void start_recording(const std::string& format, const RenderDescription& render);
    void stop_recording();
    /// What the last recording left that the window can play; empty: nothing.
    [[nodiscard]] const std::filesystem::path& playable() const { return playable_; }

    Messages messages;
    Measurements measurements;
    void wrote(const std::filesystem::path& file) { files_.push_back(file.string()); }
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

private:
    void open_scene(const SceneDescription& scene, bool play);
    void open_recording(const std::string& path, bool play);
    void ask_play(bool play);
    bool refresh_playback(double passed);
    bool refresh_flight();
    void take_refusal();
    void note_divergences();
    void note_recording();

    WindowSettings& settings_;
    int threads_ = 0;
    double speed_ = 1.0;
    SceneDescription opened_;
    std::unique_ptr<EditHistory> history_;
    std::unique_ptr<Flight> flight_;
    std::shared_ptr<const FlightView> view_;
    std::uint64_t asked_at_ = 0;  ///< number of the view when playing was asked for last
    bool asked_to_play_ = false;
    std::vector<IntegratorDescription> lanes_, lanes_before_;
    bool lanes_asked_last_ = false;
    std::string last_edit_;
    std::uint64_t refusals_taken_ = 0;  ///< of the flight
    std::vector<Refusal> refusals_;
    std::vector<std::string> divergences_;  ///< [lane] that were said
    bool was_recording_ = false;
    bool recording_asked_ = false;      ///< and nothing heard of it yet
    std::size_t recording_number_ = 0;  ///< of the last one heard of
    std::filesystem::path playable_, saved_file_;

    std::unique_ptr<Playback> playback_;
    RenderDescription recording_render_;
    std::size_t shown_frame_ = 0;
    Clock::time_point refreshed_ = Clock::now();
    std::vector<std::string> files_;
};

/// The scene's integrator with another method: a lane to compare with.
IntegratorDescription lane_of(const SceneDescription& scene, std::string_view method);

}  // namespace weft::viewer
