// Pictures of flights side by side: a row a flight, a column a time, all by the same camera.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/look/look_flight.h"
#include "render/image.h"
#include "render/off_screen.h"
#include "weft/frame.h"
#include "weft/scene.h"

namespace weft::lab {

/// A flight and what is written above it.
struct StripRow {
    std::string title;
    const LookFlight* flight = nullptr;
};

/// A moment that is shown.
struct StripColumn {
    std::string title;      ///< "0.5 s"
    std::size_t shape = 0;  ///< index into LookFlight::shapes
};

/// A camera that shows all shapes of the flights that did not fail, from where the automatic one
/// looks; the scene's own where it names one.
/// @param start the cloth before the flights.
/// @return render with camera and target given.
RenderDescription with_common_camera(const Surface& surface, const RenderDescription& render,
                                     const Shape& start, std::span<const StripRow> rows);

/// Draws flights of one cloth, each shape a tile of render.size pixels.
class TilePainter {
public:
    /// @param surface outlives the painter.
    /// @throws Error (file) where OpenGL is missing.
    TilePainter(const Surface& surface, const RenderDescription& render, const Shape& start);

    /// The flight's shape. Of a flight that failed before: the last shape that was a cloth, framed
    /// in red with when it failed, where `newly`; else an empty tile that says so.
    Image paint(const LookFlight& flight, std::size_t shape, bool newly);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

private:
    Image draw(const Shape& shape);

    const Surface& surface_;
    int width_, height_;
    OffScreenRenderer renderer_;
    std::vector<Vec3f> normals_;
};

/// The strip.
/// @param check called before each tile: may throw to end it.
Image paint_strip(TilePainter& painter, std::span<const StripRow> rows,
                  std::span<const StripColumn> columns, const std::function<void()>& check);

/// One picture of many flights at the same moment, in a grid, each with its title: a video's frame.
class TileGrid {
public:
    TileGrid(int tile_width, int tile_height, std::size_t tiles);

    [[nodiscard]] int width() const;   ///< even
    [[nodiscard]] int height() const;  ///< even
    Image paint(TilePainter& painter, std::span<const StripRow> rows, std::size_t shape,
                const std::function<void()>& check) const;

private:
    int tile_width_, tile_height_, columns_, lines_;
};

/// Why pictures cannot be drawn on this machine; empty: they can.
std::string why_no_pictures();

}  // namespace weft::lab
