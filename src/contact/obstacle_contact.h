// Obstacles that the cloth cannot enter: what they do to a step that knew nothing of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/cloth_model.h"
#include "contact/contact_supports.h"
#include "math/vec3_array.h"
#include "weft/scene.h"

namespace weft {

/// An obstacle grown by its gap.
struct Obstacle {
    bool sphere = false;
    Vec3d centre{};         ///< of a sphere [m]
    Vec3d normal{};         ///< of a plane, unit
    double reach = 0.0;     ///< radius and gap of a sphere; n.x on the grown plane [m]
    double friction = 0.0;  ///< Coulomb's coefficient
};

/// Puts particles that a step brought into an obstacle onto its surface and takes from their
/// velocity what leads inward, dv_n; Coulomb's friction takes up to mu |dv_n| of what leads along
/// it, and the same share of the way along it since they touched. So what sticks stays where it is,
/// and no correction of a place becomes a velocity. Particles only: an obstacle smaller than the
/// cloth's cells slips between them. docs/contact.md has the formulas.
///
/// Each particle is treated by itself: the same bits for any number of threads.
template <typename Real>
class ObstacleContact {
public:
    explicit ObstacleContact(const ClothModel& cloth);

    void set(std::span<const ObstacleDescription> obstacles);
    [[nodiscard]] bool empty() const { return obstacles_.empty(); }

    /// Remembers where the step begins.  @pre there are obstacles, here and below.
    void begin_step(const Vec3Array<Real>& x);

    /// Finds what holds up the cloth in a step of h that begins so.
    /// @param supports have none yet.  @pre begin_step(x).
    void find_supports(double h, const Vec3Array<Real>& x, const Vec3Array<Real>& v,
                       ContactSupports& supports) const;

    /// @param h length of the step [s].
    /// @param supports that were in the step's equations.
    /// @param x, v as it ended [slot].
    /// @return whether any particle was touched.
    bool apply(double h, const ContactSupports& supports, Vec3View<Real> x, Vec3View<Real> v) const;

private:
    template <typename Treat>
    void for_each_near(ConstVec3View<Real> x, std::size_t begin, std::size_t end,
                       const Treat& treat) const;
    [[nodiscard]] bool any_near(ConstVec3View<Real> x, std::size_t begin, std::size_t end) const;

    std::vector<std::uint8_t> free_;  // [slot] neither pinned nor padding
    std::vector<Obstacle> obstacles_;
    Vec3Array<Real> start_;  // [slot], with obstacles only
};

extern template class ObstacleContact<float>;
extern template class ObstacleContact<double>;

}  // namespace weft
