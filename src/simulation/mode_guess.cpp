#include "simulation/mode_guess.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "math/parallel.h"
#include "math/random.h"

namespace weft {

namespace {

// A family's spring as the wave sees it: k n n^T, and what it joins.
struct WaveSpring {
    double columns = 0.0, rows = 0.0;  // from one end to the other
    Eigen::Matrix3d stiffness;
};

std::vector<WaveSpring> wave_springs(const ClothModel& grid) {
    const GridShape& shape = grid.shape;
    std::vector<WaveSpring> springs;
    for (const GridSpringFamily& family : grid.families) {
        if (family.owner_columns == 0 || family.owner_rows == 0) continue;
        const Vec3d d = grid.rest_position(shape.index(family.bi, family.bj)) -
                        grid.rest_position(shape.index(family.ai, 0));
        const Eigen::Vector3d n = Eigen::Vector3d{d.x, d.y, d.z}.normalized();
        const double k =
            grid.materials[static_cast<std::size_t>(family.kind)].stiffness * family.factor;
        springs.push_back({static_cast<double>(family.bi) - static_cast<double>(family.ai),
                           static_cast<double>(family.bj), k * n * n.transpose()});
    }
    return springs;
}

// Three numbers in [-1, 1) from the bits of one random number.
Vec3d noise(std::size_t particle) {
    const std::uint64_t bits = mix_bits(particle);
    constexpr std::uint64_t mask = (1u << 21) - 1;
    const auto part = [&](int shift) {
        return static_cast<double>((bits >> shift) & mask) * 0x1.0p-20 - 1.0;
    };
    return {part(0), part(21), part(42)};
}

// What belongs to one column, or to one row.
struct LineFactors {
    double cosine = 0.0, sine = 0.0;  // of the wave's phase
    double envelope = 0.0;            // of the wave
    double noise = 1.0;

    LineFactors(double phase, std::size_t n, std::size_t count) {
        const auto at = static_cast<double>(n), size = static_cast<double>(count);
        cosine = std::cos(phase * at);
        sine = std::sin(phase * at);
        envelope = std::sin(std::numbers::pi * (at + 1) / (size + 1));
        if (n == 0 || n + 1 == count) noise = std::max(1.0, std::sqrt(size / 2));
    }
};

std::vector<LineFactors> line_factors(double phase, std::size_t count) {
    std::vector<LineFactors> lines;
    lines.reserve(count);
    for (std::size_t n = 0; n < count; ++n) lines.emplace_back(phase, n, count);
    return lines;
}

template <typename Real>
void guess_on_grid(const ClothModel& cloth, const std::vector<Real>& root_inverse_masses,
                   Vec3Array<Real>& vector) {
    constexpr double wave_part = 3.0, noise_part = 0.5;
    constexpr std::size_t row_grain = 64;
    const PlaneWave wave = fastest_wave(cloth);
    const Vec3d direction = wave_part * wave.direction;
    const auto columns = line_factors(wave.along_row, cloth.shape.columns);
    const auto rows = line_factors(wave.along_column, cloth.shape.rows);
    const Vec3View<Real> view = vector.view();
    parallel_for(rows.size(), row_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            const LineFactors& row = rows[j];
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const std::size_t slot = j * cloth.layout.row_stride() + i;
                const LineFactors& column = columns[i];
                const double height = (column.cosine * row.cosine - column.sine * row.sine) *
                                      (column.envelope * row.envelope);
                const Vec3d sum = height * direction + (noise_part * column.noise * row.noise) *
                                                           noise(cloth.shape.index(i, j));
                view.set(slot, root_inverse_masses[slot] > 0 ? vec3_cast<Real>(sum) : Vec3<Real>{});
            }
        }
    });
}

}  // namespace

PlaneWave fastest_wave(const ClothModel& grid) {
    constexpr int samples =
        24;  // of a phase, which then is right to a part of 1/24 of pi or better
    const std::vector<WaveSpring> springs = wave_springs(grid);
    PlaneWave best;
    double largest = -1.0;
    for (int column = 0; column <= samples; ++column) {
        for (int row = 0; row <= samples; ++row) {
            const double a = std::numbers::pi * row / samples;
            const double b = std::numbers::pi * column / samples;
            Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
            for (const WaveSpring& spring : springs) {
                matrix +=
                    2 * (1 - std::cos(a * spring.columns + b * spring.rows)) * spring.stiffness;
            }
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
            solver.computeDirect(matrix);
            const double value = solver.eigenvalues()(2);
            if (!(value > largest * (1 + 1e-9))) continue;
            largest = value;
            const Eigen::Vector3d d = solver.eigenvectors().col(2);
            best = {a, b, {d(0), d(1), d(2)}};
        }
    }
    return best;
}

template <typename Real>
void guess_fastest_mode(const ClothModel& cloth, const std::vector<Real>& root_inverse_masses,
                        Vec3Array<Real>& vector) {
    if (cloth.is_grid()) return guess_on_grid(cloth, root_inverse_masses, vector);
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        if (root_inverse_masses[slot] > 0) vector.set(slot, vec3_cast<Real>(noise(p)));
    });
}

template <typename Real>
void disturb_mode(const ClothModel& cloth, const std::vector<Real>& root_inverse_masses,
                  Vec3Array<Real>& vector) {
    const double part = 0.3 / std::sqrt(static_cast<double>(cloth.particle_count));
    const Vec3View<Real> view = vector.view();
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        if (root_inverse_masses[slot] > 0) view.add(slot, vec3_cast<Real>(part * noise(p)));
    });
}

template void disturb_mode(const ClothModel&, const std::vector<float>&, Vec3Array<float>&);
template void disturb_mode(const ClothModel&, const std::vector<double>&, Vec3Array<double>&);
template void guess_fastest_mode(const ClothModel&, const std::vector<float>&, Vec3Array<float>&);
template void guess_fastest_mode(const ClothModel&, const std::vector<double>&, Vec3Array<double>&);

}  // namespace weft
