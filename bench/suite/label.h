// How a row of the table is named, and found by `--filter`.
#pragma once

#include <string>
#include <string_view>

#include "weft/scene.h"

namespace weft::bench {

/// What tells one row of the table from all others.
struct Label {
    std::string name;  ///< "rk4", "textbook", "mesh symplectic-euler"
    int columns = 0, rows = 0;
    Precision precision = Precision::f32;
    int threads = 1;

    /// "rk4 256x256 single 1 thread": what a filter is held against.
    [[nodiscard]] std::string text() const;

    /// @param filter words, each of which must be a word of the text; none: every label has them.
    [[nodiscard]] bool has_words(std::string_view filter) const;
};

}  // namespace weft::bench
