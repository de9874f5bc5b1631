#include "damage/bins.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::damage {
namespace {

/// Share of an interval, and the index of the bin it lies on; -1: beside all.
struct Share {
  std::int64_t index;
  double part;
};

/// The shares of an interval of an axis, one after the other: before its first, each of its own, behind its
/// last.
class Shares {
 public:
  Shares(const Axis& axis, double from, double to) {
    if (!(axis.length > 0.0)) {
      next_ = last_ = 0;
      return;
    }
    const double most = static_cast<double>(axis.count);
    from_ = (from - axis.first) / axis.length;
    to_ = std::max(from_, (to - axis.first) / axis.length);
    count_ = axis.count;
    // the next whole number below, -1 .. count
    next_ = static_cast<std::int64_t>(std::clamp(from_, -1.0, most) + 1.0) - 1;
    last_ = static_cast<std::int64_t>(std::clamp(to_, -1.0, most) + 1.0) - 1;
    width_ = next_ < last_ ? to_ - from_ : 0.0;  // in one interval it is as good as a point
  }

  bool next(Share& share) {
    while (next_ <= last_) {
      const std::int64_t at = next_++;
      if (!(width_ > 0.0)) {  // a point, or an axis that holds everything
        share = {at == last_ && at < count_ ? at : -1, at == last_ ? 1.0 : 0.0};
        if (share.part > 0.0) return true;
        continue;
      }
      const double low = at < 0 ? from_ : std::max(from_, static_cast<double>(at));
      const double high = at >= count_ ? to_ : std::min(to_, static_cast<double>(at + 1));
      share = {at < count_ ? at : -1, (high - low) / width_};
      if (share.part > 0.0) return true;
    }
    return false;
  }

 private:
  double from_ = 0.0, to_ = 0.0, width_ = 0.0;
  std::int64_t next_ = 0, last_ = -1, count_ = 1;
};

/// Adds a whole number to a sum of a bin.
bool add_whole(DamageBin& bin, int sum, const WholeNumber& number) {
  const WholeNumber before = bin.sum[sum];
  bin.sum[sum] = plus(before, number);
  if (!left_range(before, number, bin.sum[sum])) return true;
  bin.overflow |= std::uint64_t{1} << sum;
  return false;
}

}  // namespace

Contribution contribution_of(const DamagingStrip& strip, const DamagingPatch& patch, const DamageLaws& laws) {
  Contribution c;
  const double distance = patch.distance, area = 2.0 * strip.half_length * strip.width;
  const double t_gamma = patch.speed > 0.0 ? std::max(0.0, patch.power) / patch.speed : 0.0;
  const double load = 0.25 * pi * strip.peak * area;
  const double ratio = load > 0.0 ? strip.traction / load : 0.0;
  c.pressure = strip.peak;
  c.traction = ratio * strip.peak;
  c.sum[sum_work] = strip.power * patch.duration;
  c.sum[sum_whole_life] = whole_life_damage(laws.whole_life, t_gamma) * distance * strip.width;
  if (strip.peak > 0.0)
    c.sum[sum_surface_fatigue] =
        std::max(0.0, ratio - laws.shear_yield / strip.peak) * distance * strip.width;
  c.sum[sum_time] = patch.duration * strip.width;
  // A strip that sticks may have a trace of power of the other sign.
  if (!(strip.power > 0.0 && area > 0.0 && patch.power > 0.0 && patch.speed > 0.0)) return c;
  const WearLaws& wear = laws.wear;
  c.sum[sum_wear_t_gamma] = pi * laws.wheel_diameter *
                            worn_area_rate(wear.t_gamma, t_gamma, laws.wheel_diameter) * distance *
                            (strip.power / patch.power);
  c.sum[sum_wear_sheffield] =
      wear_depth_rate(wear.sheffield, strip.power / (patch.speed * area)) * area * distance;
  // Slipping cells have the traction friction * pressure: work over friction is pressure times way.
  if (strip.friction > 0.0)
    c.sum[sum_wear_archard] = wear_coefficient(wear.archard, strip.peak, strip.sliding) /
                              wear.archard.hardness * strip.power / strip.friction * patch.duration;
  c.sum[sum_wear_power] = wear_depth_velocity(wear.power, strip.power / area) * area * patch.duration;
  return c;
}

void BinAdder::take(const Contribution& contribution, double place, double width) {
  Shares places(bins_.across, place - 0.5 * width, place + 0.5 * width);
  for (Share share{}; places.next(share);) {
    if (share.index != at_) flush();
    at_ = share.index;
    add_share(share.part, contribution, open_.sum);
    open_.pressure = std::max(open_.pressure, contribution.pressure);
    open_.traction = std::max(open_.traction, contribution.traction);
  }
}

void BinAdder::flush() {
  if (at_ == -2) return;
  Shares rows(bins_.along, from_, to_);
  for (Share row{}; rows.next(row);) {
    const bool beside = row.index < 0 || at_ < 0;
    DamageBin& bin = bins_.bin(beside ? bins_.outside() : row.index * bins_.across.count + at_);
    for (int i = 0; i < damage_sums; ++i) {
      const double scaled = open_.sum[i] * damage_scale[i] * row.part;
      if (scaled == 0.0) continue;
      if (std::abs(scaled) < largest_summand) {
        in_range_ = add_whole(bin, i, whole(scaled)) && in_range_;
      } else {
        bin.overflow |= std::uint64_t{1} << i;
        in_range_ = false;
      }
    }
    bin.largest_pressure = std::max(bin.largest_pressure, open_.pressure);
    bin.largest_traction = std::max(bin.largest_traction, open_.traction);
  }
  open_ = {};
}

bool BinAdder::finish() {
  flush();
  at_ = -2;
  return in_range_;
}

bool merge(const DamageBins& into, const DamageBins& from) {
  bool in_range = true;
  for (std::int64_t k = 0; k <= into.outside(); ++k) {
    DamageBin& bin = into.bin(k);
    const DamageBin& other = from.bin(k);
    bin.overflow |= other.overflow;
    for (int i = 0; i < damage_sums; ++i) in_range = add_whole(bin, i, other.sum[i]) && in_range;
    bin.largest_pressure = std::max(bin.largest_pressure, other.largest_pressure);
    bin.largest_traction = std::max(bin.largest_traction, other.largest_traction);
    in_range = in_range && bin.overflow == 0;
  }
  return in_range;
}

}  // namespace wrc::damage
