#include "cli/motion_report.h"

#include <fmt/format.h>

#include "cli/bench_report.h"

namespace weft {

std::string motion_table_head(const bench::MotionReference& reference) {
    return fmt::format(
               "\nhalf a second of the falling sheet, against velocity Verlet in steps of a "
               "sixteenth of\nthe largest (kinetic energy at the end: {:.3f} J)\n",
               reference.kinetic_energy) +
           fmt::format("{:<32} {:>9} {:>11} {:>11} {:>13} {:>11}\n", "", "columns", "steps", "rms",
                       "change of", "ms") +
           fmt::format("{:<32} {:>9} {:>11} {:>11} {:>13} {:>11}\n", "case", "x rows", "a frame",
                       "error [mm]", "energy [J]", "a frame");
}

std::string motion_table_line(const bench::MotionRow& row) {
    const std::string line = fmt::format("{:<32} {:>9}", row.label.name,
                                         fmt::format("{}x{}", row.label.columns, row.label.rows));
    if (!row.figures) return fmt::format("{} {}\n", line, row.note);
    return fmt::format("{} {:>11.1f} {:>11.2f} {:>+13.5f} {:>11.3f}\n", line,
                       row.figures->steps_per_frame, 1e3 * row.figures->rms_error,
                       row.figures->energy_change, row.figures->ms_per_frame);
}

nlohmann::ordered_json motion_json(const bench::MotionRow& row,
                                   const bench::MotionReference& reference) {
    nlohmann::ordered_json json = label_json(row.label);
    const auto set = [&](const char* key, double bench::MotionFigures::*figure) {
        json[key] = nullptr;
        if (row.figures) json[key] = *row.figures.*figure;
    };
    set("steps_per_frame", &bench::MotionFigures::steps_per_frame);
    set("rms_error", &bench::MotionFigures::rms_error);
    set("energy_change", &bench::MotionFigures::energy_change);
    json["kinetic_energy"] = reference.kinetic_energy;
    set("ms_per_frame", &bench::MotionFigures::ms_per_frame);
    json["note"] = nullptr;
    if (!row.note.empty()) json["note"] = row.note;
    return json;
}

}  // namespace weft
