// The experiment on rest and blow-up.
#include <fmt/format.h>

#include "lab/experiment.h"
#include "lab/settle/settle_parts.h"
#include "weft/simulation.h"

namespace weft::lab {

namespace {

std::string method_text(double duration) {
    return fmt::format(
        "The comparison prints a \"stable time\" of 8 s for Forward Euler, 3 s for Verlet and 15 s "
        "for R-K (Kutta's third-order method), and does not say what it is. Two readings are "
        "measured. At rest from: the first time after which the kinetic energy stays below {:g} of "
        "the energy that the sheet sets free when it swings down (its weight times half its "
        "height), to the end of the run. Wrecked at: the first time a co-ordinate is not finite "
        "or a spring is strained beyond {:g} (blown up), or the energy has grown by more than the "
        "energy set free (energy out of nothing: nothing here can give it). The sheet is the "
        "printed one: 40 x 40 particles, 20 m x 20 m, 800 N/m in every spring, gravity, both top "
        "corners held. The mass, the step and the damping are not printed; so masses of 1 kg and "
        "0.03 kg a particle (nylon), steps of 16 ms (which table 1 implies) and 1 ms, and none and "
        "moderate damping were run, {:g} s each. Nothing was chosen to meet the printed figures.",
        rest_fraction, Divergence::max_strain, duration);
}

constexpr const char* causes_text =
    "The comparison says that its Verlet wrinkled, that Forward Euler did better and R-K best. "
    "Each "
    "candidate for why was run on its sheet: dashpots, too light a mass, too long a step, what is "
    "misprinted, what its words may be read as, and what is easily mistyped. In the plots a point "
    "on "
    "the dashed line was not wrecked within the run.";

}  // namespace

Section measure_settle(Laboratory& laboratory) {
    RestBatch batch;
    const SeedTable table(batch, laboratory.methods(), laboratory.quick());
    const SettleSweeps sweeps(batch, laboratory.quick());
    const SettleCauses causes(batch, laboratory.quick());
    const SettleScene scene(batch, laboratory.scene(), laboratory.methods(), laboratory.quick());
    batch.run(laboratory);

    Section section;
    section.method = method_text(settle_duration(laboratory.quick()));
    table.tell(batch, section);
    section.blocks.emplace_back(Paragraph{causes_text});
    const SettleSweeps::Race race = sweeps.race(batch);
    sweeps.tell(batch, section);
    causes.tell(batch, race, section);
    scene.tell(batch, section);
    section.answer =
        table.sentence(batch) + "; " + sweeps.sentence(batch) + ", " + causes.sentence(batch, race);
    const std::string own = scene.sentence(batch);
    if (!own.empty()) section.answer += "; " + own;
    section.answer += ".";
    return section;
}

}  // namespace weft::lab
