/// Bins along the line: damage by the strips of contact, collected over the arc length of its profile and
/// over the distance along the track. Sums do not depend on the order of additions (exact_sum.hpp).
#pragma once

#include <cstdint>

#include "damage/exact_sum.hpp"
#include "damage/fatigue.hpp"
#include "damage/wear.hpp"

namespace wrc::damage {

/// Quantities that bins collect as sums: enum wrc_damage_quantity.
enum DamageSum : std::int32_t {
  sum_work,
  sum_wear_t_gamma,
  sum_wear_sheffield,
  sum_wear_archard,
  sum_wear_power,
  sum_whole_life,
  sum_surface_fatigue,
  sum_time,
  damage_sums
};

/// Units of whole numbers: a contribution of sum i counts times this before it becomes one.
inline constexpr double damage_scale[damage_sums] = {0x1p20, 0x1p40, 0x1p40, 0x1p40,
                                                     0x1p40, 0x1p40, 0x1p40, 0x1p40};

/// Places for sums in a bin, those in use and those for later.
inline constexpr std::int32_t damage_sum_places = 16;

/// One bin, laid out as the caller's (wrc_damage_bin).
struct DamageBin {
  WholeNumber sum[damage_sum_places];
  double largest_pressure = 0.0;  ///< [Pa]
  double largest_traction = 0.0;  ///< [Pa]
  std::uint64_t overflow = 0;     ///< bit i: sum i is worthless
  double reserved[4] = {};        ///< 0
};

/// `count` intervals of `length` from `first` on; length 0: one, which holds everything.
struct Axis {
  double first = 0.0, length = 0.0;
  std::int64_t count = 1;
};

/// rows * bins of a row + 1, row by row; the last collects places beside all others.
struct DamageBins {
  Axis across, along;
  DamageBin* first = nullptr;
  std::int64_t stride = sizeof(DamageBin);  ///< from one bin of the caller to the next [bytes]
  std::int64_t outside() const { return across.count * along.count; }
  DamageBin& bin(std::int64_t k) const {
    return *reinterpret_cast<DamageBin*>(reinterpret_cast<char*>(first) + k * stride);
  }
};

/// A strip in contact. Arc lengths are from the profiles' origins, flange or gauge side negative.
struct DamagingStrip {
  double place[2] = {};      ///< middle on the wheel and on the rail, arc length [m]
  double width = 0.0;        ///< [m]
  double half_length = 0.0;  ///< [m]
  double peak = 0.0;         ///< pressure [Pa]
  double friction = 0.0;     ///< [-]
  double sliding = 0.0;      ///< root mean square of its rigid slip times the rolling speed [m/s]
  double traction = 0.0;     ///< tangential force [N]
  double power = 0.0;        ///< frictional [W]
};

/// Parameters of all laws.
struct DamageLaws {
  WearLaws wear;
  WholeLifeLaw whole_life;
  double shear_yield = 0.0;     ///< k [Pa]
  double wheel_diameter = 0.0;  ///< [m]
};

/// Numbers that all strips of a patch share.
struct DamagingPatch {
  double duration = 0.0;  ///< [s]
  double distance = 0.0;  ///< rolled in that time [m]
  double speed = 0.0;     ///< that slips refer to; not the distance over the duration near standstill [m/s]
  double power = 0.0;     ///< frictional, of all its strips [W]
};

/// Damage that a strip adds to one body.
struct Contribution {
  double sum[damage_sums] = {};
  double pressure = 0.0, traction = 0.0;  ///< largest [Pa]
};

/// Adds a part of a contribution to sums beside it.
inline void add_share(double part, const Contribution& contribution, double* __restrict sum) {
  const double* __restrict const more = contribution.sum;
  for (int i = 0; i < damage_sums; ++i) sum[i] += part * more[i];
}

Contribution contribution_of(const DamagingStrip& strip, const DamagingPatch& patch, const DamageLaws& laws);

/// Adds contributions of one step to the bins of one body, spread evenly over a width of the profile and over
/// the distance `from` .. `to`: each bin gets its share. Shares that fall into one bin one after the other
/// are added as numbers first, so that a bin's whole numbers are touched once.
class BinAdder {
 public:
  BinAdder(const DamageBins& bins, double from, double to) : bins_(bins), from_(from), to_(to) {}
  /// By increasing place it is fastest; any order will do.
  void take(const Contribution& contribution, double place, double width);
  /// Adds the shares still pending. False: a range was passed.
  bool finish();

 private:
  void flush();

  DamageBins bins_;
  double from_, to_;
  std::int64_t at_ = -2;  ///< bin of the row that `open_` belongs to; -1: beside; -2: none
  Contribution open_;
  bool in_range_ = true;
};

/// Adds bins of the same axes. False: a range was passed.
bool merge(const DamageBins& into, const DamageBins& from);

}  // namespace wrc::damage
