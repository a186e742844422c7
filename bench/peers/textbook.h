// The textbook's cloth: an array of particles, an array of springs, and symplectic Euler, in
// double. What most people write first, and the yardstick of `weft bench`.
#pragma once

#include <memory>

#include "bench/peers/plain_sheet.h"

namespace weft::bench {

std::unique_ptr<SteppedPeer> make_textbook(const PlainSheet& sheet);

}  // namespace weft::bench
