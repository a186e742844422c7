#include "io/scene_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "math/quoting.h"

namespace weft {

namespace {

/// One step into the tree: a name of a table, or an index of an array.
struct KeyStep {
    std::string name;  ///< empty: an index
    std::size_t index = 0;
};

/// "pins[1].select" -> pins, 1, select; nothing where this is no dotted key.
std::optional<std::vector<KeyStep>> split_key(std::string_view key) {
    std::vector<KeyStep> steps;
    while (true) {
        const std::size_t end = std::min(key.find_first_of(".["), key.size());
        if (end == 0) return {};
        steps.push_back({std::string(key.substr(0, end)), 0});
        key.remove_prefix(end);
        while (key.starts_with('[')) {
            const std::size_t close = key.find(']');
            if (close == std::string_view::npos) return {};
            std::size_t index = 0;
            const char* last = key.data() + close;
            const auto [stop, error] = std::from_chars(key.data() + 1, last, index);
            if (error != std::errc{} || stop != last) return {};
            steps.push_back({{}, index});
            key.remove_prefix(close + 1);
        }
        if (key.empty()) return steps;
        if (!key.starts_with('.')) return {};
        key.remove_prefix(1);
    }
}

/// The value one step further in; null where there is none.
const TomlValue* step_into(const TomlValue& value, const KeyStep& step) {
    if (!step.name.empty()) return value.find(step.name);
    const auto* array = value.array();
    return array && step.index < array->size() ? &(*array)[step.index] : nullptr;
}

/// Puts `value` at `steps` into the tree, making the tables on the way.
/// @return false: an index has no value in the tree.
bool put(TomlValue& root, const std::vector<KeyStep>& steps, TomlValue value) {
    TomlValue* node = &root;
    const TomlPlace place = value.place;
    for (const KeyStep& step : steps) {
        if (step.name.empty()) {
            node = const_cast<TomlValue*>(step_into(*node, step));
            if (!node) return false;
            continue;
        }
        // A word where a table may stand as well, as in gust = "none", makes room for the table.
        if (!node->table()) *node = {TomlValue::Table{}, place};
        if (!node->find(step.name)) {
            node->table()->push_back({step.name, place, {TomlValue::Table{}, place}});
        }
        node = node->find(step.name);
    }
    *node = std::move(value);
    return true;
}

void remove(TomlValue* table, std::string_view key) {
    std::erase_if(*table->table(), [&](const auto& member) { return member.key == key; });
}

/// Of two keys of one table that cannot stand together, drops `key` where `other` overrides it.
void drop_overridden(TomlValue* section, std::string_view key, std::string_view other) {
    if (!section || !section->table()) return;
    const TomlValue* value = section->find(key);
    const TomlValue* rival = section->find(other);
    if (value && rival && rival->place.source > value->place.source) remove(section, key);
}

/// Drops everything that an override has taken the place of.
void drop_overridden(TomlValue& root) {
    drop_overridden(root.find("material"), "mass_per_area", "particle_mass");
    drop_overridden(root.find("material"), "particle_mass", "mass_per_area");
    for (const std::string_view grid_key : {"size", "resolution", "plane", "origin"}) {
        drop_overridden(root.find("cloth"), grid_key, "mesh");
    }
    TomlValue* obstacles = root.find("obstacles");
    if (!obstacles || !obstacles->array()) return;
    for (TomlValue& obstacle : *obstacles->array()) {
        drop_overridden(&obstacle, "sphere", "plane");
        drop_overridden(&obstacle, "plane", "sphere");
    }
}

[[noreturn]] void refuse_override(const SceneDocument& document, const std::string& key,
                                  const std::string& message) {
    throw Error(ErrorKind::usage,
                {.file = document.overrides.back(), .line = 0, .column = 0, .key = key}, message);
}

void apply_override(SceneDocument& document, const SceneOverride& override_text) {
    const auto& [key, text] = override_text;
    document.overrides.push_back(one_line(fmt::format("--set {}={}", key, text)));
    const auto steps = split_key(key);
    if (!steps) {
        refuse_override(document, one_line(key),
                        "not a key; write it as in integrator.method or pins[0].select");
    }
    const int source = static_cast<int>(document.overrides.size());
    if (!put(document.root, *steps, parse_toml_value(text, source))) {
        refuse_override(document, one_line(key), "the scene file has no value of this index");
    }
    drop_overridden(document.root);
}

void check_version(const SceneDocument& document) {
    const TomlValue* version = document.root.find("version");
    if (!version) {
        throw Error(ErrorKind::usage, document.error_place({}, "version"),
                    "not given; a scene file begins with version = 1");
    }
    const auto* number = std::get_if<std::int64_t>(&version->data);
    if (number && *number == 1) return;
    throw Error(ErrorKind::usage, document.error_place(version->place, "version"),
                fmt::format("{} is not allowed: 1, the only version so far", toml_text(*version)));
}

}  // namespace

TomlPlace SceneDocument::locate(std::string_view key) const {
    const TomlValue* value = &root;
    TomlPlace place;
    const auto steps = split_key(key);
    if (!steps) return place;
    for (const KeyStep& step : *steps) {
        value = step_into(*value, step);
        if (!value) break;
        place = value->place;
    }
    return place;
}

ErrorPlace SceneDocument::error_place(TomlPlace place, const std::string& key) const {
    if (place.source == 0) {
        return {.file = file, .line = place.line, .column = place.column, .key = key};
    }
    const auto index = static_cast<std::size_t>(place.source - 1);
    return {.file = overrides.at(index), .line = 0, .column = 0, .key = key};
}

SceneDocument read_scene_document(std::string_view text, const std::string& file,
                                  std::span<const SceneOverride> overrides) {
    SceneDocument document;
    document.file = file;
    document.root = parse_toml(text, file);
    document.has_cloth = document.root.find("cloth") != nullptr;
    check_version(document);
    for (const SceneOverride& override_text : overrides) apply_override(document, override_text);
    check_version(document);
    return document;
}

}  // namespace weft
