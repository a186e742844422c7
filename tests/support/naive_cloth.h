// Forces on a grid, written out as PHYSICS describes them: lists and loops, nothing of weft's own
// kernels, spring families or surfaces. Slow, and the yardstick of the fast ones.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "weft/scene.h"

namespace weft::test {

class NaiveCloth {
public:
    struct Spring {
        std::size_t p, q;
        double rest_length, k, c;
        int kind;  ///< 0 structural, 1 shear, 2 bend
    };

    explicit NaiveCloth(const SceneDescription& scene) : scene_(scene) {
        const auto& grid = scene.cloth.grid;
        columns_ = grid.resolution[0];
        rows_ = grid.resolution[1];
        dx_ = grid.size[0] / (columns_ - 1);
        dy_ = grid.size[1] / (rows_ - 1);
        list_springs();
    }

    [[nodiscard]] const std::vector<Spring>& springs() const { return springs_; }

    [[nodiscard]] std::vector<double> masses() const {
        std::vector<double> masses;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                double area = dx_ * dy_;
                if (i == 0 || i == columns_ - 1) area /= 2;
                if (j == 0 || j == rows_ - 1) area /= 2;
                masses.push_back(
                    scene_.material.particle_mass.value_or(scene_.material.mass_per_area * area));
            }
        }
        return masses;
    }

    /// f += (k (l - L) + c (v_q - v_p).u) u on p, the opposite on q.
    void add_springs(const std::vector<Vec3d>& x, const std::vector<Vec3d>& v,
                     std::vector<Vec3d>& f) const {
        for (const Spring& s : springs_) {
            const Vec3d d = x[s.q] - x[s.p];
            const double l = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
            if (l == 0.0) continue;
            const Vec3d u = d / l;
            const double tension = s.k * (l - s.rest_length) + s.c * dot(v[s.q] - v[s.p], u);
            f[s.p] += tension * u;
            f[s.q] += -(tension * u);
        }
    }

    /// f += the flat plate's force of each triangle, a third to each corner.
    void add_air(Vec3d wind, const std::vector<Vec3d>& x, const std::vector<Vec3d>& v,
                 std::vector<Vec3d>& f) const {
        for (int j = 0; j + 1 < rows_; ++j) {
            for (int i = 0; i + 1 < columns_; ++i) {
                const std::size_t a = index(i, j), b = index(i, j + 1), c = index(i + 1, j + 1),
                                  d = index(i + 1, j);
                add_plate(wind, x, v, f, a, b, c);
                add_plate(wind, x, v, f, a, c, d);
            }
        }
    }

private:
    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j * columns_ + i);
    }

    void list_springs() {
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                add(0, i, j, i + 1, j);
                add(0, i, j, i, j + 1);
                add(1, i, j, i + 1, j + 1);
                add(1, i + 1, j, i, j + 1);
                const bool borders = scene_.material.bend_layout == BendLayout::border;
                if (!borders || j == 0 || j == rows_ - 1) add(2, i, j, i + 2, j);
                if (!borders || i == 0 || i == columns_ - 1) add(2, i, j, i, j + 2);
            }
        }
    }

    void add(int kind, int i, int j, int k, int l) {
        if (i >= columns_ || k >= columns_ || j >= rows_ || l >= rows_) return;
        const double across = dx_ * std::abs(k - i), down = dy_ * std::abs(l - j);
        const double length = std::sqrt(across * across + down * down);
        const SpringMaterial& material = kind == 0   ? scene_.material.structural
                                         : kind == 1 ? scene_.material.shear
                                                     : scene_.material.bend;
        double factor = 1.0;
        if (scene_.material.stiffness_per == StiffnessPer::width) {
            // The width of cloth that the spring stands for, over its length.
            if (kind == 1) {
                factor = length * length / (2 * dx_ * dy_);
            } else {
                const bool row = l == j;
                double width = row ? dy_ : dx_;
                if (row && (j == 0 || j == rows_ - 1)) width /= 2;
                if (!row && (i == 0 || i == columns_ - 1)) width /= 2;
                if (kind == 2) width /= 2;  // two of them overlap everywhere
                factor = width / length;
            }
        }
        springs_.push_back({index(i, j), index(k, l), length, factor * material.stiffness,
                            factor * material.damping, kind});
    }

    void add_plate(Vec3d wind, const std::vector<Vec3d>& x, const std::vector<Vec3d>& v,
                   std::vector<Vec3d>& f, std::size_t a, std::size_t b, std::size_t c) const {
        const Vec3d relative = wind - (v[a] + v[b] + v[c]) / 3.0;
        const Vec3d twice = cross(x[b] - x[a], x[c] - x[a]);
        const double area = length(twice) / 2, speed = length(relative);
        if (area == 0.0 || speed == 0.0) return;
        const Vec3d n = twice / (2 * area);
        const double v_n = dot(relative, n);
        const Vec3d v_t = relative - v_n * n;
        const double rho = scene_.wind->air_density;
        const Vec3d force = (scene_.wind->drag * 0.5 * rho * area * speed * speed * v_n /
                             (0.222 * std::abs(v_n) + 0.283 * speed)) *
                                n +
                            (0.5 * rho * 2 * area * scene_.wind->skin_friction * length(v_t)) * v_t;
        for (const std::size_t corner : {a, b, c}) f[corner] += force / 3.0;
    }

    SceneDescription scene_;
    int columns_, rows_;
    double dx_, dy_;
    std::vector<Spring> springs_;
};

}  // namespace weft::test
