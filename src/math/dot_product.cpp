#include "math/dot_product.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t grain = 16384;  // below this, waking a thread costs more than the loop
constexpr std::size_t lanes = 8;      // partial sums, which the compiler may keep in vectors

double dot_of_range(const double* a, const double* b, std::size_t begin, std::size_t end) {
    std::array<double, lanes> sums{};
    std::size_t n = begin;
    for (; n + lanes <= end; n += lanes) {
        for (std::size_t k = 0; k < lanes; ++k) sums[k] += a[n + k] * b[n + k];
    }
    for (; n < end; ++n) sums[0] += a[n] * b[n];
    double sum = 0.0;
    for (const double partial : sums) sum += partial;
    return sum;
}

}  // namespace

double dot(const Vec3Array<double>& a, const Vec3Array<double>& b) {
    constexpr std::size_t most_blocks = 64;
    std::array<double, most_blocks> sums{};
    const std::size_t size = a.data_size();
    const std::size_t block = std::max<std::size_t>((size + most_blocks - 1) / most_blocks, 1024);
    const std::size_t blocks = (size + block - 1) / block;
    parallel_for(blocks, (grain + block - 1) / block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            sums[n] = dot_of_range(a.data(), b.data(), n * block, std::min((n + 1) * block, size));
        }
    });
    double sum = 0.0;
    for (const double partial : sums) sum += partial;
    return sum;
}

}  // namespace weft
