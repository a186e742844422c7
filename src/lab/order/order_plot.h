// Errors against steps, on logarithmic axes with slopes to compare with.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/order/order_fit.h"
#include "lab/section.h"

namespace weft::lab {

struct MethodErrors {
    std::string_view method;
    std::vector<ErrorAtStep> errors;
    OrderFit fit;
};

/// A line a method; dashed lines of slope 1, 2, ... up to one more than the steepest fit, from the
/// upper right corner; a text alternative with every fit.
Plot order_plot(std::string id, std::string title, std::string y_label,
                std::span<const MethodErrors> methods);

}  // namespace weft::lab
