#include "contact/obstacle_contact.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t slot_grain = 4096;        // below, waking a thread costs more than it saves
constexpr std::size_t component_grain = 65536;  // likewise, of a copy
constexpr std::size_t block = 64;               // slots that are looked at together

// A particle that an obstacle came over, rather than the other way round, leaves it at this speed:
// thrown out in one step, it would tear at its neighbours [m/s].
constexpr double leaving_speed = 10.0;

// A particle pushed from one obstacle into another, as between a ball and the ground it lies on, is
// pushed to and fro at most so often.
constexpr int most_rounds = 4;

// A sphere is met where it was entered if the way through it is longer than this part of its reach:
// from where such a step ends, the nearest surface may be the far side's.
constexpr double long_way = 0.5;

Obstacle grown(const ObstacleDescription& description) {
    Obstacle obstacle;
    obstacle.friction = description.friction;
    if (const auto* const sphere = std::get_if<SphereObstacle>(&description.shape)) {
        obstacle.sphere = true;
        obstacle.centre = sphere->centre;
        obstacle.reach = sphere->radius + description.gap;
    } else {
        const auto& plane = std::get<PlaneObstacle>(description.shape);
        const double scale = std::max(
            {std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)});
        const Vec3d scaled = plane.normal / scale;  // its square neither over- nor underflows
        obstacle.normal = scaled / length(scaled);
        obstacle.reach = dot(obstacle.normal, plane.point) + description.gap;
    }
    return obstacle;
}

double largest(Vec3d a) {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

// A step of one particle.
struct Motion {
    Vec3d start, x, v;  // x, v at its end
    double h;           // [s]
    // What held it up in the step's equations, with whose rate:
    std::span<const ContactSupport> supports;
    double rate;
};

struct Touch {
    Vec3d normal{};      // outward
    double depth = 0.0;  // of the end below the surface along it; or a trifle above: negative [m]
    double share = 1.0;  // of the step, since it touched
    bool on_surface = true;  // where it is put; else on its tangent plane, or on the way out
};

double distance(const Obstacle& obstacle, Vec3d x) {
    return obstacle.sphere ? length(x - obstacle.centre) - obstacle.reach
                           : dot(obstacle.normal, x) - obstacle.reach;
}

// What the precision of numbers leaves open, as a part of them.
template <typename Real>
constexpr double rounding = 16.0 * static_cast<double>(std::numeric_limits<Real>::epsilon());

// What the precision of places leaves open, about x [m].
template <typename Real>
double slop_at(const Obstacle& obstacle, Vec3d x) {
    return rounding<Real> * (largest(x) + largest(obstacle.centre) + std::abs(obstacle.reach));
}

Vec3d normal_at(const Obstacle& obstacle, Vec3d x) {
    if (!obstacle.sphere) return obstacle.normal;
    const Vec3d out = x - obstacle.centre;
    const double far = length(out);
    return far > 0.0 ? out / far : Vec3d{0.0, 1.0, 0.0};
}

// Where a long step from outside a sphere leads into it, and there along its tangent plane.
std::optional<Touch> entry(const Obstacle& sphere, const Motion& motion) {
    const Vec3d way = motion.x - motion.start, from = motion.start - sphere.centre;
    const double a = dot(way, way), b = dot(from, way);
    const double c = dot(from, from) - sphere.reach * sphere.reach;
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0.0) || b >= 0.0 || c <= 0.0) return {};
    const double in = c / (-b + std::sqrt(discriminant));
    const double out = std::min((-b + std::sqrt(discriminant)) / a, 1.0);
    if (!(in < 1.0) || (out - in) * std::sqrt(a) < long_way * sphere.reach) return {};
    const Vec3d normal = normal_at(sphere, motion.start + in * way);
    return Touch{normal, -(1.0 - in) * dot(way, normal), 1.0 - in, false};
}

// @param slop what the places' precision leaves open [m].
std::optional<Touch> touch(const Obstacle& obstacle, const Motion& motion, double slop) {
    if (obstacle.sphere) {
        if (const auto entered = entry(obstacle, motion)) return entered;
    }
    const double end = distance(obstacle, motion.x);
    if (!(end < slop)) return {};
    Touch found{normal_at(obstacle, motion.x), -end, 1.0};
    const double start = distance(obstacle, motion.start);
    if (start > slop)
        found.share = std::max(found.depth, 0.0) / (std::max(found.depth, 0.0) + start);
    if (start < -slop) {
        const double still = std::max(0.0, -start - leaving_speed * motion.h);
        found.depth = std::max(found.depth - still, 0.0);
        found.on_surface = still == 0.0;
    }
    return found;
}

// The part of the impulse over the mass that the step's equations had in them already [m/s].
double supported(const Motion& motion, std::size_t obstacle, Vec3d end) {
    for (const ContactSupport& support : motion.supports) {
        if (support.obstacle != obstacle) continue;
        return motion.h * motion.rate * std::max(0.0, support.height - dot(support.normal, end));
    }
    return 0.0;
}

// @param pressed part of the impulse over the mass that was taken before [m/s].
// @return whether it changed anything.
bool meet(const Obstacle& obstacle, double slop, double pressed, Motion& motion) {
    const std::optional<Touch> found = touch(obstacle, motion, slop);
    if (!found) return false;
    const Vec3d n = found->normal;
    const double inward = std::max(0.0, -dot(motion.v, n));
    if (found->depth <= slop && inward == 0.0) return false;
    const Vec3d along = motion.v - dot(motion.v, n) * n;
    const double most = obstacle.friction * (inward + pressed);
    const double stopped = most > 0.0 ? std::min(most / length(along), 1.0) : 0.0;
    const Vec3d way = motion.x - motion.start;
    motion.v += inward * n - stopped * along;
    motion.x += std::max(found->depth, 0.0) * n;
    motion.x -= (stopped * found->share) * (way - dot(way, n) * n);
    if (obstacle.sphere && found->on_surface) {  // along its tangent it came off it
        motion.x -= distance(obstacle, motion.x) * normal_at(obstacle, motion.x);
    }
    return true;
}

// @return whether it changed anything.
template <typename Real>
bool meet_all(std::span<const Obstacle> obstacles, Motion& motion) {
    const auto slop = [&](const Obstacle& obstacle) { return slop_at<Real>(obstacle, motion.x); };
    const auto inside = [&](const Obstacle& obstacle) {
        return distance(obstacle, motion.x) < -slop(obstacle);
    };
    const Vec3d end = motion.x;
    bool changed = false;
    for (int round = 0; round < most_rounds; ++round) {
        for (std::size_t n = 0; n < obstacles.size(); ++n) {
            const double pressed = round == 0 ? supported(motion, n, end) : 0.0;
            changed = meet(obstacles[n], slop(obstacles[n]), pressed, motion) || changed;
        }
        if (obstacles.size() == 1 || std::none_of(obstacles.begin(), obstacles.end(), inside))
            break;
    }
    return changed;
}

}  // namespace

template <typename Real>
ObstacleContact<Real>::ObstacleContact(const ClothModel& cloth)
    : free_(cloth.layout.slot_count(), std::uint8_t{0}) {
    cloth.layout.for_each([&](std::size_t, std::size_t slot) { free_[slot] = 1; });
    for (const Pin& pin : cloth.pins) free_[cloth.slot(pin.particle)] = 0;
}

template <typename Real>
void ObstacleContact<Real>::set(std::span<const ObstacleDescription> obstacles) {
    obstacles_.clear();
    for (const ObstacleDescription& obstacle : obstacles) obstacles_.push_back(grown(obstacle));
    if (obstacles_.empty()) {
        start_ = {};
    } else if (start_.size() != free_.size()) {
        start_ = Vec3Array<Real>(free_.size());
    }
}

template <typename Real>
void ObstacleContact<Real>::begin_step(const Vec3Array<Real>& x) {
    parallel_for(x.data_size(), component_grain, [&](std::size_t begin, std::size_t end) {
        std::copy(x.data() + begin, x.data() + end, start_.data() + begin);
    });
}

// Whether any of some slots may touch: more than do, whatever the rounding.
template <typename Real>
bool ObstacleContact<Real>::any_near(ConstVec3View<Real> x, std::size_t begin,
                                     std::size_t end) const {
    constexpr Real margin = static_cast<Real>(1e-5);
    const ConstVec3View<Real> start = start_.view();
    unsigned near = 0;
    for (const Obstacle& obstacle : obstacles_) {
        const Real reach = static_cast<Real>(obstacle.reach);
        if (obstacle.sphere) {
            const Vec3<Real> c = vec3_cast<Real>(obstacle.centre);
            const Real grown =
                reach + margin * (reach + static_cast<Real>(largest(obstacle.centre)));
            for (std::size_t s = begin; s < end; ++s) {
                const Real dx = x.x[s] - c.x, dy = x.y[s] - c.y, dz = x.z[s] - c.z;
                const Real wx = x.x[s] - start.x[s], wy = x.y[s] - start.y[s],
                           wz = x.z[s] - start.z[s];
                const Real most = grown + std::sqrt(wx * wx + wy * wy + wz * wz);
                near |= static_cast<unsigned>(dx * dx + dy * dy + dz * dz <= most * most);
            }
        } else {
            const Vec3<Real> n = vec3_cast<Real>(obstacle.normal);
            const Real grown = reach + margin * (std::abs(reach) + Real{1});
            for (std::size_t s = begin; s < end; ++s) {
                const Real height = n.x * x.x[s] + n.y * x.y[s] + n.z * x.z[s];
                const Real size = std::abs(x.x[s]) + std::abs(x.y[s]) + std::abs(x.z[s]);
                near |= static_cast<unsigned>(height <= grown + margin * size);
            }
        }
        if (near != 0) return true;
    }
    return false;
}

template <typename Real>
template <typename Treat>
void ObstacleContact<Real>::for_each_near(ConstVec3View<Real> x, std::size_t begin, std::size_t end,
                                          const Treat& treat) const {
    for (std::size_t from = begin; from < end; from += block) {
        const std::size_t to = std::min(from + block, end);
        if (!any_near(x, from, to)) continue;
        for (std::size_t s = from; s < to; ++s) {
            if (free_[s] != 0) treat(s);
        }
    }
}

template <typename Real>
void ObstacleContact<Real>::find_supports(double h, const Vec3Array<Real>& x,
                                          const Vec3Array<Real>& v,
                                          ContactSupports& supports) const {
    supports.rate = ContactSupports::stiffness / (h * h);
    for_each_near(x.view(), 0, free_.size(), [&](std::size_t s) {
        const Vec3d place = vec3_cast<double>(x[s]), velocity = vec3_cast<double>(v[s]);
        for (std::size_t n = 0; n < obstacles_.size(); ++n) {
            const Obstacle& obstacle = obstacles_[n];
            const double above = distance(obstacle, place);
            if (!(std::abs(above) <= slop_at<Real>(obstacle, place))) continue;
            const Vec3d normal = normal_at(obstacle, place);
            if (dot(velocity, normal) > rounding<Real> * (1.0 + length(velocity))) continue;
            supports.list.push_back({s, n, normal, dot(normal, place) - above});
        }
    });
}

template <typename Real>
bool ObstacleContact<Real>::apply(double h, const ContactSupports& supports, Vec3View<Real> x,
                                  Vec3View<Real> v) const {
    std::atomic<bool> touched = false;  // only ever set: in any order
    const auto supports_of = [&](std::size_t slot) {
        const auto [first, last] = std::equal_range(
            supports.list.begin(), supports.list.end(), ContactSupport{slot, 0, {}, 0.0},
            [](const ContactSupport& a, const ContactSupport& b) { return a.slot < b.slot; });
        return std::span(first, last);
    };
    const auto treat = [&](std::size_t s) {
        Motion motion{vec3_cast<double>(start_[s]),
                      vec3_cast<double>(x[s]),
                      vec3_cast<double>(v[s]),
                      h,
                      supports_of(s),
                      supports.rate};
        if (!meet_all<Real>(obstacles_, motion)) return;
        x.set(s, vec3_cast<Real>(motion.x));
        v.set(s, vec3_cast<Real>(motion.v));
        touched.store(true, std::memory_order_relaxed);
    };
    parallel_for(free_.size(), slot_grain,
                 [&](std::size_t begin, std::size_t end) { for_each_near(x, begin, end, treat); });
    return touched.load();
}

template class ObstacleContact<float>;
template class ObstacleContact<double>;

}  // namespace weft
