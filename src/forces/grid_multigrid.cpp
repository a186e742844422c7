#include "forces/grid_multigrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "forces/grid_multigrid_cycle.h"
#include "math/parallel.h"

namespace weft {

namespace {

// Vector operations are shared, and their sums formed, in pieces of so many elements.
constexpr std::size_t piece = 8192;
constexpr std::size_t pieces_a_thread = 4;

// Between these norms of r squares neither over- nor underflow in float; else r is scaled first.
constexpr double least_norm = 1e-6, largest_norm = 1e9;

// The largest |component| of r where `free` is not zero; not finite if one of them is not.
double largest_component(ConstVec3View<double> r, const float* free) {
    double largest = 0.0;
    for (std::size_t s = 0; s < r.size; ++s) {
        if (!(free[s] > 0)) continue;
        const Vec3d v = r[s];
        if (!std::isfinite(v.x + v.y + v.z)) return std::numeric_limits<double>::quiet_NaN();
        largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
    return largest;
}

class GridMultigrid final : public NewtonMatrixSolver {
public:
    GridMultigrid(const ClothModel& cloth, InstructionSet set, int threads)
        : kernels_(newton_kernels(set)),
          cycle_(cloth, kernels_, threads),
          d_(cloth.layout.slot_count()),
          p_(d_.size()),
          q_(d_.size()),
          sums_(d_.data_size() / piece + 1) {}

    void linearise(ConstVec3View<double> x, double inverse_tau,
                   const SymmetricBlocks<double>& blocks) override {
        cycle_.linearise(x, inverse_tau, blocks);
    }
    LinearReport solve(ConstVec3View<double> r, double tolerance, int max_iterations,
                       Vec3View<double> d) override;
    [[nodiscard]] std::string_view name() const override { return "multigrid"; }

private:
    template <typename Body>
    double sum_over(std::size_t size, const Body& body);
    double take(ConstVec3View<double> r, double scale);
    void give(double scale, Vec3View<double> d);
    LinearReport iterate(double norm, double tolerance, int max_iterations);

    const NewtonKernels& kernels_;
    MultigridCycle cycle_;
    Vec3Array<float> d_, p_, q_;  // solution, direction, A p; the residual is the finest level's b
    std::vector<double> sums_;    // [piece]
};

// The sum of body(begin, end) over the pieces of [0, size), in their order.
template <typename Body>
double GridMultigrid::sum_over(std::size_t size, const Body& body) {
    const std::size_t pieces = (size + piece - 1) / piece;
    parallel_for(pieces, pieces_a_thread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            sums_[n] = body(n * piece, std::min((n + 1) * piece, size));
        }
    });
    double sum = 0.0;
    for (std::size_t n = 0; n < pieces; ++n) sum += sums_[n];
    return sum;
}

// Puts scale r on the finest level; returns its norm.
double GridMultigrid::take(ConstVec3View<double> r, double scale) {
    MultigridLevel& level = cycle_.finest();
    const Vec3View<float> b = level.b.view();
    return std::sqrt(sum_over(r.size, [&](std::size_t begin, std::size_t end) {
        double sum = kernels_.narrow(scale, r.x, level.free(), b.x, begin, end);
        sum += kernels_.narrow(scale, r.y, level.free(), b.y, begin, end);
        return sum + kernels_.narrow(scale, r.z, level.free(), b.z, begin, end);
    }));
}

void GridMultigrid::give(double scale, Vec3View<double> d) {
    const ConstVec3View<float> from = std::as_const(d_).view();
    parallel_for(d.size, piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) d.x[s] = scale * static_cast<double>(from.x[s]);
        for (std::size_t s = begin; s < end; ++s) d.y[s] = scale * static_cast<double>(from.y[s]);
        for (std::size_t s = begin; s < end; ++s) d.z[s] = scale * static_cast<double>(from.z[s]);
    });
}

// Conjugate gradients for A d = b, where b becomes the residual.
LinearReport GridMultigrid::iterate(double norm, double tolerance, int max_iterations) {
    MultigridLevel& level = cycle_.finest();
    const std::size_t size = d_.data_size();
    LinearReport report{0, 1.0, tolerance >= 1.0};
    d_.fill_zero();
    if (report.converged || max_iterations < 1) return report;
    double rz = cycle_.apply();
    p_ = level.u;
    while (true) {
        const double alpha = rz / level.multiply(p_, q_);
        if (!(alpha > 0.0) || !std::isfinite(alpha)) break;
        const double square = sum_over(size, [&](std::size_t begin, std::size_t end) {
            return kernels_.advance(static_cast<float>(alpha), p_.data(), q_.data(), d_.data(),
                                    level.b.data(), begin, end);
        });
        report.residual = std::sqrt(square) / norm;
        report.converged = report.residual <= tolerance;
        if (++report.iterations == max_iterations || report.converged) break;
        const double next = cycle_.apply();
        const auto beta = static_cast<float>(next / rz);
        rz = next;
        parallel_for(size / piece + 1, pieces_a_thread, [&](std::size_t begin, std::size_t end) {
            kernels_.turn(beta, level.u.data(), p_.data(), begin * piece,
                          std::min(end * piece, size));
        });
    }
    return report;
}

LinearReport GridMultigrid::solve(ConstVec3View<double> r, double tolerance, int max_iterations,
                                  Vec3View<double> d) {
    double scale = 1.0, norm = take(r, scale);
    if (!(norm > least_norm && norm < largest_norm)) {
        const double largest = largest_component(r, cycle_.finest().free());
        scale = 1.0 / std::max(largest, 1e-300);
        norm = std::isfinite(largest) ? take(r, scale) : 0.0;
        if (norm == 0.0) {
            d_.fill_zero();
            give(1.0, d);
            return {0, largest, largest == 0.0};
        }
    }
    LinearReport report{0, 1.0, false};
    if (cycle_.valid()) {
        report = iterate(norm, tolerance, max_iterations);
    } else {
        d_.fill_zero();
    }
    give(1.0 / scale, d);
    return report;
}

}  // namespace

std::unique_ptr<NewtonMatrixSolver> make_grid_multigrid(const ClothModel& cloth, InstructionSet set,
                                                        int threads) {
    return std::make_unique<GridMultigrid>(cloth, set, threads);
}

}  // namespace weft
