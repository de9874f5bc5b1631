/// Damage along the line: bins of the caller checked and filled.
#include <algorithm>
#include <cstring>

#include "abi/call.hpp"
#include "abi/wear.hpp"

namespace wrc::abi {
namespace {

static_assert(sizeof(damage::DamageBin) <= Description<wrc_damage_bin>::first &&
              offsetof(damage::DamageBin, largest_pressure) == offsetof(wrc_damage_bin, largest_pressure) &&
              offsetof(damage::DamageBin, overflow) == offsetof(wrc_damage_bin, overflow));
static_assert(int{damage::damage_sum_places} == sizeof(wrc_damage_totals::sum) / sizeof(double));
static_assert(int{damage::damage_sums} == WRC_DAMAGE_SUMS && int{damage::sum_time} == WRC_DAMAGE_TIME);

/// Bins of the caller, whose size is that of the caller's header.
Fault read_bins(const wrc_damage_bins* theirs, const char* name, damage::DamageBins& bins) {
  wrc_damage_bins ours;
  RETURN_IF_FAILED(read(theirs, name, ours));
  RETURN_IF_FAILED(
      check_bins<damage::DamageBin>(ours, name, MEMBER(wrc_damage_bins, "bin_size"),
                                    "it is the size of one of the bins: set it to sizeof(wrc_damage_bin)"));
  bins.across = {ours.first, ours.width, static_cast<std::int64_t>(ours.count)};
  bins.along = {ours.row_first, ours.row_length, static_cast<std::int64_t>(ours.row_count)};
  constexpr std::int64_t most = 100000000;
  if (bins.outside() > most)
    return Fault::range({name, "row_count * count"}, {bins.outside(), "", 1.0, most},
                        "these are too many bins");
  if (bins.along.count > 1 && !(bins.along.length > 0.0))
    return Fault::range({name, "row_length"}, {ours.row_length, "m", 1e-3, 1e9},
                        "more than one row needs a length");
  bins.first = reinterpret_cast<damage::DamageBin*>(ours.bins);
  bins.stride = static_cast<std::int64_t>(ours.bin_size);
  return {};
}

Fault read_fatigue_laws(const wrc_fatigue_laws* theirs, const char* name, damage::WholeLifeLaw& law) {
  wrc_fatigue_laws ours;
  RETURN_IF_FAILED(read_or_defaults(theirs, name, ours));
  const auto above = [&](Member member, double value, double low) {
    member.low = low;
    return value > low ? Fault{} : refuse(member, name, value);
  };
  law = {.start = ours.whole_life_start,
         .peak_at = ours.whole_life_peak_at,
         .end = ours.whole_life_end,
         .peak = ours.whole_life_peak};
  return first_of({above(MEMBER(wrc_fatigue_laws, "whole_life_peak_at"), law.peak_at, law.start),
                   above(MEMBER(wrc_fatigue_laws, "whole_life_end"), law.end, law.peak_at)});
}

Fault read_accumulation(const wrc_accumulation* theirs, contact::Accumulation& accumulation) {
  wrc_accumulation ours;
  RETURN_IF_FAILED(read(theirs, "accumulation", ours));
  accumulation.duration = ours.duration;
  accumulation.distance = ours.distance;
  RETURN_IF_FAILED(read_wear_laws(ours.wear, "accumulation.wear", accumulation.wear));
  return read_fatigue_laws(ours.fatigue, "accumulation.fatigue", accumulation.whole_life);
}

bool same_axis(const damage::Axis& a, const damage::Axis& b) {
  return a.first == b.first && a.length == b.length && a.count == b.count;
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" {

int32_t wrc_contact_accumulate(wrc_contact* handle, const wrc_accumulation* accumulation,
                               wrc_damage_bins* wheel, wrc_damage_bins* rail, wrc_damage_totals* totals) {
  return abi::call(__func__, handle, abi::clear(totals), [&](wrc::contact::Contact& contact) -> Fault {
    wrc::contact::Accumulation ours;
    wrc::damage::DamageBins on_wheel, on_rail;
    wrc::contact::DamageTotals found;
    RETURN_IF_FAILED(abi::read_accumulation(accumulation, ours));
    if (wheel != nullptr) RETURN_IF_FAILED(abi::read_bins(wheel, "wheel", on_wheel));
    if (rail != nullptr) RETURN_IF_FAILED(abi::read_bins(rail, "rail", on_rail));
    const Fault outcome = wrc::contact::accumulate(contact, ours, wheel != nullptr ? &on_wheel : nullptr,
                                                   rail != nullptr ? &on_rail : nullptr, found);
    if (outcome.failed()) return outcome;
    wrc_damage_totals result{};
    std::copy_n(found.sum, WRC_DAMAGE_SUMS, result.sum);
    result.largest_pressure = found.largest_pressure;
    result.largest_traction = found.largest_traction;
    abi::write(result, totals);
    return outcome;
  });
}

int32_t wrc_damage_merge(wrc_damage_bins* into, const wrc_damage_bins* from) {
  const abi::FloatingPointScope scope;
  wrc::damage::DamageBins ours, theirs;
  const Fault fault =
      abi::first_of({abi::read_bins(into, "into", ours), abi::read_bins(from, "from", theirs)});
  if (fault.failed()) return fault.status;
  if (!abi::same_axis(ours.across, theirs.across) || !abi::same_axis(ours.along, theirs.along))
    return WRC_ERROR_RANGE;
  return wrc::damage::merge(ours, theirs) ? WRC_OK : WRC_FLAG_SUM_OVERFLOW;
}

int32_t wrc_damage_values(const wrc_damage_bins* bins, int32_t quantity, double* values) {
  const abi::FloatingPointScope scope;
  wrc::damage::DamageBins ours;
  const Fault fault = abi::read_bins(bins, "bins", ours);
  if (fault.failed()) return fault.status;
  if (values == nullptr) return WRC_ERROR_NULL;
  const bool is_sum = quantity >= 0 && quantity < WRC_DAMAGE_SUMS;
  if (!is_sum && quantity != WRC_DAMAGE_LARGEST_PRESSURE && quantity != WRC_DAMAGE_LARGEST_TRACTION)
    return WRC_ERROR_UNSUPPORTED;
  // Sums are kept as integers in units of 1 / damage_scale; the last bin is that of places outside all
  // others.
  bool in_range = true;
  for (int64_t k = 0; k <= ours.outside(); ++k) {
    const wrc::damage::DamageBin& bin = ours.bin(k);
    if (is_sum) {
      values[k] = wrc::damage::number(bin.sum[quantity]) / wrc::damage::damage_scale[quantity];
      in_range = in_range && (bin.overflow >> quantity & 1U) == 0;
    } else {
      values[k] = quantity == WRC_DAMAGE_LARGEST_PRESSURE ? bin.largest_pressure : bin.largest_traction;
    }
  }
  return in_range ? WRC_OK : WRC_FLAG_SUM_OVERFLOW;
}

int32_t wrc_whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma, double* damage) {
  if (damage == nullptr) return WRC_ERROR_NULL;
  *damage = 0.0;
  const abi::FloatingPointScope scope;
  wrc::damage::WholeLifeLaw law;
  const Fault fault = abi::first_of(
      {abi::read_fatigue_laws(laws, "laws", law), abi::check(t_gamma, "t_gamma", "N", 0.0, 1e9)});
  if (!fault.failed()) *damage = wrc::damage::whole_life_damage(law, t_gamma);
  return fault.status;
}

int32_t wrc_model_arc_places(const wrc_model* handle, int32_t body, uint32_t count, const double* arc,
                             double* y, double* z) {
  const abi::FloatingPointScope scope;
  for (double* each : {y, z})
    if (each != nullptr) std::fill_n(each, count, 0.0);
  if (!abi::valid(handle) || arc == nullptr) return WRC_ERROR_NULL;
  if (body != WRC_BODY_WHEEL && body != WRC_BODY_RAIL) return WRC_ERROR_UNSUPPORTED;
  const wrc::contact::Model& model = *handle->model;
  if (!model.has_geometry) return WRC_ERROR_SEQUENCE;
  for (uint32_t i = 0; i < count; ++i)
    if (!std::isfinite(arc[i])) return WRC_ERROR_NOT_FINITE;
  const wrc::contact::Bodies& right = model.bodies[static_cast<int>(wrc::geometry::Side::right)];
  const wrc::geometry::MeasuredProfile& measured = model.arc[body == WRC_BODY_WHEEL ? 0 : 1];
  const double origin_y = body == WRC_BODY_WHEEL ? right.wheel.origin_y : right.rail.origin_y;
  const double origin_z = body == WRC_BODY_WHEEL ? 0.0 : right.rail.origin_z;
  for (uint32_t i = 0; i < count; ++i) {
    const double at = wrc::geometry::place_at(measured, arc[i]);
    if (y != nullptr) y[i] = at - origin_y;
    if (z != nullptr) z[i] = wrc::geometry::evaluate(*measured.profile, at).z - origin_z;
  }
  return WRC_OK;
}

}  // extern "C"
