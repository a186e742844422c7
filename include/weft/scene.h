// What a scene is: plain data, SI units. A scene file (docs/scene-format.md) is read into a
// SceneDescription; a program may also fill one in itself. The defaults here are those of the scene
// file, and `SceneDescription{}` is the shipped flag.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "weft/vec3.h"

namespace weft {

enum class Plane { xy, xz };                 ///< hangs (y up), or lies
enum class StiffnessPer { spring, width };   ///< unit of every stiffness and damping
enum class BendLayout { interior, border };  ///< PHYSICS: all (i,j)-(i+2,j), or borders only
enum class Precision { f32, f64 };           ///< "single", "double"
enum class OnDivergence { stop, halve_step };
enum class GustModel { none, coefficient };
/// Of an implicit method's linear systems; automatic: multigrid on a grid, aggregation on a mesh.
enum class LinearSolver { automatic, multigrid, aggregation, jacobi, cholesky };
enum class EdgeSelection {  ///< parts of a grid
    top_left,
    top_right,
    bottom_left,
    bottom_right,
    left_edge,
    right_edge,
    top_edge,
    bottom_edge
};

/// A sheet of columns x rows particles; particle (column i, row j) has index j * columns + i and
/// starts at origin + (i dx, -j dy, 0) in plane xy, origin + (i dx, 0, j dy) in plane xz, with
/// dx = size[0] / (columns - 1) and dy = size[1] / (rows - 1).
struct GridDescription {
    std::array<double, 2> size{1.5, 1.0};   ///< width, height [m]
    std::array<int, 2> resolution{61, 41};  ///< columns, rows; at least 2 each
    Plane plane = Plane::xy;
    Vec3d origin{0.0, 2.0, 0.0};  ///< of particle (0, 0) [m]
    friend bool operator==(const GridDescription&, const GridDescription&) = default;
};

/// A polygon mesh as a file has it: vertices may be doubled along texture seams.
struct Mesh {
    /// Corners of one triangle or quad, as indices into `positions` and `uvs`.
    struct Face {
        std::array<std::uint32_t, 4> position{};
        std::array<std::uint32_t, 4> uv{};  ///< not read where `uvs` is empty
        int corners = 3;                    ///< 3 or 4
    };
    std::vector<Vec3d> positions;           ///< [vertex], [m]
    std::vector<std::array<float, 2>> uvs;  ///< v upward; may be empty
    std::vector<Face> faces;
    /// [face] the polygon of the file it was cut from, from 0; empty: every face is its own.
    std::vector<std::uint32_t> source_faces;
    int first_number = 1;  ///< of vertices and faces in messages
};

struct ClothDescription {
    GridDescription grid;
    std::string mesh_path;             ///< as read, resolved; empty: the grid is used
    std::shared_ptr<const Mesh> mesh;  ///< null: the grid is used
    friend bool operator==(const ClothDescription&, const ClothDescription&) = default;
};

/// Stiffness and dashpot of one kind of spring. Per spring: [N/m] and [N s/m]. Per width: the
/// tension in newtons per metre of width at unit strain [N/m], and per unit strain rate [N s/m].
struct SpringMaterial {
    double stiffness = 0.0;
    double damping = 0.0;
    friend bool operator==(const SpringMaterial&, const SpringMaterial&) = default;
};

struct MaterialDescription {
    std::string fabric = "flag";          ///< preset whose values stand below
    double mass_per_area = 0.12;          ///< [kg/m2]
    std::optional<double> particle_mass;  ///< [kg]; given, it replaces mass_per_area
    StiffnessPer stiffness_per = StiffnessPer::width;
    SpringMaterial structural{120.0, 0.012};
    SpringMaterial shear{40.0, 0.004};
    SpringMaterial bend{10.0, 0.001};
    BendLayout bend_layout = BendLayout::interior;
    friend bool operator==(const MaterialDescription&, const MaterialDescription&) = default;
};

/// A fabric preset: a row of `weft list fabrics`.
struct FabricInfo {
    std::string_view name;
    std::string_view description;
    double mass_per_area;                    ///< [kg/m2]
    SpringMaterial structural, shear, bend;  ///< per width
};
std::span<const FabricInfo> fabric_catalogue();

struct ParticleSelection {
    std::vector<std::size_t> particles;
    friend bool operator==(const ParticleSelection&, const ParticleSelection&) = default;
};
struct EverySelection {
    std::size_t every;
    EdgeSelection of;
    friend bool operator==(const EverySelection&, const EverySelection&) = default;
};
struct BoxSelection {
    Vec3d low, high;
    friend bool operator==(const BoxSelection&, const BoxSelection&) = default;
};  ///< rest positions inside, borders included [m]
using PinSelector = std::variant<EdgeSelection, ParticleSelection, EverySelection, BoxSelection>;

/// One keyframe of a pin's motion. Between keyframes the offset follows a cubic with zero slope at
/// each (smoothstep); before the first and after the last it rests.
struct PinKeyframe {
    double time = 0.0;  ///< [s], strictly rising
    Vec3d offset{};     ///< from the rest position [m]
    friend bool operator==(const PinKeyframe&, const PinKeyframe&) = default;
};

struct PinDescription {
    PinSelector select = EdgeSelection::left_edge;
    std::vector<PinKeyframe> motion;  ///< empty: does not move
    friend bool operator==(const PinDescription&, const PinDescription&) = default;
};

struct SphereObstacle {
    Vec3d centre{0.0, 0.5, 0.0};  ///< [m]
    double radius = 0.25;         ///< [m]
    friend bool operator==(const SphereObstacle&, const SphereObstacle&) = default;
};
/// A half-space; the cloth stays on the side its normal points to.
struct PlaneObstacle {
    Vec3d point{};                ///< any of the plane [m]
    Vec3d normal{0.0, 1.0, 0.0};  ///< of any length but 0
    friend bool operator==(const PlaneObstacle&, const PlaneObstacle&) = default;
};
/// What the cloth cannot enter, and rests on.
struct ObstacleDescription {
    std::variant<SphereObstacle, PlaneObstacle> shape;
    double friction = 0.4;  ///< Coulomb's coefficient, of rest and of sliding
    double gap = 0.005;     ///< that particles keep from its surface [m]
    friend bool operator==(const ObstacleDescription&, const ObstacleDescription&) = default;
};

/// A moment of a cloth's motion.
struct ClothState {
    std::vector<Vec3d> positions, velocities;  ///< [particle], [m], [m/s]
    friend bool operator==(const ClothState&, const ClothState&) = default;
};

/// What a run begins with, where that is not the cloth's rest state at time 0.
struct StartDescription {
    std::string state_path;                   ///< as read, resolved; empty: the rest state
    std::shared_ptr<const ClothState> state;  ///< null: the rest state
    double time = 0.0;                        ///< of frame 0 [s]
    friend bool operator==(const StartDescription&, const StartDescription&) = default;
};

struct ForcesDescription {
    Vec3d gravity{0.0, -9.81, 0.0};  ///< [m/s2]
    double damping = 0.0;            ///< drag c of every particle, f = -c v [kg/s]
    friend bool operator==(const ForcesDescription&, const ForcesDescription&) = default;
};

struct GustDescription {
    GustModel model = GustModel::coefficient;
    double spread = 0.5;   ///< factor in [1 - spread, 1 + spread]
    double period = 0.25;  ///< between two draws [s]
    std::uint64_t seed = 7;
    friend bool operator==(const GustDescription&, const GustDescription&) = default;
};

struct WindDescription {
    Vec3d velocity{4.0, 0.0, 1.4};  ///< mean [m/s]
    double air_density = 1.2;       ///< [kg/m3]
    double drag = 1.0;              ///< factor on the plate's normal force
    double skin_friction = 0.01;    ///< tangential coefficient C_f
    GustDescription gust;
    friend bool operator==(const WindDescription&, const WindDescription&) = default;
};

struct IntegratorDescription {
    std::string method = "auto";      ///< "auto": chosen by cost, see Simulation::method()
    std::optional<double> time_step;  ///< [s]; none: "auto", 0.9 of the stable step
    Precision precision = Precision::f32;
    /// Of methods that control their error, the largest local error of a position; of implicit
    /// ones, how far a particle may still move in the last iteration [m]. None: "auto".
    std::optional<double> tolerance;
    std::optional<int> iterations;  ///< most a step, of methods that iterate; none: "auto"
    LinearSolver linear_solver = LinearSolver::automatic;
    OnDivergence on_divergence = OnDivergence::stop;
    friend bool operator==(const IntegratorDescription&, const IntegratorDescription&) = default;
};

struct OutputDescription {
    double duration = 8.0;  ///< [s]
    double frames_per_second = 30.0;
    std::vector<std::string> formats{"glb", "pc2", "mp4"};
    bool energy_balance = false;  ///< integrate the work of every force over time
    bool settle = false;          ///< start from the state of rest
};

/// How pictures look.
struct RenderDescription {
    std::array<int, 2> size{1280, 720};  ///< picture [pixels], even numbers
    std::string texture = "flag";        ///< built-in name, or resolved PNG or JPEG path
    bool mast = true;                    ///< a pole along the cloth's left edge
    bool ground = true;                  ///< a floor that takes the shadow
    std::optional<Vec3d> camera;         ///< eye [m]; none: frames the whole motion
    std::optional<Vec3d> target;         ///< point looked at [m]; none: the cloth's middle
    double field_of_view = 35.0;         ///< vertical [degrees]
};

struct SceneDescription {
    std::string name = "Flag in the wind";
    std::string file;           ///< scene file it came from; empty: none
    std::string stem = "flag";  ///< recordings are named after it
    ClothDescription cloth;
    MaterialDescription material;
    std::vector<PinDescription> pins{PinDescription{}};
    std::vector<ObstacleDescription> obstacles;
    StartDescription start;
    ForcesDescription forces;
    std::optional<WindDescription> wind{WindDescription{}};
    IntegratorDescription integrator;
    OutputDescription output;
    RenderDescription render;

    /// Frames after frame 0: duration times frames per second, rounded.
    [[nodiscard]] std::size_t frame_count() const;
};

/// Checks every value's range and every combination; reading a file does so by itself.
/// @throws Error (usage) naming the key, the value and what is allowed.
void check_scene(const SceneDescription& scene);

/// A key of the scene file with a value in TOML syntax, e.g. {"cloth.resolution", "[100,100]"}.
/// A value that is not TOML is taken as a bare string: {"integrator.method", "rk4"}.
using SceneOverride = std::pair<std::string, std::string>;

/// Reads a scene: `scene` is the path of a TOML file, or the name of a shipped scene.
/// @throws Error (usage) with file, line, column and key; Error (file) where it cannot be read.
SceneDescription load_scene(const std::string& scene,
                            std::span<const SceneOverride> overrides = {});

/// The same from text; `file` is used in messages, and relative paths are resolved against it.
SceneDescription parse_scene(std::string_view text, const std::string& file,
                             std::span<const SceneOverride> overrides = {});

/// The scene as a file that load_scene() reads back as the same scene, every key that counts with
/// its unit. What scene.start holds goes into NAME.start.npy beside it; paths are written relative
/// to it where they lead from there. An existing file is replaced once the new one is whole.
/// @return the files written, the scene's first.
/// @throws Error (usage) as check_scene(), and for what no scene file can hold: a mesh that is in
///         no file, a path that is not UTF-8. Error (file).
std::vector<std::filesystem::path> save_scene(const SceneDescription& scene,
                                              const std::filesystem::path& file);

/// A shipped scene: a row of `weft list scenes`.
struct ShippedScene {
    std::string name;  ///< "flag"
    std::filesystem::path path;
    std::string title;  ///< its `name` key
};
/// The shipped scenes, sorted by name.
/// @throws Error (file) where weft's data directory cannot be found.
std::vector<ShippedScene> shipped_scenes();

}  // namespace weft
