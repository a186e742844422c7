// The log-log plot of cost against size, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <span>

#include "bench/suite/suite.h"
#include "io/output_file.h"

namespace weft {

/// A plot that is to be made at the end: what would keep it from being made shows at the start.
class BenchPlot {
public:
    /// @param path ends in .svg or .png.
    /// @throws Error (usage) for another ending; Error (file) where the file cannot be written or
    ///         gnuplot is not there.
    explicit BenchPlot(const std::filesystem::path& path);

    /// Draws the rows that are timed in nanoseconds a particle-step; of methods, the principal
    /// ones, unless `all`.
    /// @throws Error (file) with gnuplot's message where it fails.
    void draw(std::span<const bench::Row> rows, bool all);

private:
    OutputFile file_;
    bool svg_;
};

}  // namespace weft
