// Views of a flight, used again so that a large cloth need not allocate at every frame.
#pragma once

#include <memory>

#include "viewer/flight.h"

namespace weft::viewer {

class ViewPool {
public:
    ViewPool();
    /// A view that nobody else holds, with whatever it held before. It comes back by itself when
    /// its last holder lets go, on any thread, also after the pool has gone.
    [[nodiscard]] std::shared_ptr<FlightView> take();

private:
    struct Shelf;
    std::shared_ptr<Shelf> shelf_;
};

}  // namespace weft::viewer
