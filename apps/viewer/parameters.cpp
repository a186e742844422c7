// The table of parameters.
#include "viewer/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "viewer/scene_edits.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft::viewer {

namespace {

using S = SceneDescription;

template <typename T>
inline constexpr bool is_optional = false;
template <typename T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// The nearest integer that there is; what is not a number is 0, which is allowed nowhere here.
int to_whole(double value) {
    constexpr double most = std::numeric_limits<int>::max();
    return std::isnan(value) ? 0 : static_cast<int>(std::clamp(std::round(value), -most, most));
}

/// Reads and writes what `place`, a function of a scene, refers to.
template <auto place>
double get(const S& scene) {
    const auto& number = place(scene);
    if constexpr (is_optional<std::remove_cvref_t<decltype(number)>>) {
        return static_cast<double>(number.value_or(0));
    } else {
        return static_cast<double>(number);
    }
}
template <auto place>
void set(S& scene, double value) {
    auto& number = place(scene);
    using Number = std::remove_cvref_t<decltype(number)>;
    if constexpr (std::is_same_v<Number, std::optional<int>>) {
        number = to_whole(value);
    } else {
        number = value;
    }
}
template <auto place>
bool automatic(const S& scene) {
    return !place(scene);
}
template <auto place>
void make_automatic(S& scene) {
    place(scene).reset();
}

template <std::size_t side>
void set_size(S& scene, double value) {
    scene.cloth.grid.size[side] = value;
    scene.start = {};
}
template <std::size_t side>
void set_resolution(S& scene, double value) {
    std::array<int, 2> resolution = scene.cloth.grid.resolution;
    resolution[side] = to_whole(value);
    scene = with_resolution(scene, resolution);
}

bool has_grid(const S& s) {
    return s.cloth.mesh == nullptr;
}
bool has_particle_mass(const S& s) {
    return s.material.particle_mass.has_value();
}
bool has_mass_per_area(const S& s) {
    return !s.material.particle_mass.has_value();
}
bool has_wind(const S& s) {
    return s.wind.has_value();
}
bool has_gust(const S& s) {
    return s.wind && s.wind->gust.model != GustModel::none;
}
/// Whether it iterates its implicit steps until they are solved; Baraff and Witkin's does not.
bool solves(const IntegratorInfo& info) {
    return info.kind == IntegratorKind::implicit && info.name != "baraff-witkin";
}
// "auto" may come to any kind of method.
bool reads_tolerance(const S& s) {
    const IntegratorInfo* const info = find_integrator(s.integrator.method);
    return info == nullptr || solves(*info) || info->kind == IntegratorKind::adaptive ||
           info->name == "projective-dynamics";
}
bool reads_iterations(const S& s) {
    const IntegratorInfo* const info = find_integrator(s.integrator.method);
    return info == nullptr || solves(*info) || info->kind == IntegratorKind::by_springs;
}

constexpr auto time_step = [](auto& s) -> auto& { return s.integrator.time_step; };
constexpr auto tolerance = [](auto& s) -> auto& { return s.integrator.tolerance; };
constexpr auto iterations = [](auto& s) -> auto& { return s.integrator.iterations; };
constexpr auto structural = [](auto& s) -> auto& { return s.material.structural.stiffness; };
constexpr auto structural_c = [](auto& s) -> auto& { return s.material.structural.damping; };
constexpr auto shear = [](auto& s) -> auto& { return s.material.shear.stiffness; };
constexpr auto shear_c = [](auto& s) -> auto& { return s.material.shear.damping; };
constexpr auto bend = [](auto& s) -> auto& { return s.material.bend.stiffness; };
constexpr auto bend_c = [](auto& s) -> auto& { return s.material.bend.damping; };
constexpr auto mass_per_area = [](auto& s) -> auto& { return s.material.mass_per_area; };
constexpr auto particle_mass = [](auto& s) -> auto& { return s.material.particle_mass; };
constexpr auto gravity_x = [](auto& s) -> auto& { return s.forces.gravity.x; };
constexpr auto gravity_y = [](auto& s) -> auto& { return s.forces.gravity.y; };
constexpr auto gravity_z = [](auto& s) -> auto& { return s.forces.gravity.z; };
constexpr auto damping = [](auto& s) -> auto& { return s.forces.damping; };
constexpr auto wind_x = [](auto& s) -> auto& { return s.wind.value().velocity.x; };
constexpr auto wind_y = [](auto& s) -> auto& { return s.wind.value().velocity.y; };
constexpr auto wind_z = [](auto& s) -> auto& { return s.wind.value().velocity.z; };
constexpr auto air_density = [](auto& s) -> auto& { return s.wind.value().air_density; };
constexpr auto drag = [](auto& s) -> auto& { return s.wind.value().drag; };
constexpr auto skin_friction = [](auto& s) -> auto& { return s.wind.value().skin_friction; };
constexpr auto spread = [](auto& s) -> auto& { return s.wind.value().gust.spread; };
constexpr auto period = [](auto& s) -> auto& { return s.wind.value().gust.period; };
constexpr auto width = [](auto& s) -> auto& { return s.cloth.grid.size[0]; };
constexpr auto height = [](auto& s) -> auto& { return s.cloth.grid.size[1]; };
constexpr auto columns = [](auto& s) -> auto& { return s.cloth.grid.resolution[0]; };
constexpr auto rows = [](auto& s) -> auto& { return s.cloth.grid.resolution[1]; };

constexpr bool logarithmic = true, linear = false, restarts = true, whole = true;

// clang-format off
constexpr std::array table{
    Parameter{"integrator.time_step", "Step", "Time step", "s", 1e-6, 0.1, logarithmic,
        get<time_step>, set<time_step>, nullptr, false, false, automatic<time_step>, make_automatic<time_step>},
    Parameter{"integrator.tolerance", "Step", "Tolerance", "m", 1e-9, 0.01, logarithmic,
        get<tolerance>, set<tolerance>, reads_tolerance, false, false, automatic<tolerance>, make_automatic<tolerance>},
    Parameter{"integrator.iterations", "Step", "Iterations", "", 1, 1000, logarithmic,
        get<iterations>, set<iterations>, reads_iterations, false, whole, automatic<iterations>, make_automatic<iterations>},

    Parameter{"material.structural.stiffness", "Springs", "Structural stiffness", "N/m", 0, 1e5, logarithmic,
        get<structural>, set<structural>},
    Parameter{"material.structural.damping", "Springs", "Structural damping", "N s/m", 0, 100, logarithmic,
        get<structural_c>, set<structural_c>},
    Parameter{"material.shear.stiffness", "Springs", "Shear stiffness", "N/m", 0, 1e5, logarithmic,
        get<shear>, set<shear>},
    Parameter{"material.shear.damping", "Springs", "Shear damping", "N s/m", 0, 100, logarithmic,
        get<shear_c>, set<shear_c>},
    Parameter{"material.bend.stiffness", "Springs", "Bend stiffness", "N/m", 0, 1e5, logarithmic,
        get<bend>, set<bend>},
    Parameter{"material.bend.damping", "Springs", "Bend damping", "N s/m", 0, 100, logarithmic,
        get<bend_c>, set<bend_c>},

    Parameter{"material.mass_per_area", "Mass", "Mass per area", "kg/m2", 0.005, 5, logarithmic,
        get<mass_per_area>, set<mass_per_area>, has_mass_per_area},
    Parameter{"material.particle_mass", "Mass", "Mass of a particle", "kg", 1e-6, 10, logarithmic,
        get<particle_mass>, set<particle_mass>, has_particle_mass},

    Parameter{"forces.gravity.x", "Gravity and drag", "Gravity x", "m/s2", -20, 20, linear, get<gravity_x>, set<gravity_x>},
    Parameter{"forces.gravity.y", "Gravity and drag", "Gravity y", "m/s2", -20, 20, linear, get<gravity_y>, set<gravity_y>},
    Parameter{"forces.gravity.z", "Gravity and drag", "Gravity z", "m/s2", -20, 20, linear, get<gravity_z>, set<gravity_z>},
    Parameter{"forces.damping", "Gravity and drag", "Drag of a particle", "kg/s", 0, 1, logarithmic, get<damping>, set<damping>},

    Parameter{"wind.velocity.x", "Wind", "Wind x", "m/s", -20, 20, linear, get<wind_x>, set<wind_x>, has_wind},
    Parameter{"wind.velocity.y", "Wind", "Wind y", "m/s", -20, 20, linear, get<wind_y>, set<wind_y>, has_wind},
    Parameter{"wind.velocity.z", "Wind", "Wind z", "m/s", -20, 20, linear, get<wind_z>, set<wind_z>, has_wind},
    Parameter{"wind.air_density", "Wind", "Air density", "kg/m3", 0, 5, linear,
        get<air_density>, set<air_density>, has_wind},
    Parameter{"wind.drag", "Wind", "Drag", "", 0, 4, linear, get<drag>, set<drag>, has_wind},
    Parameter{"wind.skin_friction", "Wind", "Skin friction", "", 0, 0.2, linear,
        get<skin_friction>, set<skin_friction>, has_wind},
    Parameter{"wind.gust.spread", "Gusts", "Spread", "", 0, 0.99, linear, get<spread>, set<spread>, has_gust},
    Parameter{"wind.gust.period", "Gusts", "Period", "s", 0.01, 10, logarithmic, get<period>, set<period>, has_gust},

    Parameter{"cloth.size.x", "Cloth", "Width", "m", 0.05, 50, logarithmic, get<width>, set_size<0>, has_grid, restarts},
    Parameter{"cloth.size.y", "Cloth", "Height", "m", 0.05, 50, logarithmic, get<height>, set_size<1>, has_grid, restarts},
    Parameter{"cloth.resolution.x", "Cloth", "Columns", "", 2, 256, linear,
        get<columns>, set_resolution<0>, has_grid, restarts, whole},
    Parameter{"cloth.resolution.y", "Cloth", "Rows", "", 2, 256, linear,
        get<rows>, set_resolution<1>, has_grid, restarts, whole},
};
// clang-format on

}  // namespace

std::span<const Parameter> parameters() {
    return table;
}

const Parameter* find_parameter(std::string_view key) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Parameter& row) { return row.key == key; });
    return found == table.end() ? nullptr : &*found;
}

std::string unit_of(const Parameter& parameter, const SceneDescription& scene) {
    std::string unit(parameter.unit);
    if (parameter.section != "Springs") return unit;
    return unit + (scene.material.stiffness_per == StiffnessPer::width ? " of width" : " a spring");
}

ParameterChange with_parameter(const SceneDescription& scene, const Parameter& parameter,
                               double value) {
    ParameterChange change{scene, {}};
    parameter.set(change.scene, value);
    try {
        check_scene(change.scene);
    } catch (const Error& error) {
        change.refusal = error.what();
    }
    return change;
}

}  // namespace weft::viewer
