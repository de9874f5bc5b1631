#include "profiles/section_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wrc::profiles {

Fault unsound(const MeasuredSection& section, std::size_t number, const std::string& told, std::string& why) {
  why = told;
  Fault fault = Fault::profile({"problem.sections", number}, why.c_str());
  fault.distance = section.distance;
  return fault;
}

namespace {

bool measured(const Outline& line, std::size_t i) {
  return std::isfinite(line.y[i]) && std::isfinite(line.z[i]);
}

/// The points that were measured.
Outline without_gaps(const Outline& line) {
  Outline kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (measured(line, i)) kept.add(line.y[i], line.z[i]);
  return kept;
}

/// Checks a section's place against that of the section before. An empty text: it is sound.
std::string misplaced(const std::vector<MeasuredSection>& sections, std::size_t k) {
  const double here = sections[k].distance;
  if (!std::isfinite(here)) return "its distance is no finite number";
  if (k == 0) return {};
  const double before = sections[k - 1].distance;
  const auto number = static_cast<std::int32_t>(k);  // number of the one before, counted from 1
  if (here == before) return sentence("it lies where section ", number, " does: was it measured twice?");
  if (here < before)
    return sentence("it lies before section ", number, " at ", before,
                    " m: sections cross, or are out of order");
  if (here - before < 1e-3)
    return sentence(in_mm(here - before), " mm beyond section ", number,
                    ": sections of a model are 1 mm apart at least. In which unit are the distances?");
  return {};
}

/// Finds the place where a line crosses itself, into y and z. A line whose y increases has none.
bool crosses_itself(const Outline& line, double& y, double& z) {
  const std::size_t segments = line.size() - 1;
  const auto dy = [&](std::size_t i) { return line.y[i + 1] - line.y[i]; };
  const auto dz = [&](std::size_t i) { return line.z[i + 1] - line.z[i]; };
  for (std::size_t k = 0; k < segments; ++k) {
    // A crossing has a segment in which y decreases, within it or beside it.
    if (dy(k) > 0.0) continue;
    for (std::size_t a = k > 0 ? k - 1 : 0; a < std::min(k + 2, segments); ++a) {
      for (std::size_t b = 0; b < segments; ++b) {
        if (b + 1 >= a && b <= a + 1) continue;
        const double determinant = dy(a) * dz(b) - dz(a) * dy(b);
        const double apart_y = line.y[b] - line.y[a], apart_z = line.z[b] - line.z[a];
        const double s = (apart_y * dz(b) - apart_z * dy(b)) / determinant,
                     t = (apart_y * dz(a) - apart_z * dy(a)) / determinant;
        if (!(s > 1e-9 && s < 1.0 - 1e-9 && t > 1e-9 && t < 1.0 - 1e-9)) continue;
        y = line.y[a] + s * dy(a);
        z = line.z[a] + s * dz(a);
        return true;
      }
    }
  }
  return false;
}

/// Checks a section's line: unit, height, direction, crossings. `usual`: width of most sections [m].
std::string misshapen(const Outline& line, double usual) {
  const auto [low, high] = std::minmax_element(line.y.begin(), line.y.end());
  const double width = *high - *low;
  if (!(width >= 0.01 && width <= 2.0 && std::max(width / usual, usual / width) <= 20.0))
    return sentence("it is ", width, " m wide, most are ", usual, " m: is it in another unit?");
  const auto [top, bottom] = std::minmax_element(line.z.begin(), line.z.end());
  if (*top < -0.1 || *top > 0.06 || (*bottom < 0.01 && *top < -0.02))
    return sentence("z is ", *top, " .. ", *bottom,
                    " m, and must be 0 at the rail's top and point down: turn its sign, or move it");
  if (line.y.back() < line.y.front())
    return "its points run from the field side to the gauge side: turn them, or y, round";
  double y, z;
  if (crosses_itself(line, y, z))
    return sentence("the line crosses itself at y = ", in_mm(y), ", z = ", in_mm(z),
                    " mm: are points out of order, or two measurements in one?");
  return {};
}

/// Points at which a line turns upwards again: heads are convex, so two heads meet there.
std::vector<std::size_t> concave_corners(const Outline& line, const std::vector<double>& s, double kink) {
  constexpr double window = 1.5e-3;  // [m]
  if (s.back() < 4.0 * window) return {};
  // turn of the line at each point, over a window to either side
  std::vector<double> turn(line.size(), 0.0);
  for (std::size_t i = 0; i < line.size(); ++i)
    if (s[i] >= window && s[i] <= s.back() - window)
      turn[i] = chord_angle(line, s, s[i] - window, s[i]) - chord_angle(line, s, s[i], s[i] + window);
  // the sharpest first; turns near a corner belong to it
  std::vector<std::size_t> found;
  for (;;) {
    const auto at = static_cast<std::size_t>(std::max_element(turn.begin(), turn.end()) - turn.begin());
    if (!(turn[at] > kink)) break;
    std::size_t lowest = at;  // the lowest point between both heads
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double apart = std::abs(s[i] - s[at]);
      if (apart < window && (line.z[i] > line.z[lowest] || (line.z[i] == line.z[lowest] && i < lowest)))
        lowest = i;
    }
    for (std::size_t i = 0; i < line.size(); ++i)
      if (std::abs(s[i] - s[at]) < 2.0 * window && i != at) turn[i] = 0.0;
    turn[at] = 0.0;
    found.push_back(lowest);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Cuts one run of points above the depth at its concave corners, which no wheel reaches.
void cut_at_corners(std::size_t number, const Outline& line, double kink, std::vector<Piece>& made) {
  constexpr double beside_corner = 1e-3;  // [m]
  const std::vector<double> s = arc_lengths(line);
  std::vector<std::size_t> corners = concave_corners(line, s, kink);
  std::size_t first = 0;
  for (std::size_t c = 0; c <= corners.size(); ++c) {
    const std::size_t end = c < corners.size() ? corners[c] : line.size();
    Piece piece;
    piece.number = number;
    for (std::size_t i = first; i < end; ++i) {
      const bool near = std::any_of(corners.begin(), corners.end(), [&](std::size_t corner) {
        return std::abs(s[i] - s[corner]) <= beside_corner;
      });
      if (!near) piece.line.add(line.y[i], line.z[i]);
    }
    if (piece.line.size() > 0) made.push_back(std::move(piece));
    first = end;
  }
}

/// The parts of a line above a depth, cut at gaps and concave corners; ends are at the depth itself.
std::vector<Piece> pieces_of(std::size_t number, const Outline& line, const FacesProblem& limits) {
  std::vector<Piece> made;
  const double depth = limits.depth;
  std::size_t first = 0;
  while (first < line.size()) {
    // a run of points from `first` to `last` without a gap
    std::size_t last = first;
    if (!measured(line, first)) {
      ++first;
      continue;
    }
    for (; last + 1 < line.size() && measured(line, last + 1); ++last) {
      const double dy = line.y[last + 1] - line.y[last], dz = line.z[last + 1] - line.z[last];
      if (std::sqrt(dy * dy + dz * dz) > limits.gap) break;
    }
    // parts of the run above the depth; where the line goes on below, a point at the depth ends the part
    const auto add_end = [&](Outline& to, std::size_t inner, std::size_t outer) {
      const double share = (depth - line.z[inner]) / (line.z[outer] - line.z[inner]);
      if (share > 1e-6) to.add(line.y[inner] + share * (line.y[outer] - line.y[inner]), depth);
    };
    for (std::size_t i = last == first ? last + 1 : first; i <= last;) {
      if (!(line.z[i] < depth)) {
        ++i;
        continue;
      }
      Outline above;
      if (i > first) add_end(above, i, i - 1);
      for (; i <= last && line.z[i] < depth; ++i) above.add(line.y[i], line.z[i]);
      if (i <= last) add_end(above, i - 1, i);
      cut_at_corners(number, above, limits.kink, made);
    }
    first = last + 1;
  }
  return made;
}

/// Refuses a piece that overhangs. An upright piece is made to lean by a micrometre from point to point.
std::string overhang(Piece& piece) {
  constexpr double noise = 2e-5, lean = 1e-6;  // [m]
  const Outline& line = piece.line;
  std::size_t worst = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (worst == 0 || line.y[i] - line.y[i - 1] < line.y[worst] - line.y[worst - 1]) worst = i;
  if (worst > 0 && line.y[worst] - line.y[worst - 1] <= -noise)
    return sentence("it overhangs: y goes back from ", 1e3 * line.y[worst - 1], " to ", 1e3 * line.y[worst],
                    " mm at z = ", in_mm(line.z[worst - 1]), " mm; a face must be seen from above");
  Outline kept;
  double reached = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {
      const double dy = line.y[i] - line.y[i - 1], dz = line.z[i] - line.z[i - 1];
      if (!(std::sqrt(dy * dy + dz * dz) > lean)) continue;
    }
    const double step = lean * static_cast<double>(kept.size());
    reached = std::max(reached, line.y[i] - step);
    kept.add(reached + step, line.z[i]);
  }
  piece.line = std::move(kept);
  return {};
}

}  // namespace

Fault check_sections(const std::vector<MeasuredSection>& sections, std::string& why) {
  std::vector<double> widths;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const Outline line = without_gaps(sections[k].line);
    std::string told = misplaced(sections, k);
    if (told.empty() && line.size() < 4)
      told = sentence(static_cast<std::int32_t>(line.size()),
                      " points that were measured: a section has 4 or more");
    if (!told.empty()) return unsound(sections[k], k, told, why);
    const auto [low, high] = std::minmax_element(line.y.begin(), line.y.end());
    widths.push_back(*high - *low);
  }
  std::sort(widths.begin(), widths.end());
  const std::size_t middle = widths.size() / 2;
  const double usual = widths.size() % 2 == 1 ? widths[middle] : 0.5 * (widths[middle - 1] + widths[middle]);
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const std::string told = misshapen(without_gaps(sections[k].line), usual);
    if (!told.empty()) return unsound(sections[k], k, told, why);
  }
  return {};
}

Fault part_sections(const FacesProblem& problem, std::vector<std::vector<Piece>>& pieces, std::string& notes,
                    std::string& why) {
  pieces.clear();
  for (std::size_t k = 0; k < problem.sections.size(); ++k) {
    const MeasuredSection& section = problem.sections[k];
    std::vector<Piece> kept;
    std::string narrow;
    for (Piece& piece : pieces_of(k, section.line, problem)) {
      const std::string told = overhang(piece);
      if (!told.empty()) return unsound(section, k, told, why);
      if (piece.line.size() >= 4 && piece.line.width() >= problem.least_width) {
        kept.push_back(std::move(piece));
        continue;
      }
      double middle = 0.0;
      for (const double y : piece.line.y) middle += y / static_cast<double>(piece.line.size());
      narrow += narrow.empty() ? "" : ", ";
      narrow += sentence(in_mm(middle));
    }
    if (!narrow.empty())
      notes += section_at(k, section.distance) + ": left out, narrower than " +
               sentence(in_mm(problem.least_width)) + " mm: y = " + narrow + " mm\n";
    if (kept.empty())
      return unsound(section, k,
                     sentence("nothing lies above z = ", in_mm(problem.depth),
                              " mm: is z = 0 the rail's top, and z down?"),
                     why);
    pieces.push_back(std::move(kept));
  }
  return {};
}

}  // namespace wrc::profiles
