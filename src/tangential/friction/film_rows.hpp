/// Friction and layer of films in rows across the rail and across the wheel.
///
/// A film leaves the share a of the friction of clean bodies and adds b:  mu = a mu_clean + b. Between the
/// middles of rows a, b and the layer change in straight lines over y of both profiles. They are constant
/// beyond the last rows. A strip has their mean over its width, with a continuous slope in its places.
#pragma once

#include <cstdint>

#include "tangential/layer/layer.hpp"

namespace wrc::tangential {

/// Most rows across one body.
inline constexpr std::int32_t most_film_rows = 16;

/// Friction and layer where the films of a row of the rail meet those of a row of the wheel.
struct FilmCell {
  double share = 0.0;        ///< a [-]
  double addition = 0.0;     ///< b [-]
  double flexibility = 0.0;  ///< F of the layer [m/Pa]
  double softness = 0.0;     ///< 1 / traction at which it yields [1/Pa]
  double hardening = 0.0;    ///< [Pa/m]
};
inline constexpr std::int32_t cell_numbers = sizeof(FilmCell) / sizeof(double);

/// Rows of a body by y of its profile.
struct RowsAcross {
  double count = 1.0;
  double middle = 0.0;  ///< y of the first row's middle [m]
  double width = 1.0;   ///< each row's [m]
};

struct FilmRows {
  RowsAcross rail, wheel;
  double layered = 0.0;  ///< 1: there is a layer, even where nothing lies
  double reserved = 0.0;
  const FilmCell* cells = nullptr;  ///< rail's row by row, in each the wheel's rows
};

/// Numbers of FilmRows in the caller's array: a head, which has all but the cells, then the cells.
inline constexpr std::int32_t film_head_numbers = 8;
constexpr std::int32_t film_numbers(std::int32_t rail_rows, std::int32_t wheel_rows) {
  return film_head_numbers + cell_numbers * rail_rows * wheel_rows;
}

/// Shares of rows in the mean over a stretch [-], and their derivatives by its middle [1/m].
struct RowShares {
  std::int32_t first, count;
  double share[most_film_rows], by_y[most_film_rows];  ///< row by row, from the first on
};

/// Shares over the stretch `half` to either side of y [m]; half_by_y: d half / dy [-].
RowShares row_shares(const RowsAcross& rows, double y, double half, double half_by_y = 0.0);

/// Mean of friction and layer over a strip, and its derivatives by the strip's place on the wheel [1/m].
struct FilmOfStrip {
  FilmCell mean, by_wheel_y;
};
FilmOfStrip film_of_strip(const FilmRows& films, const RowShares& rail, const RowShares& wheel);

/// Layer of a strip's mean, and its derivatives by the strip's place on the wheel [1/m].
void layer_of_strip(const FilmOfStrip& film, Layer& layer, Layer& by_wheel_y);

}  // namespace wrc::tangential
