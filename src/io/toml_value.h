// A TOML document as plain values that know where they stand. It keeps the parser itself out of
// every other file, and lets values of a file and of the command line stand in one tree.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace weft {

/// Where a value was written.
struct TomlPlace {
    int source = 0;  ///< 0: the file; n: the n-th override, from 1
    int line = 0;    ///< from 1; 0 in an override
    int column = 0;  ///< from 1; 0 in an override
};

/// A date or a time: TOML has them, scenes have no use for them.
struct TomlDate {
    std::string text;
};

struct TomlValue {
    struct Member;
    using Array = std::vector<TomlValue>;
    using Table = std::vector<Member>;  ///< in the order of the file; no key stands twice

    std::variant<bool, std::int64_t, double, std::string, TomlDate, Array, Table> data;
    TomlPlace place;

    [[nodiscard]] const Table* table() const { return std::get_if<Table>(&data); }
    [[nodiscard]] Table* table() { return std::get_if<Table>(&data); }
    [[nodiscard]] const Array* array() const { return std::get_if<Array>(&data); }
    [[nodiscard]] Array* array() { return std::get_if<Array>(&data); }
    [[nodiscard]] const std::string* string() const { return std::get_if<std::string>(&data); }

    /// The value of `key` in a table; null where this is no table or has no such key.
    [[nodiscard]] const TomlValue* find(std::string_view key) const;
    [[nodiscard]] TomlValue* find(std::string_view key);
};

struct TomlValue::Member {
    std::string key;
    TomlPlace key_place;
    TomlValue value;
};

/// Parses a document; the result holds a table.
/// @param file names the text in errors.
/// @throws Error (usage) with line and column where `text` is not TOML.
TomlValue parse_toml(std::string_view text, const std::string& file);

/// The value of `text` as it may stand right of "KEY ="; where it is no TOML value, `text` itself
/// as a string.
TomlValue parse_toml_value(const std::string& text, int source);

/// A value in TOML syntax on one line, cut after about 60 letters.
std::string toml_text(const TomlValue& value);

}  // namespace weft
