// A vector in space: three components, array-of-structs. Bulk data lives in SoA arrays
// (src/math/vec3_array.h); this type carries single points and what crosses the public interface.
#pragma once

#include <cmath>

namespace weft {

template <typename Real>
struct Vec3 {
    Real x{}, y{}, z{};

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(Real s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, Real s) { return s * a; }
    friend constexpr Vec3 operator/(Vec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    constexpr Vec3& operator-=(Vec3 b) { return *this = *this - b; }
    constexpr Vec3& operator*=(Real s) { return *this = s * *this; }
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <typename Real>
constexpr Real dot(Vec3<Real> a, Vec3<Real> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
constexpr Vec3<Real> cross(Vec3<Real> a, Vec3<Real> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Real>
Real length(Vec3<Real> a) {
    return std::sqrt(dot(a, a));
}

template <typename Real>
bool is_finite(Vec3<Real> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

template <typename To, typename From>
constexpr Vec3<To> vec3_cast(Vec3<From> a) {
    return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace weft
