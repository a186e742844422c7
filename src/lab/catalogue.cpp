#include <algorithm>
#include <array>

#include "lab/experiment.h"

namespace weft::lab {

namespace {

constexpr std::array<Experiment, 8> experiments{{
    {"order", "Order of accuracy",
     "How fast does the error of each method shrink with its step, and is it the order that the "
     "method states?",
     0.12, 2, measure_order},
    {"local-error", "The error of one step",
     "How large is the error of a single step, and what do the printed errors of the paper mean?",
     0.04, 2, measure_local_error},
    {"stability", "The largest stable step",
     "How long may a step be before the cloth blows up, and does theory predict it?", 0.13, 1,
     measure_stability},
    {"energy", "Energy in the long run",
     "Which methods keep the energy of the motion, which lose it, and which make it up?", 0.12, 1,
     measure_energy},
    {"settle", "Rest and blow-up",
     "When does the sheet of the paper come to rest, when does it blow up, and why did its authors "
     "see Verlet wrinkle?",
     0.18, 1, measure_settle},
    {"look", "What it looks like", "What does the same cloth look like, flown by each method?",
     0.17, 1, measure_look},
    {"work-precision", "Error against cost",
     "Which method reaches a given error at the least cost?", 0.20, 2, measure_work_precision},
    {"sensitivity", "How long a trajectory means anything",
     "How fast do two runs part that begin almost alike?", 0.04, 1, measure_sensitivity},
}};

}  // namespace

std::span<const Experiment> experiment_catalogue() {
    return experiments;
}

const Experiment* find_experiment(std::string_view name) {
    const auto found = std::ranges::find(experiments, name, &Experiment::name);
    return found == experiments.end() ? nullptr : &*found;
}

}  // namespace weft::lab
