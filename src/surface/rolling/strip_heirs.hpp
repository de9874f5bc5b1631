/// Strips of a wheel's contact that remembers, and those of the committed step that are their past
/// (remembering.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "surface/pressure/pressure.hpp"
#include "surface/rolling/remembering.hpp"

namespace wrc::surface {

// A strip's only place in both steps is the same one within this, and half the distance rolled [m].
inline constexpr double same_place = 4e-3;

/// Numbers of strips that are remembered.
struct PastNumbers {
  const tangential::PastStrip* past;
  double operator[](std::int64_t k) const { return past[k].y; }
};

/// Finds the past of the strips of a step. `past`: that of each, or nullptr.
class StripHeirs {
 public:
  StripHeirs(const RememberingInput& in, const tangential::PastStrip** past)
      : in_(in), past_(past), count_(in.strips.count) {}

  static std::int32_t rail_strip(double number) { return on_rail(static_cast<std::int32_t>(number)); }
  static bool is_second(double number) { return number >= second_places; }

  /// The past of each strip, by its number. Rows of places along the track (second_place.hpp) end and begin:
  /// where either step has second places, a place's past is one of the same strip of the rail, in any row.
  void find() {
    const std::int32_t count = count_;
    const PastNumbers then{in_.past};
    std::fill_n(past_, count, nullptr);
    two_rows_ = (count > 0 && is_second(in_.number[count - 1])) ||
                (in_.past_count > 0 && is_second(then[in_.past_count - 1]));
    if (!two_rows_)
      return for_shared_strips(count, in_.number, in_.past_count, then,
                               [&](std::int32_t j, std::int64_t k) { past_[j] = in_.past + k; });
    // both rows of both steps, strip by strip of the rail
    std::int64_t j[2] = {0, 0}, k[2] = {0, 0};
    while (j[1] < count && !is_second(in_.number[j[1]])) ++j[1];
    while (k[1] < in_.past_count && !is_second(then[k[1]])) ++k[1];
    const std::int64_t j_end[2] = {j[1], count}, k_end[2] = {k[1], in_.past_count};
    while (j[0] < j_end[0] || j[1] < j_end[1]) {
      // number of the next strip with a place now, and its places of both steps
      std::int32_t strip = second_places;
      for (int r = 0; r < 2; ++r)
        if (j[r] < j_end[r]) strip = std::min(strip, rail_strip(in_.number[j[r]]));
      std::int64_t now[2], past[2];
      for (int r = 0; r < 2; ++r) {
        now[r] = j[r] < j_end[r] && rail_strip(in_.number[j[r]]) == strip ? j[r]++ : -1;
        while (k[r] < k_end[r] && rail_strip(then[k[r]]) < strip) ++k[r];
        past[r] = k[r] < k_end[r] && rail_strip(then[k[r]]) == strip ? k[r] : -1;
      }
      pair_places(now, past, heirs_[face_of(strip)]);
    }
  }

  /// Number of the face that a strip of the rail belongs to.
  std::int32_t face_of(std::int32_t strip) const {
    std::int32_t face = 0;
    while (face + 1 < in_.rail.ranges && strip >= in_.rail.range[face].first + in_.rail.range[face].count)
      ++face;
    return face;
  }

  /// The row that a row of the committed step is now, by most of its places; -1: all have left, and other
  /// places are in that row. Strips that left belong to it. Faces renumber their rows by themselves.
  int row_now(int row, std::int32_t face) const {
    const Heirs& heirs = heirs_[face];
    const int other = 1 - row;
    if (heirs[row][0] + heirs[row][1] == 0) return heirs[other][row] > 0 ? -1 : row;
    return heirs[row][other] > heirs[row][row] ? other : row;
  }

  /// The strip in contact that a strip of the committed step is the past of, or -1. `from`: the first one
  /// with its number or a larger one.
  std::int32_t heir_of(std::int64_t k, std::int32_t from) const {
    const double number = in_.past[k].y;
    if (!two_rows_) return from < count_ && in_.number[from] == number ? from : -1;
    // a place may have changed its row
    for (const std::int32_t row : {0, second_places}) {
      const double *const end = in_.number + count_, *const at = std::lower_bound(
                                                         in_.number, end, 1.0 * (rail_strip(number) + row));
      if (at != end && past_[at - in_.number] == in_.past + k)
        return static_cast<std::int32_t>(at - in_.number);
    }
    return -1;
  }

 private:
  /// Places of a face by their row in the committed step, then by that of now.
  using Heirs = std::int32_t[2][2];

  /// How far a place is from one of the committed step [m]. Places on a ramp have gone with the wheel, those
  /// at its end have stayed on the rail: half the distance rolled lies between.
  double apart(double along, std::int64_t past) const {
    return std::abs(along - in_.direction * in_.past[past].centre + 0.5 * in_.rolled);
  }

  /// The past of a strip's places in both rows, -1 where there is none: of two ways to pair them the one of
  /// less distance along the track. One place then and one now, farther apart, are two.
  void pair_places(const std::int64_t (&now)[2], const std::int64_t (&past)[2], Heirs& heirs) {
    const auto has = [&](int a, int b) { return now[a] >= 0 && past[b] >= 0; };
    const auto off = [&](int a, int b) { return has(a, b) ? apart(in_.along[now[a]], past[b]) : 0.0; };
    const double most = same_place + 0.5 * in_.rolled;
    const bool two_now = now[0] >= 0 && now[1] >= 0, two_past = past[0] >= 0 && past[1] >= 0;
    // the sum of both distances, or which is nearer to the one place of the other step
    bool crossed = !has(0, 0) && !has(1, 1);
    if (two_now && two_past)
      crossed = off(0, 1) + off(1, 0) < off(0, 0) + off(1, 1);
    else if (two_now)
      crossed = past[0] >= 0 ? off(1, 0) < off(0, 0) : off(0, 1) < off(1, 1);
    else if (two_past)
      crossed = now[0] >= 0 ? off(0, 1) < off(0, 0) : off(1, 0) < off(1, 1);
    for (int a = 0; a < 2; ++a) {
      const int b = crossed ? 1 - a : a;
      if (!has(a, b) || (!two_now && !two_past && off(a, b) > most)) continue;
      past_[now[a]] = in_.past + past[b];
      ++heirs[b][a];
    }
  }

  const RememberingInput& in_;
  const tangential::PastStrip** const past_;
  const std::int32_t count_;
  bool two_rows_ = false;              // has either step second places along the track?
  Heirs heirs_[most_rail_faces] = {};  // with two rows
};

}  // namespace wrc::surface
