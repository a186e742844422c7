#include "simulation/cloth_system.h"

#include <algorithm>
#include <cmath>

#include "forces/energy.h"
#include "forces/wind.h"
#include "math/parallel.h"

namespace weft {

namespace {

// Particles worth a thread of their own: less takes as long as waking the thread.
constexpr std::size_t particle_grain = 4096;
constexpr std::size_t triangle_grain = 4096;

}  // namespace

template <typename Real>
ClothSystem<Real>::ClothSystem(const ClothModel& cloth, const SceneDescription& scene,
                               InstructionSet instruction_set, int threads)
    : cloth_(cloth),
      scene_(scene),
      instruction_set_(instruction_set),
      threads_(threads),
      description_(scene.forces) {
    inverse_masses_.assign(cloth.layout.slot_count(), Real{0});
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        inverse_masses_[slot] = static_cast<Real>(1 / cloth.masses[p]);
    });
    for (const Pin& pin : cloth.pins) inverse_masses_[cloth.slot(pin.particle)] = 0;
    moving_pins_.reserve(cloth.pins.size());
    if (scene.wind && scene.wind->air_density > 0.0) wind_ = scene.wind;
    if (cloth.is_grid()) {
        grid_springs_.emplace(cloth);
        if (instruction_set != InstructionSet::scalar) {
            grid_kernel_.emplace(cloth, scene.forces, wind_, inverse_masses_, instruction_set,
                                 threads);
        }
        if (wind_) grid_air_.emplace(*wind_, cloth.shape, cloth.layout.row_stride());
    } else {
        mesh_springs_.emplace(cloth);
        if (instruction_set != InstructionSet::scalar) {
            mesh_kernel_.emplace(cloth, scene.forces, wind_, inverse_masses_, instruction_set,
                                 threads);
        }
        if (wind_) mesh_air_.emplace(*wind_, cloth.surface, cloth.layout);
    }
}

template <typename Real>
void ClothSystem<Real>::add_forces(Kinds kinds, Vec3<Real> wind, ConstVec3View<Real> x,
                                   ConstVec3View<Real> v, Vec3View<Real> f, std::size_t begin,
                                   std::size_t end) const {
    const Real c = static_cast<Real>(description_.damping);
    const std::size_t row = cloth_.is_grid() ? cloth_.layout.row_stride() : 1;
    for (std::size_t s = begin * row; s < end * row; ++s) f.x[s] = -c * v.x[s];
    for (std::size_t s = begin * row; s < end * row; ++s) f.y[s] = -c * v.y[s];
    for (std::size_t s = begin * row; s < end * row; ++s) f.z[s] = -c * v.z[s];
    if (kinds == Kinds::all) {
        if (grid_springs_) grid_springs_->add_forces(x, v, f, begin, end);
        if (mesh_springs_) mesh_springs_->add_forces(x, v, f, begin, end);
    }
    if (grid_air_) grid_air_->add_forces(wind, x, v, f, begin, end);
    if (mesh_air_) mesh_air_->add_forces(f, begin, end);
}

template <typename Real>
template <typename Finish>
void ClothSystem<Real>::forces(Kinds kinds, double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                               Vec3View<Real> f, const Finish& finish) {
    const Vec3<Real> wind = wind_at(t);
    if (mesh_air_) {
        parallel_for(mesh_air_->triangle_count(), triangle_grain,
                     [&](std::size_t begin, std::size_t end) {
                         mesh_air_->compute(wind, x, v, begin, end);
                     });
    }
    const bool grid = cloth_.is_grid();
    const std::size_t row = grid ? cloth_.layout.row_stride() : 1;
    const std::size_t grain = std::max<std::size_t>(particle_grain / row, 1);
    parallel_for(grid ? cloth_.shape.rows : cloth_.layout.slot_count(), grain,
                 [&](std::size_t begin, std::size_t end) {
                     add_forces(kinds, wind, x, v, f, begin, end);
                     finish(begin * row, end * row);
                 });
}

template <typename Real>
void ClothSystem<Real>::acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                                     Vec3View<Real> a) {
    if (grid_kernel_) return grid_kernel_->accelerate(wind_at(t), x, v, a);
    if (mesh_kernel_) return mesh_kernel_->accelerate(wind_at(t), x, v, a);
    twin_acceleration(Kinds::all, t, x, v, a);
}

template <typename Real>
void ClothSystem<Real>::external_acceleration(double t, ConstVec3View<Real> x,
                                              ConstVec3View<Real> v, Vec3View<Real> a) {
    twin_acceleration(Kinds::without_springs, t, x, v, a);
}

template <typename Real>
const SpringNetwork* ClothSystem<Real>::spring_network() {
    if (!spring_network_) {
        spring_network_ = std::make_unique<SpringNetwork>(weft::spring_network(cloth_));
    }
    return spring_network_.get();
}

template <typename Real>
ClothImplicitSystem* ClothSystem<Real>::implicit_system() {
    if (implicit_system_) return implicit_system_.get();
    const auto make = [&](DynamicsSystem<double>& forces) {
        implicit_system_ = std::make_unique<ClothImplicitSystem>(
            cloth_, scene_, forces, grips_, supports_, warnings_, instruction_set_, threads_);
    };
    if constexpr (std::is_same_v<Real, double>) {
        make(*this);
    } else {
        forces_in_double_ =
            std::make_unique<ClothSystem<double>>(cloth_, scene_, instruction_set_, threads_);
        make(*forces_in_double_);
    }
    return implicit_system_.get();
}

template <typename Real>
void ClothSystem<Real>::twin_acceleration(Kinds kinds, double t, ConstVec3View<Real> x,
                                          ConstVec3View<Real> v, Vec3View<Real> a) {
    const Vec3<Real> g = vec3_cast<Real>(description_.gravity);
    const Real* w = inverse_masses_.data();
    forces(kinds, t, x, v, a, [&](std::size_t begin, std::size_t end) {
        const auto accelerate = [&](Real* component, Real gravity) {
            for (std::size_t s = begin; s < end; ++s) {
                component[s] = w[s] > 0 ? gravity + w[s] * component[s] : Real{0};
            }
        };
        accelerate(a.x, g.x);
        accelerate(a.y, g.y);
        accelerate(a.z, g.z);
    });
}

template <typename Real>
Vec3<Real> ClothSystem<Real>::wind_at(double t) const {
    return wind_ ? vec3_cast<Real>(wind_velocity(*wind_, t)) : Vec3<Real>{};
}

template <typename Real>
void ClothSystem<Real>::kick_drift(double t, double kick, double drift, Vec3View<Real> x,
                                   Vec3View<Real> v) {
    if (grid_kernel_) return grid_kernel_->kick_drift(wind_at(t), kick, drift, x, v);
    mesh_kernel_->kick_drift(wind_at(t), kick, drift, x, v);
}

template <typename Real>
void ClothSystem<Real>::verlet(double t, double h, Vec3View<Real> x, Vec3View<Real> v,
                               Vec3View<Real> a) {
    moving_pins_.clear();  // keeps its memory
    for (const Pin& pin : cloth_.pins) {
        if (pin.motion == Pin::no_motion) continue;
        const PinOffset offset = pin_offset(cloth_.motions[pin.motion], t + h);
        moving_pins_.push_back({cloth_.slot(pin.particle),
                                vec3_cast<Real>(pin.rest + offset.offset),
                                vec3_cast<Real>(offset.velocity)});
    }
    grid_kernel_->verlet(wind_at(t + h), h, moving_pins_, x, v, a);
}

template <typename Real>
void ClothSystem<Real>::constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const {
    const bool held = grid_kernel_ && grid_kernel_->holds();
    if (held && cloth_.motions.empty()) return;  // nothing moves a pin that rests
    for (const Pin& pin : cloth_.pins) {
        PinOffset offset;
        if (pin.motion != Pin::no_motion) offset = pin_offset(cloth_.motions[pin.motion], t);
        const std::size_t slot = cloth_.slot(pin.particle);
        const auto place = vec3_cast<Real>(pin.rest + offset.offset);
        const auto velocity = vec3_cast<Real>(offset.velocity);
        if (held) {
            grid_kernel_->put(slot, place, velocity);
        } else {
            x.set(slot, place);
            v.set(slot, velocity);
        }
    }
}

template <typename Real>
double ClothSystem<Real>::pin_power(double t, ConstVec3View<Real> f) const {
    double power = 0.0;
    for (const Pin& pin : cloth_.pins) {
        if (pin.motion == Pin::no_motion) continue;
        const PinOffset offset = pin_offset(cloth_.motions[pin.motion], t);
        const Vec3d others = vec3_cast<double>(f[cloth_.slot(pin.particle)]);
        const double mass = cloth_.masses[pin.particle];
        power += dot(mass * (offset.acceleration - description_.gravity) - others, offset.velocity);
    }
    return power;
}

template <typename Real>
Work ClothSystem<Real>::power(double t, ConstVec3View<Real> x, ConstVec3View<Real> v) {
    Work power;
    power.dashpots = dashpot_power(cloth_, x, v);
    power.drag = drag_power(cloth_, description_, v);
    if (!wind_ && cloth_.motions.empty()) return power;
    if (forces_.size() == 0) forces_ = Vec3Array<Real>(cloth_.layout.slot_count());
    forces(Kinds::all, t, x, v, forces_.view(), [](std::size_t, std::size_t) {});
    power.pins = pin_power(t, std::as_const(forces_).view());
    if (mesh_air_) power.air = mesh_air_->power(v);
    if (grid_air_) {
        forces_.fill_zero();
        const Vec3<Real> wind = wind_at(t);
        grid_air_->add_forces(wind, x, v, forces_.view(), 0, cloth_.shape.rows);
        cloth_.layout.for_each([&](std::size_t, std::size_t slot) {
            power.air += dot(vec3_cast<double>(forces_[slot]), vec3_cast<double>(v[slot]));
        });
    }
    return power;
}

template class ClothSystem<float>;
template class ClothSystem<double>;

}  // namespace weft
