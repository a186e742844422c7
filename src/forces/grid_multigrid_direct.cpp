#include "forces/grid_multigrid_direct.h"

#include <algorithm>

namespace weft {

namespace {

double component(const Vec3d& v, std::size_t c) {
    return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

}  // namespace

MultigridDirect::MultigridDirect(const MultigridLevel& level)
    : length_(std::max(level.columns(), level.rows())),
      width_(std::min(level.columns(), level.rows())),
      matrix_(3 * length_ * width_, 3 * reach * width_ + 2),
      vector_(matrix_.size()) {
    const bool wide = level.columns() == length_;
    for (std::size_t along = 0; along < length_; ++along) {
        for (std::size_t across = 0; across < width_; ++across) {
            const std::size_t slot = wide ? level.slot(along, across) : level.slot(across, along);
            nodes_.push_back({slot, 3 * nodes_.size()});
        }
    }
}

// Multiplies by the sums of unit vectors so far apart that their products do not meet.
void MultigridDirect::factor(MultigridLevel& level) {
    matrix_.set_zero();
    for (const Node& node : nodes_) {
        if (level.free()[node.slot] > 0) continue;
        for (std::size_t c = 0; c < 3; ++c) matrix_.entry(node.place + c, node.place + c) = 1.0;
    }
    level.u.fill_zero();
    for (std::size_t along = 0; along < std::min(apart, length_); ++along) {
        for (std::size_t across = 0; across < width_; ++across) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3<float> unit{c == 0 ? 1.0f : 0.0f, c == 1 ? 1.0f : 0.0f,
                                       c == 2 ? 1.0f : 0.0f};
                for (std::size_t a = along; a < length_; a += apart) {
                    const std::size_t slot = nodes_[a * width_ + across].slot;
                    level.u.set(slot, level.free()[slot] > 0 ? unit : Vec3<float>{});
                }
                level.multiply(level.u, level.b);
                take_columns(level, along, across, c);
            }
            for (std::size_t a = along; a < length_; a += apart) {
                level.u.set(nodes_[a * width_ + across].slot, {});
            }
        }
    }
    valid_ = matrix_.factor();
}

// Reads the columns of one component of the nodes (along + n apart, across) from their product.
void MultigridDirect::take_columns(const MultigridLevel& level, std::size_t along,
                                   std::size_t across, std::size_t c) {
    for (std::size_t a = along; a < length_; a += apart) {
        const Node& from = nodes_[a * width_ + across];
        if (!(level.free()[from.slot] > 0)) continue;
        const std::size_t column = from.place + c;
        const std::size_t last = std::min((a + reach + 1) * width_, nodes_.size());
        for (std::size_t n = a * width_ + across; n < last; ++n) {
            const Vec3d product = vec3_cast<double>(level.b[nodes_[n].slot]);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t row = nodes_[n].place + k;
                const bool inside = row >= column && row - column <= 3 * reach * width_ + 2;
                if (inside) matrix_.entry(row, column) = component(product, k);
            }
        }
    }
}

double MultigridDirect::solve(MultigridLevel& level) {
    for (const Node& node : nodes_) {
        const bool free = level.free()[node.slot] > 0;
        const Vec3d b = free ? vec3_cast<double>(level.b[node.slot]) : Vec3d{};
        for (std::size_t c = 0; c < 3; ++c) vector_[node.place + c] = component(b, c);
    }
    matrix_.solve(vector_);
    double product = 0.0;
    for (const Node& node : nodes_) {
        const double* const v = &vector_[node.place];
        const Vec3<float> u = vec3_cast<float>(Vec3d{v[0], v[1], v[2]});
        level.u.set(node.slot, u);
        product += dot(vec3_cast<double>(level.b[node.slot]), vec3_cast<double>(u));
    }
    return product;
}

}  // namespace weft
