// What an iterative solution of A d = r came to.
#pragma once

namespace weft {

struct LinearReport {
    int iterations = 0;     ///< of conjugate gradients; 1 for a factorisation
    double residual = 0.0;  ///< |r - A d| / |r|, in the norm that the solver states
    bool converged = false;
};

}  // namespace weft
