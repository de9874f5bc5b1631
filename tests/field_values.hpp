/// A field of a region, as wrc_contact_field() writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "wrc/wrc.h"

struct FieldValues {
  std::int32_t status = WRC_OK;
  std::uint64_t cells = 0, strips = 0;  ///< cells: 1 of a field over strips or rows
  std::vector<double> values;

  /// Of cell i of strip j.
  double at(std::size_t i, std::size_t j) const { return values[j * cells + i]; }
  /// Of strip or row j.
  double operator[](std::size_t j) const { return values[j * cells]; }
};

inline FieldValues field_values(wrc_contact* contact, std::int32_t index, std::int32_t field) {
  FieldValues found;
  std::uint64_t counts[2] = {0, 0};
  found.status = wrc_contact_field(contact, index, field, nullptr, 0, counts);
  found.cells = counts[0];
  found.strips = counts[1];
  found.values.resize(counts[0] * counts[1]);
  if (found.status >= WRC_OK)
    found.status =
        wrc_contact_field(contact, index, field, found.values.data(), found.values.size(), nullptr);
  return found;
}

/// The same as an array over cells and strips, or over strips: element (i, j) at data[i * stride[0] + j *
/// stride[1]].
struct FieldView {
  const double* data = nullptr;
  std::uint64_t count[2] = {0, 0}, stride[2] = {0, 0};
  std::vector<double> values;
};

inline std::int32_t view_field(wrc_contact* contact, std::int32_t index, std::int32_t field,
                               FieldView* view) {
  *view = {};
  FieldValues found = field_values(contact, index, field);
  view->values = std::move(found.values);
  if (found.status < WRC_OK) return found.status;
  const bool over_cells = field <= WRC_FIELD_TEMPERATURE_RISE;
  view->data = view->values.data();
  view->count[0] = over_cells ? found.cells : found.strips;
  view->count[1] = over_cells ? found.strips : 1;
  view->stride[0] = 1;
  view->stride[1] = found.cells;
  return found.status;
}
