// Generates the force table (tangential/force_table/force_table.hpp) from the exact half-space solver:
//     wrc_make_force_table FILE [threads]
// Each shape, a pair (a/b, psi), is appended to FILE.progress when it is solved, and told on stderr; a run
// that was interrupted goes on from there. Delete that file after a change of the axes or the solver. 33
// shapes, 1900 or 3400 creepages each, each solved on two grids: some ten minutes of one core.

#include <Eigen/LU>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "halfspace/tangential.hpp"
#include "linear_theory/linear_theory.hpp"
#include "patch/material.hpp"
#include "sdec_pressure.hpp"
#include "tangential/force_table/force_table_file.hpp"

namespace {

using namespace wrc;

constexpr tangential::ForceTableAxes axes{.ratios = 11,
                                          .shapes = 3,
                                          .elevations = 11,
                                          .azimuths = 24,
                                          .saturations = 17,
                                          .largest_ratio = 10.0,
                                          .largest_shape_number = 0.8,
                                          .half_saturation = 1.5,
                                          .poisson = 0.27};

// Error of the forces on n x n cells: about 25 % of mu N / n, mostly of first order. Extrapolated from these
// two it is 0.1 % (median) and 0.35 % (95th percentile).
constexpr int coarse_cells = 16, fine_cells = 32;
constexpr int linear_theory_cells = 32;

struct Values {
  double v[tangential::force_table_values] = {};
};

// All nodes of one shape; element (elevation, azimuth, saturation).
class Shape {
 public:
  Shape() : values_(static_cast<std::size_t>(axes.elevations * axes.azimuths * axes.saturations)) {}
  Values& at(int elevation, int azimuth, int saturation) {
    const int column = (azimuth % axes.azimuths + axes.azimuths) % axes.azimuths;
    return values_[static_cast<std::size_t>((elevation * axes.azimuths + column) * axes.saturations +
                                            saturation)];
  }
  std::vector<Values>& all() { return values_; }

 private:
  std::vector<Values> values_;
};

// In units G = c = mu = N = 1. Creepages and moment of a node are about the centre of pressure.
class ShapeSolver {
 public:
  ShapeSolver(double ratio, double psi)
      : patch_{.a = std::sqrt(ratio), .b = 1.0 / std::sqrt(ratio), .psi = psi},
        centre_(tangential::pressure_centre({patch_.a, patch_.b, psi})),
        scale_(tangential::creepage_scale(ratio)),
        linear_(halfspace::LinearTheory(ratio, axes.poisson, linear_theory_cells).at(psi).value),
        coarse_(grid(coarse_cells), {1.0, axes.poisson}),
        fine_(grid(fine_cells), {1.0, axes.poisson}) {}

  // Of one direction (unit vector of scaled creepages), for all saturations.
  void solve(const double direction[3], Shape& shape, int elevation, int azimuth, int& unfinished) {
    const int last = axes.saturations - 1;
    const tangential::Creepage unit{direction[0] / scale_.longitudinal, direction[1] / scale_.lateral,
                                    direction[2] / scale_.spin};
    shape.at(elevation, azimuth, 0) = linear(unit);
    for (int i = 1; i < last; ++i) {
      const double t = tangential::node_saturation(axes, i), r = axes.half_saturation * t / (1.0 - t);
      shape.at(elevation, azimuth, i) =
          partial({r * unit.longitudinal, r * unit.lateral, r * unit.spin}, t, unfinished);
    }
    shape.at(elevation, azimuth, last) = full_slip(unit);
  }

 private:
  halfspace::Grid grid(int cells) const { return halfspace::grid_over(patch_, cells, cells); }

  // Force / t for t -> 0: v = half_saturation * t.
  Values linear(const tangential::Creepage& unit) const {
    const tangential::Creepage joint = at_joint(unit);
    const double nx = joint.longitudinal, ny = joint.lateral, phi = joint.spin;
    const double fx = -(linear_.c11 * nx + linear_.c13 * phi);
    const double fy = -(linear_.c22 * ny + linear_.c23 * phi);
    const double mz = -(linear_.c31 * nx + linear_.c32 * ny + linear_.c33 * phi) + centre_ * fx;
    return {{axes.half_saturation * fx, axes.half_saturation * fy, axes.half_saturation * mz, 1.0}};
  }

  Values partial(const tangential::Creepage& creepage, double t, int& unfinished) {
    const auto on = [&](halfspace::RollingSolver& solver) {
      halfspace::RollingProblem problem;
      problem.pressure =
          halfspace::sdec_pressure(patch_, peak_, solver.grid(), halfspace::CellPressure::mean);
      problem.friction = {1.0};
      problem.creepage = at_joint(creepage);
      problem.tolerance = 1e-3;
      const halfspace::RollingSolution s = solver.solve(problem);
      if (s.fault.status != WRC_OK) ++unfinished;
      const double mz = s.forces.mz + centre_ * s.forces.fx;
      return Values{{s.forces.fx, s.forces.fy, mz, s.forces.adhesion_fraction}};
    };
    const Values coarse = on(coarse_), fine = on(fine_);
    Values limit = fine;
    for (int k = 0; k < 3; ++k) {
      limit.v[k] += (fine.v[k] - coarse.v[k]) * coarse_cells / (fine_cells - coarse_cells);
      limit.v[k] /= t;
    }
    return limit;
  }

  // Friction against the rigid slip, by the midpoint rule in the angles of the two half ellipses.
  Values full_slip(const tangential::Creepage& unit) const {
    const tangential::Creepage c = at_joint(unit);
    constexpr int n = 256;
    double fx = 0.0, fy = 0.0, mz = 0.0;
    for (int side = -1; side <= 1; side += 2) {
      const double width = patch_.b * (1.0 + side * patch_.psi);
      for (int j = 0; j < n; ++j) {
        const double v = 0.5 * pi * (j + 0.5) / n, y = side * width * std::sin(v);
        const double half_length = patch_.a * std::cos(v);
        for (int i = 0; i < n; ++i) {
          const double u = pi * ((i + 0.5) / n - 0.5), x = half_length * std::sin(u);
          const double load = peak_ * std::cos(v) * std::cos(u) *                // pressure
                              half_length * std::cos(u) * width * std::cos(v) *  // dx dy
                              pi / n * 0.5 * pi / n;
          const double wx = c.longitudinal - c.spin * y, wy = c.lateral + c.spin * x;
          const double w = std::hypot(wx, wy);
          if (!(w > 0.0)) continue;
          fx -= load * wx / w;
          fy -= load * wy / w;
          mz -= load * (x * wy - y * wx) / w;
        }
      }
    }
    return {{fx, fy, mz + centre_ * fx, 0.0}};
  }

  tangential::Creepage at_joint(const tangential::Creepage& c) const {
    return {c.longitudinal + c.spin * centre_, c.lateral, c.spin};
  }

  static constexpr double peak_ = 1.5 / pi;
  halfspace::SdecPatch patch_;
  double centre_;
  tangential::CreepageScale scale_;
  halfspace::LinearCoefficients linear_;
  halfspace::RollingSolver coarse_, fine_;
};

Shape solve_shape(int ratio, int shape_number, int& unfinished) {
  const double psi = tangential::node_shape_number(axes, shape_number);
  ShapeSolver solver(tangential::node_ratio(axes, ratio), psi);
  Shape shape;
  const int n = axes.azimuths, top = axes.elevations - 1;
  for (int e = 0; e <= top; ++e) {
    for (int k = 0; k < n; ++k) {
      const auto copy = [&](int from, double sign_x, double sign_y) {
        for (int i = 0; i < axes.saturations; ++i) {
          Values v = shape.at(e, from, i);
          v.v[0] *= sign_x;
          v.v[1] *= sign_y;
          v.v[2] *= sign_y;
          shape.at(e, k, i) = v;
        }
      };
      const int mirrored = n / 2 - k;  // of an ellipse: the direction seen in y -> -y, with all signs changed
      if (e == top && k > 0) {
        copy(0, 1.0, 1.0);  // pure spin has no azimuth
      } else if (e == 0 && k >= n / 2) {
        copy(k - n / 2, -1.0, -1.0);  // without spin: the opposite direction
      } else if (psi == 0.0 && mirrored >= 0 && mirrored < k) {
        copy(mirrored, -1.0, 1.0);
      } else if (psi == 0.0 && k > n / 2 && n + mirrored < k) {
        copy(n + mirrored, -1.0, 1.0);
      } else {
        const double elevation = 0.5 * pi * e / top, azimuth = 2.0 * pi * k / n;
        const double direction[3] = {std::cos(elevation) * std::cos(azimuth),
                                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
        solver.solve(direction, shape, e, k, unfinished);
      }
    }
  }
  return shape;
}

// ------------------------------------------------------------------------------------------------- progress

struct Record {
  std::int32_t ratio = 0, shape_number = 0, unfinished = 0, reserved = 0;
};

class Progress {
 public:
  explicit Progress(std::string path)
      : path_(std::move(path)), shapes_(static_cast<std::size_t>(axes.ratios * axes.shapes)) {
    if (std::FILE* file = std::fopen(path_.c_str(), "rb")) {
      Record record;
      Shape shape;
      while (std::fread(&record, sizeof record, 1, file) == 1 &&
             std::fread(shape.all().data(), sizeof(Values), shape.all().size(), file) == shape.all().size()) {
        shapes_.at(index(record.ratio, record.shape_number)) = shape.all();
        ++done_;
        unfinished_ += record.unfinished;
      }
      std::fclose(file);
      std::fprintf(stderr, "%s: %d shapes are there\n", path_.c_str(), done_);
      rewrite();  // an interrupted record at the end would hide those after it
    }
  }

  bool has(int ratio, int shape_number) const { return !shapes_[index(ratio, shape_number)].empty(); }

  void add(int ratio, int shape_number, Shape& shape, int unfinished) {
    const std::lock_guard lock(mutex_);
    shapes_[index(ratio, shape_number)] = shape.all();
    append({ratio, shape_number, unfinished, 0}, shape.all(), "ab");
    ++done_;
    ++added_;
    unfinished_ += unfinished;
    const double minutes =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() / 60.0;
    const int total = static_cast<int>(shapes_.size());
    std::fprintf(stderr,
                 "%d of %d shapes, %.0f min, about %.0f min left, %d solutions at the iteration cap\n", done_,
                 total, minutes, minutes * (total - done_) / added_, unfinished_);
  }

  const std::vector<Values>& shape(int ratio, int shape_number) const {
    return shapes_[index(ratio, shape_number)];
  }

 private:
  static std::size_t index(int ratio, int shape_number) {
    return static_cast<std::size_t>(ratio * axes.shapes + shape_number);
  }
  void append(const Record& record, const std::vector<Values>& values, const char* mode) const {
    std::FILE* file = std::fopen(path_.c_str(), mode);
    const bool written = file != nullptr && std::fwrite(&record, sizeof record, 1, file) == 1 &&
                         std::fwrite(values.data(), sizeof(Values), values.size(), file) == values.size();
    if (file == nullptr || std::fclose(file) != 0 || !written) {
      std::fprintf(stderr, "cannot write %s\n", path_.c_str());
      std::exit(1);
    }
  }
  void rewrite() const {
    const char* mode = "wb";
    for (int i = 0; i < axes.ratios; ++i) {
      for (int j = 0; j < axes.shapes; ++j) {
        if (!has(i, j)) continue;
        append({i, j, 0, 0}, shape(i, j), mode);
        mode = "ab";
      }
    }
  }

  std::string path_;
  std::vector<std::vector<Values>> shapes_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int done_ = 0, added_ = 0, unfinished_ = 0;
};

void solve_all(Progress& progress, int threads) {
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int k = next++; k < axes.ratios * axes.shapes; k = next++) {
      const int ratio = k / axes.shapes, shape_number = k % axes.shapes;
      if (progress.has(ratio, shape_number)) continue;
      int unfinished = 0;
      Shape shape = solve_shape(ratio, shape_number, unfinished);
      progress.add(ratio, shape_number, shape, unfinished);
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& each : others) each.join();
}

// -------------------------------------------------------------------------------------------------- splines

// From values at the nodes to coefficients of the quadratic B-spline through them.
Eigen::MatrixXd open_filter(int n) {
  Eigen::MatrixXd spline = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    const int middle = std::clamp(i, 1, n - 2);
    const double u = i - middle;
    spline(i, middle - 1) = 0.5 * (0.5 - u) * (0.5 - u);
    spline(i, middle) = 0.75 - u * u;
    spline(i, middle + 1) = 0.5 * (0.5 + u) * (0.5 + u);
  }
  return spline.inverse();
}

Eigen::MatrixXd closed_filter(int n) {
  Eigen::MatrixXd spline = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    spline(i, i) = 0.75;
    spline(i, (i + 1) % n) = spline(i, (i + n - 1) % n) = 0.125;
  }
  return spline.inverse();
}

// Replaces the line of numbers that `element` shows by its coefficients.
void filter(const Eigen::MatrixXd& matrix, const std::function<double&(int)>& element) {
  Eigen::VectorXd line(matrix.rows());
  for (int i = 0; i < line.size(); ++i) line(i) = element(i);
  line = matrix * line;
  for (int i = 0; i < line.size(); ++i) element(i) = line(i);
}

// Along a great circle through the pole, which is closed: up at one azimuth, down at the opposite one, then
// on at negative spin, where signs of creepages and forces are changed.
void filter_elevation(const Eigen::MatrixXd& matrix, Shape& shape, int azimuth, int saturation, int value) {
  const int top = axes.elevations - 1, half = 2 * top, opposite = azimuth + axes.azimuths / 2;
  const double sign = value < 3 ? -1.0 : 1.0;
  Eigen::VectorXd circle(2 * half);
  for (int i = 0; i < half; ++i) {
    const Values& node =
        i <= top ? shape.at(i, azimuth, saturation) : shape.at(half - i, opposite, saturation);
    circle(i) = node.v[value];
    circle(i + half) = sign * circle(i);
  }
  circle = matrix * circle;
  for (int i = 0; i <= top; ++i) shape.at(i, azimuth, saturation).v[value] = circle(i);
  for (int i = 0; i <= top; ++i) shape.at(i, opposite, saturation).v[value] = circle(half - i);
}

void filter_direction(Shape& shape) {
  const Eigen::MatrixXd around = closed_filter(axes.azimuths), up = closed_filter(4 * (axes.elevations - 1)),
                        along = open_filter(axes.saturations);
  for (int value = 0; value < tangential::force_table_values; ++value) {
    for (int e = 0; e < axes.elevations; ++e) {
      for (int k = 0; k < axes.azimuths; ++k)
        filter(along, [&](int i) -> double& { return shape.at(e, k, i).v[value]; });
      for (int i = 0; i < axes.saturations; ++i)
        filter(around, [&](int k) -> double& { return shape.at(e, k, i).v[value]; });
    }
    for (int k = 0; k < axes.azimuths / 2; ++k) {
      for (int i = 0; i < axes.saturations; ++i) filter_elevation(up, shape, k, i, value);
    }
  }
}

std::vector<float> coefficients(const Progress& progress) {
  std::vector<Shape> shapes(static_cast<std::size_t>(axes.ratios * axes.shapes));
  const auto shape_at = [&](int i, int j) -> Shape& {
    return shapes[static_cast<std::size_t>(i * axes.shapes + j)];
  };
  for (int i = 0; i < axes.ratios; ++i) {
    for (int j = 0; j < axes.shapes; ++j) {
      shape_at(i, j).all() = progress.shape(i, j);
      filter_direction(shape_at(i, j));
    }
  }
  const Eigen::MatrixXd over_ratio = open_filter(axes.ratios), over_shape = open_filter(axes.shapes);
  for (std::size_t node = 0; node < shapes.front().all().size(); ++node) {
    for (int value = 0; value < tangential::force_table_values; ++value) {
      const auto element = [&](int i, int j) -> double& { return shape_at(i, j).all()[node].v[value]; };
      for (int i = 0; i < axes.ratios; ++i)
        filter(over_shape, [&](int j) -> double& { return element(i, j); });
      for (int j = 0; j < axes.shapes; ++j)
        filter(over_ratio, [&](int i) -> double& { return element(i, j); });
    }
  }
  std::vector<float> all;
  for (int e = 0; e < axes.elevations; ++e) {
    for (int k = 0; k < axes.azimuths; ++k) {
      for (int i = 0; i < axes.ratios; ++i) {
        for (int t = 0; t < axes.saturations; ++t) {
          for (int j = 0; j < axes.shapes; ++j) {
            for (const double value : shape_at(i, j).at(e, k, t).v) all.push_back(static_cast<float>(value));
          }
        }
      }
    }
  }
  return all;
}

bool write(const char* path, const std::vector<float>& numbers) {
  tangential::ForceTableFileHeader header;
  const std::int32_t nodes[5] = {axes.ratios, axes.shapes, axes.elevations, axes.azimuths, axes.saturations};
  std::copy_n(nodes, 5, header.nodes);
  header.largest_ratio = axes.largest_ratio;
  header.largest_shape_number = axes.largest_shape_number;
  header.half_saturation = axes.half_saturation;
  header.poisson = axes.poisson;
  const std::size_t bytes = numbers.size() * sizeof(float);
  header.checksum =
      tangential::file_checksum(numbers.data(), bytes, tangential::file_checksum(&header, sizeof header));
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(&header, sizeof header, 1, file) == 1 &&
                       std::fwrite(numbers.data(), sizeof(float), numbers.size(), file) == numbers.size();
  return std::fclose(file) == 0 && written;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 2 ? std::atoi(argv[2]) : 2;
  if (argc < 2 || threads < 1) {
    std::fprintf(stderr, "wrc_make_force_table FILE [threads]\n");
    return 2;
  }
  Progress progress(std::string(argv[1]) + ".progress");
  solve_all(progress, threads);
  if (!write(argv[1], coefficients(progress))) {
    std::fprintf(stderr, "cannot write %s\n", argv[1]);
    return 1;
  }
  return 0;
}
