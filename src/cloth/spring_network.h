// All springs of a cloth, listed one by one: for methods that assemble matrices or project each.
#pragma once

#include <cstdint>
#include <vector>

#include "cloth/cloth_model.h"

namespace weft {

struct SpringNetwork {
    /// Between the particles in slots p and q.
    struct Spring {
        std::uint32_t p = 0, q = 0;
        double rest_length = 0.0;  ///< [m]
        double stiffness = 0.0;    ///< [N/m]
        double damping = 0.0;      ///< [N s/m]
    };
    /// In a grid by families, then rows; in a mesh as the model lists them.
    std::vector<Spring> springs;
    std::vector<double> inverse_masses;  ///< [slot], 0: pinned, or padding [1/kg]
};

SpringNetwork spring_network(const ClothModel& cloth);

}  // namespace weft
