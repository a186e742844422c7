// Bullet's deformable body on the sheet: springs in N/m, stepped by implicit Euler.
#pragma once

#include <memory>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

/// btDeformableMultiBodyDynamicsWorld with btDeformableMassSpringForce, implicit, at its own
/// defaults of iterations and tolerances. It has one stiffness for structural and shear springs
/// (the sheet's structural one), another for bend springs, and one dashpot. One step is one frame.
/// Only where Bullet was found when this was built.
std::unique_ptr<SteppedPeer> make_bullet_deformable(const PlainSheet& sheet);

}  // namespace weft::bench
