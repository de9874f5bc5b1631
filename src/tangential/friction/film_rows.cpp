#include "tangential/friction/film_rows.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::tangential {
namespace {

/// Share of row k at t [-]. t is in widths from the middle of the first of `count` rows.
double share_at(double t, std::int32_t k, std::int32_t count) {
  const double from_middle = t - k;
  if ((k == 0 && from_middle < 0.0) || (k == count - 1 && from_middle > 0.0)) return 1.0;
  return std::max(0.0, 1.0 - std::abs(from_middle));
}

/// Integral of that share from the row's middle to t.
double integral_to(double t, std::int32_t k, std::int32_t count) {
  const double from_middle = t - k;
  if ((k == 0 && from_middle < 0.0) || (k == count - 1 && from_middle > 0.0)) return from_middle;
  const double d = std::min(std::abs(from_middle), 1.0);
  return std::copysign(d - 0.5 * d * d, from_middle);
}

}  // namespace

RowShares row_shares(const RowsAcross& rows, double y, double half, double half_by_y) {
  RowShares shares;
  const std::int32_t count = static_cast<std::int32_t>(rows.count);
  // a single row has the whole share
  if (count == 1) {
    shares.first = 0;
    shares.count = 1;
    shares.share[0] = 1.0;
    shares.by_y[0] = 0.0;
    return shares;
  }
  // rows whose straight lines reach into the stretch; ends of the stretch as t above
  const auto row = [&](double t) {
    return static_cast<std::int32_t>(std::clamp(std::floor(t), 0.0, count - 1.0));
  };
  const double from = (y - half - rows.middle) / rows.width, to = (y + half - rows.middle) / rows.width;
  shares.first = row(from);
  shares.count = std::min(row(to) + 2, count) - shares.first;
  for (std::int32_t i = 0; i < shares.count; ++i) {
    const std::int32_t k = shares.first + i;
    const double mean = (integral_to(to, k, count) - integral_to(from, k, count)) / (to - from);
    shares.share[i] = mean;
    // d/dy of a mean over [y - h, y + h]: (f(to) - f(from)) / 2h + h' ((f(to) + f(from)) / 2 - mean) / h
    const double last = share_at(to, k, count), first = share_at(from, k, count);
    shares.by_y[i] = (0.5 * (last - first) + half_by_y * (0.5 * (last + first) - mean)) / half;
  }
  return shares;
}

FilmOfStrip film_of_strip(const FilmRows& films, const RowShares& rail, const RowShares& wheel) {
  FilmOfStrip film;
  const std::int32_t across = static_cast<std::int32_t>(films.wheel.count);
  const bool layered = films.layered > 0.0;
  const auto add = [&](double factor, const FilmCell& cell, FilmCell& sum) {
    sum.share += factor * cell.share;
    sum.addition += factor * cell.addition;
    if (!layered) return;
    sum.flexibility += factor * cell.flexibility;
    sum.softness += factor * cell.softness;
    sum.hardening += factor * cell.hardening;
  };
  // each pair of rows by the product of their shares
  for (std::int32_t r = 0; r < rail.count; ++r) {
    const FilmCell* const row = films.cells + (rail.first + r) * across + wheel.first;
    for (std::int32_t w = 0; w < wheel.count; ++w) {
      add(rail.share[r] * wheel.share[w], row[w], film.mean);
      add(rail.share[r] * wheel.by_y[w], row[w], film.by_wheel_y);
    }
  }
  return film;
}

void layer_of_strip(const FilmOfStrip& film, Layer& layer, Layer& by_wheel_y) {
  constexpr double hardest = 1e11;  // [Pa]: yields nowhere
  const FilmCell &mean = film.mean, &slope = film.by_wheel_y;
  // the layer's F, tau_0 and k from means of F, 1 / tau_0 and k
  layer = {mean.flexibility, hardest, mean.hardening};
  by_wheel_y = {slope.flexibility, 0.0, slope.hardening};
  if (mean.softness * hardest > 1.0) {
    layer.yield = 1.0 / mean.softness;
    by_wheel_y.yield = -slope.softness * layer.yield * layer.yield;
  }
  // softening is bounded: beyond half of the modulus over the thickness tractions would jump
  const double least = mean.flexibility > 0.0 ? -0.49 / mean.flexibility : layer.hardening;
  if (layer.hardening >= least) return;
  layer.hardening = least;
  by_wheel_y.hardening = 0.49 * slope.flexibility / (mean.flexibility * mean.flexibility);
}

}  // namespace wrc::tangential
