/// Continuity and speed of the normal methods through the C interface, printed; S1002 on the benchmark UIC60.
///     normal_report sweep [--rows FILE.csv]    lateral shift -6..+7 mm by 0.02 mm, yaw -20..20 mrad, 80 kN;
///                         [--limits SHARE]     its second differences; status 1 when a solve fails or one
///                                              is beyond this share [1] of its limit
///
///     normal_report jumps [--limits SHARE]     the same: what is left of its changes as the step shrinks
///
///     normal_report flange [CELLS]             first touch leaping to the flange, against the exact solver
///                                              on CELLS x 2 CELLS cells [160]: of the true surfaces, of
///                                              the rows
///
///     normal_report trips                      load -> approach -> load of the methods that search the
///                                              approach: what leaps, and what does not come back
///
///     normal_report speed                      microseconds per solve of every method, 60 strips
///
///     normal_report solves METHOD cold|warm N  N solves of one method and nothing else, for a profiler
///
/// The first two end with one line of JSON when --json is given.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

const char* const method_names[] = {"hertz",   "kik_piotrowski", "ekp", "ekp_ellipse", "analyn",
                                    "stripes", "strip_halfspace"};
constexpr int32_t methods = 7;
constexpr double load_of_all = 80e3;  // [N]

/// A right wheel on its rail with one method.
class Wheel {
 public:
  wrc_planar_point point{};
  wrc_planar_normal_solution normal{};
  double tolerance = 0.0;  ///< of a prescribed load [-]

  Wheel(int32_t method, bool warm, int32_t rail_kind = WRC_PROFILE_UIC60_BENCHMARK) {
    wrc_config config = test_config();
    if (rail_kind == WRC_PROFILE_60E1) config.track.rail_inclination = 0.025;
    tolerance = config.normal.load_tolerance;
    config.normal.method = method;
    config.planar.start = warm ? 1 : 0;
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = rail_kind;
    load_.normal_force = load_of_all;
    if (wrc_model_create(&config, nullptr, &model_, nullptr, 0) < 0 ||
        wrc_contact_create(model_, WRC_SIDE_RIGHT, nullptr, &contact_, nullptr, 0) < 0) {
      std::fprintf(stderr, "no model\n");
      std::exit(2);
    }
    uint64_t bytes = 0;
    wrc_contact_state_size(model_, &bytes);
    state_.resize(bytes);
  }
  ~Wheel() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }
  Wheel(const Wheel&) = delete;
  Wheel& operator=(const Wheel&) = delete;

  int32_t place(double lateral, double yaw) {
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = lateral;
    pose.yaw = yaw;
    return wrc_planar_geometry(contact_, &pose, &point);
  }
  int32_t solve() { return wrc_planar_normal(contact_, nullptr, &load_, &normal); }
  int32_t solve_load(double normal_force) {
    wrc_planar_load load = wrc_planar_load_default();
    load.normal_force = normal_force;
    return wrc_planar_normal(contact_, nullptr, &load, &normal);
  }
  int32_t solve_approach(double approach) {
    wrc_planar_load load = wrc_planar_load_default();
    load.prescribed = WRC_PRESCRIBE_APPROACH;
    load.approach = approach;
    return wrc_planar_normal(contact_, nullptr, &load, &normal);
  }

  /// Takes over the rows of another wheel's gap, as the caller's.
  int32_t take_rows(const Wheel& other) {
    const FieldValues y = other.field(WRC_FIELD_GAP_Y, 0), height = other.field(WRC_FIELD_GAP_HEIGHT, 0),
                      centre = other.field(WRC_FIELD_GAP_CENTRE, 0),
                      curvature = other.field(WRC_FIELD_GAP_CURVATURE, 0);
    wrc_planar_gap gap = sized<wrc_planar_gap>();
    gap.row_count = static_cast<uint32_t>(y.strips);
    gap.y = y.values.data();
    gap.height = height.values.data();
    gap.centre = centre.values.data();
    gap.curvature = curvature.values.data();
    return wrc_planar_normal(contact_, &gap, &load_, &normal);
  }

  /// The shortest of three identical solves [us]: what the code takes, not what else the machine does.
  double time_of_solve() {
    double best = 1e9;
    wrc_contact_save(contact_, state_.data(), state_.size());
    for (int i = 0; i < 3; ++i) {
      wrc_contact_restore(contact_, state_.data(), state_.size());
      const auto start = std::chrono::steady_clock::now();
      solve();
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      best = std::min(best, time.count());
    }
    return best;
  }

  wrc_contact* contact() const { return contact_; }

  /// Box around all patches, contact frame [m].
  struct Extent {
    double x_from = 1.0, x_to = -1.0, y_from = 1.0, y_to = -1.0;
  };
  Extent extent() const {
    Extent box;
    for (int32_t k = 0; k < normal.patch_count; ++k) {
      const FieldValues y = field(WRC_FIELD_STRIP_Y, k), width = field(WRC_FIELD_STRIP_WIDTH, k),
                        half = field(WRC_FIELD_STRIP_HALF_LENGTH, k),
                        centre = field(WRC_FIELD_STRIP_CENTRE, k);
      for (uint64_t j = 0; j < y.strips; ++j) {
        box.x_from = std::min(box.x_from, centre[j] - half[j]);
        box.x_to = std::max(box.x_to, centre[j] + half[j]);
        box.y_from = std::min(box.y_from, y[j] - 0.5 * width[j]);
        box.y_to = std::max(box.y_to, y[j] + 0.5 * width[j]);
      }
    }
    return box;
  }

  /// Lateral centre of pressure, track frame: the contact frame jumps with the point of first touch [m].
  double centre() const {
    double moment = 0.0, load = 0.0;
    for (int32_t k = 0; k < normal.patch_count; ++k) {
      const FieldValues y = field(WRC_FIELD_STRIP_Y, k), width = field(WRC_FIELD_STRIP_WIDTH, k),
                        half = field(WRC_FIELD_STRIP_HALF_LENGTH, k), peak = field(WRC_FIELD_STRIP_PEAK, k);
      for (uint64_t j = 0; j < y.strips; ++j) {
        const double part = width[j] * half[j] * peak[j];
        moment += part * y[j];
        load += part;
      }
    }
    return point.y + std::cos(point.angle) * moment / load;
  }

 private:
  FieldValues field(int32_t id, int32_t of_patch) const { return field_values(contact_, of_patch, id); }
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
  wrc_planar_load load_ = wrc_planar_load_default();
  std::vector<unsigned char> state_;
};

// ------------------------------------------------------------------------------------------------- sweep

/// What must move smoothly while the wheelset does.
struct Solved {
  double lateral = 0.0, load = 0.0, centre = 0.0, area = 0.0, approach = 0.0, peak = 0.0, angle = 0.0;
  int32_t patches = 0;
  bool capped = false;  ///< sweeps were ended by their cap, and the result says so
};

/// The sweep in three stretches, by what the surfaces do there.
struct Stretch {
  const char* name;
  double to;  ///< lateral shift [m]
};
constexpr Stretch stretches[] = {
    {"tread", 4.0e-3},   // one patch, or several that drift; curvature leaps where arcs of the profiles join
    {"root", 6.3e-3},    // the patch runs onto the rail's arcs of 80 and 13 mm
    {"flange", 7.0e-3},  // first touch climbs the flange: patches come and go within micrometres
};
constexpr int stretch_count = 3;

/// The largest second difference |f(i + 1) - 2 f(i) + f(i - 1)| of one quantity, and where.
struct Jump {
  double size = 0.0, lateral = 0.0, yaw = 0.0;
};
struct Quantity {
  const char* name;
  const char* unit;
  double Solved::*value;
  double scale;                  ///< to the unit printed
  double limits[stretch_count];  ///< of the jumps, in the unit printed
  Jump largest[stretch_count] = {};
};
int sweep(bool json, const char* rows_path, double share_of_limits) {
  FILE* rows = rows_path != nullptr ? std::fopen(rows_path, "w") : nullptr;
  if (rows != nullptr)
    std::fprintf(rows, "yaw_mrad,lateral_mm,patches,area_mm2,approach_um,peak_MPa,centre_mm\n");
  // Why these sizes: with 80 kN at the centre the patch has 175 mm2, 67 um and 860 MPa. The load is
  // prescribed: nothing but rounding is left of its changes. Tread: a step over the joint of two arcs changes
  // a patch by up to 2 % and its centre by half a step. Root: curvature changes tenfold, so 3 % of area and
  // approach, 10 % of the peak, five steps of the centre. Flange: within a step the load may go over to
  // another contact, in another plane: the limits are a whole centre's way, area and peak there, and the
  // difference of the planes' approaches.
  Quantity quantities[] = {{"normal force", "N", &Solved::load, 1.0, {1e-6, 1e-6, 1e-6}},
                           {"patch centre", "mm", &Solved::centre, 1e3, {0.012, 0.1, 2.0}},
                           {"total area", "mm2", &Solved::area, 1e6, {1.2, 5.0, 125.0}},
                           {"approach", "um", &Solved::approach, 1e6, {0.8, 2.5, 60.0}},
                           {"peak pressure", "MPa", &Solved::peak, 1e-6, {14.0, 100.0, 2800.0}}};
  std::map<int32_t, int> flags;
  int solves = 0, failed = 0, changes = 0;
  Wheel wheel(WRC_NORMAL_STRIP_HALFSPACE, false);
  for (int mrad = -20; mrad <= 20; mrad += 5) {
    std::vector<Solved> path;
    for (int i = -300; i <= 350; ++i) {
      const double lateral = 0.02e-3 * i;
      int32_t status = wheel.place(lateral, 1e-3 * mrad);
      if (status >= 0) status = std::max(status, wheel.solve());
      ++solves;
      if (status < 0) {
        ++failed;
        continue;
      }
      if (status > 0) ++flags[status];
      const wrc_planar_normal_solution& p = wheel.normal;
      path.push_back({lateral, p.normal_force, wheel.centre(), p.area, p.approach, p.peak_pressure,
                      wheel.point.angle, p.patch_count});
      if (rows != nullptr)
        std::fprintf(rows, "%d,%.3f,%d,%.6f,%.6f,%.6f,%.6f\n", mrad, 1e3 * lateral, p.patch_count,
                     1e6 * p.area, 1e6 * p.approach, 1e-6 * p.peak_pressure, 1e3 * path.back().centre);
    }
    for (std::size_t i = 1; i < path.size(); ++i) changes += path[i].patches != path[i - 1].patches;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      int stretch = 0;
      while (path[i].lateral > stretches[stretch].to) ++stretch;
      for (Quantity& q : quantities) {
        double jump =
            std::fabs(path[i + 1].*q.value - 2.0 * (path[i].*q.value) + path[i - 1].*q.value) * q.scale;
        if (!std::isfinite(jump)) jump = HUGE_VAL;
        if (jump > q.largest[stretch].size) q.largest[stretch] = {jump, path[i].lateral, 1e-3 * mrad};
      }
    }
  }
  if (rows != nullptr) std::fclose(rows);

  std::printf("strip_halfspace, %.0f kN, lateral -6..+7 mm by 0.02 mm, yaw -20..20 mrad by 5 mrad\n",
              1e-3 * load_of_all);
  std::printf("%d solves, %d failed, %d changes of the number of patches\n", solves, failed, changes);
  for (const auto& [status, count] : flags) std::printf("  %-28s %d\n", wrc_status_name(status), count);
  std::printf("largest second difference |f(i+1) - 2 f(i) + f(i-1)| over 0.02 mm, the limit, and where\n");
  std::printf("%-18s", "");
  for (const Stretch& stretch : stretches)
    std::printf("  %-7s up to %+.1f mm%21s", stretch.name, 1e3 * stretch.to, "");
  std::printf("\n");
  int beyond = 0;
  for (const Quantity& q : quantities) {
    std::printf("%-14s %-4s", q.name, q.unit);
    for (int k = 0; k < stretch_count; ++k) {
      const Jump& jump = q.largest[k];
      const double limit = share_of_limits * q.limits[k];
      beyond += !(jump.size <= limit);
      std::printf("  %8.3g %s %-6g (%+5.2f mm %+3.0f mrad)", jump.size, jump.size <= limit ? "<=" : " >",
                  limit, 1e3 * jump.lateral, 1e3 * jump.yaw);
    }
    std::printf("\n");
  }
  if (json) {
    std::printf("{\"solves\": %d, \"failed\": %d, \"changes\": %d", solves, failed, changes);
    for (const auto& [status, count] : flags) std::printf(", \"%s\": %d", wrc_status_name(status), count);
    for (const Quantity& q : quantities)
      std::printf(", \"%s [%s]\": {\"tread\": %.6g, \"root\": %.6g, \"flange\": %.6g}", q.name, q.unit,
                  q.largest[0].size, q.largest[1].size, q.largest[2].size);
    std::printf("}\n");
  }
  if (beyond > 0) std::printf("%d jumps beyond their limits\n", beyond);
  return failed == 0 && beyond == 0 ? 0 : 1;
}

// ------------------------------------------------------------------------------------------------- jumps

/// A contact angle that changes by more than this in one step belongs to another contact [rad].
constexpr double turned = 0.05;

/// What is left of the change between two poses when the interval is halved towards the larger change again
/// and again: nothing but rounding for what is continuous, however steep, and the whole of a jump.
int jumps(double share_of_limits) {
  constexpr double step = 0.02e-3;
  constexpr int halvings = 12;
  struct Tracked {
    const char* name;
    const char* unit;
    double Solved::*value;
    double scale;
    double threshold;  ///< changes below this over a step are not looked into, in the unit printed
    double limit;      ///< of what is left, in the unit printed
    std::vector<Jump> found;
  };
  // Why these limits: a strip that comes or goes as a whole is a sixtieth of a patch: 3 mm2 of 175; the load
  // it hands over moves the centre between the tread and the flange, some 20 mm apart, by a thousandth, the
  // approach by 0.3 %. The peak is that of a spot a strip wide which comes up beside the patch, and is not
  // resolved.
  Tracked tracked[] = {{"patch centre", "mm", &Solved::centre, 1e3, 0.1, 0.02, {}},
                       {"total area", "mm2", &Solved::area, 1e6, 1.0, 3.0, {}},
                       {"approach", "um", &Solved::approach, 1e6, 1.0, 0.25, {}},
                       {"peak pressure", "MPa", &Solved::peak, 1e-6, 20.0, 130.0, {}}};
  Wheel wheel(WRC_NORMAL_STRIP_HALFSPACE, false);
  const auto at = [&](double lateral, double yaw) {
    wheel.place(lateral, yaw);
    const bool capped = wheel.solve() == WRC_FLAG_ITERATION_CAP;
    const wrc_planar_normal_solution& p = wheel.normal;
    return Solved{lateral,         p.normal_force,    wheel.centre(), p.area, p.approach,
                  p.peak_pressure, wheel.point.angle, p.patch_count,  capped};
  };
  int leaps = 0, capped = 0;
  for (int mrad = -20; mrad <= 20; mrad += 5) {
    const double yaw = 1e-3 * mrad;
    Solved before = at(-6e-3, yaw);
    for (int i = -299; i <= 350; ++i) {
      const Solved here = at(step * i, yaw);
      for (Tracked& t : tracked) {
        Solved low = before, high = here;
        const auto change = [&](const Solved& from, const Solved& to) {
          return std::fabs(to.*t.value - from.*t.value) * t.scale;
        };
        if (change(low, high) < t.threshold) continue;
        for (int n = 0; n < halvings; ++n) {
          const Solved middle = at(0.5 * (low.lateral + high.lateral), yaw);
          (change(low, middle) > change(middle, high) ? high : low) = middle;
        }
        if (std::fabs(high.angle - low.angle) > turned) {
          ++leaps;  // another contact plane: the load along its normal is another load
          continue;
        }
        if (low.capped || high.capped) {
          ++capped;
          continue;
        }
        t.found.push_back({change(low, high), low.lateral, yaw});
      }
      before = here;
    }
  }
  std::printf(
      "strip_halfspace, %.0f kN, lateral -6..+7 mm by 0.02 mm, yaw -20..20 mrad by 5 mrad\n"
      "changes over a step that are still there over %.0f nm; left out: %d of another contact plane, %d that "
      "end\n"
      "at a result flagged as capped\n",
      1e-3 * load_of_all, 1e9 * step / (1 << halvings), leaps, capped);
  std::printf("%-14s %-4s %10s %10s %10s %10s  %s\n", "", "", "looked at", "95th pct", "largest", "limit",
              "where");
  int beyond = 0;
  for (Tracked& t : tracked) {
    std::sort(t.found.begin(), t.found.end(), [](const Jump& a, const Jump& b) { return a.size < b.size; });
    if (t.found.empty()) continue;
    const Jump& most = t.found.back();
    const double limit = share_of_limits * t.limit;
    beyond += !(most.size <= limit);
    std::printf("%-14s %-4s %10zu %10.3g %10.3g %10.3g  %+5.2f mm %+3.0f mrad\n", t.name, t.unit,
                t.found.size(), t.found[t.found.size() * 95 / 100].size, most.size, limit, 1e3 * most.lateral,
                1e3 * most.yaw);
  }
  if (beyond > 0) std::printf("%d jumps beyond their limits\n", beyond);
  return beyond == 0 ? 0 : 1;
}

// ------------------------------------------------------------------------------------------------ flange

/// The exact solution of the gap in a contact.
struct Exact {
  bool solved = false;
  wrc_exact_normal_solution of = sized<wrc_exact_normal_solution>();
  double ahead = 0.0;  ///< where the peak lies: x from the middle of its row [m]
};

Exact solve_exactly(wrc_contact* contact, const wrc_grid& grid, double load) {
  std::vector<double> gap(static_cast<std::size_t>(grid.nx) * grid.ny), pressure(gap.size());
  wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
  problem.normal_force = load;
  problem.grid = grid;
  problem.gap = gap.data();
  Exact exact;
  exact.of.pressure = pressure.data();
  exact.solved = wrc_exact_gap(contact, &grid, gap.data()) >= 0 &&
                 wrc_exact_normal(&problem, &exact.of, nullptr, 0) >= 0;
  const std::ptrdiff_t cells = grid.nx;
  const std::ptrdiff_t peak = std::max_element(pressure.begin(), pressure.end()) - pressure.begin();
  const auto row = gap.begin() + peak - peak % cells;
  const std::ptrdiff_t middle = std::min_element(row, row + cells) - row;
  exact.ahead = grid.dx * static_cast<double>(peak % cells - middle);
  return exact;
}

/// The strips against the exact half-space solver, where first touch moves to the flange: on the true
/// surfaces, and on the rows the strips read. `cells` along x, twice as many along y.
int flange(uint32_t cells) {
  std::printf(
      "strip_halfspace against the exact solver of the true surfaces | of the rows the strips read; %.0f kN\n"
      "errors in %%; x: of the exact peak, from the middle of its row [mm]\n"
      "%8s %6s %8s %9s %9s %9s",
      1e-3 * load_of_all, "lateral", "yaw", "patches", "approach", "area", "peak");
  for (int i = 0; i < 2; ++i) std::printf(" | %8s %7s %7s %7s", "approach", "area", "peak", "x");
  std::printf("\n");
  Wheel wheel(WRC_NORMAL_STRIP_HALFSPACE, false), rows(WRC_NORMAL_STRIP_HALFSPACE, false);
  for (double yaw : {0.0, 0.010})
    for (double lateral : {6.0, 6.1, 6.2, 6.3, 6.4, 6.5, 6.55, 6.6, 6.65, 6.7, 6.75, 6.85, 6.95}) {
      lateral *= 1e-3;
      wheel.place(lateral, yaw);
      wheel.solve();
      rows.take_rows(wheel);
      const Wheel::Extent extent = wheel.extent();
      constexpr double margin = 1e-3;
      wrc_grid grid = sized<wrc_grid>();
      grid.nx = cells;
      grid.ny = 2 * cells;
      grid.dx = (extent.x_to - extent.x_from + 2.0 * margin) / grid.nx;
      grid.dy = (extent.y_to - extent.y_from + 2.0 * margin) / grid.ny;
      grid.x0 = extent.x_from - margin + 0.5 * grid.dx;
      grid.y0 = extent.y_from - margin + 0.5 * grid.dy;
      const wrc_planar_normal_solution& p = wheel.normal;
      std::printf("%+8.3f %6.0f %8d %9.3f %9.3f %9.1f", 1e3 * lateral, 1e3 * yaw, p.patch_count,
                  1e6 * p.approach, 1e6 * p.area, 1e-6 * p.peak_pressure);
      for (const Wheel* each : {&wheel, &rows}) {
        const Exact exact = solve_exactly(each->contact(), grid, p.normal_force);
        if (!exact.solved) return 1;
        std::printf(" | %+8.2f %+7.2f %+7.2f %7.2f", 100.0 * (p.approach / exact.of.approach - 1.0),
                    100.0 * (p.area / exact.of.area - 1.0),
                    100.0 * (p.peak_pressure / exact.of.peak_pressure - 1.0), 1e3 * exact.ahead);
      }
      std::printf("\n");
    }
  return 0;
}

// ------------------------------------------------------------------------------------------------- trips

/// From a load to its approach and back, of the methods that search the approach: the load comes back, or a
/// flag says that the method's load leaps. Fails where neither is so.
int trips() {
  std::printf(
      "load -> approach -> load, lateral -6..+6 mm by 0.05 mm, yaw -5, 0, 15 mrad, eleven loads of 0.5..150 "
      "kN\n"
      "%-16s %-10s %8s %8s %8s %8s %8s   %s\n",
      "method", "rail", "trips", "leaps", "capped", "failed", "lost", "largest error without a flag");
  const struct {
    const char* name;
    int32_t kind;
  } rails[] = {{"benchmark", WRC_PROFILE_UIC60_BENCHMARK}, {"60E1", WRC_PROFILE_60E1}};
  int bad = 0;
  for (int32_t method = 0; method < WRC_NORMAL_STRIP_HALFSPACE; ++method)
    for (const auto& rail : rails) {
      Wheel wheel(method, false, rail.kind);
      int count = 0, leaps = 0, capped = 0, failed = 0, lost = 0;
      double worst = 0.0, worst_lateral = 0.0, worst_yaw = 0.0, worst_load = 0.0;
      for (const double yaw : {-5e-3, 0.0, 15e-3})
        for (int i = -120; i <= 120; ++i) {
          const double lateral = 0.05e-3 * i;
          if (wheel.place(lateral, yaw) < 0) ++failed;
          double load = 500.0;
          for (int k = 0; k <= 10; ++k, load *= std::pow(300.0, 0.1)) {
            ++count;
            const int32_t status = wheel.solve_load(load);
            if (status < 0) {
              ++failed;
              continue;
            }
            const double found = wheel.normal.approach;
            if (status == WRC_FLAG_ITERATION_CAP || status == WRC_FLAG_LOAD_JUMPS) {
              ++(status == WRC_FLAG_LOAD_JUMPS ? leaps : capped);
              continue;
            }
            if (wheel.solve_approach(found) < 0) {
              ++failed;
              continue;
            }
            const double error = std::fabs(wheel.normal.normal_force / load - 1.0);
            lost += error > wheel.tolerance;
            if (error > worst) {
              worst = error;
              worst_lateral = lateral;
              worst_yaw = yaw;
              worst_load = load;
            }
          }
        }
      bad += failed + lost;
      std::printf("%-16s %-10s %8d %8d %8d %8d %8d   %.2e (%+5.2f mm %+3.0f mrad %.1f kN)\n",
                  method_names[method], rail.name, count, leaps, capped, failed, lost, worst,
                  1e3 * worst_lateral, 1e3 * worst_yaw, 1e-3 * worst_load);
    }
  return bad == 0 ? 0 : 1;
}

// ------------------------------------------------------------------------------------------------- speed

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

/// Times along the sweep, straight and under 10 mrad of yaw, 20 um per step [us].
std::vector<double> times(int32_t method, bool warm) {
  std::vector<double> found;
  Wheel wheel(method, warm);
  for (double yaw : {0.0, 0.010}) {
    for (int i = -300; i <= 350; ++i) {
      if (wheel.place(0.02e-3 * i, yaw) >= 0) found.push_back(wheel.time_of_solve());
    }
  }
  return found;
}

int speed(bool json) {
  std::printf(
      "microseconds per solve, load prescribed, 60 strips, gap given (the shortest of three runs each;\n"
      "lateral -6..+7 mm by 20 um, yaw 0 and 10 mrad)\n");
  std::printf("%-16s %5s %8s %8s %8s %12s\n", "method", "start", "p50", "p99", "max", "p50 / EKP");
  const double ekp = quantile(times(WRC_NORMAL_EKP, false), 0.5);
  std::string line;
  for (int32_t method = 0; method < methods; ++method) {
    for (bool warm : {false, true}) {
      if (warm && method != WRC_NORMAL_STRIP_HALFSPACE)
        continue;  // only this one starts from the last solution
      const std::vector<double> t = times(method, warm);
      const char* const start = warm ? "warm" : "cold";
      const double p50 = quantile(t, 0.5), p99 = quantile(t, 0.99), most = quantile(t, 1.0);
      std::printf("%-16s %5s %8.1f %8.1f %8.1f %12.2f\n", method_names[method], start, p50, p99, most,
                  p50 / ekp);
      char entry[256];
      std::snprintf(entry, sizeof entry,
                    "%s\"%s %s\": {\"p50\": %.2f, \"p99\": %.2f, \"max\": %.2f, \"to_ekp\": %.3f}",
                    line.empty() ? "" : ", ", method_names[method], start, p50, p99, most, p50 / ekp);
      line += entry;
    }
  }
  if (json) std::printf("{%s}\n", line.c_str());
  return 0;
}

int solves(const char* name, bool warm, int count) {
  const auto found = std::find_if(method_names, method_names + methods,
                                  [&](const char* each) { return std::strcmp(each, name) == 0; });
  if (found == method_names + methods) return 2;
  Wheel wheel(static_cast<int32_t>(found - method_names), warm);
  long iterations = 0;
  for (int i = 0; i < count; ++i) {
    wheel.place(0.02e-3 * (i % 650 - 300), 0.0);
    wheel.solve();
    iterations += wheel.normal.iterations;
  }
  std::printf("%d solves, %.2f iterations each\n", count, static_cast<double>(iterations) / count);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  bool json = false;
  const char* rows = nullptr;
  double limits = 1.0;
  for (int i = 2; i < argc; ++i) {
    json = json || std::strcmp(argv[i], "--json") == 0;
    if (std::strcmp(argv[i], "--rows") == 0 && i + 1 < argc) rows = argv[i + 1];
    if (std::strcmp(argv[i], "--limits") == 0 && i + 1 < argc) limits = std::atof(argv[i + 1]);
  }
  if (what == "sweep") return sweep(json, rows, limits);
  if (what == "jumps") return jumps(limits);
  if (what == "flange") {
    const int cells = argc > 2 ? std::atoi(argv[2]) : 160;
    if (cells >= 4 && cells <= 512) return flange(static_cast<uint32_t>(cells));
  }
  if (what == "trips") return trips();
  if (what == "speed") return speed(json);
  if (what == "solves" && argc > 4)
    return solves(argv[2], std::strcmp(argv[3], "warm") == 0, std::atoi(argv[4]));
  std::fprintf(
      stderr,
      "usage: normal_report sweep [--rows FILE] [--limits SHARE] [--json] | jumps [--limits SHARE] | "
      "flange [CELLS 4..512] | trips | speed [--json] | solves METHOD cold|warm N\n");
  return 2;
}
