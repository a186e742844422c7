// Bullet's soft body on the sheet: one solver pass a frame of 1/60 s, as a game would have it.
#pragma once

#include <memory>
#include <string>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

/// Positions are those of a link for every spring, at Bullet's own default of iterations and link
/// stiffness (1: as stiff as the iterations make it; it knows no N/m). One step is one frame.
/// Only where Bullet was found when this was built.
std::unique_ptr<SteppedPeer> make_bullet(const PlainSheet& sheet);

/// E.g. "3.24".
std::string bullet_version();

}  // namespace weft::bench
