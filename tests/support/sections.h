// Reading what experiments come to.
#pragma once

#include <stdexcept>
#include <string>

#include "lab/section.h"

namespace weft::test {

/// @throws std::out_of_range where the section has no such table.
inline const lab::Table& table_of(const lab::Section& section, const std::string& id) {
    for (const lab::Block& block : section.blocks) {
        const lab::Table* table = std::get_if<lab::Table>(&block);
        if (table != nullptr && table->id == id) return *table;
    }
    throw std::out_of_range(id);
}

}  // namespace weft::test
