// The comparison's table 1, "local error": what it prints, what that is, and what is measured.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "lab/laboratory.h"
#include "lab/section.h"

namespace weft::lab {

/// Where the paper's sheet is after the steps that are measured.
Trial printed_errors_reference();

/// A trial a row of the table.
/// @param reference result of printed_errors_reference(); outlives the trials.
std::vector<Trial> printed_errors_trials(const nlohmann::json& reference);

struct PrintedErrors {
    Table table;
    std::string text;    ///< a paragraph to read it by
    std::string answer;  ///< of the experiment, without a full stop
};

/// @param results of printed_errors_trials().
PrintedErrors printed_errors(std::span<const nlohmann::json> results);

}  // namespace weft::lab
