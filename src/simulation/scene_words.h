// The words that scene files use for the enumerations of scene.h.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "weft/scene.h"

namespace weft {

/// Words in the order of the enumerators.
template <typename Enum>
inline constexpr std::array<std::string_view, 0> scene_words{};

template <>
inline constexpr std::array<std::string_view, 2> scene_words<Plane>{"xy", "xz"};
template <>
inline constexpr std::array<std::string_view, 2> scene_words<StiffnessPer>{"spring", "width"};
template <>
inline constexpr std::array<std::string_view, 2> scene_words<BendLayout>{"interior", "border"};
template <>
inline constexpr std::array<std::string_view, 2> scene_words<Precision>{"single", "double"};
template <>
inline constexpr std::array<std::string_view, 2> scene_words<OnDivergence>{"stop", "halve-step"};
template <>
inline constexpr std::array<std::string_view, 2> scene_words<GustModel>{"none", "coefficient"};
template <>
inline constexpr std::array<std::string_view, 5> scene_words<LinearSolver>{
    "auto", "multigrid", "aggregation", "jacobi", "cholesky"};
template <>
inline constexpr std::array<std::string_view, 8> scene_words<EdgeSelection>{
    "top-left",  "top-right",  "bottom-left", "bottom-right",
    "left-edge", "right-edge", "top-edge",    "bottom-edge"};

template <typename Enum>
constexpr std::string_view scene_word(Enum value) {
    return scene_words<Enum>.at(static_cast<std::size_t>(value));
}

/// @return whether the selection is a whole edge, not a corner.
constexpr bool is_edge(EdgeSelection selection) {
    return static_cast<int>(selection) >= static_cast<int>(EdgeSelection::left_edge);
}

}  // namespace weft
