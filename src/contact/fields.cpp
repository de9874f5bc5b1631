#include "contact/fields.hpp"

#include <cstddef>

namespace wrc {
namespace {

bool computed(const Contact& contact, FieldStage stage) {
  switch (stage) {
    case FieldStage::gap:
      return contact.gap_rows > 0;
    case FieldStage::patch:
      return true;
    case FieldStage::tangential:
      return contact.reached >= Stage::tangential;
    case FieldStage::damage:
      return contact.reached >= Stage::damage;
    case FieldStage::wear:
      return (contact.beside & Contact::wear) != 0;
    case FieldStage::temperature:
      return (contact.beside & Contact::temperature) != 0;
  }
  return false;
}

/// The array of the strips rolled that corresponds to one of the patch's strips.
Array of_region(Array of_patch) {
  const auto behind = static_cast<std::size_t>(of_patch) - static_cast<std::size_t>(Array::strip_y);
  return static_cast<Array>(static_cast<std::size_t>(Array::region_y) + behind);
}

}  // namespace

Field find_field(const Contact& contact, const Patch* patch, const FieldRow& row) {
  if (!computed(contact, row.stage)) return {};
  if (row.grid == FieldGrid::gap_rows) return {array(contact, row.array), 0, contact.gap_rows};
  if (patch == nullptr || !contact.touching) return {};
  if (row.stage == FieldStage::patch) {
    if (contact.reached < Stage::tangential || !gives_fields(contact))
      return {array(contact, row.array) + patch->first, 0, patch->count};
    return {array(contact, of_region(row.array)) + patch->region_first, 0, patch->region_count};
  }
  const std::int32_t cells = row.grid == FieldGrid::cells ? contact.model->options.sizes.cells : 0;
  const std::int32_t first = patch->region_first * (cells > 0 ? cells : 1);
  return {array(contact, row.array) + first, cells, patch->region_count};
}

}  // namespace wrc
