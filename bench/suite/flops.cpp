#include "bench/suite/flops.h"

namespace weft::bench {

double flops_per_step(const PlainSheet& sheet, int evaluations) {
    const bool damped =
        sheet.structural.damping > 0.0 || sheet.shear.damping > 0.0 || sheet.bend.damping > 0.0;
    const double springs = static_cast<double>(plain_spring_count(sheet));
    const double particles = static_cast<double>(sheet.particle_count());
    return evaluations * (springs * flops_per_spring(damped) + particles * flops_per_particle);
}

}  // namespace weft::bench
