/// Vectors and rotations in space, of plain numbers and of numbers that carry derivatives.
#pragma once

namespace wrc {

template <class Number>
struct Vec3 {
  Number x, y, z;

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

template <class Number>
Number dot(const Vec3<Number>& a, const Vec3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vec3<Number> cross(const Vec3<Number>& a, const Vec3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// a + b x c, of vectors as arrays.
template <class Number>
void add_cross(Number (&a)[3], const Number (&b)[3], const Number (&c)[3]) {
  a[0] += b[1] * c[2] - b[2] * c[1];
  a[1] += b[2] * c[0] - b[0] * c[2];
  a[2] += b[0] * c[1] - b[1] * c[0];
}

}  // namespace wrc
