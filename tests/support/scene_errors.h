// What tests of scenes share: the error that something throws.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <string>

#include "weft/error.h"
#include "weft/scene.h"

namespace weft::test {

/// @return the error thrown by `action`; nothing where it throws none.
template <typename Action>
std::optional<Error> error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    return {};
}

/// what() of the error that parsing `text` as "scene.toml" throws; empty where there is none.
inline std::string parse_error(const std::string& text,
                               std::span<const SceneOverride> overrides = {}) {
    const auto error = error_of([&] { parse_scene(text, "scene.toml", overrides); });
    return error ? error->what() : "";
}

}  // namespace weft::test
