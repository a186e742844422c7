#include "viewer/change_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "io/scene_keys.h"
#include "viewer/compare_section.h"
#include "viewer/method_menu.h"
#include "viewer/obstacle_section.h"
#include "viewer/scene_edits.h"
#include "weft/integrators.h"

namespace weft::viewer {

namespace {

// Sections that one most likely wants; the others are folded at first.
bool open_at_first(std::string_view name) {
    return name == "Springs" || name == "Wind";
}

bool applies_to(const SceneDescription& scene, const Parameter& parameter) {
    return parameter.applies == nullptr || parameter.applies(scene);
}

bool is_automatic(const SceneDescription& scene, const Parameter& parameter) {
    return parameter.automatic != nullptr && parameter.automatic(scene);
}

double frame_length(const SceneDescription& scene) {
    return 1.0 / scene.output.frames_per_second;
}

// What the reference of scene files says of a key; that of a vector for its components.
std::string meaning_of(const Parameter& parameter) {
    std::string_view key = parameter.key;
    const SceneKey* row = find_scene_key(key);
    if (row == nullptr) row = find_scene_key(key.substr(0, key.rfind('.')));
    if (row == nullptr) return std::string(key);
    return fmt::format("{}\n{}", row->key, row->meaning);
}

std::string tooltip_of(const Parameter& parameter, const SceneDescription& opened) {
    std::string text = meaning_of(parameter);
    if (applies_to(opened, parameter)) {
        text += fmt::format("\nRight click: back to {}",
                            is_automatic(opened, parameter)
                                ? "auto"
                                : with_unit(parameter.get(opened), unit_of(parameter, opened)));
    }
    return text + "\nDouble click: type a number";
}

bool same_value(const Parameter& parameter, const SceneDescription& a, const SceneDescription& b) {
    const bool in_a = applies_to(a, parameter), in_b = applies_to(b, parameter);
    if (!in_a || !in_b) return in_a == in_b;
    return is_automatic(a, parameter) == is_automatic(b, parameter) &&
           parameter.get(a) == parameter.get(b);
}

// What comes of the step: a whole number of them makes a frame.
void stable_step_line(const LaneView& lane, const SceneDescription& scene) {
    const double frame = frame_length(scene), set = scene.integrator.time_step.value_or(0.0);
    if (lane.stable_step <= 0.0) {
        coloured_text(colours::trouble, "No step of this method is stable here.");
    } else if (lane.time_step > lane.stable_step) {
        coloured_text(
            colours::trouble,
            fmt::format("Beyond the stable {:.4g} s: expect it to blow up.", lane.stable_step));
    } else if (set > frame) {
        coloured_text(colours::faint,
                      fmt::format("A frame is {:.4g} s: steps are no longer.", frame));
    } else if (set > lane.stable_step) {
        coloured_text(colours::faint, fmt::format("A frame is {} steps of {:.4g} s, and stable.",
                                                  lane.steps_per_frame, lane.time_step));
    } else if (!std::isfinite(lane.stable_step)) {
        coloured_text(colours::faint, "No step is too long to be stable.");
    } else {
        coloured_text(colours::faint, fmt::format("Stable up to {:.4g} s.", lane.stable_step));
    }
}

// Above the rows of a section: what is chosen rather than a number.
void choices_of(std::string_view name, Workbench& bench) {
    const SceneDescription& scene = bench.scene();
    if (name == "Springs") {
        ImGui::SetNextItemWidth(-FLT_MIN);
        const std::string preview = "Fabric: " + scene.material.fabric;
        if (ImGui::BeginCombo("##fabric", preview.c_str())) {
            for (const FabricInfo& fabric : fabric_catalogue()) {
                const std::string row(fabric.name);
                if (ImGui::Selectable(row.c_str(), row == scene.material.fabric)) {
                    bench.edit(with_fabric(scene, fabric.name), "fabric");
                    bench.end_gesture();
                }
                tooltip_of_last(std::string(fabric.description));
            }
            ImGui::EndCombo();
        }
        show_refusal(bench, "fabric");
    } else if (name == "Wind") {
        bool wind = scene.wind.has_value();
        if (ImGui::Checkbox("Air", &wind)) {
            bench.edit(with_wind(scene, wind), "air");
            bench.end_gesture();
        }
        if (!wind) return;
        bool gusts = scene.wind->gust.model != GustModel::none;
        ImGui::SameLine(0.0F, 1.5F * em());
        if (ImGui::Checkbox("Gusts", &gusts)) {
            bench.edit(with_gusts(scene, gusts), "gusts");
            bench.end_gesture();
        }
    }
}

}  // namespace

void show_refusal(const Workbench& bench, const std::string& what) {
    if (const Refusal* refusal = bench.refusal(what))
        coloured_text(colours::trouble, refusal->text);
}

void mark_stable_step(SliderLook& look, const LaneView& lane, const SceneDescription& scene) {
    if (lane.stable_step < frame_length(scene)) look.limit = lane.stable_step;
    look.beyond = lane.time_step > lane.stable_step;
}

void see_section(WindowSettings& settings, bool recording) {
    if (!section("See", true)) return;
    const float column =
        0.5F * ImGui::GetContentRegionAvail().x + ImGui::GetStyle().WindowPadding.x;
    ImGui::Checkbox("Wireframe", &settings.wireframe);
    ImGui::SameLine(column);
    ImGui::Checkbox("Particles", &settings.particles);
    ImGui::Checkbox("Normals", &settings.normals);
    if (recording) return;  // it tells nothing of wind, pins and springs
    ImGui::SameLine(column);
    ImGui::Checkbox("Pins", &settings.pins);
    ImGui::Checkbox("Wind arrows", &settings.wind_arrows);
    constexpr std::array names{"Springs: none", "Springs by strain", "Springs by kind"};
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::Combo("##springs", &settings.springs, names.data(), static_cast<int>(names.size()));
}

void ChangePanel::draw(const Place& place, Workbench& bench, WindowSettings& settings,
                       const Act& act) {
    if (begin_panel("Change", place)) draw_scene(bench, settings, act);
    end_panel();
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) held_.clear();
}

void ChangePanel::draw_scene(Workbench& bench, WindowSettings& settings, const Act& act) {
    const EditHistory& history = bench.history();
    if (text_button("Open")) act({Action::open});
    ImGui::SameLine();
    if (text_button("Save")) act({Action::save});
    ImGui::SameLine(0.0F, 1.2F * em());
    const bool undoes = history.can_undo(), redoes = history.can_redo();
    if (icon_button(Icon::undo, "undo", undoes ? "undo " + history.undo_what() : "nothing to undo",
                    undoes)) {
        act({Action::undo});
    }
    ImGui::SameLine();
    if (icon_button(Icon::redo, "redo", redoes ? "redo " + history.redo_what() : "nothing to redo",
                    redoes)) {
        act({Action::redo});
    }
    ImGui::Spacing();
    draw_method(bench);
    compare_section(bench);
    see_section(settings, false);
    draw_parameters(bench);
    obstacle_section(bench, act);
}

void ChangePanel::draw_method(Workbench& bench) {
    if (!section("Method", true)) return;
    const LaneView& lane = bench.view().lanes.front();
    const std::string& method = bench.scene().integrator.method;
    if (const auto chosen = method_menu("##method", method, true, -FLT_MIN)) {
        bench.set_method(*chosen);
    }
    if (const IntegratorInfo* info = find_integrator(lane.method)) {
        // It would cover a refusal below.
        if (bench.refusal("method") == nullptr) tooltip_of_last(std::string(info->formula));
        const std::string summary = summary_of_method(lane.method);
        coloured_text(colours::faint,
                      method == "auto" ? fmt::format("{}: {}", lane.method, summary) : summary);
    }
    show_refusal(bench, "method");
    SceneDescription flown = bench.scene();
    flown.integrator.method = lane.method;  // what "auto" came to
    for (const Parameter& parameter : parameters()) {
        if (parameter.section != "Step") continue;
        if (!applies_to(flown, parameter)) continue;
        draw_parameter(parameter, bench);
        if (parameter.key == "integrator.time_step") stable_step_line(lane, bench.scene());
    }
}

void ChangePanel::draw_parameters(Workbench& bench) {
    std::string_view present;
    bool open = false;
    for (const Parameter& parameter : parameters()) {
        if (parameter.section == "Step") continue;
        const bool applies = applies_to(bench.scene(), parameter);
        // The air has a switch, which stays while its numbers do not apply.
        if (!applies && parameter.section != "Wind") continue;
        if (parameter.section != present) {
            present = parameter.section;
            open = section(std::string(present).c_str(), open_at_first(present));
            if (open) choices_of(present, bench);
        }
        // The choices may have changed the scene.
        if (open && applies_to(bench.scene(), parameter)) draw_parameter(parameter, bench);
    }
}

void ChangePanel::draw_parameter(const Parameter& parameter, Workbench& bench) {
    const SceneDescription& scene = bench.scene();
    const LaneView& lane = bench.view().lanes.front();
    const bool is_step = parameter.key == "integrator.time_step";
    const bool automatic = is_automatic(scene, parameter);
    double value = parameter.get(scene);
    if (const auto held = held_.find(parameter.key); held != held_.end()) value = held->second;
    // The tick beside it leaves little room, and the heading says the rest.
    SliderLook look{.label = is_step ? "Step" : std::string(parameter.label),
                    .unit = std::string(parameter.unit)};
    look.changed = !same_value(parameter, scene, bench.opened_scene());
    if (is_step) mark_stable_step(look, lane, scene);
    if (automatic) {
        look.automatic = is_step ? with_unit(lane.time_step, look.unit) : "auto";
        if (is_step) value = lane.time_step;
    }
    const std::string id(parameter.key);
    if (parameter.automatic != nullptr) {
        look.width = ImGui::GetContentRegionAvail().x - tick_width("auto");
    }
    const SliderAnswer answer = value_slider(
        id.c_str(), value, {parameter.low, parameter.high, parameter.logarithmic}, look);
    const std::string label(parameter.label);
    // It would cover a refusal below.
    if (answer.hovered && mouse_rests() && bench.refusal(label) == nullptr) {
        show_tooltip(tooltip_of(parameter, bench.opened_scene()));
    }
    take_answer(parameter, bench, answer, value);
    if (parameter.automatic != nullptr) draw_tick(parameter, bench);
    show_refusal(bench, label);
}

// The tick that leaves a number to weft. Taken away, the number is what weft had chosen, or that of
// the scene file, or the middle of the slider.
void ChangePanel::draw_tick(const Parameter& parameter, Workbench& bench) {
    bool automatic = parameter.automatic(bench.scene());
    ImGui::SameLine();
    if (!ImGui::Checkbox(("auto##" + std::string(parameter.key)).c_str(), &automatic)) return;
    SceneDescription changed = bench.scene();
    if (automatic) {
        parameter.make_automatic(changed);
    } else if (parameter.key == "integrator.time_step") {
        parameter.set(changed, bench.view().lanes.front().time_step);
    } else {
        const double opened = parameter.get(bench.opened_scene());
        parameter.set(changed, opened > 0.0 ? opened : std::sqrt(parameter.low * parameter.high));
    }
    bench.edit(changed, std::string(parameter.label));
    bench.end_gesture();
}

void ChangePanel::take_answer(const Parameter& parameter, Workbench& bench,
                              const SliderAnswer& answer, double value) {
    const SceneDescription& opened = bench.opened_scene();
    if (answer.reset && applies_to(opened, parameter)) {
        if (is_automatic(opened, parameter)) {
            SceneDescription changed = bench.scene();
            parameter.make_automatic(changed);
            bench.edit(changed, std::string(parameter.label));
        } else {
            bench.set_parameter(parameter, parameter.get(opened));
        }
        bench.end_gesture();
        return;
    }
    if (parameter.restarts && !answer.released) {
        if (answer.edited) held_[parameter.key] = parameter.whole ? std::round(value) : value;
        return;
    }
    if (answer.edited || (parameter.restarts && answer.released)) {
        bench.set_parameter(parameter, value);
    }
    if (answer.released) bench.end_gesture();
}

}  // namespace weft::viewer
