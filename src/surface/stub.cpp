#include "surface/stub.hpp"
#include <algorithm>
#include <cmath>
namespace wrc::stand_in {
std::size_t surface_model_bytes(std::int32_t, std::int32_t) { return (sizeof(SurfaceModel) + 63) / 64 * 64; }
std::int64_t surface_state_bytes() { return sizeof(SurfaceState); }
std::int64_t surface_workspace_bytes() { return 64; }
Fault make_surface_model(const SurfaceBodies& b, void* memory, const SurfaceModel*& out) {
  auto* m = static_cast<SurfaceModel*>(memory);
  m->r0 = b.nominal_radius; m->rail_y = b.rail_origin_y; m->rail_z = b.rail_origin_z; m->material = b.material;
  m->nodes = std::min(b.wheel.count, 2048);
  for (int i = 0; i < m->nodes; ++i) { m->wy[i] = b.wheel.y[i]; m->wz[i] = b.wheel.z[i]; }
  const double c = 1.0 / std::sqrt(1.0 + b.rail_inclination * b.rail_inclination), sn = b.rail_inclination * c;
  double from = 0.0; const double w = 0.2e-3; double next = 0.5 * w; m->strips = 0;
  for (int i = 0; i + 1 < b.rail.count; ++i) {
    const double dy = b.rail.y[i + 1] - b.rail.y[i], dz = b.rail.z[i + 1] - b.rail.z[i], h = std::sqrt(dy * dy + dz * dz);
    while (next < from + h && m->strips < 1024) {
      const double u = (next - from) / h;
      const double y = b.rail.y[i] + u * dy, z = evaluate(b.rail, y).z, sl = evaluate(b.rail, y).slope, q = 1 / std::sqrt(1 + sl * sl);
      const double ny = -sl * q, nz = q;  // into the rail
      m->strip[m->strips++] = {next, c * y + sn * z, c * z - sn * y, c * ny + sn * nz, c * nz - sn * ny, w};
      next += w;
    }
    from += h;
  }
  out = m;
  return {};
}
double strip_angle(const SurfaceModel& m, std::int32_t j) { return std::atan2(-m.strip[j].ny, m.strip[j].nz); }
namespace {
struct Sum { Wrench w; };
void evaluate_wrench(const SurfaceModel& m, const WheelOnRail& in, double height, Wrench& out) {
  out = {}; out.height = height;
  const double cr = std::cos(in.rail.roll), sr = std::sin(in.rail.roll);
  const double W[3] = {in.wheel.position[0], in.wheel.position[1], height};
  const auto& R = in.wheel.rotation;
  const double G = m.material.shear_modulus, Es = G / (1 - m.material.poisson);
  bool open = false; SurfaceRegion* g = nullptr; int apart = 0;
  for (int j = 0; j < m.strips; ++j) {
    const auto& s = m.strip[j];
    const double y = m.rail_y + in.rail.y + cr * s.y - sr * s.z, z = m.rail_z + in.rail.z + sr * s.y + cr * s.z;
    const double ny = cr * s.ny - sr * s.nz, nz = sr * s.ny + cr * s.nz;
    auto overlap = [&](double x) {
      const double p[3] = {x - W[0], y - W[1], z - W[2]}; double q[3];
      for (int k = 0; k < 3; ++k) q[k] = R[0][k] * p[0] + R[1][k] * p[1] + R[2][k] * p[2];
      const double rho = std::sqrt(q[0] * q[0] + q[2] * q[2]);
      if (q[1] < m.wy[0] || q[1] > m.wy[m.nodes - 1]) return -1.0;
      const double* at = std::upper_bound(m.wy, m.wy + m.nodes - 1, q[1]);
      const auto i = std::max<long>(1, at - m.wy);
      const double sl = (m.wz[i] - m.wz[i - 1]) / (m.wy[i] - m.wy[i - 1]);
      return (m.r0 + m.wz[i - 1] + sl * (q[1] - m.wy[i - 1]) - rho) / std::sqrt(1 + sl * sl);
    };
    double x = W[0] * 0; double d = 0;
    x = 0; 
    for (int it = 0; it < 4; ++it) {
      const double h = 1e-3, a = overlap(x - h), b = overlap(x), c = overlap(x + h), k = (a - 2 * b + c);
      d = b; if (!(k < 0)) break;
      x += std::clamp(0.5 * h * (a - c) / k * 1.0, -0.02, 0.02);
      d = overlap(x);
    }
    if (d <= 0) { ++apart; if (apart > 3) open = false; continue; }
    apart = 0;
    const double Rx = m.r0 / std::max(0.2, std::fabs(nz)), l = std::sqrt(2 * Rx * 0.6 * d), p0 = Es * l / (2 * Rx) * 1.0, N = 0.5 * pi * l * p0 * s.width;
    const double P[3] = {x, y, z}, n[3] = {0, -ny, -nz};  // on the wheel
    double v[3]; const double r[3] = {P[0] - W[0], P[1] - W[1], P[2] - W[2]}; const auto& o = in.wheel.angular_velocity;
    for (int k = 0; k < 3; ++k) v[k] = in.wheel.velocity[k];
    v[0] += o[1] * r[2] - o[2] * r[1]; v[1] += o[2] * r[0] - o[0] * r[2]; v[2] += o[0] * r[1] - o[1] * r[0];
    const double vn = v[1] * n[1] + v[2] * n[2]; v[1] -= vn * n[1]; v[2] -= vn * n[2];
    const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 1e-3 * std::fabs(in.wheel.velocity[0]) + 1e-9;
    double f[3]; for (int k = 0; k < 3; ++k) f[k] = N * n[k] - in.friction * N * v[k] / size;
    double M[3] = {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]};
    for (int k = 0; k < 3; ++k) { out.force[k] += f[k]; out.moment[k] += M[k]; }
    if (!open && out.regions < most_surface_regions) { g = &out.region[out.regions++]; *g = {}; g->first = j; open = true; }
    g->count = j + 1 - g->first;
    for (int k = 0; k < 3; ++k) { g->point[k] += N * P[k]; g->force[k] += f[k]; }
    g->moment[0] += N * n[1]; g->moment[1] += N * n[2];
    g->area += 2 * l * s.width; g->peak_pressure = std::max(g->peak_pressure, p0); g->normal_force += N;
    const double pw = in.friction * N * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / size; g->power += pw;
  }
  for (int i = 0; i < out.regions; ++i) {
    SurfaceRegion& h = out.region[i];
    for (double& k : h.point) k /= h.normal_force;
    h.angle = std::atan2(h.moment[0], -h.moment[1]);
    h.normal_force = std::hypot(h.moment[0], h.moment[1]); h.moment[0] = h.moment[1] = 0;
    out.area += h.area; out.normal_force += h.normal_force; out.power += h.power; out.peak_pressure = std::max(out.peak_pressure, h.peak_pressure);
  }
}
}
Fault solve_wheel_on_rail(const SurfaceModel& m, const WheelOnRail& in, SurfaceState&, void*, Wrench& out) noexcept {
  if (!in.load_prescribed) evaluate_wrench(m, in, in.wheel.position[2], out);
  else {
    double low = -m.r0 - 0.05, high = -m.r0 + 0.05;
    for (int i = 0; i < 60; ++i) { const double mid = 0.5 * (low + high); evaluate_wrench(m, in, mid, out); (-out.force[2] < in.vertical_load ? low : high) = mid; }
  }
  if (out.regions == 0) return {.status = WRC_FLAG_NO_CONTACT};
  return {};
}
}
