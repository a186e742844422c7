#include "lab/report/report_files.h"

#include <fmt/format.h>

#include <cmath>

#include "lab/report/html_text.h"
#include "weft/version.h"

namespace weft::lab {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* end_of_line = "\r\n";

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_cell(const Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) return exact_number(*number);
    if (const auto* text = std::get_if<std::string>(&cell)) return csv_field(*text);
    return {};
}

Json number_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json cell_json(const Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) {
        return std::isfinite(*number) ? Json(*number) : Json(exact_number(*number));
    }
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    return nullptr;
}

Json axis_json(const std::string& label, bool logarithmic) {
    return {{"label", label}, {"logarithmic", logarithmic}};
}

Json plot_json(const Plot& plot) {
    Json series = Json::array(), labels = Json::array();
    for (const Series& line : plot.series) {
        Json points = Json::array();
        for (const auto& [x, y] : line.points) {
            points.push_back({number_or_null(x), number_or_null(y)});
        }
        series.push_back({{"name", line.name}, {"look", line.look}, {"points", points}});
    }
    for (const Label& label : plot.labels) {
        labels.push_back(
            {{"x", number_or_null(label.x)}, {"y", number_or_null(label.y)}, {"text", label.text}});
    }
    return {{"kind", "plot"},
            {"id", plot.id},
            {"title", plot.title},
            {"text", plot.text},
            {"x", axis_json(plot.x_label, plot.log_x)},
            {"y", axis_json(plot.y_label, plot.log_y)},
            {"series", series},
            {"labels", labels}};
}

Json table_json(const Table& table) {
    Json columns = Json::array(), rows = Json::array();
    for (const Column& column : table.columns) columns.push_back(column.name);
    for (const auto& row : table.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) cells.push_back(cell_json(cell));
        rows.push_back(cells);
    }
    return {{"kind", "table"},
            {"id", table.id},
            {"caption", table.caption},
            {"columns", columns},
            {"rows", rows}};
}

Json block_json(const PlacedBlock& placed) {
    if (const auto* plot = std::get_if<Plot>(placed.block)) return plot_json(*plot);
    if (const auto* table = std::get_if<Table>(placed.block)) return table_json(*table);
    if (const auto* media = std::get_if<Media>(placed.block)) {
        return {{"kind", "media"},
                {"id", media->id},
                {"file", placed.files},
                {"caption", media->caption},
                {"text", media->text}};
    }
    return {{"kind", "paragraph"}, {"text", std::get<Paragraph>(*placed.block).text}};
}

Json section_json(const PlacedSection& placed) {
    const Section& section = *placed.section;
    Json findings = Json::array(), blocks = Json::array();
    for (const Finding& finding : section.findings) {
        findings.push_back({{"name", finding.name},
                            {"value", number_or_null(finding.value)},
                            {"unit", finding.unit}});
    }
    for (const PlacedBlock& block : placed.blocks) blocks.push_back(block_json(block));
    return {{"experiment", section.experiment},
            {"scene", placed.scene},
            {"title", section.title},
            {"question", section.question},
            {"method", section.method},
            {"answer", section.answer},
            {"skipped", section.skipped.empty() ? Json(nullptr) : Json(section.skipped)},
            {"command", section.command},
            {"findings", findings},
            {"blocks", blocks}};
}

}  // namespace

std::string plot_csv(const Plot& plot) {
    std::string text = fmt::format("series,{},{}{}", csv_field(plot.x_label),
                                   csv_field(plot.y_label), end_of_line);
    for (const Series& series : plot.series) {
        const std::string name = csv_field(series.name);
        for (const auto& [x, y] : series.points) {
            text += fmt::format("{},{},{}{}", name, exact_number(x), exact_number(y), end_of_line);
        }
    }
    return text;
}

std::string table_csv(const Table& table) {
    std::string text;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        text += (n == 0 ? "" : ",") + csv_field(table.columns[n].name);
    }
    text += end_of_line;
    for (const auto& row : table.rows) {
        for (std::size_t n = 0; n < row.size(); ++n) text += (n == 0 ? "" : ",") + csv_cell(row[n]);
        text += end_of_line;
    }
    return text;
}

Json report_json(const ReportHead& head, std::span<const PlacedExperiment> experiments) {
    Json sections = Json::array();
    for (const PlacedExperiment& experiment : experiments) {
        for (const PlacedSection& section : experiment.sections) {
            sections.push_back(section_json(section));
        }
    }
    return {{"version", 1},        {"weft", WEFT_VERSION},    {"title", head.title},
            {"scene", head.scene}, {"command", head.command}, {"quick", head.quick},
            {"facts", head.facts}, {"sections", sections}};
}

}  // namespace weft::lab
