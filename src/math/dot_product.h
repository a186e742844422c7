// The scalar product of whole arrays.
#pragma once

#include "math/vec3_array.h"

namespace weft {

/// sum over slots a.b, in blocks of fixed places: the same bits for any number of threads.
double dot(const Vec3Array<double>& a, const Vec3Array<double>& b);

}  // namespace weft
