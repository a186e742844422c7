#include "forces/grid_multigrid_level.h"

#include <algorithm>
#include <cmath>

#include "math/parallel.h"

namespace weft {

namespace {

// Particles worth a thread of their own: fewer take as long as waking the thread.
constexpr std::size_t band_grain = 8192;

// A sheet is solved directly once it has no more nodes, or too few columns or rows to halve.
constexpr std::size_t direct_nodes = 30, least_count = 4;

// Coarsening is to weaken the stiffer of two directions, or point by point smoothing would not
// suffice: where springs along rows are this much stiffer than those along columns, only columns
// are halved, and the other way round.
constexpr double uneven = 2.0;

// How many columns and rows the next sheet has.
std::pair<std::size_t, std::size_t> coarser_counts(const MultigridSheet& sheet) {
    const double along_rows = sheet.families[0].factor, along_columns = sheet.families[1].factor;
    const bool halve_columns = along_rows * uneven > along_columns;
    const bool halve_rows = along_columns * uneven > along_rows;
    const bool small = sheet.columns * sheet.rows <= direct_nodes;
    if (small || (halve_columns && sheet.columns < least_count) ||
        (halve_rows && sheet.rows < least_count)) {
        return {sheet.columns, sheet.rows};
    }
    return {halve_columns ? (sheet.columns + 1) / 2 : sheet.columns,
            halve_rows ? (sheet.rows + 1) / 2 : sheet.rows};
}

double distance_ratio(std::size_t fine, std::size_t coarse) {
    return static_cast<double>(fine - 1) / static_cast<double>(coarse - 1);
}

// The fine node nearest to a coarse one.
std::size_t nearest_node(std::size_t node, std::size_t coarse, std::size_t fine) {
    return (2 * node * (fine - 1) + (coarse - 1)) / (2 * (coarse - 1));
}

// @param along, beside how much farther apart nodes are along the springs, and lines of them.
void coarsen_line(GridSpringFamily& family, double along, double beside) {
    family.border_factor = (family.border_factor + family.factor * (beside - 1) / 2) / along;
    family.factor *= beside / along;
    family.rest_length *= along;
}

void coarsen_shear(GridSpringFamily& family, double dx, double dy, double across, double down) {
    const double square = dx * dx + dy * dy;
    const double coarser = across * across * dx * dx + down * down * dy * dy;
    family.factor *= coarser / (square * across * down);
    family.border_factor = family.factor;
    family.rest_length *= std::sqrt(coarser / square);
}

std::vector<NewtonBand> bands_of(std::size_t rows, std::size_t count, float* lines,
                                 std::size_t room) {
    std::vector<NewtonBand> bands;
    for (std::size_t n = 0; n < count; ++n) {
        bands.push_back({n * rows / count, (n + 1) * rows / count, lines + n * room});
    }
    return bands;
}

template <typename Body>
void for_each_band(const std::vector<NewtonBand>& bands, const Body& body) {
    parallel_for(bands.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) body(bands[n]);
    });
}

float* component(Vec3View<float> field, std::size_t c) {
    return c == 0 ? field.x : c == 1 ? field.y : field.z;
}

}  // namespace

MultigridSheet finest_sheet(const ClothModel& cloth) {
    MultigridSheet sheet{cloth.shape.columns, cloth.shape.rows, cloth.families,
                         std::vector<bool>(cloth.particle_count, false)};
    for (const Pin& pin : cloth.pins) sheet.pinned[pin.particle] = true;
    return sheet;
}

std::optional<MultigridSheet> coarser_sheet(const MultigridSheet& sheet) {
    const auto [columns, rows] = coarser_counts(sheet);
    if (columns == sheet.columns && rows == sheet.rows) return std::nullopt;
    const double across = distance_ratio(sheet.columns, columns);
    const double down = distance_ratio(sheet.rows, rows);
    const double dx = sheet.families[0].rest_length, dy = sheet.families[1].rest_length;
    MultigridSheet coarser{columns, rows, sheet.families, {}};
    for (GridSpringFamily& family : coarser.families) {
        const std::size_t reach = std::max(family.ai, family.bi);
        family.owner_columns = columns > reach ? columns - reach : 0;
        family.owner_rows = rows > family.bj ? rows - family.bj : 0;
        if (family.along_row()) {
            coarsen_line(family, across, down);
        } else if (family.along_column()) {
            coarsen_line(family, down, across);
        } else {
            coarsen_shear(family, dx, dy, across, down);
        }
    }
    for (std::size_t n = 0; n < columns * rows; ++n) {
        const std::size_t i = nearest_node(n % columns, columns, sheet.columns);
        const std::size_t j = nearest_node(n / columns, rows, sheet.rows);
        coarser.pinned.push_back(sheet.pinned[j * sheet.columns + i]);
    }
    return coarser;
}

MultigridLevel::MultigridLevel(const MultigridSheet& sheet, const ClothModel& cloth,
                               const std::optional<MultigridSheet>& coarser,
                               const NewtonKernels& kernels, int threads)
    : kernels_(kernels), sums_(sheet.rows) {
    const ParticleLayout layout = ParticleLayout::of_grid(sheet.columns, sheet.rows);
    grid_.columns = sheet.columns;
    grid_.rows = sheet.rows;
    grid_.stride = layout.row_stride();
    for (std::size_t n = 0; n < grid_family_count; ++n) {
        const auto kind = static_cast<std::size_t>(sheet.families[n].kind);
        set_family(sheet, cloth.materials[kind], n);
    }
    for (Vec3Array<float>* field :
         {&b, &u, &x_, &spare_, &blocks_[0], &blocks_[1], &factors_[0], &factors_[1]}) {
        *field = Vec3Array<float>(layout.slot_count());
    }
    set_pointers();
    free_.assign(layout.slot_count(), 0.0f);
    layout.for_each([&](std::size_t node, std::size_t slot) {
        free_[slot] = sheet.pinned[node] ? 0.0f : 1.0f;
    });
    if (coarser) {
        const ParticleLayout next = ParticleLayout::of_grid(coarser->columns, coarser->rows);
        transfer_.emplace(sheet.columns, sheet.rows, layout.row_stride(), coarser->columns,
                          coarser->rows, next.row_stride());
    }
    cut_bands(threads, coarser);
}

void MultigridLevel::set_pointers() {
    grid_.x = std::as_const(x_).view();
    for (std::size_t n = 0; n < 6; ++n) {
        grid_.blocks[n] = block(n);
        grid_.factors[n] = component(factors_[n / 3].view(), n % 3);
        grid_.column_factors[n] = column_factors_[n].data();
    }
}

float* MultigridLevel::block(std::size_t entry) {
    return component(blocks_[entry / 3].view(), entry % 3);
}

// A family along columns has its factor from the column, one along rows from the row.
void MultigridLevel::set_family(const MultigridSheet& sheet, const SpringMaterial& material,
                                std::size_t n) {
    const GridShape shape{sheet.columns, sheet.rows, 0.0, 0.0};
    const GridSpringFamily& family = sheet.families[n];
    const std::size_t inner_column = shape.columns > 2 ? 1 : 0;
    const double column_base = !family.along_column() ? 1.0
                               : family.factor > 0.0  ? family.factor
                                                      : family.border_factor;
    std::vector<float>& factors = column_factors_[n];
    factors.assign(grid_.stride, 0.0f);
    for (std::size_t i = 0; i < family.owner_columns; ++i) {
        const double factor = family.along_column() ? family.spring_factor(i, 0, shape) : 1.0;
        factors[i] = static_cast<float>(column_base > 0.0 ? factor / column_base : 0.0);
    }
    if (factors[0] != factors[inner_column]) grid_.left_edge = true;
    for (std::size_t j = 0; j < shape.rows; ++j) {
        const auto spring = [&](double factor) {
            const double present = j < family.owner_rows ? factor : 0.0;
            return NewtonSpring{static_cast<float>(material.stiffness * present),
                                static_cast<float>(family.rest_length),
                                static_cast<float>(material.damping * present)};
        };
        NewtonRow& row = grid_.row_constants[grid_.row_kind(j)];
        row.inner[n] = spring(family.spring_factor(inner_column, j, shape));
        row.edge[n] =
            spring(family.along_column() ? column_base : family.spring_factor(0, j, shape));
    }
}

void MultigridLevel::cut_bands(int threads, const std::optional<MultigridSheet>& coarser) {
    const std::size_t most = std::max<std::size_t>(rows() * columns() / band_grain, 1);
    const std::size_t count = std::min(static_cast<std::size_t>(std::max(threads, 1)), most);
    const std::size_t room = NewtonBand::line_count * NewtonBand::line_stride(grid_.stride);
    lines_ = LineAligned<float>(count * room);
    bands_ = bands_of(rows(), count, lines_.data(), room);
    if (coarser) coarse_bands_ = bands_of(coarser->rows, count, lines_.data(), room);
}

double MultigridLevel::sum_of_rows() const {
    double sum = 0.0;
    for (const double row : sums_) sum += row;
    return sum;
}

void MultigridLevel::set_matrix(ConstVec3View<double> positions, double inverse_tau,
                                const SymmetricBlocks<double>& blocks) {
    grid_.inverse_tau = static_cast<float>(inverse_tau);
    set_positions(positions);
    set_blocks(blocks);
    factor();
}

void MultigridLevel::set_positions(ConstVec3View<double> positions) {
    const Vec3d middle = positions[slot(columns() / 2, rows() / 2)];
    const Vec3View<float> x = x_.view();
    for_each_band(bands_, [&](const NewtonBand& band) {
        const std::size_t begin = slot(0, band.row_begin), end = slot(0, band.row_end);
        for (std::size_t s = begin; s < end; ++s) {
            x.x[s] = static_cast<float>(positions.x[s] - middle.x);
        }
        for (std::size_t s = begin; s < end; ++s) {
            x.y[s] = static_cast<float>(positions.y[s] - middle.y);
        }
        for (std::size_t s = begin; s < end; ++s) {
            x.z[s] = static_cast<float>(positions.z[s] - middle.z);
        }
    });
}

void MultigridLevel::set_blocks(const SymmetricBlocks<double>& blocks) {
    const auto& [xx, xy, xz, yy, yz, zz] = blocks.entries;
    bool isotropic = true;
    for (std::size_t s = 0; s < free_.size() && isotropic; ++s) {
        const double off = std::abs(xy[s]) + std::abs(xz[s]) + std::abs(yz[s]);
        isotropic = free_[s] == 0.0f || (off == 0.0 && xx[s] == yy[s] && xx[s] == zz[s]);
    }
    grid_.isotropic = isotropic;
    for (std::size_t n = 0; n < entry_count(); ++n) {
        float* const to = block(n);
        const double* const from = blocks.entries[n].data();
        for_each_band(bands_, [&](const NewtonBand& band) {
            for (std::size_t s = slot(0, band.row_begin); s < slot(0, band.row_end); ++s) {
                to[s] = free_[s] == 0.0f ? 0.0f : static_cast<float>(from[s]);
            }
        });
    }
}

void MultigridLevel::set_matrix(const MultigridLevel& finer) {
    grid_.inverse_tau = finer.grid_.inverse_tau;
    grid_.isotropic = finer.grid_.isotropic;
    const NewtonTransfer transfer = finer.transfer_->tables();
    const ConstVec3View<float> from = finer.grid_.x;
    const Vec3View<float> to = x_.view();
    for_each_band(finer.coarse_bands_, [&](const NewtonBand& band) {
        finer.transfer_->sample(from.x, to.x, band.row_begin, band.row_end);
        finer.transfer_->sample(from.y, to.y, band.row_begin, band.row_end);
        finer.transfer_->sample(from.z, to.z, band.row_begin, band.row_end);
        for (std::size_t n = 0; n < entry_count(); ++n) {
            kernels_.coarsen(transfer, band, finer.grid_.blocks[n], block(n));
        }
    });
    for (std::size_t s = 0; s < free_.size(); ++s) block(0)[s] *= free_[s];
    factor();
}

void MultigridLevel::factor() {
    for_each_band(bands_, [&](const NewtonBand& band) { kernels_.factor(grid_, band); });
}

double MultigridLevel::multiply(const Vec3Array<float>& operand, Vec3Array<float>& out) {
    for_each_band(bands_, [&](const NewtonBand& band) {
        kernels_.product(grid_, band, operand.view(), out.view(), sums_.data());
    });
    return sum_of_rows();
}

void MultigridLevel::start(float omega) {
    for_each_band(bands_, [&](const NewtonBand& band) {
        kernels_.start(grid_, band, omega, std::as_const(b).view(), u.view());
    });
}

double MultigridLevel::smooth(float omega) {
    const bool in_place = bands_.size() == 1 && &kernels_ != &newton_twins;
    Vec3Array<float>& out = in_place ? u : spare_;
    for_each_band(bands_, [&](const NewtonBand& band) {
        kernels_.smooth(grid_, band, omega, std::as_const(u).view(), std::as_const(b).view(),
                        out.view(), sums_.data());
    });
    if (!in_place) std::swap(u, spare_);
    return sum_of_rows();
}

void MultigridLevel::send_residual(MultigridLevel& coarser) {
    for_each_band(bands_, [&](const NewtonBand& band) {
        kernels_.residual(grid_, band, std::as_const(u).view(), std::as_const(b).view(),
                          spare_.view());
    });
    const NewtonTransfer transfer = transfer_->tables();
    const ConstVec3View<float> from = std::as_const(spare_).view();
    const Vec3View<float> to = coarser.b.view();
    for_each_band(coarse_bands_, [&](const NewtonBand& band) {
        kernels_.coarsen(transfer, band, from.x, to.x);
        kernels_.coarsen(transfer, band, from.y, to.y);
        kernels_.coarsen(transfer, band, from.z, to.z);
    });
}

void MultigridLevel::add_correction(const MultigridLevel& coarser) {
    const NewtonTransfer transfer = transfer_->tables();
    const ConstVec3View<float> from = coarser.u.view();
    const Vec3View<float> to = u.view();
    for_each_band(bands_, [&](const NewtonBand& band) {
        kernels_.interpolate(transfer, band, from.x, grid_.blocks[0], to.x);
        kernels_.interpolate(transfer, band, from.y, grid_.blocks[0], to.y);
        kernels_.interpolate(transfer, band, from.z, grid_.blocks[0], to.z);
    });
}

}  // namespace weft
