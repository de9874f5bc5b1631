#include "surface/overlap.hpp"

#include <algorithm>
#include <cmath>

#include "number.hpp"

namespace wrc {
namespace {

/// What an attitude makes of the outline's equation.
struct Attitude2 {
  double e1, e3, e2;  ///< e / sqrt(e1^2 + e3^2)
};

struct Outline {
  double x, y, z;     ///< from the wheel's reference point, rail axes [m]
  double dy, dz;      ///< along the profile's length
  double ny, nz;      ///< unit normal, out of the wheel
  double curvature;   ///< kappa times the cosine between this normal and that it is measured along [1/m]
  bool seen;          ///< the outline exists there
};

Attitude2 attitude_of(const RelativePose& pose) {
  const double e1 = pose.rotation[0][0], e2 = pose.rotation[0][1], e3 = pose.rotation[0][2];
  const double inverse = 1.0 / std::sqrt(e1 * e1 + e3 * e3);
  return {e1 * inverse, e3 * inverse, e2 * inverse};
}

Outline outline_of(const RelativePose& pose, const Attitude2& a, const CurvePoint& p) {
  const auto& R = pose.rotation;
  const double per_speed = 1.0 / std::sqrt(p.dy * p.dy + p.dz * p.dz);
  const double uy = p.dy * per_speed, uz = p.dz * per_speed;
  // steep faces of a yawed wheel have no outline: the slope is held where sin(theta + alpha) stays below one
  constexpr double least = 1e-3, steepest = 0.98;
  const double across = larger(uy, least);
  double sine = a.e2 * uz / across;
  const bool seen = uy > least && std::abs(sine) < steepest;
  sine = smaller(larger(sine, -steepest), steepest);
  const double cosine = root(1.0 - sine * sine);
  const double st = sine * a.e1 - cosine * a.e3, ct = cosine * a.e1 + sine * a.e3;
  // d(uz / uy) by length, both derivatives of the curve's
  const double turning = (p.ddz * p.dy - p.dz * p.ddy) / (p.dy * p.dy + 1e-12);
  const double theta_s = seen ? a.e2 * turning / cosine : 0.0;
  const double r = p.z;
  const double px = r * st, pz = r * ct;
  const double tx = p.dz * st + r * ct * theta_s, tz = p.dz * ct - r * st * theta_s;
  Outline o;
  o.x = R[0][0] * px + R[0][1] * p.y + R[0][2] * pz;
  o.y = R[1][0] * px + R[1][1] * p.y + R[1][2] * pz;
  o.z = R[2][0] * px + R[2][1] * p.y + R[2][2] * pz;
  o.dy = R[1][0] * tx + R[1][1] * p.dy + R[1][2] * tz;
  o.dz = R[2][0] * tx + R[2][1] * p.dy + R[2][2] * tz;
  const double nx = uy * st, ny = -uz, nz = uy * ct;
  o.ny = R[1][0] * nx + R[1][1] * ny + R[1][2] * nz;
  o.nz = R[2][0] * nx + R[2][1] * ny + R[2][2] * nz;
  const double cos_chi = R[0][0] * ct - R[0][2] * st, cos2 = cos_chi * cos_chi;
  const double meridian = (p.dy * p.ddz - p.dz * p.ddy) * per_speed * per_speed * per_speed;
  o.curvature = cos2 * uy / r - (1.0 - cos2) * meridian;
  o.seen = seen;
  return o;
}

}  // namespace

void find_overlaps(const RailStrips& rail, const WheelCurve& wheel, const RelativePose& pose, double margin,
                   const OverlapScratch& scratch, Overlaps& overlaps) noexcept {
  const Curve& curve = wheel.curve;
  const Attitude2 attitude = attitude_of(pose);
  constexpr double nowhere = -1.0;  // [m]
  for (std::int32_t j = 0; j < rail.count; ++j) scratch.overlap[j] = nowhere;

  // Along the outline, from knot to knot: each ray that is crossed gets an estimate, the deepest one counts.
  std::int32_t last = -1;  // strips up to this one have their rays behind the knot
  bool seen_before = false;
  double y_before = 0.0, z_before = 0.0;
  for (std::int32_t k = 0; k <= curve.pieces; ++k) {
    const std::int32_t piece = std::min(k, curve.pieces - 1);
    const Outline o =
        outline_of(pose, attitude, evaluate(curve, piece, k == piece ? 0.0 : curve.s[k] - curve.s[piece]));
    const double y = o.y + pose.y, z = o.z + pose.z;
    const auto along = [&](std::int32_t j, double py, double pz) {
      return (py - rail.y[j]) * rail.ty[j] + (pz - rail.z[j]) * rail.tz[j];
    };
    const auto cross = [&](std::int32_t j) {
      if (!seen_before || !o.seen) return;
      const double from = along(j, y_before, z_before), to = along(j, y, z);
      const double t = from == to ? 0.5 : smaller(larger(from / (from - to), 0.0), 1.0);
      const double py = y_before + t * (y - y_before) - rail.y[j], pz = z_before + t * (z - z_before) - rail.z[j];
      const double overlap = -py * rail.tz[j] + pz * rail.ty[j];
      if (overlap <= scratch.overlap[j]) return;
      scratch.overlap[j] = overlap;
      scratch.piece[j] = k - 1;
      scratch.part[j] = t;
    };
    while (last + 1 < rail.count && along(last + 1, y, z) > 0.0) cross(++last);
    while (last >= 0 && along(last, y, z) <= 0.0) cross(last--);
    y_before = y;
    z_before = z;
    seen_before = o.seen;
  }

  // A chord of the outline lies at most this far from it.
  constexpr double sagitta = 30e-6;
  overlaps.count = 0;
  for (std::int32_t j = 0; j < rail.count && overlaps.count < overlaps.capacity; ++j) {
    if (scratch.overlap[j] < -margin - sagitta) continue;
    const std::int32_t k = scratch.piece[j];
    const double length = curve.s[k + 1] - curve.s[k];
    double u = scratch.part[j] * length;
    constexpr int steps = 5;
    for (int n = 0; n < steps; ++n) {
      const Outline o = outline_of(pose, attitude, evaluate(curve, k, u));
      const double miss = (o.y + pose.y - rail.y[j]) * rail.ty[j] + (o.z + pose.z - rail.z[j]) * rail.tz[j];
      const double slope = o.dy * rail.ty[j] + o.dz * rail.tz[j];
      const double step = std::abs(slope) > 0.02 ? miss / slope : 0.0;
      u = smaller(larger(u - step, 0.0), length);
    }
    const Outline o = outline_of(pose, attitude, evaluate(curve, k, u));
    const double py = o.y + pose.y - rail.y[j], pz = o.z + pose.z - rail.z[j];
    const double along_normal = -py * rail.tz[j] + pz * rail.ty[j];
    const double cosine = -o.ny * rail.tz[j] + o.nz * rail.ty[j];
    if (cosine < 0.2) continue;
    const double half = root(0.5 * (1.0 + cosine));
    const double depth = along_normal * cosine / (half * half);
    if (depth <= -margin) continue;
    const double curvature = o.curvature / half;
    if (!(curvature > 1e-2)) continue;
    const std::int32_t i = overlaps.count++;
    overlaps.strip[i] = j;
    overlaps.depth[i] = depth;
    overlaps.centre[i] = o.x;
    overlaps.curvature[i] = curvature;
    overlaps.ny[i] = 0.5 * (o.ny - rail.tz[j]) / half;
    overlaps.nz[i] = 0.5 * (o.nz + rail.ty[j]) / half;
    overlaps.wy[i] = o.y;
    overlaps.wz[i] = o.z;
  }
}

}  // namespace wrc
