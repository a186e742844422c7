// Looking things up in the table of scene keys, and printing it.
#include "io/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "math/nearest_name.h"

namespace weft {

namespace {

std::string_view name_of(const std::monostate&) {
    return "integer";
}
std::string_view name_of(SceneAccess<bool>) {
    return "boolean";
}
std::string_view name_of(SceneAccess<double>) {
    return "number";
}
std::string_view name_of(SceneAccess<std::uint64_t>) {
    return "integer";
}
std::string_view name_of(SceneAccess<Vec3d>) {
    return "three numbers";
}
std::string_view name_of(SceneAccess<std::array<double, 2>>) {
    return "two numbers";
}
std::string_view name_of(SceneAccess<std::array<int, 2>>) {
    return "two integers";
}
std::string_view name_of(SceneAccess<std::optional<double>>) {
    return "number";
}
std::string_view name_of(SceneAccess<std::optional<int>>) {
    return "integer";
}
std::string_view name_of(SceneAccess<std::optional<Vec3d>>) {
    return "three numbers";
}
std::string_view name_of(SceneAccess<std::vector<std::string>>) {
    return "list of strings";
}
std::string_view name_of(SceneAccess<PinSelector>) {
    return "string or table";
}
std::string_view name_of(SceneAccess<std::vector<PinKeyframe>>) {
    return "list of tables";
}
/// Text, and the enumerations, which are words.
template <typename Word>
std::string_view name_of(SceneAccess<Word>) {
    return "string";
}

/// "wind.gust" of "wind.gust.spread"; empty for a key of the whole file.
std::string_view section_of(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : key.substr(0, dot);
}

std::string_view last_name(std::string_view key) {
    return key.substr(section_of(key).empty() ? 0 : section_of(key).size() + 1);
}

/// Table of the reference that a key stands in: its first name, with the brackets of a list.
std::string_view heading_of(std::string_view key) {
    if (section_of(key).empty()) return {};
    return key.substr(0, key.find('.'));
}

std::string title_of(std::string_view heading) {
    if (heading.empty()) return "The file itself";
    if (!heading.ends_with("[]")) return fmt::format("`[{}]`", heading);
    return fmt::format("`[[{}]]`", heading.substr(0, heading.size() - 2));
}

/// Every key, and every section that has keys.
std::vector<std::string_view> keys_and_sections() {
    std::vector<std::string_view> names;
    for (const SceneKey& row : scene_keys()) {
        names.push_back(row.key);
        for (std::string_view section = section_of(row.key); !section.empty();
             section = section_of(section)) {
            if (section.ends_with("[]")) section.remove_suffix(2);
            if (std::find(names.begin(), names.end(), section) == names.end()) {
                names.push_back(section);
            }
        }
    }
    return names;
}

}  // namespace

const SceneKey* find_scene_key(std::string_view key) {
    for (const SceneKey& row : scene_keys()) {
        if (row.key == key) return &row;
    }
    return nullptr;
}

const SceneList* list_of_scene_key(std::string_view key) {
    const std::size_t end = key.find("[]");
    if (end == std::string_view::npos) return nullptr;
    for (const SceneList& list : scene_lists()) {
        if (list.name == key.substr(0, end)) return &list;
    }
    return nullptr;
}

std::vector<std::string_view> names_in_section(std::string_view section) {
    std::vector<std::string_view> names;
    for (const SceneKey& row : scene_keys()) {
        std::string_view rest = row.key;
        if (!section.empty()) {
            if (!rest.starts_with(section)) continue;
            rest.remove_prefix(section.size());
            if (!rest.starts_with('.')) continue;
            rest.remove_prefix(1);
        }
        const std::string_view name = rest.substr(0, rest.find_first_of(".["));
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::string nearest_scene_key(std::string_view section, std::string_view name) {
    const std::vector<std::string_view> keys = keys_and_sections();
    std::vector<std::string_view> last_names;
    for (const std::string_view key : keys) last_names.push_back(last_name(key));
    const auto key_called = [&](std::string_view wanted) {
        const auto found = std::find(last_names.begin(), last_names.end(), wanted);
        const std::size_t index = static_cast<std::size_t>(found - last_names.begin());
        return found == last_names.end() ? std::string{} : std::string(keys[index]);
    };
    // The right key in the wrong section is likelier than any misspelling.
    if (std::string elsewhere = key_called(name); !elsewhere.empty()) return elsewhere;
    const std::string_view here = nearest_name(name, names_in_section(section));
    if (!here.empty())
        return section.empty() ? std::string(here) : fmt::format("{}.{}", section, here);
    const std::string_view anywhere = nearest_name(name, last_names);
    return anywhere.empty() ? std::string{} : key_called(anywhere);
}

std::string_view type_name(const SceneKey& key) {
    return std::visit([](const auto& access) { return name_of(access); }, key.field);
}

std::string scene_keys_markdown() {
    std::string text;
    std::string_view heading = "-";
    for (const SceneKey& row : scene_keys()) {
        if (heading_of(row.key) != heading) {
            heading = heading_of(row.key);
            text += fmt::format("\n### {}\n\n", title_of(heading));
            text += "| key | type | unit | default | allowed | meaning |\n";
            text += "|---|---|---|---|---|---|\n";
        }
        const std::string_view name =
            heading.empty() ? row.key : row.key.substr(row.key.find('.') + 1);
        const std::string fallback =
            row.fallback.empty() ? "none" : fmt::format("`{}`", row.fallback);
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", name, type_name(row), row.unit,
                            fallback, row.allowed, row.meaning);
    }
    return text.substr(1);
}

}  // namespace weft
