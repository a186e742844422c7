// Compiled with -O3 -march=native (bench/CMakeLists.txt). So that none of this code can be taken
// for another file's by the linker, all types here are its own.
#include "bench/peers/textbook.h"

#include <cmath>

namespace weft::bench {

namespace {

struct vec3 {
    double x, y, z;
};

vec3 operator+(vec3 a, vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
vec3 operator-(vec3 a, vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
vec3 operator*(double s, vec3 a) {
    return {s * a.x, s * a.y, s * a.z};
}
vec3 operator/(vec3 a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}
vec3& operator+=(vec3& a, vec3 b) {
    return a = a + b;
}
vec3& operator-=(vec3& a, vec3 b) {
    return a = a - b;
}
double dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
double length(vec3 a) {
    return std::sqrt(dot(a, a));
}

struct Particle {
    vec3 position, velocity, force;
    double mass;
    bool pinned;
};

struct Spring {
    int a, b;
    double k, c, rest_length;
};

class Textbook final : public SteppedPeer {
public:
    explicit Textbook(const PlainSheet& sheet)
        : gravity_{sheet.gravity.x, sheet.gravity.y, sheet.gravity.z}, drag_(sheet.drag) {
        for (int j = 0; j < sheet.rows; ++j) {
            for (int i = 0; i < sheet.columns; ++i) {
                const Vec3d rest = sheet.rest_position(i, j);
                particles_.push_back({{rest.x, rest.y, rest.z},
                                      {0, 0, 0},
                                      {0, 0, 0},
                                      sheet.mass,
                                      sheet.is_pinned(i, j)});
            }
        }
        for (const PlainSpring& s : plain_springs(sheet)) {
            springs_.push_back({s.a, s.b, s.k, s.c, s.rest_length});
        }
    }

    void step(double dt, int count) override {
        for (int n = 0; n < count; ++n) {
            compute_forces();
            integrate(dt);
        }
    }

    void copy_positions(std::span<Vec3d> positions) const override {
        for (std::size_t p = 0; p < particles_.size(); ++p) {
            const vec3 x = particles_[p].position;
            positions[p] = {x.x, x.y, x.z};
        }
    }

private:
    void compute_forces() {
        for (Particle& p : particles_) {
            p.force = p.mass * gravity_ - drag_ * p.velocity;
        }
        for (const Spring& spring : springs_) {
            Particle& a = particles_[static_cast<std::size_t>(spring.a)];
            Particle& b = particles_[static_cast<std::size_t>(spring.b)];
            const vec3 d = b.position - a.position;
            const double l = length(d);
            const vec3 u = d / l;
            const double tension =
                spring.k * (l - spring.rest_length) + spring.c * dot(b.velocity - a.velocity, u);
            const vec3 force = tension * u;
            a.force += force;
            b.force -= force;
        }
    }

    void integrate(double dt) {
        for (Particle& p : particles_) {
            if (p.pinned) continue;
            p.velocity += dt * (p.force / p.mass);
            p.position += dt * p.velocity;
        }
    }

    vec3 gravity_;
    double drag_;
    std::vector<Particle> particles_;
    std::vector<Spring> springs_;
};

}  // namespace

std::unique_ptr<SteppedPeer> make_textbook(const PlainSheet& sheet) {
    return std::make_unique<Textbook>(sheet);
}

}  // namespace weft::bench
