#include "bench/peers/bullet_deformable.h"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace weft::bench {

namespace {

btVector3 vector(Vec3d a) {
    return {static_cast<btScalar>(a.x), static_cast<btScalar>(a.y), static_cast<btScalar>(a.z)};
}

class BulletDeformable final : public SteppedPeer {
public:
    explicit BulletDeformable(const PlainSheet& sheet)
        : drag_rate_(sheet.drag / sheet.mass),
          springs_(static_cast<btScalar>(sheet.structural.stiffness),
                   static_cast<btScalar>(sheet.structural.damping), true, sheet.bend.stiffness),
          gravity_(vector(sheet.gravity)) {
        constraint_solver_.setDeformableSolver(&deformable_solver_);
        world_.setImplicit(true);
        world_.setUseProjection(true);  // else Bullet 3.24 stands still where it is implicit
        world_.setGravity(vector(sheet.gravity));
        world_.getWorldInfo().m_gravity = vector(sheet.gravity);
        add_cloth(sheet);
    }
    ~BulletDeformable() override {
        world_.removeSoftBodyForce(cloth_.get());
        world_.removeSoftBody(cloth_.get());
    }
    BulletDeformable(const BulletDeformable&) = delete;
    BulletDeformable& operator=(const BulletDeformable&) = delete;

    void step(double dt, int count) override {
        const auto kept = static_cast<btScalar>(std::exp(-drag_rate_ * dt));
        for (int n = 0; n < count; ++n) {
            world_.stepSimulation(static_cast<btScalar>(dt), 0);
            // It has no drag of its own.
            for (int p = 0; p < cloth_->m_nodes.size(); ++p) cloth_->m_nodes[p].m_v *= kept;
        }
    }

    void copy_positions(std::span<Vec3d> positions) const override {
        for (std::size_t p = 0; p < positions.size(); ++p) {
            const btVector3& x = cloth_->m_nodes[static_cast<int>(p)].m_x;
            positions[p] = {x.x(), x.y(), x.z()};
        }
    }

private:
    void add_cloth(const PlainSheet& sheet) {
        btAlignedObjectArray<btVector3> places;
        btAlignedObjectArray<btScalar> masses;
        for (int j = 0; j < sheet.rows; ++j) {
            for (int i = 0; i < sheet.columns; ++i) {
                places.push_back(vector(sheet.rest_position(i, j)));
                masses.push_back(sheet.is_pinned(i, j) ? 0.0f : static_cast<btScalar>(sheet.mass));
            }
        }
        cloth_ = std::make_unique<btSoftBody>(&world_.getWorldInfo(), places.size(), &places[0],
                                              &masses[0]);
        const std::vector<PlainSpring> springs = plain_springs(sheet);
        const std::size_t bend_springs = bend_spring_count(sheet);
        for (std::size_t n = 0; n < springs.size(); ++n) {
            cloth_->appendLink(springs[n].a, springs[n].b);
            cloth_->m_links[cloth_->m_links.size() - 1].m_bbending =
                n + bend_springs >= springs.size() ? -1 : 0;  // a signed field of one bit
        }
        cloth_->setActivationState(DISABLE_DEACTIVATION);
        world_.addSoftBody(cloth_.get());
        world_.addForce(cloth_.get(), &springs_);
        world_.addForce(cloth_.get(), &gravity_);
    }

    // plain_springs() has them last.
    static std::size_t bend_spring_count(const PlainSheet& sheet) {
        const int along_rows = (sheet.columns - 2) * sheet.rows,
                  along_columns = sheet.columns * (sheet.rows - 2);
        return static_cast<std::size_t>(along_rows + along_columns);
    }

    double drag_rate_;  // [1/s]
    btDeformableMassSpringForce springs_;
    btDeformableGravityForce gravity_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btDeformableBodySolver deformable_solver_;
    btDeformableMultiBodyConstraintSolver constraint_solver_;
    btDeformableMultiBodyDynamicsWorld world_{&dispatcher_, &broadphase_, &constraint_solver_,
                                              &configuration_, &deformable_solver_};
    std::unique_ptr<btSoftBody> cloth_;
};

}  // namespace

std::unique_ptr<SteppedPeer> make_bullet_deformable(const PlainSheet& sheet) {
    return std::make_unique<BulletDeformable>(sheet);
}

}  // namespace weft::bench
