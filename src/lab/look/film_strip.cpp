#include "lab/look/film_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lab/look/picture_text.h"
#include "render/camera.h"
#include "render/stage.h"
#include "weft/error.h"

namespace weft::lab {

namespace {

constexpr Colour paper{255, 255, 255}, ink{20, 24, 31}, empty{226, 229, 234};
constexpr Colour alarm{178, 24, 43};        // dark red, that shows on all of them
constexpr int gap = 4;                      // between tiles [pixels]
constexpr int scale = 2;                    // of letters
constexpr int line = 22;                    // of text, with air [pixels]
constexpr std::size_t most_points = 20000;  // that a camera is fitted to

std::string failed_text(const LookFlight& flight) {
    return fmt::format("{} {:.3g} s", flight.failure == blown_up ? blown_up : "stopped",
                       *flight.failed);
}

// The lowest and highest particle along each axis: what a coarse choice of particles may miss.
std::array<Vec3d, 6> extremes_of(const Shape& shape) {
    std::array<Vec3d, 6> extremes{};
    extremes.fill(shape.front());
    for (const Vec3d& x : shape) {
        if (x.x < extremes[0].x) extremes[0] = x;
        if (x.x > extremes[1].x) extremes[1] = x;
        if (x.y < extremes[2].y) extremes[2] = x;
        if (x.y > extremes[3].y) extremes[3] = x;
        if (x.z < extremes[4].z) extremes[4] = x;
        if (x.z > extremes[5].z) extremes[5] = x;
    }
    return extremes;
}

// In the middle of the tile's lower end, on a band of its own.
void write_below(Image& tile, const std::string& text, Colour colour) {
    const int size = text_width(text, scale) + 8 <= tile.width ? scale : 1;
    const int height = text_height(size);
    fill_rectangle(tile, 0, tile.height - height - 6, tile.width, height + 6, paper);
    draw_text(tile, (tile.width - text_width(text, size)) / 2, tile.height - height - 1, text,
              colour, size);
}

}  // namespace

RenderDescription with_common_camera(const Surface& surface, const RenderDescription& render,
                                     const Shape& start, std::span<const StripRow> rows) {
    if (render.camera) return render;
    std::size_t count = start.size();
    for (const StripRow& row : rows) {
        if (!row.flight->failed) count += start.size() * row.flight->shapes.size();
    }
    const std::size_t every = count / most_points + 1;
    Stage stage = plan_stage(surface, start, render);
    stage.view.clear();
    const auto add = [&](const Shape& shape) {
        for (std::size_t p = 0; p < shape.size(); p += every) {
            stage.view.push_back(to_glm(shape[p]));
        }
        for (const Vec3d& extreme : extremes_of(shape)) stage.view.push_back(to_glm(extreme));
    };
    add(start);
    for (const StripRow& row : rows) {
        if (row.flight->failed) continue;
        for (const Shape& shape : row.flight->shapes) add(shape);
    }
    if (stage.mast && !stage.mast->level) stage.view.push_back(stage.mast->top);
    const Camera camera = choose_camera(stage, render);
    const auto point = [](const glm::vec3& p) { return Vec3d{p.x, p.y, p.z}; };
    RenderDescription fixed = render;
    fixed.camera = point(camera.eye);
    fixed.target = point(camera.target);
    return fixed;
}

TilePainter::TilePainter(const Surface& surface, const RenderDescription& render,
                         const Shape& start)
    : surface_(surface),
      width_(render.size[0]),
      height_(render.size[1]),
      renderer_(surface, render),
      normals_(surface.particle_count) {
    compute_normals(surface_, start, normals_);
    renderer_.set_first_frame({0, 0.0, start, {}, normals_});
}

Image TilePainter::draw(const Shape& shape) {
    compute_normals(surface_, shape, normals_);
    return renderer_.draw({0, 0.0, shape, {}, normals_});
}

Image TilePainter::paint(const LookFlight& flight, std::size_t shape, bool newly) {
    if (shape < flight.shapes.size()) return draw(flight.shapes[shape]);
    const bool shown = newly && !flight.last.empty();
    Image tile = shown ? draw(flight.last) : blank_image(width_, height_, empty);
    if (flight.failed) write_below(tile, failed_text(flight), alarm);
    if (shown) draw_border(tile, 3, alarm);
    return tile;
}

Image paint_strip(TilePainter& painter, std::span<const StripRow> rows,
                  std::span<const StripColumn> columns, const std::function<void()>& check) {
    const int width = painter.width() + gap, height = painter.height() + line + gap;
    Image strip = blank_image(static_cast<int>(columns.size()) * width + gap,
                              static_cast<int>(rows.size()) * height + line + gap, paper);
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const int middle = gap + static_cast<int>(c) * width + painter.width() / 2;
        draw_text(strip, middle - text_width(columns[c].title, scale) / 2, 4, columns[c].title, ink,
                  scale);
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const int top = line + static_cast<int>(r) * height;
        draw_text(strip, gap, top + 4, rows[r].title, rows[r].flight->failed ? alarm : ink, scale);
        bool newly = true;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            check();
            const LookFlight& flight = *rows[r].flight;
            paste(strip, painter.paint(flight, columns[c].shape, newly),
                  gap + static_cast<int>(c) * width, top + line);
            if (columns[c].shape >= flight.shapes.size()) newly = false;
        }
    }
    return strip;
}

TileGrid::TileGrid(int tile_width, int tile_height, std::size_t tiles)
    : tile_width_(tile_width), tile_height_(tile_height) {
    columns_ = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles)))));
    lines_ = std::max(1, (static_cast<int>(tiles) + columns_ - 1) / columns_);
}

int TileGrid::width() const {
    return (columns_ * tile_width_ + 1) / 2 * 2;
}

int TileGrid::height() const {
    return (lines_ * (tile_height_ + line) + 1) / 2 * 2;
}

Image TileGrid::paint(TilePainter& painter, std::span<const StripRow> rows, std::size_t shape,
                      const std::function<void()>& check) const {
    Image picture = blank_image(width(), height(), paper);
    int size = scale;
    for (const StripRow& row : rows) {
        if (text_width(row.title, scale) + 8 > tile_width_) size = 1;
    }
    for (std::size_t n = 0; n < rows.size(); ++n) {
        check();
        const int x = static_cast<int>(n) % columns_ * tile_width_;
        const int y = static_cast<int>(n) / columns_ * (tile_height_ + line);
        const bool over = shape >= rows[n].flight->shapes.size();
        draw_text(picture, x + 4, y + 4, rows[n].title, over ? alarm : ink, size);
        paste(picture, painter.paint(*rows[n].flight, shape, true), x, y + line);
    }
    return picture;
}

std::string why_no_pictures() {
    try {
        const GlContext context;
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace weft::lab
