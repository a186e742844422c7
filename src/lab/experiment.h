// The experiments: one table that the command, the report and the tests read.
#pragma once

#include <span>
#include <string_view>

#include "lab/laboratory.h"
#include "lab/section.h"

namespace weft::lab {

/// A row of `weft list experiments`.
struct Experiment {
    std::string_view name;      ///< key on the command line: "order"
    std::string_view title;     ///< "Order of accuracy"
    std::string_view question;  ///< one sentence
    double share;               ///< of a whole study's time, roughly
    int batches;                ///< calls of Laboratory::run()
    /// Measures. Fills blocks, answer, method, findings and, where the experiment does not apply
    /// to the scene, skipped; the rest is filled in by the caller.
    /// @throws Interrupted; Error.
    Section (*run)(Laboratory& laboratory);
};

/// All experiments, in the order of the report.
std::span<const Experiment> experiment_catalogue();

/// @return nullptr where no such experiment exists.
const Experiment* find_experiment(std::string_view name);

Section measure_order(Laboratory& laboratory);           // order/order.cpp
Section measure_local_error(Laboratory& laboratory);     // order/local_error.cpp
Section measure_stability(Laboratory& laboratory);       // stability/stability.cpp
Section measure_energy(Laboratory& laboratory);          // energy/energy.cpp
Section measure_settle(Laboratory& laboratory);          // settle/settle.cpp
Section measure_look(Laboratory& laboratory);            // look/look.cpp
Section measure_work_precision(Laboratory& laboratory);  // work_precision/work_precision.cpp
Section measure_sensitivity(Laboratory& laboratory);     // sensitivity/sensitivity.cpp

}  // namespace weft::lab
