/// The fields that callers see: which array each is, over what, and from which stage on.
///
/// Made of the comments of enum wrc_field (tools/interface): a new field is a line there, an array of its
/// name here, and whatever fills that.
#pragma once

#include <cstdint>

#include "contact/contact.hpp"

namespace wrc {

enum class FieldGrid { gap_rows, strips, cells };

/// What must have been computed. `patch`: the strips of the patch, and after the tangential stage those that
/// its method rolled.
enum class FieldStage { gap, patch, tangential, damage, wear, temperature };

struct FieldRow {
  Array array;
  FieldGrid grid;
  FieldStage stage;

  /// Methods that give forces alone have none.
  constexpr bool is_of_tractions() const { return stage >= FieldStage::tangential; }
};

/// By enum wrc_field.
inline constexpr FieldRow field_rows[] = {
#define WRC_FIELD_ROW(name, grid, stage) {Array::name, FieldGrid::grid, FieldStage::stage},
#include "contact/generated/fields.inc"
#undef WRC_FIELD_ROW
};

/// Where a field lies and how long it is.
struct Field {
  const double* data = nullptr;          ///< nullptr: its stage has not been reached
  std::int32_t cells = 0, elements = 0;  ///< cells == 0: one value per strip or row
};

/// The field of one patch; of fields over gap rows `patch` does not matter.
Field find_field(const Contact& contact, const Patch* patch, const FieldRow& row);

}  // namespace wrc
