#include "lab/report/report_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "io/input_file.h"
#include "lab/report/html_text.h"

namespace weft::lab {

namespace {

// Lengths of a cell's text [bytes].
constexpr std::size_t short_text = 16, long_text = 32;  // above the second it may wrap

// Whether a column holds numbers, with a short word among them at most: it is set to the right.
bool is_numeric(const Table& table, std::size_t column) {
    bool any = false;
    for (const auto& row : table.rows) {
        const auto* text = std::get_if<std::string>(&row[column]);
        if (text != nullptr && text->size() > short_text) return false;
        any = any || std::holds_alternative<double>(row[column]);
    }
    return any;
}

std::string cell_html(const Cell& cell, const Column& column, bool first, bool numeric) {
    if (const auto* number = std::get_if<double>(&cell)) {
        return fmt::format("<td class=\"number\" data-value=\"{}\">{}</td>", exact_number(*number),
                           html_number(*number, column.digits));
    }
    const auto* text = std::get_if<std::string>(&cell);
    if (text == nullptr) return "<td class=\"missing\"></td>";
    const std::string shown = html_with_code(*text);
    const char* kind = text->size() > long_text ? " class=\"long\""
                       : numeric                ? " class=\"number\""
                                                : "";
    return first ? fmt::format("<th scope=\"row\"{}>{}</th>", kind, shown)
                 : fmt::format("<td{}>{}</td>", kind, shown);
}

std::string link(const std::string& file, const char* text) {
    std::string address;
    for (const char c : file) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '/';
        address +=
            plain ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return fmt::format("<a href=\"{}\">{}</a>", address, text);
}

std::string in_words(const std::string& text) {
    if (text.empty()) return {};
    return "<details><summary>In words</summary>" + paragraphs_html(text) + "</details>\n";
}

std::string figure_html(const PlacedBlock& placed, const std::string& drawing,
                        const std::string& caption, const std::string& text,
                        const std::string& links) {
    return fmt::format(
        "<figure id=\"{0}\">\n<div class=\"scroll\" role=\"group\" tabindex=\"0\" "
        "aria-labelledby=\"{0}.caption\">\n{1}</div>\n<figcaption>\n<p id=\"{0}.caption\">"
        "<b>Figure&nbsp;{2}.</b> {3}</p>\n<p "
        "class=\"files\">{4}</p>\n{5}</figcaption>\n</figure>\n",
        placed.anchor, drawing, placed.number, html_with_code(caption), links, in_words(text));
}

std::string plot_html(const PlacedBlock& placed, const Plot& plot) {
    return figure_html(placed, placed.inline_svg, plot.title, plot.text,
                       link(placed.files + ".csv", "CSV") + " " +
                           link(placed.files + ".svg", "SVG") + " " +
                           link(placed.files + ".png", "PNG"));
}

// Width and height of a PNG file, from its head; 0 where it is none.
std::pair<unsigned, unsigned> png_size(const Bytes& bytes) {
    if (bytes.size() < 24) return {0, 0};
    const auto number = [&](std::size_t place) {
        unsigned value = 0;
        for (std::size_t n = place; n < place + 4; ++n) {
            value = (value << 8U) | static_cast<unsigned>(bytes[n]);
        }
        return value;
    };
    return {number(16), number(20)};
}

std::string media_html(const PlacedBlock& placed, const Media& media,
                       const std::filesystem::path& directory) {
    const InputFile file(media.file.is_absolute() || exists(media.file) ? media.file
                                                                        : directory / media.file);
    const Bytes bytes = file.read(0, file.size());
    const std::string ending = media.file.extension().string();
    std::string drawing;
    const char* kind = ending == ".png" ? "PNG" : "Video";
    if (ending == ".png") {
        const auto [width, height] = png_size(bytes);
        drawing = fmt::format("<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\"{}>\n",
                              data_uri("image/png", bytes), html(media.text), width, height,
                              width > 640 ? " class=\"wide\"" : "");
    } else if (ending == ".mp4" || ending == ".webm") {
        drawing = fmt::format(
            "<video controls loop muted playsinline preload=\"auto\" aria-label=\"{}\" "
            "src=\"{}\"></video>\n",
            html(media.text), data_uri("video/" + ending.substr(1), bytes));
    } else {
        throw file.error("the report shows .png, .mp4 and .webm files");
    }
    return figure_html(placed, drawing, media.caption, media.text, link(placed.files, kind));
}

}  // namespace

std::string paragraphs_html(const std::string& text) {
    std::string result;
    std::size_t place = 0;
    while (place < text.size()) {
        const std::size_t end = std::min(text.find("\n\n", place), text.size());
        const std::string paragraph = text.substr(place, end - place);
        if (paragraph.find_first_not_of(" \n") != std::string::npos) {
            result += "<p>" + html_with_code(paragraph) + "</p>\n";
        }
        place = end + 2;
    }
    return result;
}

std::string table_html(const Table& table, const std::string& anchor, int number) {
    std::string text = fmt::format(
        "<div class=\"scroll\" role=\"group\" tabindex=\"0\" aria-labelledby=\"{0}.caption\">\n"
        "<table id=\"{0}\" class=\"sortable\">\n<caption "
        "id=\"{0}.caption\"><span>{1}{2}</span></caption>\n"
        "<thead>\n<tr>",
        anchor, number > 0 ? fmt::format("<b>Table&nbsp;{}.</b> ", number) : std::string(),
        html_with_code(table.caption));
    std::vector<bool> numeric;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        numeric.push_back(is_numeric(table, n));
        text += fmt::format("<th scope=\"col\"{}>{}</th>", numeric[n] ? " class=\"number\"" : "",
                            html(table.columns[n].name));
    }
    text += "</tr>\n</thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        text += "<tr>";
        for (std::size_t n = 0; n < row.size(); ++n) {
            text += cell_html(row[n], table.columns[n], n == 0, numeric[n]);
        }
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n</div>\n";
}

std::string block_html(const PlacedBlock& placed, const std::filesystem::path& directory) {
    if (const auto* plot = std::get_if<Plot>(placed.block)) return plot_html(placed, *plot);
    if (const auto* table = std::get_if<Table>(placed.block)) {
        return "<div class=\"table\">\n" + table_html(*table, placed.anchor, placed.number) +
               "<p class=\"files\">" + link(placed.files + ".csv", "CSV") + "</p>\n</div>\n";
    }
    if (const auto* media = std::get_if<Media>(placed.block)) {
        return media_html(placed, *media, directory);
    }
    return paragraphs_html(std::get<Paragraph>(*placed.block).text);
}

}  // namespace weft::lab
