// The only file that includes the TOML parser, which is slow to compile.
#include "io/toml_value.h"

// Where the parser is compiled here instead of being linked, version 3.3.0 asserts that "[=" cannot
// be before it reports it as the error it is.
#define TOML_ASSERT(expr) static_assert(true)

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <sstream>
#include <tuple>
#include <type_traits>
#include <utility>

#include "math/quoting.h"
#include "weft/error.h"

namespace weft {

namespace {

TomlPlace place_of(const toml::source_region& region, int source) {
    if (source != 0) return {source, 0, 0};
    return {0, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

TomlValue converted(const toml::node& node, int source);

TomlValue::Table converted_table(const toml::table& table, int source) {
    TomlValue::Table members;
    for (const auto& [key, node] : table) {
        members.push_back(
            {std::string(key.str()), place_of(key.source(), source), converted(node, source)});
    }
    // The parser sorts keys by name; people read a file from its top.
    std::stable_sort(members.begin(), members.end(), [](const auto& a, const auto& b) {
        return std::tie(a.key_place.line, a.key_place.column) <
               std::tie(b.key_place.line, b.key_place.column);
    });
    return members;
}

TomlValue converted(const toml::node& node, int source) {
    TomlValue value{.data = false, .place = place_of(node.source(), source)};
    node.visit([&](const auto& typed) {
        using Node = std::decay_t<decltype(typed)>;
        if constexpr (std::is_same_v<Node, toml::table>) {
            value.data = converted_table(typed, source);
        } else if constexpr (std::is_same_v<Node, toml::array>) {
            TomlValue::Array items;
            items.reserve(typed.size());
            for (const toml::node& item : typed) items.push_back(converted(item, source));
            value.data = std::move(items);
        } else if constexpr (toml::is_chronological<Node>) {
            std::ostringstream text;
            text << typed.get();
            value.data = TomlDate{text.str()};
        } else {
            value.data = typed.get();
        }
    });
    return value;
}

constexpr std::size_t text_limit = 60;

/// Writes `value` behind `text`, and stops soon after `text_limit` letters.
void append_text(const TomlValue& value, std::string& text) {
    if (text.size() > text_limit) return;
    if (const auto* array = value.array()) {
        text += '[';
        for (std::size_t i = 0; i < array->size() && text.size() <= text_limit; ++i) {
            if (i > 0) text += ", ";
            append_text((*array)[i], text);
        }
        text += ']';
    } else if (const auto* table = value.table()) {
        text += table->empty() ? "{" : "{ ";
        for (std::size_t i = 0; i < table->size() && text.size() <= text_limit; ++i) {
            if (i > 0) text += ", ";
            text += one_line((*table)[i].key) + " = ";
            append_text((*table)[i].value, text);
        }
        text += table->empty() ? "}" : " }";
    } else if (const auto* string = value.string()) {
        text += in_quotes(*string);
    } else if (const auto* date = std::get_if<TomlDate>(&value.data)) {
        text += date->text;
    } else if (const auto* boolean = std::get_if<bool>(&value.data)) {
        text += *boolean ? "true" : "false";
    } else if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
        text += fmt::format("{}", *integer);
    } else {
        text += fmt::format("{}", std::get<double>(value.data));
    }
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view key) const {
    if (const Table* members = table()) {
        for (const Member& member : *members) {
            if (member.key == key) return &member.value;
        }
    }
    return nullptr;
}

TomlValue* TomlValue::find(std::string_view key) {
    return const_cast<TomlValue*>(std::as_const(*this).find(key));
}

TomlValue parse_toml(std::string_view text, const std::string& file) {
    try {
        return converted(toml::parse(text, file), 0);
    } catch (const toml::parse_error& error) {
        const TomlPlace place = place_of(error.source(), 0);
        throw Error(ErrorKind::usage,
                    {.file = file, .line = place.line, .column = place.column, .key = {}},
                    "not valid TOML: " + one_line(error.description()));
    }
}

TomlValue parse_toml_value(const std::string& text, int source) {
    TomlValue bare{.data = text, .place = {source, 0, 0}};
    try {
        const toml::table document = toml::parse("value = " + text);
        // More than one key means that a line break stood in the text.
        if (document.size() != 1) return bare;
        return converted(*document.get("value"), source);
    } catch (const toml::parse_error&) {
        return bare;
    }
}

std::string toml_text(const TomlValue& value) {
    std::string text;
    append_text(value, text);
    if (text.size() <= text_limit) return text;
    std::size_t end = text_limit;
    // Do not cut a UTF-8 letter in two: its later bytes are 10xxxxxx.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

}  // namespace weft
