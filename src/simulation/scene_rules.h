// What is allowed for scene values, in words. check_scene enforces these rules and quotes them; the
// table of scene keys prints them in docs/scene-format.md.
#pragma once

#include <string_view>

namespace weft::scene_rules {

inline constexpr std::string_view positive = "a finite number above 0";
inline constexpr std::string_view not_negative = "a finite number, 0 or more";
inline constexpr std::string_view vector = "three finite numbers";
inline constexpr std::string_view friction = "a number from 0 to 10";
inline constexpr std::string_view gap = "a number from 0 to 1";
inline constexpr std::string_view normal = "three finite numbers, not all 0";
inline constexpr std::string_view settle_among_obstacles =
    "false with [[obstacles]]; what rests on them is not found yet";
inline constexpr std::string_view sheet_size = "two finite numbers above 0";
inline constexpr std::string_view resolution = "two integers (columns, rows), each at least 2";
inline constexpr std::string_view spread = "a number, at least 0 and below 1";
inline constexpr std::string_view time_step = "a finite number above 0, or \"auto\"";
inline constexpr std::string_view tolerance = "a finite number above 0, or \"auto\"";
inline constexpr std::string_view iterations = "an integer from 1 to 100000, or \"auto\"";
inline constexpr std::string_view linear_solver =
    "\"auto\", \"multigrid\", \"aggregation\", \"jacobi\" or \"cholesky\"";
inline constexpr std::string_view picture_size = "two even integers from 16 to 8192";
inline constexpr std::string_view field_of_view = "a number above 0 and below 180";
inline constexpr std::string_view view_point = "three finite numbers, or \"auto\"";
inline constexpr std::string_view name = "a string of one line, not empty";

}  // namespace weft::scene_rules
