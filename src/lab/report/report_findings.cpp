#include "lab/report/report_findings.h"

#include <algorithm>
#include <cmath>

namespace weft::lab {

namespace {

std::size_t row_of(Table& table, const Section& section, const Finding& finding) {
    const std::vector<Cell> head{section.title, finding.name, finding.unit};
    const auto found = std::ranges::find_if(table.rows, [&](const std::vector<Cell>& row) {
        return std::equal(head.begin(), head.end(), row.begin());
    });
    if (found != table.rows.end()) return static_cast<std::size_t>(found - table.rows.begin());
    table.rows.push_back(head);
    table.rows.back().resize(table.columns.size());
    return table.rows.size() - 1;
}

void add_ratio(std::vector<Cell>& row) {
    const auto* first = std::get_if<double>(&row[3]);
    const auto* second = std::get_if<double>(&row[4]);
    if (first == nullptr || second == nullptr) return;
    const double ratio = *second / *first;
    if (std::isfinite(ratio)) row[5] = ratio;
}

}  // namespace

Table findings_table(std::span<const PlacedExperiment> experiments,
                     const std::vector<std::string>& scenes) {
    Table table{.id = "findings",
                .caption = "A row is a number that sums an experiment up.",
                .columns = {{"experiment"}, {"finding"}, {"unit"}},
                .rows = {}};
    for (const std::string& scene : scenes) table.columns.push_back({scene});
    const bool pair = scenes.size() == 2;
    if (pair) {
        table.columns.push_back({"ratio " + scenes[1] + " : " + scenes[0]});
        table.caption += " The ratio is that of the second scene to the first.";
    }
    for (const PlacedExperiment& experiment : experiments) {
        for (const PlacedSection& placed : experiment.sections) {
            const auto scene = std::ranges::find(scenes, placed.scene) - scenes.begin();
            for (const Finding& finding : placed.section->findings) {
                const std::size_t row = row_of(table, *placed.section, finding);
                table.rows[row][3 + static_cast<std::size_t>(scene)] = finding.value;
            }
        }
    }
    if (pair) std::ranges::for_each(table.rows, add_ratio);
    return table;
}

}  // namespace weft::lab
