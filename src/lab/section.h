// What an experiment comes to: plain data that the report, the CSV files and the JSON are made of.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace weft::lab {

/// Points of one line of a plot.
struct Series {
    enum class Style { marks, line, line_and_marks, dashed };

    std::string name;                           ///< in the key; empty: not in it
    std::vector<std::array<double, 2>> points;  ///< (x, y), in the order they are joined in
    Style style = Style::line_and_marks;
    /// Whose colour, mark and dashes: a method's name, so that a method looks the same in every
    /// plot; or "neutral", for what is no method (references, limits, slopes).
    std::string look{};
};

/// A note at a place of a plot.
struct Label {
    double x = 0.0, y = 0.0;
    std::string text;
};

/// A figure with axes. Points that a logarithmic axis cannot show (not positive), and values not
/// finite, are left out of the drawing; they stay in the numbers.
struct Plot {
    std::string id;     ///< unique in its section, of letters, digits and "-"; names its files
    std::string title;  ///< above it
    std::string x_label, y_label;  ///< with units
    bool log_x = false, log_y = false;
    bool equal_axes = false;  ///< one unit is as long on both axes
    std::vector<Series> series;
    std::vector<Label> labels{};
    std::string text;  ///< what it shows, for those who cannot see it
};

/// A value in a table: nothing, a number (not finite ones too), or text.
using Cell = std::variant<std::monostate, double, std::string>;

struct Column {
    std::string name;  ///< heading, with its unit
    int digits = 4;    ///< significant ones shown; files have all
};

struct Table {
    std::string id;       ///< as Plot::id
    std::string caption;  ///< says what a row is
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;  ///< each of columns.size() cells
};

/// A picture or a video that the experiment made.
struct Media {
    std::string id;              ///< as Plot::id
    std::filesystem::path file;  ///< .png, .mp4 or .webm, in the study's directory
    std::string caption;
    std::string text;  ///< what it shows, for those who cannot see it
};

/// Running text.
struct Paragraph {
    std::string text;  ///< plain; `code` between backquotes
};

/// A number that sums an experiment up: what two scenes are compared by.
struct Finding {
    std::string name;  ///< "observed limit of rk4"
    double value = 0.0;
    std::string unit;  ///< "s"; may be empty
};

using Block = std::variant<Paragraph, Plot, Table, Media>;

/// One experiment on one scene.
struct Section {
    std::string experiment;  ///< its key: "order"
    std::string title;
    std::string question;       ///< what it asks, one sentence
    std::string method;         ///< how it measures, a short paragraph
    std::vector<Block> blocks;  ///< figures and tables in reading order
    std::string answer;         ///< one sentence
    std::string command;        ///< that makes this section alone
    std::string skipped;        ///< why it does not apply to the scene; empty: it ran
    std::vector<Finding> findings;
};

}  // namespace weft::lab
