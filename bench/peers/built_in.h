// The peers from other libraries; null where the library was not found when this was built.
#pragma once

#include <memory>
#include <string>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

using MakePeer = std::unique_ptr<SteppedPeer> (*)(const PlainSheet&);

extern const MakePeer odeint_rk4;
extern const MakePeer odeint_velocity_verlet;
extern const MakePeer bullet_soft_body;
extern const MakePeer bullet_deformable;

/// Versions, e.g. "1.74.0"; empty where not built in.
std::string boost_version_built_in();
std::string bullet_version_built_in();

}  // namespace weft::bench
