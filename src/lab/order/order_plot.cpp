#include "lab/order/order_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::lab {

namespace {

// What of the plane points lie in.
struct Extent {
    double x_low = std::numeric_limits<double>::infinity(), x_high = 0.0;
    double y_low = std::numeric_limits<double>::infinity(), y_high = 0.0;

    void add(double x, double y) {
        if (!std::isfinite(y) || y <= 0.0) return;
        x_low = std::min(x_low, x);
        x_high = std::max(x_high, x);
        y_low = std::min(y_low, y);
        y_high = std::max(y_high, y);
    }
    [[nodiscard]] bool empty() const { return x_high <= 0.0; }
};

int steepest(std::span<const MethodErrors> methods) {
    double order = 1.0;
    for (const MethodErrors& method : methods) {
        if (method.fit.points > 0) order = std::max(order, method.fit.order);
    }
    return std::min(static_cast<int>(std::lround(order)), 7);
}

// Lines of slope 1, 2, ... down and left from the upper right corner, as far as there are errors.
void add_slopes(const Extent& extent, int most, Plot& plot) {
    for (int slope = 1; slope <= most; ++slope) {
        const double fall = extent.y_low / extent.y_high;
        const double left = std::max(extent.x_low, extent.x_high * std::pow(fall, 1.0 / slope));
        const double bottom = extent.y_high * std::pow(left / extent.x_high, slope);
        Series line;
        line.points = {{left, bottom}, {extent.x_high, extent.y_high}};
        line.style = Series::Style::dashed;
        line.look = "neutral";
        plot.series.push_back(std::move(line));
        plot.labels.push_back({left, bottom, fmt::format("slope {}", slope)});
    }
}

std::string text_of(const Plot& plot, std::span<const MethodErrors> methods) {
    std::string fits;
    for (const MethodErrors& method : methods) {
        if (!fits.empty()) fits += ", ";
        fits += method.fit.points > 0 ? fmt::format("{} {:.2f}", method.method, method.fit.order)
                                      : fmt::format("{} none", method.method);
    }
    return fmt::format("{}, both axes logarithmic. Slopes of the fitted lines: {}.", plot.title,
                       fits);
}

}  // namespace

Plot order_plot(std::string id, std::string title, std::string y_label,
                std::span<const MethodErrors> methods) {
    Plot plot;
    plot.id = std::move(id);
    plot.title = std::move(title);
    plot.x_label = "step dt [s]";
    plot.y_label = std::move(y_label);
    plot.log_x = plot.log_y = true;
    Extent extent;
    for (const MethodErrors& method : methods) {
        Series line;
        line.name = line.look = std::string(method.method);
        for (const ErrorAtStep& point : method.errors) {
            line.points.push_back({point.step, point.error});
            // Blown-up flights that did not fail would squeeze all others.
            if (point.error < 1e3) extent.add(point.step, point.error);
        }
        plot.series.push_back(std::move(line));
    }
    if (!extent.empty()) add_slopes(extent, steepest(methods), plot);
    plot.text = text_of(plot, methods);
    return plot;
}

}  // namespace weft::lab
