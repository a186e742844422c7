#include "bench/peers/plain_sheet.h"

#include <cmath>

namespace weft::bench {

std::vector<PlainSpring> plain_springs(const PlainSheet& sheet) {
    std::vector<PlainSpring> springs;
    springs.reserve(plain_spring_count(sheet));
    const auto join_all = [&](PlainSheet::Kind kind, int right, int down) {
        for (int j = 0; j + down < sheet.rows; ++j) {
            for (int i = 0; i < sheet.columns; ++i) {
                if (i + right < 0 || i + right >= sheet.columns) continue;
                const double length = sheet.cell * std::hypot(right, down);
                springs.push_back({j * sheet.columns + i, (j + down) * sheet.columns + i + right,
                                   kind.stiffness, kind.damping, length});
            }
        }
    };
    join_all(sheet.structural, 1, 0);
    join_all(sheet.structural, 0, 1);
    join_all(sheet.shear, 1, 1);
    join_all(sheet.shear, -1, 1);
    join_all(sheet.bend, 2, 0);
    join_all(sheet.bend, 0, 2);
    return springs;
}

std::size_t plain_spring_count(const PlainSheet& sheet) {
    const auto columns = static_cast<std::size_t>(sheet.columns);
    const auto rows = static_cast<std::size_t>(sheet.rows);
    return (columns - 1) * rows + columns * (rows - 1) + 2 * (columns - 1) * (rows - 1) +
           (columns - 2) * rows + columns * (rows - 2);
}

}  // namespace weft::bench
