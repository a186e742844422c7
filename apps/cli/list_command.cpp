#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "io/scene_keys.h"
#include "lab/experiment.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/recorder.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

std::string_view kind_name(IntegratorKind kind) {
    switch (kind) {
        case IntegratorKind::explicit_steps:
            return "explicit";
        case IntegratorKind::adaptive:
            return "adaptive";
        case IntegratorKind::implicit:
            return "implicit";
        case IntegratorKind::by_springs:
            break;
    }
    return "by springs";
}

std::string auto_step_text(const IntegratorInfo& info) {
    if (info.auto_step > 0.0) return fmt::format("1/{:.0f}", 1.0 / info.auto_step);
    return info.kind == IntegratorKind::adaptive ? "error" : "stable";
}

void list_integrators(bool json) {
    Json rows = Json::array();
    if (!json) {
        fmt::print("{:<22} {:>5} {:>6} {:>5} {:>10} {:>8} {:>8}  {}\n", "name", "order", "damped",
                   "evals", "symplectic", "limit", "auto", "update");
    }
    for (const IntegratorInfo& info : integrator_catalogue()) {
        rows.push_back(
            {{"name", info.name},
             {"order", info.order},
             {"damped_order", info.damped_order},
             {"evaluations", info.evaluations},
             {"symplectic", info.symplectic},
             {"imaginary_limit",
              std::isinf(info.imaginary_limit) ? Json("any") : Json(info.imaginary_limit)},
             {"kind", kind_name(info.kind)},
             {"auto_step", info.auto_step > 0.0 ? Json(info.auto_step) : Json(nullptr)},
             {"formula", info.formula},
             {"reference", info.reference}});
        if (json) continue;
        const std::string limit =
            std::isinf(info.imaginary_limit) ? "any" : fmt::format("{:.4g}", info.imaginary_limit);
        fmt::print("{:<22} {:>5} {:>6} {:>5} {:>10} {:>8} {:>8}  {}\n", info.name, info.order,
                   info.damped_order,
                   info.evaluations > 0 ? fmt::format("{}", info.evaluations) : "-",
                   info.symplectic ? "yes" : "no", limit, auto_step_text(info), info.formula);
        fmt::print("{:71}{}\n", "", info.reference);
    }
    if (json) {
        fmt::print("{}\n", Json{{"integrators", rows}}.dump(2));
    } else {
        fmt::print(
            "order: of the global error; damped: the same where forces depend on velocity;\n"
            "evals: force evaluations a step, -: as many as it takes; limit: stable up to dt * "
            "omega, undamped;\nauto: the step [s] that time_step = \"auto\" takes, by stability, "
            "by "
            "error, or for accuracy.\nmethod = \"auto\" takes velocity-verlet, or tr-bdf2 where "
            "that "
            "costs less.\n");
    }
}

void list_fabrics(bool json) {
    Json rows = Json::array();
    if (!json) {
        fmt::print("{:<10} {:>9} {:>11} {:>9} {:>9}  {}\n", "name", "kg/m2", "structural", "shear",
                   "bend", "");
    }
    for (const FabricInfo& fabric : fabric_catalogue()) {
        const auto spring = [](const SpringMaterial& material) {
            return Json{{"stiffness", material.stiffness}, {"damping", material.damping}};
        };
        rows.push_back({{"name", fabric.name},
                        {"description", fabric.description},
                        {"mass_per_area", fabric.mass_per_area},
                        {"stiffness_per", "width"},
                        {"structural", spring(fabric.structural)},
                        {"shear", spring(fabric.shear)},
                        {"bend", spring(fabric.bend)}});
        if (json) continue;
        fmt::print("{:<10} {:>9.4g} {:>11.4g} {:>9.4g} {:>9.4g}  {}\n", fabric.name,
                   fabric.mass_per_area, fabric.structural.stiffness, fabric.shear.stiffness,
                   fabric.bend.stiffness, fabric.description);
    }
    if (json) {
        fmt::print("{}\n", Json{{"fabrics", rows}}.dump(2));
    } else {
        fmt::print("stiffness per width [N/m]\n");
    }
}

void list_scenes(bool json) {
    Json rows = Json::array();
    for (const ShippedScene& scene : shipped_scenes()) {
        rows.push_back(
            {{"name", scene.name}, {"title", scene.title}, {"path", scene.path.string()}});
        if (!json) fmt::print("{:<12} {:<44} {}\n", scene.name, scene.title, scene.path.string());
    }
    if (json) fmt::print("{}\n", Json{{"scenes", rows}}.dump(2));
}

void list_formats(bool json) {
    Json rows = Json::array();
    for (const FormatInfo& format : format_catalogue()) {
        rows.push_back(
            {{"name", format.name}, {"files", format.files}, {"description", format.description}});
        if (!json) {
            fmt::print("{:<6} {}\n       writes {}\n", format.name, format.description,
                       format.files);
        }
    }
    if (json) fmt::print("{}\n", Json{{"formats", rows}}.dump(2));
}

void list_experiments(bool json) {
    Json rows = Json::array();
    for (const lab::Experiment& experiment : lab::experiment_catalogue()) {
        rows.push_back({{"name", experiment.name},
                        {"title", experiment.title},
                        {"question", experiment.question}});
        if (!json) fmt::print("{:<16} {}\n", experiment.name, experiment.question);
    }
    if (json) fmt::print("{}\n", Json{{"experiments", rows}}.dump(2));
}

void list_keys(bool json) {
    Json rows = Json::array();
    for (const SceneKey& key : scene_keys()) {
        rows.push_back({{"key", key.key},
                        {"type", type_name(key)},
                        {"unit", key.unit},
                        {"default", key.fallback},
                        {"allowed", key.allowed},
                        {"meaning", key.meaning}});
    }
    if (json) {
        fmt::print("{}\n", Json{{"keys", rows}}.dump(2));
    } else {
        fmt::print("{}", scene_keys_markdown());
    }
}

struct List {
    std::string_view name;
    void (*print)(bool json);
};
constexpr std::array<List, 6> lists{{{"integrators", list_integrators},
                                     {"fabrics", list_fabrics},
                                     {"scenes", list_scenes},
                                     {"formats", list_formats},
                                     {"experiments", list_experiments},
                                     {"keys", list_keys}}};

}  // namespace

int list_command(const std::string& what, bool json) {
    for (const List& list : lists) {
        if (list.name != what) continue;
        list.print(json);
        return exit_done;
    }
    throw Error(
        ErrorKind::usage, {},
        fmt::format(
            "\"{}\" cannot be listed: integrators, fabrics, scenes, formats, experiments or keys "
            "can",
            what));
}

}  // namespace weft
