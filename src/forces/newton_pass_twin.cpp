// The kernels of forces/newton_pass.h written to be read, particle by particle; the vector kernels
// are held against them.
#include <algorithm>
#include <cmath>

#include "forces/newton_pass.h"

namespace weft {

namespace {

using Field = NewtonKernels::Field;
using ConstField = NewtonKernels::ConstField;
using Block = std::array<float, 6>;  // xx, xy, xz, yy, yz, zz

// Where a family's springs begin and end, seen from their owner, as GridSpringFamily.
struct Ends {
    std::size_t ai, bi, bj;
};
constexpr std::array<Ends, grid_family_count> family_ends{
    {{0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {0, 2, 0}, {0, 0, 2}}};

// A spring's matrix: across I + along dx dx^T.
struct SpringMatrix {
    float across = 0, along = 0;
    Vec3<float> dx{};
};

SpringMatrix spring_matrix(const NewtonGrid& grid, std::size_t family, std::size_t i,
                           std::size_t j) {
    const Ends& ends = family_ends[family];
    const std::size_t a = j * grid.stride + i + ends.ai;
    const std::size_t b = (j + ends.bj) * grid.stride + i + ends.bi;
    const Vec3<float> dx = grid.x[b] - grid.x[a];
    const float squared = dot(dx, dx);
    if (!(squared > 0)) return {};
    const NewtonSpring& spring = grid.row_constants[grid.row_kind(j)].edge[family];
    const float factor = grid.column_factors[family][i];
    const float slack = std::min(1.0f, spring.rest_length / std::sqrt(squared));
    return {factor * spring.stiffness * (1 - slack),
            factor * (spring.stiffness * slack + spring.damping * grid.inverse_tau) / squared, dx};
}

// Calls visit(spring's matrix, slot of its other end) for every spring of particle (i, j).
template <typename Visit>
void for_each_spring(const NewtonGrid& grid, std::size_t i, std::size_t j, const Visit& visit) {
    for (std::size_t family = 0; family < grid_family_count; ++family) {
        const auto [ai, bi, bj] = family_ends[family];
        const std::size_t width = std::max(ai, bi);
        const auto visit_owned = [&](std::size_t owner, std::size_t row, std::size_t di,
                                     std::size_t dj) {
            if (owner + width >= grid.columns || row + bj >= grid.rows) return;
            visit(spring_matrix(grid, family, owner, row), (row + dj) * grid.stride + owner + di);
        };
        if (i >= ai) visit_owned(i - ai, j, bi, bj);
        if (i >= bi && j >= bj) visit_owned(i - bi, j - bj, ai, 0);
    }
}

// Calls visit(i, j, slot) for the particles of a band.
template <typename Visit>
void for_each_particle(const NewtonGrid& grid, const NewtonBand& band, const Visit& visit) {
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        for (std::size_t i = 0; i < grid.columns; ++i) visit(i, j, j * grid.stride + i);
    }
}

Block block_at(const NewtonGrid& grid, std::size_t slot) {
    const float xx = grid.blocks[0][slot];
    if (grid.isotropic) return {xx, 0, 0, xx, 0, xx};
    Block block;
    for (std::size_t n = 0; n < block.size(); ++n) block[n] = grid.blocks[n][slot];
    return block;
}

Vec3<float> times(const Block& b, Vec3<float> u) {
    return {b[0] * u.x + b[1] * u.y + b[2] * u.z, b[1] * u.x + b[3] * u.y + b[4] * u.z,
            b[2] * u.x + b[4] * u.y + b[5] * u.z};
}

// (A u) of one particle; zero where it is pinned.
Vec3<float> product_at(const NewtonGrid& grid, ConstField u, std::size_t i, std::size_t j) {
    const std::size_t slot = j * grid.stride + i;
    if (!(grid.blocks[0][slot] > 0)) return {};
    Vec3<float> sum = times(block_at(grid, slot), u[slot]);
    for_each_spring(grid, i, j, [&](const SpringMatrix& spring, std::size_t other) {
        const Vec3<float> du = u[slot] - u[other];
        sum += spring.across * du + (spring.along * dot(spring.dx, du)) * spring.dx;
    });
    return sum;
}

Vec3<float> residual_at(const NewtonGrid& grid, ConstField u, ConstField b, std::size_t i,
                        std::size_t j) {
    const std::size_t slot = j * grid.stride + i;
    if (!(grid.blocks[0][slot] > 0)) return {};
    return b[slot] - product_at(grid, u, i, j);
}

// L diag(d) L^T of a block; no pivot less than `least`.
Block factors_of(const Block& a, float least) {
    const auto inverse = [least](float pivot) { return 1 / std::max(pivot, least); };
    const float i0 = inverse(a[0]), l10 = a[1] * i0, l20 = a[2] * i0;
    const float i1 = inverse(a[3] - l10 * a[1]);
    const float t = a[4] - l20 * a[1], l21 = t * i1;
    const float i2 = inverse(a[5] - l20 * a[2] - l21 * t);
    return {i0, i1, i2, l10, l20, l21};
}

// D^-1 r
Vec3<float> solve_block(const NewtonGrid& grid, std::size_t slot, Vec3<float> r) {
    const auto factor = [&](std::size_t n) { return grid.factors[n][slot]; };
    const float l10 = factor(3), l20 = factor(4), l21 = factor(5);
    const float y1 = r.y - l10 * r.x, y2 = r.z - l20 * r.x - l21 * y1;
    const float z2 = factor(2) * y2, z1 = factor(1) * y1 - l21 * z2;
    return {factor(0) * r.x - l10 * z1 - l20 * z2, z1, z2};
}

void factor(const NewtonGrid& grid, const NewtonBand& band) {
    for_each_particle(grid, band, [&](std::size_t i, std::size_t j, std::size_t slot) {
        Block sum = block_at(grid, slot);
        const float least = std::min({sum[0], sum[3], sum[5]});
        for_each_spring(grid, i, j, [&](const SpringMatrix& spring, std::size_t) {
            const Vec3<float> dx = spring.dx, along = spring.along * dx;
            const Block added{
                along.x * dx.x + spring.across, along.x * dx.y, along.x * dx.z,
                along.y * dx.y + spring.across, along.y * dx.z, along.z * dx.z + spring.across};
            for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += added[n];
        });
        const Block factors = least > 0 ? factors_of(sum, least) : Block{};
        for (std::size_t n = 0; n < factors.size(); ++n) grid.factors[n][slot] = factors[n];
    });
}

void product(const NewtonGrid& grid, const NewtonBand& band, ConstField u, Field out,
             double* sums) {
    std::fill(sums + band.row_begin, sums + band.row_end, 0.0);
    for_each_particle(grid, band, [&](std::size_t i, std::size_t j, std::size_t slot) {
        const Vec3<float> value = product_at(grid, u, i, j);
        out.set(slot, value);
        sums[j] += static_cast<double>(dot(u[slot], value));
    });
}

void residual(const NewtonGrid& grid, const NewtonBand& band, ConstField u, ConstField b,
              Field out) {
    for_each_particle(grid, band, [&](std::size_t i, std::size_t j, std::size_t slot) {
        out.set(slot, residual_at(grid, u, b, i, j));
    });
}

void smooth(const NewtonGrid& grid, const NewtonBand& band, float omega, ConstField u, ConstField b,
            Field out, double* sums) {
    std::fill(sums + band.row_begin, sums + band.row_end, 0.0);
    for_each_particle(grid, band, [&](std::size_t i, std::size_t j, std::size_t slot) {
        const Vec3<float> z = solve_block(grid, slot, residual_at(grid, u, b, i, j));
        const Vec3<float> value = u[slot] + omega * z;
        out.set(slot, value);
        sums[j] += static_cast<double>(dot(b[slot], value));
    });
}

void start(const NewtonGrid& grid, const NewtonBand& band, float omega, ConstField b, Field out) {
    for_each_particle(grid, band, [&](std::size_t, std::size_t, std::size_t slot) {
        out.set(slot, omega * solve_block(grid, slot, b[slot]));
    });
}

void coarsen(const NewtonTransfer& transfer, const NewtonBand& band, const float* fine,
             float* coarse) {
    const NewtonTransferAxis &across = transfer.across, &down = transfer.down;
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        for (std::size_t i = 0; i < across.coarse; ++i) {
            float sum = 0;
            for (std::size_t m = 0; m < NewtonTransferAxis::taps; ++m) {
                for (std::size_t n = 0; n < NewtonTransferAxis::taps; ++n) {
                    const float weight = down.taken[m][j] * across.taken[n][i];
                    const std::size_t row = static_cast<std::size_t>(down.first[j]) + m;
                    const std::size_t column = static_cast<std::size_t>(across.first[i]) + n;
                    if (weight != 0) sum += weight * fine[row * transfer.fine_stride + column];
                }
            }
            coarse[j * transfer.coarse_stride + i] = sum;
        }
    }
}

void interpolate(const NewtonTransfer& transfer, const NewtonBand& band, const float* coarse,
                 const float* blocks, float* fine) {
    for (std::size_t j = band.row_begin; j < band.row_end; ++j) {
        const auto row = static_cast<std::size_t>(transfer.down.left[j]);
        const float down = transfer.down.weight[j];
        for (std::size_t i = 0; i < transfer.across.fine; ++i) {
            const std::size_t slot = j * transfer.fine_stride + i;
            if (!(blocks[slot] > 0)) continue;
            const auto column = static_cast<std::size_t>(transfer.across.left[i]);
            const float across = transfer.across.weight[i];
            const auto in_row = [&](std::size_t r) {
                const float* const at = coarse + r * transfer.coarse_stride + column;
                return across == 0 ? at[0] : at[0] + across * (at[1] - at[0]);
            };
            const float above = in_row(row);
            fine[slot] += down == 0 ? above : above + down * (in_row(row + 1) - above);
        }
    }
}

double narrow(double scale, const double* from, const float* blocks, float* to, std::size_t begin,
              std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
        to[i] = blocks[i] > 0 ? static_cast<float>(scale * from[i]) : 0.0f;
        sum += static_cast<double>(to[i]) * static_cast<double>(to[i]);
    }
    return sum;
}

double advance(float alpha, const float* p, const float* q, float* x, float* r, std::size_t begin,
               std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
        x[i] += alpha * p[i];
        r[i] -= alpha * q[i];
        sum += static_cast<double>(r[i]) * static_cast<double>(r[i]);
    }
    return sum;
}

void turn(float beta, const float* z, float* p, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + beta * p[i];
}

}  // namespace

const NewtonKernels newton_twins{factor,  product,     residual, smooth,  start,
                                 coarsen, interpolate, narrow,   advance, turn};

}  // namespace weft
