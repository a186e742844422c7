// Scene files are written from the JSON of a scene, which has its shape and only what counts in it.
#include "io/scene_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/scene_json.h"
#include "io/scene_keys.h"
#include "io/toml_value.h"
#include "math/quoting.h"
#include "weft/error.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t comment_column = 34;  // that of the shipped scenes
constexpr std::size_t longest_line = 100;   // of lists of particles

/// The shortest number that reads back to the same bits, with a point, as TOML tells 1 from 1.0.
std::string number_text(double number) {
    const std::string text = fmt::format("{}", number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string string_text(const std::string& key, const std::string& text) {
    const std::string quoted = in_quotes(text);
    const TomlValue read = parse_toml_value(quoted, 1);
    if (read.string() && *read.string() == text) return quoted;
    throw scene_error(key, one_line(quoted), "in a scene file, text in UTF-8");
}

std::string integer_text(const std::string& key, std::uint64_t integer) {
    constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (integer <= largest) return fmt::format("{}", integer);
    throw scene_error(key, fmt::format("{}", integer),
                      fmt::format("in a scene file, at most {}", largest));
}

/// @param key dotted, for errors.
std::string value_text(const std::string& key, const Json& value) {
    if (value.is_string()) return string_text(key, value.get<std::string>());
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    if (value.is_number_float()) return number_text(value.get<double>());
    if (value.is_number_unsigned()) return integer_text(key, value.get<std::uint64_t>());
    if (value.is_number()) return fmt::format("{}", value.get<std::int64_t>());
    std::vector<std::string> parts;
    for (const auto& [name, part] : value.items()) {
        if (value.is_array()) {
            parts.push_back(value_text(key, part));
        } else {
            parts.push_back(fmt::format("{} = {}", name, value_text(key + "." + name, part)));
        }
    }
    const std::string list = fmt::format("{}", fmt::join(parts, ", "));
    return value.is_array() ? "[" + list + "]" : "{ " + list + " }";
}

/// "[s], [m]" of "s, m".
std::string bracketed(std::string_view units) {
    std::string text = "[";
    for (const char letter : units) {
        if (letter == ',') text += ']';
        text += letter;
        if (letter == ' ' && text.ends_with(", ")) text += '[';
    }
    return text + "]";
}

/// What is said behind a value: its unit, or those of the parts of an inline table.
std::string comment_of(const std::string& key, const Json& value) {
    const auto unit_of = [](const std::string& name) {
        const SceneKey* row = find_scene_key(name);
        return row && !row->unit.empty() ? bracketed(row->unit) : std::string{};
    };
    if (!value.is_object()) return value.is_string() ? std::string{} : unit_of(key);
    std::vector<std::string> named, units;
    for (const auto& [name, part] : value.items()) {
        const std::string unit = unit_of(key + "." + name);
        if (unit.empty()) continue;
        units.push_back(unit);
        named.push_back(name + " " + unit);
    }
    const bool all_the_same =
        units.size() == value.size() && std::count(units.begin(), units.end(), units[0]) ==
                                            static_cast<std::ptrdiff_t>(units.size());
    return all_the_same ? units[0] : fmt::format("{}", fmt::join(named, ", "));
}

void append_line(std::string& text, std::string line, const std::string& comment) {
    if (!comment.empty()) {
        line.resize(std::max(line.size() + 2, comment_column), ' ');
        line += "# " + comment;
    }
    text += line + '\n';
}

/// A line with a long list of particles, broken between two of them.
std::string folded(std::string line) {
    const std::string indent = "    ";
    std::string text;
    while (line.size() > longest_line) {
        const std::size_t comma = line.rfind(", ", longest_line - 1);
        if (comma == std::string::npos) break;
        text += line.substr(0, comma + 1) + "\n";
        line = indent + line.substr(comma + 2);
    }
    return text + line;
}

/// @param key dotted, with "[]" for an index.
void append_entry(std::string& text, const std::string& key, const std::string& name,
                  const Json& value) {
    const std::string comment = comment_of(key, value);
    if (key == "pins[].motion") {
        if (value.empty()) return;
        append_line(text, name + " = [", comment);
        for (const Json& keyframe : value) text += "    " + value_text(key, keyframe) + ",\n";
        text += "]\n";
        return;
    }
    const std::string line = fmt::format("{} = {}", name, value_text(key, value));
    append_line(text, value.contains("particles") ? folded(line) : line, comment);
}

void append_section(std::string& text, const std::string& header, const std::string& key,
                    const Json& section) {
    text += "\n" + header + "\n";
    for (const auto& [name, value] : section.items()) {
        append_entry(text, key + "." + name, name, value);
    }
}

}  // namespace

std::string scene_to_toml(const SceneDescription& scene) {
    std::string text = "# Saved by weft: every key that counts in this scene, with its value.\n\n";
    const Json json = scene_to_json(scene);
    for (const auto& [name, value] : json.items()) {
        if (value.is_object()) {
            append_section(text, fmt::format("[{}]", name), name, value);
        } else if (value.is_array()) {
            for (const Json& element : value) {
                append_section(text, fmt::format("[[{}]]", name), name + "[]", element);
            }
        } else {
            append_entry(text, name, name, value);
        }
    }
    return text;
}

}  // namespace weft
