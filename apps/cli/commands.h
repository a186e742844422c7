// The commands of weft, one function each: what to do with the options once they are parsed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "weft/scene.h"

namespace weft {

/// Exit statuses of the command.
enum ExitStatus {
    exit_done = 0,
    exit_diverged = 1,
    exit_usage = 2,
    exit_file = 3,
    exit_interrupted = 130
};

/// Options that commands share.
struct SceneOptions {
    std::string scene;                  ///< path, or name of a shipped scene
    std::vector<std::string> set;       ///< "KEY=VALUE"
    std::optional<std::size_t> frames;  ///< to simulate
    int threads = 0;                    ///< 0: all
    bool settle = false;                ///< start from rest; without frames, nothing else
    bool quiet = false, json = false;
};

struct RunOptions : SceneOptions {
    std::string directory;  ///< empty: weft-out/NAME
};

struct RenderOptions : SceneOptions {
    std::string file;
    std::optional<std::size_t> frame;  ///< for a single picture
};

struct ViewOptions : SceneOptions {
    std::vector<std::string> compare;  ///< methods beside the scene's own
    bool paused = false;
};

struct BenchOptions {
    bool json = false;
    bool quick = false;          ///< one repeat, up to 256 x 256
    bool large = false;          ///< up to 4096 x 4096
    std::string filter;          ///< words that a case's name must all have
    std::optional<int> repeats;  ///< of every timing
    std::string plot;            ///< file to draw; empty: none
};

struct LabCommandOptions {
    std::vector<std::string> words;    ///< experiments and scenes, as they come
    std::vector<std::string> set;      ///< "KEY=VALUE"
    std::vector<std::string> methods;  ///< to rank; empty: all
    std::string directory;             ///< empty: weft-lab/NAME
    bool quick = false, quiet = false, json = false;
    int threads = 0;  ///< 0: all
};

int run_command(const RunOptions& options);
int render_command(const RenderOptions& options);
int view_command(const ViewOptions& options);
int check_command(const SceneOptions& options);
int bench_command(const BenchOptions& options);
int lab_command(const LabCommandOptions& options);
/// @param what "integrators", "fabrics", "scenes", "formats", "experiments" or "keys"
int list_command(const std::string& what, bool json);

/// @param option that names methods, "--methods"; with_auto: "auto" is one.
/// @throws Error (usage) where there is no such method, naming the nearest.
void check_methods(const std::string& option, const std::vector<std::string>& methods,
                   bool with_auto);
/// Reads the scene with the options' overrides and frames applied.
SceneDescription load_scene(const SceneOptions& options);
/// How a recording is to look, which does not say so itself. @param set "render.KEY=VALUE"
RenderDescription render_settings(const std::vector<std::string>& set);

}  // namespace weft
