#include "lab/stability/spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "forces/linear_kernel.h"
#include "math/largest_eigenvalue.h"
#include "math/random.h"

namespace weft::lab {

namespace {

using Vector = Vec3Array<double>;

constexpr double memory = 128e6;  // of the Krylov vectors [bytes]

void add(Vector& out, double factor, const Vector& in) {
    double* to = out.data();
    const double* from = in.data();
    for (std::size_t n = 0; n < out.data_size(); ++n) to[n] += factor * from[n];
}

void scale(Vector& vector, double factor) {
    for (std::size_t n = 0; n < vector.data_size(); ++n) vector.data()[n] *= factor;
}

// Krylov vectors and the tridiagonal matrix that the stiffness is in them.
class Lanczos {
public:
    Lanczos(const ClothModel& cloth, LinearKernel<double>& kernel)
        : cloth_(cloth), kernel_(kernel) {}

    /// @return whether it ended by itself.
    bool run(std::size_t count, const Watch& watch) {
        vectors_.push_back(noise());
        Vector image(cloth_.layout.slot_count());
        double largest = 0.0;
        while (true) {
            watch();
            const Vector& last = vectors_.back();
            diagonal_.push_back(
                kernel_.multiply(LinearMatrix::stiffness, 1.0, last.view(), image.view()).in_out);
            // Twice: what the first pass leaves of rounding, the second takes away.
            for (int pass = 0; pass < 2; ++pass) {
                for (const Vector& vector : vectors_)
                    add(image, -dot_product(image, vector), vector);
            }
            const double length = std::sqrt(dot_product(image, image));
            largest = std::max({largest, diagonal_.back(), length});
            if (!(length > 1e-9 * largest)) return true;
            if (vectors_.size() == count) return false;
            off_diagonal_.push_back(length);
            scale(image, 1.0 / length);
            vectors_.push_back(image);
        }
    }

    std::vector<Mode> modes(const Watch& watch) {
        const auto size = static_cast<Eigen::Index>(diagonal_.size());
        const Eigen::Map<const Eigen::VectorXd> diagonal(diagonal_.data(), size),
            off_diagonal(off_diagonal_.data(), size - 1);
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal, off_diagonal);
        // At the very end rounding may find the drifting modes, of no frequency, once more.
        const double same = 1e-12 * solver.eigenvalues()(size - 1);
        std::vector<Mode> modes;
        for (Eigen::Index n = 0; n < size; ++n) {
            watch();
            if (n > 0 && solver.eigenvalues()(n) - solver.eigenvalues()(n - 1) < same) continue;
            modes.push_back({std::sqrt(std::max(solver.eigenvalues()(n), 0.0)),
                             damping_rate(solver.eigenvectors().col(n))});
        }
        return modes;
    }

private:
    // Pinned particles do not move.
    [[nodiscard]] Vector noise() const {
        Vector vector(cloth_.layout.slot_count());
        cloth_.layout.for_each([&](std::size_t p, std::size_t slot) {
            if (!(kernel_.root_inverse_masses()[slot] > 0.0)) return;
            const auto part = [&](std::uint64_t n) { return 2.0 * random_uniform(11, n, p) - 1.0; };
            vector.set(slot, {part(0), part(1), part(2)});
        });
        const double length = std::sqrt(dot_product(vector, vector));
        if (length > 0.0) scale(vector, 1.0 / length);
        return vector;
    }

    // u^T C u of the Ritz vector.
    double damping_rate(const Eigen::VectorXd& weights) {
        Vector vector(cloth_.layout.slot_count()), image(cloth_.layout.slot_count());
        for (std::size_t n = 0; n < vectors_.size(); ++n) {
            add(vector, weights(static_cast<Eigen::Index>(n)), vectors_[n]);
        }
        const LinearSums sums = kernel_.multiply(LinearMatrix::damping, 1.0,
                                                 std::as_const(vector).view(), image.view());
        return std::max(sums.in_out, 0.0);
    }

    const ClothModel& cloth_;
    LinearKernel<double>& kernel_;
    std::vector<Vector> vectors_;
    std::vector<double> diagonal_, off_diagonal_;
};

}  // namespace

Spectrum ritz_spectrum(const Specimen& specimen, const ParticleState<double>& state,
                       std::size_t count, const Watch& watch) {
    const ClothModel& cloth = specimen.cloth();
    if (cloth.pins.size() == cloth.particle_count) return {{}, true};
    LinearKernel<double> kernel(cloth, specimen.scene().forces, chosen_instruction_set(), 1);
    kernel.linearise_at(state.x.view());
    const double vector_size = sizeof(double) * 3.0 * static_cast<double>(state.x.size());
    const auto room = static_cast<std::size_t>(std::max(memory / vector_size, 4.0));
    Lanczos process(cloth, kernel);
    Spectrum spectrum;
    spectrum.complete = process.run(std::max<std::size_t>(std::min(count, room), 1), watch);
    spectrum.modes = process.modes(watch);
    return spectrum;
}

}  // namespace weft::lab
