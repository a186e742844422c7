#include "viewer/window_settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <system_error>

#include "io/output_file.h"
#include "io/text_file.h"
#include "weft/error.h"
#include "weft/recorder.h"

namespace weft::viewer {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_recent = 10;
constexpr int smallest_side = 200, largest_side = 16384;  // [screen co-ordinates]

/// Reads the values of one object; a value that is missing, of another type or out of range leaves
/// its target as it is.
struct Reader {
    const Json& object;

    [[nodiscard]] const Json* value(const char* key) const {
        const auto found = object.find(key);
        return found == object.end() ? nullptr : &*found;
    }
    static std::optional<int> integer(const Json& json, int low, int high) {
        if (!json.is_number_integer()) return std::nullopt;
        const auto number = json.get<double>();  // holds any integer of JSON without wrapping
        if (number < low || number > high) return std::nullopt;
        return static_cast<int>(number);
    }
    void read(const char* key, bool& target) const {
        if (const Json* json = value(key); json && json->is_boolean()) target = json->get<bool>();
    }
    void read(const char* key, int& target, int low, int high) const {
        if (const Json* json = value(key)) target = integer(*json, low, high).value_or(target);
    }
    void read(const char* key, std::array<int, 2>& target, int low, int high) const {
        const Json* json = value(key);
        if (json == nullptr || !json->is_array() || json->size() != 2) return;
        const auto first = integer(json->at(0), low, high),
                   second = integer(json->at(1), low, high);
        if (first && second) target = {*first, *second};
    }
};

void read_format(const Reader& reader, std::string& target) {
    const Json* json = reader.value("recording_format");
    if (json == nullptr || !json->is_string()) return;
    const auto name = json->get<std::string>();
    const auto formats = format_catalogue();
    if (std::any_of(formats.begin(), formats.end(),
                    [&](const FormatInfo& format) { return format.name == name; })) {
        target = name;
    }
}

void read_recent(const Reader& reader, std::vector<std::string>& target) {
    const Json* json = reader.value("recent");
    if (json == nullptr || !json->is_array()) return;
    std::set<std::string> seen;
    for (const Json& entry : *json) {
        if (!entry.is_string() || target.size() == most_recent) continue;
        const auto path = entry.get<std::string>();
        if (!path.empty() && seen.insert(path).second) target.push_back(path);
    }
}

Json to_json(const WindowSettings& settings) {
    return {{"size", settings.size},
            {"position", settings.position},
            {"maximised", settings.maximised},
            {"panels", settings.panels},
            {"wireframe", settings.wireframe},
            {"particles", settings.particles},
            {"normals", settings.normals},
            {"wind_arrows", settings.wind_arrows},
            {"pins", settings.pins},
            {"springs", settings.springs},
            {"recording_format", settings.recording_format},
            {"recent", settings.recent}};
}

/// Empty where it cannot be read.
std::string text_of(const std::filesystem::path& path) {
    constexpr std::size_t most = 1 << 20;  // far more than the window ever writes
    try {
        return read_text_file(path.string(), most);
    } catch (const Error&) {
        return {};
    }
}

/// An environment variable that holds an absolute path, the only ones XDG counts; else empty.
std::filesystem::path directory_of(const char* variable) {
    const char* const value = std::getenv(variable);
    std::filesystem::path directory = value == nullptr ? "" : value;
    return directory.is_absolute() ? directory : std::filesystem::path{};
}

}  // namespace

std::filesystem::path window_settings_path() {
    std::filesystem::path directory = directory_of("XDG_CONFIG_HOME");
    if (directory.empty()) {
        directory = directory_of("HOME");
        if (directory.empty()) return {};
        directory /= ".config";
    }
    return directory / "weft" / "window.json";
}

WindowSettings load_window_settings(const std::filesystem::path& path) {
    WindowSettings settings;
    const Json json = Json::parse(text_of(path), nullptr, false);
    if (!json.is_object()) return settings;
    const Reader reader{json};
    reader.read("size", settings.size, smallest_side, largest_side);
    reader.read("position", settings.position, 0, largest_side);
    reader.read("maximised", settings.maximised);
    reader.read("panels", settings.panels);
    reader.read("wireframe", settings.wireframe);
    reader.read("particles", settings.particles);
    reader.read("normals", settings.normals);
    reader.read("wind_arrows", settings.wind_arrows);
    reader.read("pins", settings.pins);
    reader.read("springs", settings.springs, 0, 2);
    read_format(reader, settings.recording_format);
    read_recent(reader, settings.recent);
    return settings;
}

void save_window_settings(const WindowSettings& settings, const std::filesystem::path& path) {
    if (path.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    try {
        OutputFile file(path);
        // A path need not be UTF-8, JSON must be.
        file.write(to_json(settings).dump(4, ' ', false, Json::error_handler_t::replace) + "\n");
        file.commit();
    } catch (const Error&) {
        // No directory to write to, or a full disk: there is nobody left to tell.
    }
}

void remember(WindowSettings& settings, const std::string& opened) {
    if (opened.empty()) return;
    std::string entry = opened;
    std::error_code none;
    if (std::filesystem::exists(opened, none)) {
        const auto path = std::filesystem::absolute(opened, none);
        if (!none) entry = path.lexically_normal().string();  // so that it is found from elsewhere
    }
    std::erase(settings.recent, entry);
    settings.recent.insert(settings.recent.begin(), entry);
    if (settings.recent.size() > most_recent) settings.recent.resize(most_recent);
}

}  // namespace weft::viewer
