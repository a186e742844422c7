// The words that are written over cloths. Knows no window.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace weft::viewer {

/// Lines joined by commas into as few rows as keep to a width.
std::vector<std::string> shared_rows(const std::vector<std::string>& lines, float width,
                                     const std::function<float(const std::string&)>& width_of);

/// A force as it is read at a glance: "3.2 N", "45 mN".  @param newtons not negative.
std::string force_text(double newtons);

}  // namespace weft::viewer
