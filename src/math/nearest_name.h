// The known name that a misspelt one was probably meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace weft {

/// Changes of one letter (put in, left out, replaced, or swapped with its neighbour) that turn `a`
/// into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// @return the name of `known` nearest to `name`, the first of several as near; empty where none is
///         within a third of its letters (and two changes are always allowed).
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known);

/// @return " (did you mean NAME?)" for the nearest name, with a leading space; empty where none is
///         near.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace weft
