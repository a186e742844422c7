// The physics of the window: up to four simulations of one scene, in step, on a thread of their
// own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/overlay_shapes.h"
#include "weft/simulation.h"

namespace weft::viewer {

inline constexpr std::size_t most_lanes = 4;

/// What of a cloth stays while it flies. An edited scene (its pins, its mass) gives a shape of its
/// own, of the same number where the surface is as before.
struct ClothShape {
    Surface surface;
    std::uint64_t surface_number = 0;  ///< equal: so are the surfaces
    std::vector<DrawnSpring> springs;
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< of the faces, as particles
    std::vector<std::uint32_t> pinned;                ///< particles, rising
    Stage stage;                                      ///< planned from the rest state
    double mass = 0.0;                                ///< [kg]
};

/// One cloth, flown by one method, at one moment.
struct LaneView {
    std::shared_ptr<const ClothShape> shape;
    FrameBuffer frame;  ///< positions, velocities, normals
    std::string method, method_reason;
    double time_step = 0.0;    ///< [s]
    double stable_step = 0.0;  ///< of this method on this scene [s]; 0: none; or infinite
    std::size_t steps_per_frame = 1, step_count = 0;
    double milliseconds = 0.0;  ///< a frame took, the mean of the last ones
    Energy energy;
    SpringStrain largest_strain;
    std::uint64_t state_hash = 0;
    Vec3d grip_force{};                    ///< [N]
    std::optional<Divergence> divergence;  ///< at which it stopped
    std::vector<std::string> warnings;
};

struct RecordingView {
    std::size_t number = 0;  ///< counts the recordings asked for
    bool active = false;
    bool ending = false;                       ///< an earlier one is being put in place
    std::size_t frames = 0;                    ///< so far
    std::vector<std::filesystem::path> files;  ///< of the last one that ended
    std::vector<std::string> warnings;         ///< likewise
    std::string error;                         ///< why the last one failed; empty: it did not
};

/// All of a flight at one moment.
struct FlightView {
    std::uint64_t number = 0;  ///< counts the views
    SceneDescription scene;    ///< that flies; its integrator is that of lane 0
    std::vector<LaneView> lanes;
    bool playing = false;
    double speed = 1.0;          ///< simulated seconds wanted a second
    double reached_speed = 0.0;  ///< what the machine makes of it; 0 while it rests
    Vec3d wind{};                ///< at the present time [m/s]
    /// Whether the state comes from the scene alone: flown from its start without a change, grip or
    /// moved pin. Then `weft run` of the saved scene gives the same state hash at the same frame.
    bool pristine = true;
    std::string refusal;         ///< why the last change was not taken; empty: it was
    std::uint64_t refusals = 0;  ///< counts them: the same change may be refused again
    RecordingView recording;
};

struct RecordingRequest {
    std::string format;               ///< of weft list formats
    std::filesystem::path directory;  ///< made where it is missing
    /// Files that exist are not replaced: NAME-2, NAME-3, ... (save the script that opens point
    /// caches in Blender, which names the newest).
    std::string stem;
    RenderDescription render;  ///< camera and target as the window has them
};

/// Every function may be called from the window's thread, and returns at once save the constructor
/// and the destructor; what it asks for is seen in a later view. Lanes advance by frames of the
/// scene, all of them or none. A lane that diverges stays at its last good frame.
class Flight {
public:
    /// @param lanes integrators to fly beside the scene's own, at most three.
    /// @param threads of each simulation; 0: all but one of the machine's, at least one.
    /// @throws Error as Simulation's constructor does.
    Flight(const SceneDescription& scene, std::vector<IntegratorDescription> lanes = {},
           int threads = 0);
    ~Flight();  ///< ends a recording properly
    Flight(const Flight&) = delete;
    Flight& operator=(const Flight&) = delete;

    /// The newest view; never null.
    [[nodiscard]] std::shared_ptr<const FlightView> view() const;

    void play(bool playing);
    void step();                   ///< one frame, and pause
    void reset();                  ///< to the start of the scene as it now is
    void set_speed(double speed);  ///< above 0, at most 100; others are refused
    /// Goes on with another scene: from the present state where the cloth stays the same, else from
    /// its start. Where it cannot be, the old one goes on and `refusal` says why. Of several asked
    /// for in quick succession only the last is taken.
    void set_scene(const SceneDescription& scene);
    void set_lanes(std::vector<IntegratorDescription> lanes);  ///< all restart together
    /// Grips of particles that the cloth does not have (any more) let go.
    void set_grips(std::size_t lane, std::vector<Grip> grips);
    void start_recording(const RecordingRequest& request);  ///< of lane 0, from the present frame
    void stop_recording();

private:
    struct Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace weft::viewer
