// The positions of frames as the floats of a file.
#pragma once

#include <bit>

#include "io/byte_order.h"
#include "io/output_file.h"
#include "weft/frame.h"

namespace weft {

/// The needs of a recorder that writes nothing but positions as floats.
inline constexpr FrameNeeds rounded_positions_alone{
    .positions = false, .velocities = false, .normals = false, .rounded_positions = true};

/// Writes points as three floats each, in the byte order of a file.
class PointWriter {
public:
    explicit PointWriter(std::endian order) : order_(order) {}

    /// The frame's rounded positions, or, where it has none, its positions.  @throws Error (file).
    void write_positions(OutputFile& file, const Frame& frame);
    /// Each component rounded to float.  @throws Error (file).
    void write(OutputFile& file, std::span<const Vec3d> points);
    void write(OutputFile& file, std::span<const Vec3f> points);

private:
    template <typename Real>
    void write_in_blocks(OutputFile& file, std::span<const Vec3<Real>> points);

    std::endian order_;
    Bytes block_;
};

}  // namespace weft
