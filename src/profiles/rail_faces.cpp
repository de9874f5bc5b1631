#include "profiles/rail_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace wrc::profiles {

namespace {

/// Pieces of neighbouring sections that are one face.
using Run = std::vector<Piece>;

double overlap(const Outline& a, const Outline& b) {
  return std::min(a.y.back(), b.y.back()) - std::max(a.y.front(), b.y.front());
}

/// The part of a piece that lies over another. Ends that agree within 5 mm are kept.
Piece cropped(const Piece& wide, const Piece& narrow) {
  constexpr double agree = 5e-3;  // [m]
  const auto end = [](double own, double other) { return std::abs(own - other) < agree ? own : other; };
  const double low = end(wide.line.y.front(), narrow.line.y.front()),
               high = end(wide.line.y.back(), narrow.line.y.back());
  Piece part;
  part.number = wide.number;
  const auto add = [&](double y) { part.line.add(y, linear_between(wide.line.y, wide.line.z, y)); };
  add(low);
  for (const double y : wide.line.y)
    if (y > low && y < high) add(y);
  add(high);
  return part;
}

/// Follows pieces along the track. Where a piece is much wider than the one before, another rail joins or
/// leaves: one face ends and another begins, with the common part in both sections.
class Follower {
 public:
  Follower(const FacesProblem& problem, std::string& notes) : problem_(problem), notes_(notes) {}

  std::vector<Run> follow(std::vector<std::vector<Piece>> pieces) {
    begin(pieces[0]);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const double low = problem_.sections[k - 1].distance, high = problem_.sections[k].distance;
      const bool interrupted = std::any_of(problem_.interruptions.begin(), problem_.interruptions.end(),
                                           [&](double place) { return low <= place && place <= high; });
      if (interrupted) {
        end_all();
        begin(pieces[k]);
      } else {
        pair(pieces[k]);
      }
    }
    end_all();
    return std::move(done_);
  }

 private:
  const FacesProblem& problem_;
  std::string& notes_;
  std::vector<Run> done_, open_;

  void begin(std::vector<Piece>& pieces) {
    for (Piece& piece : pieces) {
      open_.emplace_back();
      open_.back().push_back(std::move(piece));
    }
  }

  void end_all() {
    for (Run& run : open_) done_.push_back(std::move(run));
    open_.clear();
  }

  /// Continues each run with the piece of the next section that lies over it most.
  void pair(std::vector<Piece>& here) {
    struct Pair {
      double over;
      std::size_t run, piece;
    };
    std::vector<Pair> pairs;
    for (std::size_t r = 0; r < open_.size(); ++r)
      for (std::size_t p = 0; p < here.size(); ++p) {
        const Outline &before = open_[r].back().line, &after = here[p].line;
        const double over = overlap(before, after);
        if (over > 0.3 * std::min(before.width(), after.width())) pairs.push_back({over, r, p});
      }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.over > b.over; });
    std::vector<Run> went_on;
    std::vector<bool> used(open_.size(), false), taken(here.size(), false);
    for (const Pair& each : pairs) {
      if (used[each.run] || taken[each.piece]) continue;
      used[each.run] = taken[each.piece] = true;
      went_on.push_back(go_on(open_[each.run], here[each.piece]));
    }
    // runs without a piece end here; pieces without a run begin one
    for (std::size_t r = 0; r < open_.size(); ++r)
      if (!used[r]) done_.push_back(std::move(open_[r]));
    open_ = std::move(went_on);
    std::vector<Piece> rest;
    for (std::size_t p = 0; p < here.size(); ++p)
      if (!taken[p]) rest.push_back(std::move(here[p]));
    begin(rest);
  }

  /// Adds the piece to the run and returns it. Where widths differ by a fifth, it returns the run that
  /// begins.
  Run go_on(Run& run, Piece& piece) {
    const double before = run.back().line.width(), after = piece.line.width();
    if (!(std::abs(after - before) > std::max(10e-3, 0.2 * std::max(after, before)))) {
      run.push_back(std::move(piece));
      return std::move(run);
    }
    notes_ +=
        section_at(piece.number, problem_.sections[piece.number].distance) +
        sentence(
            ": a face is ", std::floor(1e3 * after + 0.5), " mm wide, ", std::floor(1e3 * before + 0.5),
            " mm in the section before: another rail joins or leaves; the face ends and a new one begins\n");
    Run next;
    if (before < after) {  // the old face ends with the common part of this section
      run.push_back(cropped(piece, run.back()));
    } else {  // the new face begins with the common part of the section before
      next.push_back(cropped(run.back(), piece));
    }
    next.push_back(std::move(piece));
    done_.push_back(std::move(run));
    return next;
  }
};

/// An outline without the part that lies deeper on its steep field side.
Outline shortened_at_end(const Outline& line, double depth) {
  std::size_t last = line.size() - 1;
  while (last > 3 && line.z[last - 1] > depth &&
         line.z[last] - line.z[last - 1] > 0.6 * (line.y[last] - line.y[last - 1]))
    --last;
  const auto first_of = [&](std::size_t count) {
    return Outline{{line.y.begin(), line.y.begin() + static_cast<std::ptrdiff_t>(count)},
                   {line.z.begin(), line.z.begin() + static_cast<std::ptrdiff_t>(count)}};
  };
  if (line.z[last] <= depth || line.z[last - 1] > depth) return first_of(last + 1);
  const double share = (depth - line.z[last - 1]) / (line.z[last] - line.z[last - 1]);
  Outline cut = first_of(last);
  // no points on top of each other
  if (!(share < 1e-2)) cut.add(line.y[last - 1] + share * (line.y[last] - line.y[last - 1]), depth);
  return cut;
}

/// The same line seen from the field side.
Outline mirrored(const Outline& line) {
  Outline turned;
  for (std::size_t i = line.size(); i-- > 0;) turned.add(-line.y[i], line.z[i]);
  return turned;
}

/// Ends the steep sides of all outlines equally deep below their tops, since shares of length would shift
/// otherwise. On the gauge side a wheel may touch down to 18 mm.
void even_sides(std::vector<FaceOutline>& outlines) {
  constexpr double whole[] = {18e-3, 1e-3};  // depths of the gauge and the field side [m]
  for (const int side : {0, 1}) {
    const auto depth_of = [&](const Outline& line) {
      return (side == 0 ? line.z.front() : line.z.back()) - line.top();
    };
    double least = depth_of(outlines[0].line);
    for (const FaceOutline& each : outlines) least = std::min(least, depth_of(each.line));
    if (!(least > whole[side])) continue;
    for (FaceOutline& each : outlines) {
      const double depth = each.line.top() + least;
      each.line = side == 0 ? mirrored(shortened_at_end(mirrored(each.line), depth))
                            : shortened_at_end(each.line, depth);
    }
  }
}

/// y at which a head, followed from its top, first reaches 45 degrees on the gauge (-1) or the field side
/// (1).
std::optional<double> corner_of(const Outline& line, double sign) {
  constexpr double step = 1e-4, half_chord = 7.5e-4, from_end = 1.5e-3;  // [m]
  constexpr double steep = 0.25 * pi;
  const std::vector<double> s = arc_lengths(line);
  const double top =
      s[static_cast<std::size_t>(std::min_element(line.z.begin(), line.z.end()) - line.z.begin())];
  const auto count = static_cast<std::size_t>(std::ceil(s.back() / step));
  std::optional<double> found;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = step * static_cast<double>(i);
    if (!(sign * (at - top) > 0.0) || (sign > 0.0 && found)) continue;
    if (sign * chord_angle(line, s, at - half_chord, at + half_chord) > steep) found = at;
  }
  if (!found) return {};
  const double y = linear_between(s, line.y, *found);
  if (!(line.y.front() + from_end < y && y < line.y.back() - from_end)) return {};
  return y;
}

/// Marks the corners on the gauge and the field side, if every outline has them apart from each other.
void mark_corners(std::vector<FaceOutline>& outlines) {
  constexpr double apart = 1.5e-3, same_corner = 5e-3;  // [m]
  std::vector<std::vector<double>> found;
  for (const double sign : {-1.0, 1.0}) {
    std::vector<double> corners;
    double before = 0.0;
    bool same = true;  // false: the search met another corner
    for (const FaceOutline& each : outlines) {
      const std::optional<double> corner = corner_of(each.line, sign);
      if (!corner) break;
      const double from_end = (sign > 0.0 ? each.line.y.back() : each.line.y.front()) - *corner;
      same = same && (corners.empty() || std::abs(from_end - before) < same_corner);
      before = from_end;
      corners.push_back(*corner);
    }
    if (same && corners.size() == outlines.size()) found.push_back(std::move(corners));
  }
  if (found.size() == 2)
    for (std::size_t k = 0; k < outlines.size(); ++k)
      if (found[1][k] - found[0][k] < apart) {
        found.pop_back();
        break;
      }
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    outlines[k].marks.clear();
    for (const std::vector<double>& corners : found) outlines[k].marks.push_back(corners[k]);
  }
}

/// Lengths along an outline at its beginning, its marks and its end [m].
std::vector<double> knots_of(const FaceOutline& outline, const std::vector<double>& s) {
  std::vector<double> knots{0.0};
  for (const double mark : outline.marks) knots.push_back(linear_between(outline.line.y, s, mark));
  knots.push_back(s.back());
  return knots;
}

/// Points at equal shares of the length between marks, as the model blends them.
Outline at_shares(const FaceOutline& outline) {
  constexpr std::size_t per_part = 60;
  const std::vector<double> s = arc_lengths(outline.line), knots = knots_of(outline, s);
  Outline points;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double step = (knots[k + 1] - knots[k]) / (per_part - 1);
    for (std::size_t i = 0; i < per_part; ++i) {
      const double at = i + 1 == per_part ? knots[k + 1] : knots[k] + step * static_cast<double>(i);
      points.add(linear_between(s, outline.line.y, at), linear_between(s, outline.line.z, at));
    }
  }
  return points;
}

/// Largest distance, along the normal and on the upper 15 mm, of an outline from the straight blend of its
/// neighbours [m].
double spacing_error(const FaceOutline* three) {
  constexpr double upper = 0.015;  // [m]
  const Outline before = at_shares(three[0]), here = at_shares(three[1]), after = at_shares(three[2]);
  const double share = (three[1].distance - three[0].distance) / (three[2].distance - three[0].distance),
               lowest = here.top() + upper;
  double largest = 0.0;
  const std::size_t last = here.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, last);
    const double dy = here.y[b] - here.y[a], dz = here.z[b] - here.z[a], size = std::sqrt(dy * dy + dz * dz);
    if (!(here.z[i] < lowest && size > 0.0)) continue;
    const double y = here.y[i] - ((1.0 - share) * before.y[i] + share * after.y[i]),
                 z = here.z[i] - ((1.0 - share) * before.z[i] + share * after.z[i]);
    largest = std::max(largest, std::abs(y * dz - z * dy) / size);
  }
  return largest;
}

/// Extends downwards an outline that is narrow or has its highest point at an end: a model needs 20 mm and a
/// top within. Such flanks lie under a face beside it, or where no wheel touches.
Outline wide_enough(Outline line) {
  constexpr double least = 20.5e-3, beyond_top = 3e-3, fall = 1.5, spacing = 1e-3;  // m, m, -, m
  const double missing = std::max(0.0, least - line.width()), top = line.top() + 1e-6;
  const bool top_first = line.z.front() <= top, top_last = line.z.back() <= top;
  const auto go_on = [&](Outline& to, double y, double z, double sign, double length) {
    const int count = std::max(4, static_cast<int>(length / spacing));
    for (int i = 1; i < count; ++i) {
      const double away = length * i / (count - 1);
      to.add(y + sign * away, z + fall * away);
    }
  };
  if (top_first) {
    line = mirrored(line);
    go_on(line, line.y.back(), line.z.back(), 1.0, beyond_top);
    line = mirrored(line);
  }
  const double length = std::max(top_last ? beyond_top : 0.0, missing);
  if (length > 0.0) go_on(line, line.y.back(), line.z.back(), 1.0, length);
  return line;
}

/// The face of the pieces from `begin` to `end`.
Face face_of(const Piece* begin, const Piece* end, const FacesProblem& problem, FaceKind kind) {
  Face face{kind, {}};
  for (const Piece* piece = begin; piece != end; ++piece) {
    FaceOutline outline;
    outline.number = piece->number;
    outline.distance = problem.sections[piece->number].distance;
    outline.line = piece->line;
    face.outlines.push_back(std::move(outline));
  }
  std::vector<FaceOutline>& outlines = face.outlines;
  even_sides(outlines);
  mark_corners(outlines);
  for (std::size_t k = 1; k + 1 < outlines.size(); ++k)
    outlines[k].spacing_error = spacing_error(&outlines[k - 1]);
  for (FaceOutline& each : outlines) {
    each.top = each.line.top();
    each.profile = each.line;
    for (double& z : each.profile.z) z -= each.top;
    each.profile = wide_enough(std::move(each.profile));
  }
  return face;
}

constexpr const char* names[] = {"rail", "stock", "blade", "wing", "nose", "check"};
const char* name_of(FaceKind kind) { return names[static_cast<int>(kind)]; }

/// Largest ratio of lengths between marks of an outline and the first one's.
double stretch_of(const Face& face, std::size_t k) {
  const auto knots = [&](std::size_t i) {
    return knots_of(face.outlines[i], arc_lengths(face.outlines[i].line));
  };
  const std::vector<double> here = knots(k), first = knots(0);
  double largest = 1.0;
  for (std::size_t i = 1; i < here.size(); ++i) {
    const double ratio = (here[i] - here[i - 1]) / (first[i] - first[i - 1]);
    largest = std::max({largest, ratio, 1.0 / ratio});
  }
  return largest;
}

/// The faces of a run. Where outlines grow too long for one face there are several, each from the section
/// with which the face before ends.
void add_faces(const Run& run, const FacesProblem& problem, FaceKind kind, RailFaces& found) {
  constexpr double most_stretch = 7.0;  // a model refuses 8
  const Piece *begin = run.data(), *const end = begin + run.size();
  for (;;) {
    Face face = face_of(begin, end, problem, kind);
    std::size_t longer = 0;
    while (longer < face.outlines.size() && stretch_of(face, longer) <= most_stretch) ++longer;
    if (longer == face.outlines.size() || longer < 2) {
      found.faces.push_back(std::move(face));
      return;
    }
    const FaceOutline& last = face.outlines[longer - 1];
    found.notes += sentence(name_of(kind), ": at ") + section_at(last.number, last.distance) +
                   sentence(", its outline is ", in_mm(1e-3 * stretch_of(face, longer - 1)),
                            " times as long between marks as at its beginning: it goes on as another face\n");
    found.faces.push_back(face_of(begin, begin + longer, problem, kind));
    begin += longer - 1;
  }
}

/// Pieces of two faces in the same section, the other further to the field side.
struct Beside {
  const Piece *own, *other;
  std::size_t run;  ///< number of the other's
};

std::vector<Beside> fieldwards_of(const std::vector<Run>& runs, std::size_t run) {
  constexpr double over = 2e-3;  // [m]
  std::vector<Beside> found;
  for (const Piece& own : runs[run])
    for (std::size_t other = 0; other < runs.size(); ++other)
      if (other != run)
        for (const Piece& theirs : runs[other])
          if (theirs.number == own.number && theirs.line.y.front() > own.line.y.back() - over)
            found.push_back({&own, &theirs, other});
  return found;
}

/// Kind of a face that has another on its field side. If it is as high all along, it is a check rail. If it
/// begins against the other, it is a blade, else a nose. None where there is no other face.
std::optional<FaceKind> kind_of_gauge_face(const std::vector<Run>& runs, std::size_t run) {
  constexpr double as_high = 5e-3, against = 10e-3;  // [m]
  const std::vector<Beside> both = fieldwards_of(runs, run);
  if (both.empty()) return {};
  const bool high = std::all_of(both.begin(), both.end(), [](const Beside& each) {
    return each.own->line.top() < each.other->line.top() + as_high;
  });
  if (high && both.size() == runs[run].size()) return FaceKind::check;
  const Piece &first = runs[run].front(), &last = runs[run].back();
  const Piece* const tip = first.line.top() > last.line.top() ? &first : &last;
  for (const Beside& each : both)
    if (each.own == tip && each.other->line.y.front() - tip->line.y.back() < against) return FaceKind::blade;
  return FaceKind::nose;
}

/// Kind of a face by its place beside the others.
FaceKind kind_of(const std::vector<Run>& runs, std::size_t run) {
  if (const std::optional<FaceKind> own = kind_of_gauge_face(runs, run)) return *own;
  // It has no face on its field side. Faces that have it on theirs tell its kind.
  bool beside_blade = false, beside_nose = false;
  for (std::size_t other = 0; other < runs.size(); ++other) {
    if (other == run) continue;
    const std::vector<Beside> pairs = fieldwards_of(runs, other);
    const bool beside =
        std::any_of(pairs.begin(), pairs.end(), [&](const Beside& each) { return each.run == run; });
    if (!beside) continue;
    const std::optional<FaceKind> theirs = kind_of_gauge_face(runs, other);
    beside_blade = beside_blade || theirs == FaceKind::blade;
    beside_nose = beside_nose || theirs == FaceKind::nose;
  }
  return beside_blade ? FaceKind::stock : beside_nose ? FaceKind::wing : FaceKind::rail;
}

/// The runs of two sections or more, from the gauge side.
std::vector<Run> from_gauge_side(std::vector<Run> all, const FacesProblem& problem, std::string& notes) {
  std::vector<Run> runs;
  for (Run& run : all) {
    if (run.size() > 1) {
      runs.push_back(std::move(run));
      continue;
    }
    const Outline& line = run[0].line;
    double middle = 0.0;
    for (const double y : line.y) middle += y / static_cast<double>(line.size());
    notes += section_at(run[0].number, problem.sections[run[0].number].distance) +
             sentence(": a face at y = ", in_mm(middle),
                      " mm is in no other section and is left out: data are thin there\n");
  }
  const auto place = [](const Run& run) {
    double sum = 0.0;
    for (const Piece& piece : run) sum += piece.line.y.front();
    return sum / static_cast<double>(run.size());
  };
  std::stable_sort(runs.begin(), runs.end(), [&](const Run& a, const Run& b) { return place(a) < place(b); });
  return runs;
}

/// Keeps the part of the track that is wanted, with a section beyond on either side.
void keep_part(double first, double last, std::vector<Face>& faces) {
  std::vector<Face> kept;
  for (Face& face : faces) {
    std::vector<FaceOutline>& all = face.outlines;
    if (!(all.front().distance < last && all.back().distance > first)) continue;
    std::size_t low = 0, high = 0;
    while (low + 1 < all.size() && all[low + 1].distance <= first) ++low;
    while (high + 1 < all.size() && all[high].distance < last) ++high;
    kept.push_back({face.kind, {}});
    for (std::size_t k = low; k <= high; ++k) kept.back().outlines.push_back(std::move(all[k]));
  }
  faces = std::move(kept);
}

/// Lists thin data: sections far from the mean of their neighbours, and more faces than a model holds.
std::string thin_places(const std::vector<Face>& faces, const FacesProblem& problem) {
  std::string told;
  std::size_t running = 0;
  for (const Face& face : faces) {
    running += face.kind != FaceKind::check ? 1 : 0;
    for (std::size_t k = 1; k + 1 < face.outlines.size(); ++k) {
      const FaceOutline& each = face.outlines[k];
      if (!(each.spacing_error > problem.tolerance)) continue;
      told += sentence(name_of(face.kind), ": ") + section_at(each.number, each.distance) +
              sentence(" is ", in_mm(each.spacing_error), " mm off the mean of its neighbours, ",
                       std::floor(1e3 * (each.distance - face.outlines[k - 1].distance) + 0.5), " and ",
                       std::floor(1e3 * (face.outlines[k + 1].distance - each.distance) + 0.5),
                       " mm away: half the spacing leaves a quarter of that\n");
    }
  }
  if (running > problem.most_faces)
    told += sentence(static_cast<std::int32_t>(running), " faces: a model holds ",
                     static_cast<std::int32_t>(problem.most_faces),
                     ". Give a shorter part of the track, or leave faces out\n");
  return told;
}

}  // namespace

Fault find_faces(const FacesProblem& problem, RailFaces& found, std::string& why) {
  found = {};
  RETURN_IF_FAILED(check_sections(problem.sections, why));
  std::vector<std::vector<Piece>> pieces;
  RETURN_IF_FAILED(part_sections(problem, pieces, found.notes, why));
  std::vector<Run> all = Follower(problem, found.notes).follow(std::move(pieces));
  const std::vector<Run> runs = from_gauge_side(std::move(all), problem, found.notes);
  for (std::size_t r = 0; r < runs.size(); ++r) add_faces(runs[r], problem, kind_of(runs, r), found);
  keep_part(problem.first, problem.last, found.faces);
  found.thin = thin_places(found.faces, problem);
  return {};
}

}  // namespace wrc::profiles
