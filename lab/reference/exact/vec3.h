/// Three coordinates of any number type: double, long double or Boost.Multiprecision's.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace gnomon::oracle {

template<class R>
struct Vec3 {
    R x = 0, y = 0, z = 0;

    Vec3() = default;
    Vec3(R x_, R y_, R z_) : x(x_), y(y_), z(z_) {}
    template<class Other>
    explicit Vec3(const glm::tvec3<Other>& v) : x(v.x), y(v.y), z(v.z) {}
    template<class Other>
    explicit Vec3(const Vec3<Other>& v) : x(R(v.x)), y(R(v.y)), z(R(v.z)) {}

    R& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    const R& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

template<class R>
Vec3<R> operator+(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template<class R>
Vec3<R> operator-(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template<class R>
Vec3<R> operator-(const Vec3<R>& a) {
    return {-a.x, -a.y, -a.z};
}
template<class R>
Vec3<R> operator*(const R& s, const Vec3<R>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template<class R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template<class R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template<class R>
R length(const Vec3<R>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}
template<class R>
Vec3<R> unit(const Vec3<R>& a) {
    return (1 / length(a)) * a;
}

template<class R>
glm::vec3 toFloat(const Vec3<R>& a) {
    return {float(a.x), float(a.y), float(a.z)};
}

} // namespace gnomon::oracle
