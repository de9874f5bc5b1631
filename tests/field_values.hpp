/// A field of a region, as wrc_contact_field() writes it.
#pragma once

#include <cstddef>
#include <cstdint>
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
