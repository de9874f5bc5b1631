/// Runs of a wheel along rails of sections under its load, in small steps at several lateral places: flags,
/// jumps from step to step, and the exact solver at some of the places. Columns and frames:
/// tests/data/README.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "kinds.hpp"
#include "settings_cases.hpp"

namespace compare {
namespace {

constexpr double inside = 5e-3;     // from the ends of the sections [m]
constexpr double leap = 0.05;       // change of the force from one step to the next, of N [-]
constexpr double piece = 10e-3;     // of a line, kept and told when it is done [m]
constexpr double told_jump = 2e-3;  // from which a piece's largest jump is listed, of N [-]

/// Results of a run, numbers for each key, kept in a file line by line. A run that was ended goes on from
/// there.
class Kept {
 public:
  explicit Kept(const std::string& path) : path_(path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
      if (const std::size_t at = line.find('='); at != std::string::npos)
        found_[line.substr(0, at)] = line.substr(at + 1);
  }
  /// Numbers of a key, computed by `find` where the file has none.
  template <class Find>
  std::vector<double> of(const std::string& key, Find&& find) {
    if (const auto known = found_.find(key); known == found_.end()) {
      std::ostringstream text;
      text.precision(17);
      for (const double number : find()) text << ' ' << number;
      found_[key] = text.str();
      if (!path_.empty()) std::ofstream(path_, std::ios::app) << key << '=' << text.str() << '\n';
    }
    std::istringstream text(found_[key]);
    std::vector<double> numbers;
    for (double number = 0.0; text >> number;) numbers.push_back(number);
    return numbers;
  }

  /// Refuses a file whose numbers of the key are not these to the last bit: it is another rail's, wheel's or
  /// library's.
  void check(const std::string& key, const std::vector<double>& now) {
    if (of(key, [&] { return now; }) != now)
      throw std::runtime_error(path_ + ": '" + key + "' has another force than this rail, wheel and library");
  }

 private:
  std::string path_;
  std::map<std::string, std::string> found_;
};

/// A line along the track at one lateral place.
struct Line {
  const CaseBodies::Made& made;
  WheelCase wheel;
  double begin, end, step;  // [m]

  std::size_t places() const { return 1 + static_cast<std::size_t>(std::floor((end - begin) / step + 1e-9)); }
  double distance(std::size_t place) const { return begin + step * static_cast<double>(place); }
  /// Solves the wheel under its load at a distance [m].
  int32_t solve_at(double distance) {
    wheel.input.distance = distance;
    return wheel.solve(*made.solver);
  }
};

/// Sums over a line or a piece of it; the place of a largest jump stands after it.
enum : std::size_t { flagged, failed, leaps, jump, jump_at, height_jump, height_jump_at, numbers_of_line };

/// Follows a line over the places `first` to `last`, `last` not included. Each place is solved anew, so a
/// piece does not depend on those before. A jump of the force is its second difference over the normal force,
/// so even growth is none. `list`: prints the reason of each place with a status of its own.
std::vector<double> follow(Line& line, std::size_t first, std::size_t last, bool list) {
  std::vector<double> sums(numbers_of_line, 0.0);
  Vector force[2] = {};
  double z[2] = {};
  int known = 0;
  // two places more before the piece: its first second difference needs them
  for (std::size_t place = first - std::min<std::size_t>(first, 2); place < last; ++place) {
    const double at = line.distance(place);
    const int32_t status = line.solve_at(at);
    const bool counts = place >= first, none = status < 0 || status == WRC_FLAG_NO_CONTACT;
    if (list && counts && status != WRC_OK)
      std::printf("     at %.3f mm: %s\n", 1e3 * at, line.made.solver->reason(status).c_str());
    sums[flagged] += counts && status > 0 ? 1.0 : 0.0;
    sums[failed] += counts && (none || status == WRC_FLAG_ITERATION_CAP) ? 1.0 : 0.0;
    if (none) {
      known = 0;
      continue;
    }
    const Vector now = line.wheel.force();
    const double per = 1.0 / line.wheel.wrench.normal_force;
    if (counts && known > 0 && per * length(difference(now, force[0])) > leap) sums[leaps] += 1.0;
    if (counts && known > 1) {
      Vector bend;
      for (std::size_t k = 0; k < 3; ++k) bend[k] = now[k] - 2.0 * force[0][k] + force[1][k];
      const double found = per * length(bend), moved = std::fabs(line.wheel.wrench.z - 2.0 * z[0] + z[1]);
      if (found > sums[jump]) sums[jump] = found, sums[jump_at] = at;
      if (moved > sums[height_jump]) sums[height_jump] = moved, sums[height_jump_at] = at;
    }
    force[1] = std::exchange(force[0], now);
    z[1] = std::exchange(z[0], line.wheel.wrench.z);
    ++known;
  }
  return sums;
}

/// Follows a whole line, piece by piece, each kept when it is done. `list`: prints pieces with jumps, too.
std::vector<double> follow(Line& line, const std::string& key, bool list, Kept& kept) {
  std::vector<double> sums(numbers_of_line, 0.0);
  const auto each = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(piece / line.step)));
  for (std::size_t first = 0; first < line.places(); first += each) {
    const std::size_t last = std::min(first + each, line.places());
    char part[80];
    std::snprintf(part, sizeof part, ", from %.3f to %.3f mm", 1e3 * line.distance(first),
                  1e3 * line.distance(last - 1));
    std::fprintf(stderr, "\r%s%s ", key.c_str(), part);
    const auto found = kept.of(key + part, [&] { return follow(line, first, last, list); });
    if (list && found[jump] > told_jump)
      std::printf("     jump of %.2e at %.3f mm\n", found[jump], 1e3 * found[jump_at]);
    for (const std::size_t sum : {flagged, failed, leaps}) sums[sum] += found[sum];
    for (const std::size_t most : {jump, height_jump})
      if (found[most] > sums[most]) sums[most] = found[most], sums[most + 1] = found[most + 1];
  }
  return sums;
}

/// Real time beside the exact solver at its height: both statuses; the differences of the force and of its
/// vertical part over the normal force [-]; the peak pressure over the exact one, less 1 [-].
std::vector<double> against_exact(Line line, double at, double cell) {
  const int32_t status = line.solve_at(at);
  const wrc_wrench real = line.wheel.wrench;
  line.wheel.input.prescribed = WRC_PRESCRIBE_HEIGHT;
  line.wheel.input.vertical_load = 0.0;
  line.wheel.input.wheel.z = real.z;
  const int32_t exact_status = status < 0 ? status : solve_exactly(line.wheel, *line.made.solver, cell);
  const wrc_wrench& exact = line.wheel.wrench;
  const Vector off = difference({real.force[0], real.force[1], real.force[2]}, line.wheel.force());
  const double per = 1.0 / real.normal_force;
  return {1.0 * status, 1.0 * exact_status, per * length(off), -per * off[2],
          real.peak_pressure / exact.peak_pressure - 1.0};
}

/// Adds the sums over a line to the report.
void add_line(const Options& options, std::size_t row, const std::string& key, const Line& line,
              const std::vector<double>& sums, std::map<std::string, Errors>& errors) {
  errors["flagged"].add(row, sums[flagged]);
  errors["failed"].add(row, sums[failed]);
  errors["leaps"].add(row, sums[leaps]);
  errors["jump"].add(row, sums[jump]);
  errors["height_jump"].add(row, 1e6 * sums[height_jump]);
  if (options.list)
    std::printf(
        "%4zu %s: of %zu places %g flagged, %g failed, %g leaps; jumps %.2e at %.2f mm, %.3f um at %.2f mm\n",
        row, key.c_str(), line.places(), sums[flagged], sums[failed], sums[leaps], sums[jump],
        1e3 * sums[jump_at], 1e6 * sums[height_jump], 1e3 * sums[height_jump_at]);
  std::fflush(stdout);  // a line is there when it is done, in a file, too
}

/// Adds the differences to the exact solver at a place, if both have a result.
void add_place(const Options& options, std::size_t row, const std::string& key,
               const std::vector<double>& both, std::map<std::string, Errors>& errors) {
  const auto status = static_cast<int32_t>(both[0]), exact_status = static_cast<int32_t>(both[1]);
  for (const int32_t each : {status, exact_status})
    if (each < 0 || each == WRC_FLAG_NO_CONTACT || each == WRC_FLAG_ITERATION_CAP) return;
  errors[status == WRC_OK ? "force" : "force_flagged"].add(row, both[2]);
  if (status == WRC_OK) {
    errors["vertical"].add(row, both[3]);
    errors["peak_pressure"].add(row, both[4]);
  }
  if (options.list)
    std::printf("%4zu %s: force %.2f %%, vertical %+.2f %%, peak %+.2f %%; status %d, %d\n", row, key.c_str(),
                100.0 * both[2], 100.0 * both[3], 100.0 * both[4], status, exact_status);
}

}  // namespace

Report compare_runs(const Csv& file, const Options& options) {
  Report report;
  report.kind = options.kind;
  report.measures = {"flagged", "failed",   "leaps",         "jump",         "height_jump",
                     "force",   "vertical", "peak_pressure", "force_flagged"};
  report.units = {{"flagged", "1"}, {"failed", "1"}, {"leaps", "1"}, {"height_jump", "um"}};
  report.default_variant = "wrc_contact_wrench";
  report.variants = {report.default_variant};
  auto& errors = report.errors[report.default_variant];
  CaseBodies bodies(file, options.setting);
  Kept kept(options.keep);
  std::set<std::string> rails;
  for (const CaseRows& rows : case_rows(file)) {
    // one run for each rail, about the first of its cases
    if (!options.wanted(rows.number) || !rails.insert(file.text(rows.first, "sections")).second) continue;
    const CaseBodies::Made& made = bodies.of(rows.first);
    // the force at the case's own place tells whether a file kept is of this run
    WheelCase own = case_of(file, rows.first, {});
    own.solve(*made.solver);
    const Vector force = own.force();
    kept.check("case " + std::to_string(rows.number) + ", " + options.setting, {force.begin(), force.end()});
    for (int k = -most_beside; k <= most_beside; ++k) {
      if (!options.wants_beside(k)) continue;
      Line line{made, case_of(file, rows.first, {}), std::max(options.from, made.begin + inside),
                std::min(options.to, made.end - inside), options.step};
      line.wheel.input.wheel.y += 1e-3 * k;
      const std::size_t row = report.rows++;
      char text[160];
      const auto name = [&](const char* what, double length) -> std::string {
        std::snprintf(text, sizeof text, "case %ld, %s, y %+d mm, %s %.3f mm", rows.number,
                      options.setting.c_str(), k, what, 1e3 * length);
        std::fprintf(stderr, "\r%s ", text);
        return text;
      };
      const std::string key = name("every", options.step);
      add_line(options, row, key, line, follow(line, key, options.list, kept), errors);
      for (double at = line.begin; options.exact_every > 0.0 && at <= line.end; at += options.exact_every) {
        const std::string place = name("exact at", at) + ", cells of " + std::to_string(1e3 * options.cell);
        const auto both = kept.of(place, [&] { return against_exact(line, at, options.cell); });
        add_place(options, row, place, both, errors);
      }
    }
  }
  return report;
}

}  // namespace compare
