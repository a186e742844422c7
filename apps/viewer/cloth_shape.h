// Shapes of cloths, from scenes.
#pragma once

#include <cstdint>
#include <memory>

#include "viewer/flight.h"

namespace weft::viewer {

/// A number that no surface had before.
std::uint64_t new_surface_number();

/// The shape of a scene's cloth.
/// @param surface_number new_surface_number(), or that of a shape with the same cloth.
/// @throws Error as build_cloth().
std::shared_ptr<const ClothShape> make_cloth_shape(const SceneDescription& scene,
                                                   std::uint64_t surface_number);

}  // namespace weft::viewer
