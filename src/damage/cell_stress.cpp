#include "damage/cell_stress.hpp"

#include <cmath>

#include "base/elementary.hpp"

namespace wrc {
namespace {

/// asinh(t), by logarithms of numbers from 1 on.
double area_sine(double t) {
  const double size = std::abs(t);
  return std::copysign(natural_log(size + std::sqrt(size * size + 1.0)), t);
}

/// Derivatives of F and F1 under a unit load, by their antiderivatives over x and y at one corner of a cell.
/// Members are named after what they differentiate by; `of_` those of F1.
struct Corner {
  double xx, yy, zz, xy, xz, yz;
  double xxx, xxy, xyy, yyy, xxz, xyz, yyz, xzz, yzz, zzz;
  double of_xxx, of_xxy, of_xyy, of_yyy;
};

/// X, Y from the corner to the point. With r^2 = X^2 + Y^2 + z^2, over both indefinite integrals,
///     F_xy -> ln(r + z), F_xz -> ln(Y + r), F_zz -> -atan(XY / (z r)),
///     F_xx -> atan(Y / X) - atan(z Y / (X r)), F1_xxy -> -X / (r + z),
/// and all others follow by differentiation, exchange of x and y, and F being harmonic.
Corner corner_at(double X, double Y, double z) {
  const double x2 = X * X, y2 = Y * Y, z2 = z * z;
  const double r = std::sqrt(x2 + y2 + z2), rz = r + z;
  const auto angle = [](double over, double under) {
    if (over == 0.0) return 0.0;
    return under > 0.0 ? arctangent(over / under) : std::copysign(0.5 * pi, over);
  };
  Corner c{};
  c.xx = angle(X * Y * (r - z), x2 * r + z * y2);
  c.zz = -angle(X * Y, z * r);
  c.yy = -c.xx - c.zz;
  c.xy = natural_log(rz);
  c.xz = area_sine(Y / std::sqrt(x2 + z2));
  c.yz = area_sine(X / std::sqrt(y2 + z2));
  c.xyz = 1.0 / r;
  c.xxy = X / (r * rz);
  c.xyy = Y / (r * rz);
  c.xxz = -X * Y / (r * (x2 + z2));
  c.yyz = -X * Y / (r * (y2 + z2));
  c.xzz = -z * Y / (r * (x2 + z2));
  c.yzz = -z * X / (r * (y2 + z2));
  c.zzz = -c.xxz - c.yyz;
  c.xxx = -c.xyy - c.xzz;
  c.yyy = -c.xxy - c.yzz;
  c.of_xxy = -X / rz;
  c.of_xyy = -Y / rz;
  c.of_xxx = Y / rz - c.xz;
  c.of_yyy = X / rz - c.yz;
  return c;
}

/// One corner's share of the stresses, by the formulas of the header.
CellStress share_of(const Corner& c, double nu, double z) {
  constexpr double scale = 0.5 / pi;
  const double k = 1.0 - 2.0 * nu;
  CellStress s;
  s.of_pressure = {.xx = scale * (2.0 * nu * c.zz - z * c.xxz - k * c.xx),
                   .yy = scale * (2.0 * nu * c.zz - z * c.yyz - k * c.yy),
                   .zz = scale * (c.zz - z * c.zzz),
                   .xy = scale * (-k * c.xy - z * c.xyz),
                   .yz = scale * (-z * c.yzz),
                   .zx = scale * (-z * c.xzz)};
  s.of_traction_x = {.xx = scale * (2.0 * (1.0 + nu) * c.xz + 2.0 * nu * c.of_xxx - z * c.xxx),
                     .yy = scale * (2.0 * nu * c.xz + 2.0 * nu * c.of_xyy - z * c.xyy),
                     .zz = scale * (-z * c.xzz),
                     .xy = scale * (c.yz + 2.0 * nu * c.of_xxy - z * c.xxy),
                     .yz = scale * (-z * c.xyz),
                     .zx = scale * (c.zz - z * c.xxz)};
  s.of_traction_y = {.xx = scale * (2.0 * nu * c.yz + 2.0 * nu * c.of_xxy - z * c.xxy),
                     .yy = scale * (2.0 * (1.0 + nu) * c.yz + 2.0 * nu * c.of_yyy - z * c.yyy),
                     .zz = scale * (-z * c.yzz),
                     .xy = scale * (c.xz + 2.0 * nu * c.of_xyy - z * c.xyy),
                     .yz = scale * (c.zz - z * c.yyz),
                     .zx = scale * (-z * c.xyz)};
  return s;
}

}  // namespace

void add(const Stress& from, double factor, Stress& to) {
  to.xx += factor * from.xx;
  to.yy += factor * from.yy;
  to.zz += factor * from.zz;
  to.xy += factor * from.xy;
  to.yz += factor * from.yz;
  to.zx += factor * from.zx;
}

void add(const CellStress& from, double factor, CellStress& to) {
  add(from.of_pressure, factor, to.of_pressure);
  add(from.of_traction_x, factor, to.of_traction_x);
  add(from.of_traction_y, factor, to.of_traction_y);
}

CellStress corner_stress(double poisson, double X, double Y, double z) {
  return share_of(corner_at(X, Y, z), poisson, z);
}

CellStress cell_stress(double poisson, double x, double y, double z, double dx, double dy) {
  CellStress sum;
  for (const double side_x : {0.5, -0.5}) {
    for (const double side_y : {0.5, -0.5}) {
      add(corner_stress(poisson, x + side_x * dx, y + side_y * dy, z), side_x * side_y > 0.0 ? 1.0 : -1.0,
          sum);
    }
  }
  return sum;
}

// Both follow from the derivatives of ln(r + z) at a point; in this form nothing cancels right below it.
Stress point_force_stress(double poisson, double x, double y, double z, double normal, double along,
                          double across) {
  constexpr double scale = 0.5 / pi;
  const double k = 1.0 - 2.0 * poisson;
  const double r2 = x * x + y * y + z * z, r = std::sqrt(r2);
  const double u = 1.0 / r, u2 = u * u, u3 = u2 * u;  // 1 / r
  const double w = 1.0 / (r + z), w2 = w * w;
  const double x2 = x * x, y2 = y * y;
  // What does not depend on nu is radial: -3 (force . r) r r / r^5.
  const double radial = -3.0 * (normal * z + along * x + across * y) * u3 * u2;
  // k-terms: A of 1 / r^3, B of 1 / (r (r + z)^2), C of the products of three coordinates.
  const double a = k * u3, b = k * u * w2, c = k * u2 * w2 * (u + 2.0 * w);
  const double d = k * u2 * w * (u + w);  // (2 r + z) / (r^3 (r + z)^2)
  const double own = k * (z * u3 - u * w);
  Stress s;
  s.xx = scale * (radial * x2 + normal * (own + d * x2) + along * x * (a - 3.0 * b + c * x2) +
                  across * y * (a - b + c * x2));
  s.yy = scale * (radial * y2 + normal * (own + d * y2) + along * x * (a - b + c * y2) +
                  across * y * (a - 3.0 * b + c * y2));
  s.zz = scale * radial * z * z;
  s.xy = scale * (radial * x * y + normal * d * x * y + along * y * (c * x2 - b) + across * x * (c * y2 - b));
  s.yz = scale * radial * y * z;
  s.zx = scale * radial * x * z;
  return s;
}

}  // namespace wrc
