#include "bench/peers/bullet.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace weft::bench {

namespace {

class Bullet final : public SteppedPeer {
public:
    explicit Bullet(const PlainSheet& sheet) : drag_rate_(sheet.drag / sheet.mass) {
        const btVector3 gravity = vector(sheet.gravity);
        world_.setGravity(gravity);
        world_.getWorldInfo().m_gravity = gravity;
        add_cloth(sheet);
    }
    ~Bullet() override { world_.removeSoftBody(cloth_.get()); }
    Bullet(const Bullet&) = delete;
    Bullet& operator=(const Bullet&) = delete;

    void step(double dt, int count) override {
        cloth_->m_cfg.kDP = static_cast<btScalar>(-std::expm1(-drag_rate_ * dt));
        for (int n = 0; n < count; ++n) world_.stepSimulation(static_cast<btScalar>(dt), 0);
    }

    void copy_positions(std::span<Vec3d> positions) const override {
        for (std::size_t p = 0; p < positions.size(); ++p) {
            const btVector3& x = cloth_->m_nodes[static_cast<int>(p)].m_x;
            positions[p] = {x.x(), x.y(), x.z()};
        }
    }

private:
    static btVector3 vector(Vec3d a) {
        return {static_cast<btScalar>(a.x), static_cast<btScalar>(a.y), static_cast<btScalar>(a.z)};
    }

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
        for (const PlainSpring& spring : plain_springs(sheet)) {
            cloth_->appendLink(spring.a, spring.b);
        }
        world_.addSoftBody(cloth_.get());
    }

    double drag_rate_;  // [1/s]
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::unique_ptr<btSoftBody> cloth_;
};

}  // namespace

std::unique_ptr<SteppedPeer> make_bullet(const PlainSheet& sheet) {
    return std::make_unique<Bullet>(sheet);
}

std::string bullet_version() {
    return std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

}  // namespace weft::bench
