// The window behind `weft view`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/scene.h"

namespace weft::viewer {

struct WindowRequest {
    std::optional<SceneDescription> scene;  ///< either this
    std::string recording;                  ///< or the path of one
    RenderDescription recording_render;     ///< how it is to look
    std::vector<std::string> compare;       ///< methods beside the scene's own, three at most
    int threads = 0;                        ///< of each simulation; 0: all but one
    bool paused = false;                    ///< waits for Space
    bool (*interrupted)() = nullptr;        ///< asked often; true closes the window
};

/// What happened in the window, for --json.
struct WindowReport {
    std::size_t frames_drawn = 0;
    double seconds = 0.0;
    double frames_per_second = 0.0;  ///< median
    double latency_ms_median = 0.0;  ///< from an input's event to its frame on the screen
    double latency_ms_largest = 0.0;
    std::size_t simulation_frame = 0;   ///< of lane 0 when it closed
    std::uint64_t state_hash = 0;       ///< of lane 0 then; 0 for a recording
    bool pristine = true;               ///< see FlightView
    std::vector<std::string> files;     ///< written: scenes, recordings, screenshots
    std::vector<std::string> messages;  ///< shown: refusals, divergences, errors
};

/// Opens the window and returns when it is closed.
/// @throws Error (file) where there is no display or no OpenGL 3.3, naming `weft render`; as
///         Flight and Playback for what it opens.
WindowReport run_window(const WindowRequest& request);

}  // namespace weft::viewer
