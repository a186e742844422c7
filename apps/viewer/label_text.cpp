// Few rows, round numbers.
#include "viewer/label_text.h"

#include <fmt/format.h>

namespace weft::viewer {

std::vector<std::string> shared_rows(const std::vector<std::string>& lines, float width,
                                     const std::function<float(const std::string&)>& width_of) {
    std::vector<std::string> rows;
    for (const std::string& line : lines) {
        const std::string joined = rows.empty() ? line : rows.back() + ", " + line;
        if (!rows.empty() && width_of(joined) <= width)
            rows.back() = joined;
        else
            rows.push_back(line);
    }
    return rows;
}

std::string force_text(double newtons) {
    if (newtons < 0.0005) return "0 N";
    if (newtons < 0.1) return fmt::format("{:.0f} mN", 1000.0 * newtons);
    if (newtons < 10.0) return fmt::format("{:.1f} N", newtons);
    if (newtons < 1e5) return fmt::format("{:.0f} N", newtons);
    return fmt::format("{:.1e} N", newtons);
}

}  // namespace weft::viewer
