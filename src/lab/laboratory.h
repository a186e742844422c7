// Runs the measurements of experiments: several at once, each kept on disk as soon as it is done,
// so that a study goes on where it was interrupted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weft/scene.h"

namespace weft::lab {

/// Thrown out of a study that the user interrupted; what was finished is kept.
struct Interrupted {};

/// Asked between steps of a measurement: throws Interrupted once the user wants to stop.
using Watch = std::function<void()>;

/// One measurement. The same trial gives the same result, times aside.
struct Trial {
    /// Unique in its experiment, and says all that determines the result besides the scene and
    /// the weft that measures: "rk4 dt=0.001 frames=100". Spaces are fine.
    std::string name;
    /// May run on any thread, beside others. What it throws but Interrupted ends the study.
    /// Numbers that are not finite come back as null.
    std::function<nlohmann::json(const Watch&)> measure;
    double work = 1.0;  ///< how long it takes beside the others of its batch, roughly
};

/// What trials share the machine for.
enum class Batch {
    together,  ///< as many at once as there are threads
    timed,     ///< one at a time: they measure time
};

/// How far a study is.
struct LabProgress {
    std::string experiment;        ///< running now
    std::string trial;             ///< finished last
    std::size_t done = 0, of = 0;  ///< trials of the present batch
    double fraction = 0.0;         ///< of the whole study, from 0 to 1, estimated
};

struct LabOptions {
    bool quick = false;                ///< fewer and shorter runs: under a minute in all
    int threads = 0;                   ///< that trials may take; 0: all hardware threads
    std::vector<std::string> methods;  ///< to rank; empty: all
    std::function<void(const LabProgress&)>
        progress;                ///< called by one thread at a time; may be empty
    std::function<bool()> stop;  ///< whether to end now; may be empty
};

/// The bench of one scene's study. Experiments run one after the other on it.
class Laboratory {
public:
    /// @param directory of the study; finished trials stand in directory/trials.
    /// @throws Error (file) where it cannot be made.
    Laboratory(SceneDescription scene, std::filesystem::path directory, LabOptions options);

    /// The scene as the user gave it; precision as given. Experiments measure in double.
    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    [[nodiscard]] bool quick() const { return options_.quick; }
    /// The methods to rank, in menu order: those asked for, or all of integrator_catalogue().
    [[nodiscard]] const std::vector<std::string_view>& methods() const { return methods_; }
    /// Where an experiment puts pictures and videos: directory/EXPERIMENT, made on demand.
    [[nodiscard]] std::filesystem::path media_directory() const;
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// Measures the trials that are not kept from before; an experiment calls it once a batch.
    /// @return the results in the order of `trials`, whatever the number of threads.
    /// @throws Interrupted; Error.
    std::vector<nlohmann::json> run(std::span<const Trial> trials, Batch batch = Batch::together);

    /// Throws Interrupted once the user wants to stop.
    void check_interrupt() const;

    /// From now on trials belong to the experiment; it stands for `share` of the study and calls
    /// run() `batches` times.
    void begin_experiment(std::string_view experiment, double share, int batches);

private:
    [[nodiscard]] std::filesystem::path file_of(const Trial& trial) const;
    [[nodiscard]] std::optional<nlohmann::json> kept(const Trial& trial) const;
    /// @return the result as it will be read (what is not finite has become null).
    nlohmann::json keep(const Trial& trial, const nlohmann::json& result) const;
    void tell(const std::string& trial, std::size_t done, std::size_t of, double fraction) const;

    SceneDescription scene_;
    std::filesystem::path directory_;
    LabOptions options_;
    std::vector<std::string_view> methods_;
    std::string fingerprint_;  ///< of scene, version and quickness: results of others are not taken
    std::string experiment_;
    double share_ = 0.0, done_share_ = 0.0;
    int batches_ = 1, batch_ = 0;
};

}  // namespace weft::lab
