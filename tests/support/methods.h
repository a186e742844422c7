// The methods of the catalogue by what limits their step.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "weft/integrators.h"

namespace weft::test {

inline std::vector<IntegratorInfo> methods_of(std::initializer_list<IntegratorKind> kinds) {
    std::vector<IntegratorInfo> found;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (std::find(kinds.begin(), kinds.end(), info.kind) != kinds.end()) found.push_back(info);
    }
    return found;
}

inline std::vector<IntegratorInfo> explicit_methods() {
    return methods_of({IntegratorKind::explicit_steps});
}

}  // namespace weft::test
