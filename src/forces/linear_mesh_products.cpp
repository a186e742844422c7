// A mesh's products: tables of its springs, rows of the vectors, threads.
#include <algorithm>

#include "forces/linear_products.h"
#include "forces/mesh_pass_tables.h"
#include "math/parallel.h"
#include "math/simd_targets.h"

namespace weft {

namespace {

constexpr std::size_t block_slices = 64;  // summed together
constexpr std::size_t block_grain = 8;    // worth a thread of their own

template <typename Real>
class MeshProducts final : public LinearKernel<Real>::Products {
public:
    MeshProducts(const ClothModel& cloth, const ForcesDescription& forces,
                 std::vector<Real> root_inverse_masses, InstructionSet set)
        : LinearKernel<Real>::Products(std::move(root_inverse_masses)),
          lanes_(mesh_lanes<Real>(set)),
          slices_((cloth.layout.slot_count() + lanes_ - 1) / lanes_),
          tables_(cloth, lanes_),
          masses_(slices_ * lanes_),
          x_(4 * slices_ * lanes_),
          u_(4 * slices_ * lanes_),
          sums_((slices_ + block_slices - 1) / block_slices) {
        if constexpr (sizeof(Real) == 4) {
            function_ = linear_mesh_single(set);
            write_records_ = linear_records_single(set);
        } else {
            function_ = linear_mesh_double(set);
            write_records_ = linear_records_double(set);
        }
        std::copy(this->root_inverse_masses().begin(), this->root_inverse_masses().end(),
                  masses_.data());
        for (std::size_t n = 0; n < tables_.neighbours.items.size(); ++n) {
            tables_.neighbours.items[n] *= 4;
        }
        pass_.spring_starts = tables_.neighbours.starts.data();
        pass_.neighbours = tables_.neighbours.items.data();
        pass_.tensions = tables_.tensions.data();
        if (tables_.widths.size() > 0) pass_.widths = tables_.widths.data();
        for (std::size_t kind = 0; kind < spring_kind_count; ++kind) {
            const LinearSpring<Real> spring = linear_spring<Real>(
                cloth.materials[kind].stiffness, cloth.materials[kind].damping, 0.0);
            pass_.kinds[kind] = {spring.stiffness, spring.scaled_damping};
        }
        pass_.root_inverse_masses = masses_.data();
        pass_.drag = static_cast<Real>(forces.damping);
        pass_.x_records = x_.data();
        pass_.u_records = u_.data();
    }

    void linearise_at(ConstVec3View<Real> x) override {
        pass_.x = {x.x, x.y, x.z};
        write_records({pass_.x, nullptr, Real{1}, x_.data()});
    }

    LinearSums multiply(LinearMatrix matrix, Real scale, ConstVec3View<Real> u,
                        Vec3View<Real> out) override {
        pass_.matrix = matrix;
        pass_.scale = scale;
        pass_.u = {u.x, u.y, u.z};
        pass_.out = {out.x, out.y, out.z};
        write_records({pass_.u, masses_.data(), scale, u_.data()});
        for_blocks([&](std::size_t block, std::size_t begin, std::size_t end) {
            sums_[block] = function_(pass_, begin, end);
        });
        LinearSums sums;
        for (const LinearSums& block : sums_) {
            sums.in_out += block.in_out / static_cast<double>(scale);
            sums.out_out += block.out_out;
        }
        return sums;
    }

private:
    // Calls body(block, slice_begin, slice_end).
    template <typename Body>
    void for_blocks(const Body& body) const {
        parallel_for(sums_.size(), block_grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                body(n, n * block_slices, std::min((n + 1) * block_slices, slices_));
            }
        });
    }

    void write_records(const LinearRecords<Real>& from) const {
        for_blocks([&](std::size_t, std::size_t begin, std::size_t end) {
            write_records_(from, begin, end);
        });
    }

    std::size_t lanes_, slices_;
    MeshSpringTables<Real> tables_;
    LineAligned<Real> masses_, x_, u_;
    std::vector<LinearSums> sums_;  // [block]
    LinearMeshPass<Real> pass_;
    LinearMeshFunction<Real> function_;
    LinearRecordsFunction<Real> write_records_;
};

}  // namespace

template <typename Real>
std::unique_ptr<typename LinearKernel<Real>::Products> make_mesh_products(
    const ClothModel& cloth, const ForcesDescription& forces, std::vector<Real> root_inverse_masses,
    InstructionSet set) {
    return std::make_unique<MeshProducts<Real>>(cloth, forces, std::move(root_inverse_masses), set);
}

template std::unique_ptr<LinearKernel<float>::Products> make_mesh_products(const ClothModel&,
                                                                           const ForcesDescription&,
                                                                           std::vector<float>,
                                                                           InstructionSet);
template std::unique_ptr<LinearKernel<double>::Products> make_mesh_products(
    const ClothModel&, const ForcesDescription&, std::vector<double>, InstructionSet);

}  // namespace weft
