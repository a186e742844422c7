#include "cli/implicit_frame_report.h"

#include <fmt/format.h>

#include "cli/bench_report.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

std::string columns_of(const std::optional<bench::FrameFigures>& figures) {
    if (!figures) return fmt::format(" {:>9} {:>8} {:>8} {:>8} {:>5}", "-", "-", "-", "-", "-");
    const auto& ratio = figures->ratio_to_cholesky;
    return fmt::format(" {:>9.2f} {:>8} {:>8.0f} {:>8.1f} {:>5}", figures->ms,
                       ratio ? fmt::format("{:.1f}", *ratio) : "-", figures->ns_per_particle,
                       figures->explicit_steps, figures->iterations);
}

Json json_of(const std::optional<bench::FrameFigures>& figures) {
    if (!figures) return nullptr;
    const auto& ratio = figures->ratio_to_cholesky;
    return {{"ms", figures->ms},
            {"ratio_to_cholesky", ratio ? Json(*ratio) : Json(nullptr)},
            {"ns_per_particle", figures->ns_per_particle},
            {"explicit_steps", figures->explicit_steps},
            {"iterations", figures->iterations},
            {"linear_iterations", figures->linear_iterations}};
}

}  // namespace

std::string frame_table_head() {
    const auto titles = [](std::string_view a, std::string_view b, std::string_view c,
                           std::string_view d, std::string_view e) {
        return fmt::format(" {:>9} {:>8} {:>8} {:>8} {:>5}", a, b, c, d, e);
    };
    const std::string above = titles("", "ratio to", "ns/par-", "explicit", "iter-"),
                      below = titles("ms", "cholesky", "ticle", "steps", "ation");
    return fmt::format("\nfrom x + h v to within      of the solution, rms:{:>30}{:>43}\n", "1 mm",
                       "0.1 mm") +
           fmt::format("{:<36} {:>9}{}{}\n", "", "columns", above, above) +
           fmt::format("{:<36} {:>9}{}{}\n", "case", "x rows", below, below);
}

std::string frame_table_line(const bench::FrameRow& row) {
    const std::string line = fmt::format("{:<36} {:>9}", row.label.name,
                                         fmt::format("{}x{}", row.label.columns, row.label.rows));
    if (!row.note.empty()) return fmt::format("{} {}\n", line, row.note);
    return fmt::format("{}{}{}\n", line, columns_of(row.figures[0]), columns_of(row.figures[1]));
}

nlohmann::ordered_json frame_json(const bench::FrameRow& row) {
    Json json = label_json(row.label);
    json["to_1_mm"] = json_of(row.figures[0]);
    json["to_0.1_mm"] = json_of(row.figures[1]);
    json["note"] = row.note.empty() ? Json(nullptr) : Json(row.note);
    return json;
}

}  // namespace weft
