// The readable twins of math/block_pass.cpp.
#include <algorithm>
#include <array>
#include <cmath>

#include "math/block_pass.h"

namespace weft {

namespace {

Vec3f value(const float* values, std::size_t row) {
    const float* const at = values + row / block_lanes * 3 * block_lanes + row % block_lanes;
    return {at[0], at[block_lanes], at[2 * block_lanes]};
}

void set_value(float* values, std::size_t row, Vec3f v) {
    float* const at = values + row / block_lanes * 3 * block_lanes + row % block_lanes;
    at[0] = v.x, at[block_lanes] = v.y, at[2 * block_lanes] = v.z;
}

void set_out(const BlockPass& pass, std::size_t row, Vec3f v) {
    set_value(pass.out, row, v);
    if (pass.out_records == nullptr) return;
    float* const record = pass.out_records + 4 * row;
    record[0] = v.x, record[1] = v.y, record[2] = v.z;
}

Vec3f record(const BlockPass& pass, std::size_t vector, std::size_t row) {
    const float* const at = pass.u_records + pass.columns[vector * block_lanes + row % block_lanes];
    return {at[0], at[1], at[2]};
}

// Numbers of a row's or coupling's group.
template <std::size_t size>
std::array<float, size> numbers(const float* groups, std::size_t group, std::size_t row) {
    std::array<float, size> result{};
    for (std::size_t n = 0; n < size; ++n) {
        result[n] = groups[(group * size + n) * block_lanes + row % block_lanes];
    }
    return result;
}

Vec3f times(const std::array<float, 6>& s, Vec3f u) {
    return {s[0] * u.x + s[1] * u.y + s[2] * u.z, s[1] * u.x + s[3] * u.y + s[4] * u.z,
            s[2] * u.x + s[4] * u.y + s[5] * u.z};
}

// (A u) at a row.
Vec3f row_product(const BlockPass& pass, std::size_t row) {
    const std::size_t slice = row / block_lanes;
    const Vec3f u = value(pass.u, row);
    Vec3f sum = times(numbers<6>(pass.own, slice, row), u);
    for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
        const Vec3f du = u - record(pass, n, row);
        if (pass.form == BlockForm::spring) {
            const auto k = numbers<4>(pass.couplings, n, row);
            const Vec3f g{k[1], k[2], k[3]};
            sum += k[0] * du + dot(g, du) * g;
        } else {
            sum += times(numbers<6>(pass.couplings, n, row), du);
        }
    }
    return sum;
}

// weight W^T W r
Vec3f divided(const BlockPass& pass, std::size_t row, Vec3f r) {
    const auto w = numbers<6>(pass.factors, row / block_lanes, row);
    const Vec3f s{w[0] * r.x, w[1] * r.x + w[3] * r.y, w[2] * r.x + w[4] * r.y + w[5] * r.z};
    return pass.weight *
           Vec3f{w[0] * s.x + w[1] * s.y + w[2] * s.z, w[3] * s.y + w[4] * s.z, w[5] * s.z};
}

// Calls body(row), which returns what it adds to the block's sum.
template <typename Body>
void for_rows(const BlockPass& pass, std::size_t begin, std::size_t end, const Body& body) {
    constexpr std::size_t rows = slices_per_block * block_lanes;
    for (std::size_t block = begin; block < end; ++block) {
        const std::size_t last = std::min((block + 1) * rows, pass.slices * block_lanes);
        double sum = 0.0;
        for (std::size_t row = block * rows; row < last; ++row) sum += body(row);
        if (pass.sums != nullptr) pass.sums[block] = sum;
    }
}

double dot_in_double(Vec3f a, Vec3f b) {
    return dot(vec3_cast<double>(a), vec3_cast<double>(b));
}

void product(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        const Vec3f out = row_product(pass, row);
        set_out(pass, row, out);
        return dot_in_double(value(pass.u, row), out);
    });
}

void residual(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        set_out(pass, row, value(pass.b, row) - row_product(pass, row));
        return 0.0;
    });
}

void smooth(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        const Vec3f b = value(pass.b, row);
        const Vec3f out = value(pass.u, row) + divided(pass, row, b - row_product(pass, row));
        set_out(pass, row, out);
        return dot_in_double(b, out);
    });
}

void precondition(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        const Vec3f b = value(pass.b, row), out = divided(pass, row, b);
        set_out(pass, row, out);
        return dot_in_double(b, out);
    });
}

void advance(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        set_value(pass.out, row, value(pass.out, row) + pass.weight * value(pass.u, row));
        const Vec3f r = value(pass.residual, row) - pass.weight * value(pass.b, row);
        set_value(pass.residual, row, r);
        return dot_in_double(r, r);
    });
}

void direction(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        set_out(pass, row, value(pass.u, row) + pass.weight * value(pass.out, row));
        return 0.0;
    });
}

void transfer(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        const std::size_t slice = row / block_lanes;
        Vec3f sum = pass.u == nullptr ? Vec3f{} : value(pass.u, row);
        for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
            sum += numbers<1>(pass.couplings, n, row)[0] * record(pass, n, row);
        }
        set_out(pass, row, sum);
        return 0.0;
    });
}

// W with W^T W = A^-1, see math/block_factor-inl.h.
std::array<double, 6> inverse_factor(const std::array<double, 6>& a) {
    const double trace = a[0] + a[3] + a[5];
    if (!(trace > 0.0)) return {};
    const auto root = [&](double pivot) { return 1 / std::sqrt(std::max(pivot, 1e-14 * trace)); };
    const double xx = root(a[0]), l_yx = a[1] * xx, l_zx = a[2] * xx;
    const double yy = root(a[3] - l_yx * l_yx), l_zy = (a[4] - l_zx * l_yx) * yy;
    const double zz = root(a[5] - l_zx * l_zx - l_zy * l_zy);
    const double yx = -l_yx * xx * yy;
    return {xx, yx, -(l_zx * xx + l_zy * yx) * zz, yy, -l_zy * yy * zz, zz};
}

void factor_row(const BlockPass& pass, std::size_t row) {
    const std::size_t slice = row / block_lanes;
    std::array<double, 6> sum{};
    for (std::size_t n = pass.starts[slice]; n < pass.starts[slice + 1]; ++n) {
        if (pass.form == BlockForm::spring) {
            const auto k = numbers<4>(pass.couplings, n, row);
            const double a = k[0], x = k[1], y = k[2], z = k[3];
            const double spring[] = {a + x * x, x * y, x * z, a + y * y, y * z, a + z * z};
            for (std::size_t c = 0; c < 6; ++c) sum[c] += spring[c];
        } else {
            const auto k = numbers<6>(pass.couplings, n, row);
            for (std::size_t c = 0; c < 6; ++c) sum[c] += static_cast<double>(k[c]);
        }
    }
    const auto own = numbers<6>(pass.own, slice, row);
    for (std::size_t c = 0; c < 6; ++c) sum[c] += static_cast<double>(own[c]);
    const double shift = static_cast<double>(pass.weight) * (sum[0] + sum[3] + sum[5]);
    float* const own_at = pass.own_out + slice * 6 * block_lanes + row % block_lanes;
    float* const factors = pass.factors_out + slice * 6 * block_lanes + row % block_lanes;
    for (const std::size_t c : {0u, 3u, 5u}) {
        own_at[c * block_lanes] += static_cast<float>(shift);
        sum[c] += shift;
    }
    const std::array<double, 6> w = inverse_factor(sum);
    for (std::size_t c = 0; c < 6; ++c) factors[c * block_lanes] = static_cast<float>(w[c]);
}

void factor(const BlockPass& pass, std::size_t begin, std::size_t end) {
    for_rows(pass, begin, end, [&](std::size_t row) {
        factor_row(pass, row);
        return 0.0;
    });
}

}  // namespace

BlockFunctions plain_block_functions() {
    return {factor, product, residual, smooth, precondition, advance, direction, transfer};
}

}  // namespace weft
