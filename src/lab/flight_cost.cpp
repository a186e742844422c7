#include "lab/flight_cost.h"

#include "weft/integrators.h"

namespace weft::lab {

double evaluation_cost(const SceneDescription& scene) {
    return (scene.wind ? 2.0 : 1.0) * (scene.cloth.mesh ? 2.8 : 1.0);
}

double step_cost(std::string_view method, bool exact) {
    const IntegratorInfo& info = *find_integrator(method);
    const bool two_stages = method == "tr-bdf2" || method == "sdirk2";
    switch (info.kind) {
        case IntegratorKind::explicit_steps:
            return info.evaluations;
        case IntegratorKind::adaptive:
            return 12.0;
        case IntegratorKind::implicit:
            return (two_stages ? 2.0 : 1.0) * (exact ? 500.0 : 200.0);
        case IntegratorKind::by_springs:
            break;
    }
    return method == "xpbd" ? 40.0 : method == "vbd" ? 2000.0 : 400.0;
}

double power_cost(const SceneDescription& scene) {
    return scene.wind ? 28.0 : 3.5;
}

}  // namespace weft::lab
