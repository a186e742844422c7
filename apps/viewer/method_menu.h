// A menu of all integrators.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace weft::viewer {

/// @param present the method chosen, or "auto".  @param width [screen units]
/// @return another one that was chosen; a view into the catalogue.
std::optional<std::string_view> method_menu(const char* id, const std::string& present,
                                            bool with_auto, float width);

/// "order 4, explicit": what the menu says of a method; empty where there is none of that name.
std::string summary_of_method(std::string_view name);

}  // namespace weft::viewer
