#include "io/scene_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "math/nearest_name.h"
#include "simulation/scene_words.h"
#include "weft/error.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

// Reading: each function gives nothing where the value has another type or shape.

void assign(const TomlValue& value, std::optional<bool>& out) {
    if (const bool* boolean = std::get_if<bool>(&value.data)) out = *boolean;
}

void assign(const TomlValue& value, std::optional<double>& out) {
    if (const double* number = std::get_if<double>(&value.data)) out = *number;
    if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
        out = static_cast<double>(*integer);
    }
}

void assign(const TomlValue& value, std::optional<int>& out) {
    const auto* integer = std::get_if<std::int64_t>(&value.data);
    if (integer && std::in_range<int>(*integer)) out = static_cast<int>(*integer);
}

void assign(const TomlValue& value, std::optional<std::uint64_t>& out) {
    const auto* integer = std::get_if<std::int64_t>(&value.data);
    if (integer && *integer >= 0) out = static_cast<std::uint64_t>(*integer);
}

void assign(const TomlValue& value, std::optional<std::string>& out) {
    if (const std::string* string = value.string()) out = *string;
}

template <typename Enum>
    requires std::is_enum_v<Enum>
void assign(const TomlValue& value, std::optional<Enum>& out) {
    const std::string* word = value.string();
    if (!word) return;
    const auto& words = scene_words<Enum>;
    const auto found = std::find(words.begin(), words.end(), *word);
    if (found != words.end()) out = static_cast<Enum>(found - words.begin());
}

void assign(const TomlValue& value, std::optional<Vec3d>& out);
void assign(const TomlValue& value, std::optional<PinKeyframe>& out);

template <typename Item>
void assign(const TomlValue& value, std::optional<std::vector<Item>>& out) {
    const auto* array = value.array();
    if (!array) return;
    std::vector<Item> items;
    for (const TomlValue& item_value : *array) {
        std::optional<Item> item;
        assign(item_value, item);
        if (!item) return;
        items.push_back(std::move(*item));
    }
    out = std::move(items);
}

template <typename Number>
void assign(const TomlValue& value, std::optional<std::array<Number, 2>>& out) {
    std::optional<std::vector<Number>> numbers;
    assign(value, numbers);
    if (numbers && numbers->size() == 2) out = {(*numbers)[0], (*numbers)[1]};
}

void assign(const TomlValue& value, std::optional<Vec3d>& out) {
    std::optional<std::vector<double>> numbers;
    assign(value, numbers);
    if (numbers && numbers->size() == 3) out = Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

/// A value that is not given is not read, so "not given" is what "auto" leaves; see
/// read_scene_value.
template <typename Value>
void assign(const TomlValue& value, std::optional<std::optional<Value>>& out) {
    std::optional<Value> inner;
    assign(value, inner);
    if (inner) out = inner;
}

void assign(const TomlValue& value, std::optional<PinKeyframe>& out) {
    const TomlValue* time = value.find("time");
    const TomlValue* offset = value.find("offset");
    if (!time || !offset || value.table()->size() != 2) return;
    std::optional<double> seconds;
    std::optional<Vec3d> metres;
    assign(*time, seconds);
    assign(*offset, metres);
    if (seconds && metres) out = PinKeyframe{*seconds, *metres};
}

std::optional<PinSelector> selection_table(const TomlValue& value) {
    const std::size_t names = value.table()->size();
    if (const TomlValue* particles = value.find("particles"); particles && names == 1) {
        std::optional<std::vector<std::uint64_t>> numbers;
        assign(*particles, numbers);
        if (!numbers) return {};
        return ParticleSelection{{numbers->begin(), numbers->end()}};
    }
    if (const TomlValue* box = value.find("box"); box && names == 1) {
        std::optional<std::vector<Vec3d>> corners;
        assign(*box, corners);
        if (!corners || corners->size() != 2) return {};
        return BoxSelection{(*corners)[0], (*corners)[1]};
    }
    const TomlValue* every = value.find("every");
    const TomlValue* of = value.find("of");
    if (!every || !of || names != 2) return {};
    std::optional<std::uint64_t> count;
    std::optional<EdgeSelection> edge;
    assign(*every, count);
    assign(*of, edge);
    if (!count || !edge) return {};
    return EverySelection{*count, *edge};
}

void assign(const TomlValue& value, std::optional<PinSelector>& out) {
    if (value.table()) {
        out = selection_table(value);
        return;
    }
    std::optional<EdgeSelection> edge;
    assign(value, edge);
    if (edge) out = *edge;
}

/// The words among which a misspelt one may be meant.
template <typename Value>
std::span<const std::string_view> known_words() {
    if constexpr (std::is_enum_v<Value>) return scene_words<Value>;
    if constexpr (std::is_same_v<Value, PinSelector>) return scene_words<EdgeSelection>;
    return {};
}

// Writing.

Json to_json(bool value) {
    return value;
}
Json to_json(double value) {
    return value;
}
Json to_json(int value) {
    return value;
}
Json to_json(std::uint64_t value) {
    return value;
}
Json to_json(const std::string& value) {
    return value;
}
Json to_json(Vec3d value) {
    return {value.x, value.y, value.z};
}
Json to_json(const std::vector<std::string>& value) {
    return value;
}
template <typename Number>
Json to_json(const std::array<Number, 2>& value) {
    return value;
}
template <typename Enum>
    requires std::is_enum_v<Enum>
Json to_json(Enum value) {
    return std::string(scene_word(value));
}
template <typename Value>
Json to_json(const std::optional<Value>& value) {
    return value ? to_json(*value) : Json("auto");
}

struct SelectorJson {
    Json operator()(EdgeSelection edge) const { return to_json(edge); }
    Json operator()(const ParticleSelection& selection) const {
        return {{"particles", selection.particles}};
    }
    Json operator()(const EverySelection& selection) const {
        return {{"every", selection.every}, {"of", to_json(selection.of)}};
    }
    Json operator()(const BoxSelection& box) const {
        return {{"box", Json::array({to_json(box.low), to_json(box.high)})}};
    }
};

Json to_json(const PinSelector& selector) {
    return std::visit(SelectorJson{}, selector);
}

Json to_json(const std::vector<PinKeyframe>& motion) {
    Json list = Json::array();
    for (const PinKeyframe& keyframe : motion) {
        list.push_back({{"time", keyframe.time}, {"offset", to_json(keyframe.offset)}});
    }
    return list;
}

}  // namespace

void read_scene_value(const SceneKey& key, const std::string& path, const TomlValue& value,
                      SceneDescription& scene, std::size_t index) {
    const auto read = [&]<typename Value>(SceneAccess<Value> access) {
        Value& target = access(scene, index);
        // A word of its own is read as such; elsewhere "auto" is what is there when nothing is
        // given.
        constexpr bool is_word = std::is_same_v<Value, std::string> || std::is_enum_v<Value>;
        if (!is_word && key.fallback == "\"auto\"" && value.string() && *value.string() == "auto") {
            target = Value{};
            return;
        }
        std::optional<Value> result;
        assign(value, result);
        if (result) {
            target = std::move(*result);
            return;
        }
        const std::string hint =
            value.string() ? did_you_mean(*value.string(), known_words<Value>()) : std::string{};
        throw scene_error(path, toml_text(value), std::string(key.allowed) + hint);
    };
    std::visit(
        [&](const auto& access) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(access)>, std::monostate>) {
                read(access);
            }
        },
        key.field);
}

Json scene_value_json(const SceneKey& key, SceneDescription& scene, std::size_t index) {
    return std::visit(
        [&](const auto& access) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(access)>, std::monostate>) {
                return 1;
            } else {
                return to_json(access(scene, index));
            }
        },
        key.field);
}

}  // namespace weft
