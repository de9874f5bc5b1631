/// Fields over the strips and cells of a region, written into memory of the caller.
#include <algorithm>
#include <iterator>

#include "contact/assessments.hpp"
#include "contact/rolled_region.hpp"
#include "tangential/friction/flash_temperature.hpp"

namespace wrc::contact {
namespace {

struct Row {
  FieldOver over;
  FieldNeeds needs;
};
constexpr Row rows_of_fields[] = {
#define WRC_FIELD(name, over, needs) {FieldOver::over, FieldNeeds::needs},
    WRC_FIELDS(WRC_FIELD)
#undef WRC_FIELD
};
static_assert(std::size(rows_of_fields) == static_cast<std::size_t>(FieldId::count_));

const Row& row_of(FieldId field) { return rows_of_fields[static_cast<std::size_t>(field)]; }

/// Refuses a field whose result the newest solution does not have.
Fault check_needs(const Contact& contact, FieldNeeds needs) {
  const bool wheel = contact.newest == Solution::wheel;
  switch (needs) {
    case FieldNeeds::strips:
      return {};
    case FieldNeeds::wheel:
      return wheel ? Fault{}
                   : Fault::unsupported("field",
                                        "the strips of a patch lie in a plane, not on a rail's profile");
    case FieldNeeds::gap:
      return {};
    case FieldNeeds::rolling:
      return wheel ? Fault{} : tractions_needed(contact, "this method does not roll strip by strip");
    case FieldNeeds::tractions:
      break;
  }
  if (!wheel) return tractions_needed(contact, "this method has no tractions over the patch: choose another");
  return has_tractions(contact)
             ? Fault{}
             : Fault::unsupported("field", "patches rolled as a whole: their strips have no tractions");
}

/// Position of a field in a run of fields that begins with `first`.
std::int32_t number_from(FieldId first, FieldId field) {
  return static_cast<std::int32_t>(field) - static_cast<std::int32_t>(first);
}

void copy_gap(const Contact& contact, FieldId field, double* values) {
  const patch::GapRows rows = gap_rows(contact);
  const double* const each[] = {rows.y, rows.height, rows.centre, rows.curvature};
  std::copy_n(each[number_from(FieldId::gap_y, field)], rows.count, values);
}

/// The array a field over cells lies in, element (cell i, strip j) at i * strips + j.
const double* cells_of(const Contact& contact, const RolledRegion& rolled, FieldId field) {
  // Tractions and slips are there already; power, fatigue and temperature are made in work space.
  const tangential::TangentialFields& fields = rolled.fields;
  if (field <= FieldId::slip_y) {
    const double* const each[] = {fields.traction_x, fields.traction_y, fields.slip_x, fields.slip_y};
    return each[number_from(FieldId::traction_x, field)];
  }
  if (field == FieldId::temperature_rise) {
    tangential::flash_rise(rolled.strips, fields, rolled.cells(), rolled.speed,
                           contact.model->options.effusivities, tangential::FlashWeights(rolled.cells()),
                           rolled.work.power_density);
    return rolled.work.power_density;
  }
  assess(contact, rolled, rolled.work);
  return field == FieldId::power_density ? rolled.work.power_density : rolled.work.fatigue_index;
}

void write_cells(const Contact& contact, const RolledRegion& rolled, FieldId field, double* values) {
  const std::int32_t strips = rolled.strips.count, cells = rolled.cells();
  // Inside a field is stored cell by cell (march order), outside strip by strip.
  const auto write = [&](auto&& value) {
    for (std::int32_t j = 0; j < strips; ++j)
      for (std::int32_t i = 0; i < cells; ++i) values[j * cells + i] = value(i, j);
  };
  if (field == FieldId::x) return write([&](auto i, auto j) { return rolled.x(i, j); });
  if (field == FieldId::pressure) return write([&](auto i, auto j) { return rolled.pressure(i, j); });
  // Fields in arrays, element (cell i, strip j) at i * strips + j.
  const double* const of_cells = cells_of(contact, rolled, field);
  write([&](auto i, auto j) { return of_cells[i * strips + j]; });
}

/// The array a field over strips lies in.
const double* strips_of(const Contact& contact, const RolledRegion& rolled, FieldId field,
                        const damage::SheffieldWearLaw& wear) {
  // Geometry and pressure, then places on the rail's profile, then results of rolling.
  const patch::Strips& strips = rolled.strips;
  if (field <= FieldId::strip_peak) {
    const double* const each[] = {strips.y, strips.width, strips.centre, strips.half_length, strips.peak};
    return each[number_from(FieldId::strip_y, field)];
  }
  if (field >= FieldId::strip_profile_y) {
    const double* const each[] = {rolled.profile_y, rolled.profile_z, rolled.angle};
    return each[number_from(FieldId::strip_profile_y, field)];
  }
  if (field == FieldId::strip_friction) return rolled.friction;
  // Power per width [W/m], or volume worn per width and distance rolled [m].
  double largest = 0.0;
  if (field == FieldId::strip_power) {
    assess(contact, rolled, rolled.work);
  } else {
    for (std::int32_t j = 0; j < strips.count; ++j)
      rolled.work.strip_power[j] = worn_of_strip(rolled, wear, j, largest);
  }
  return rolled.work.strip_power;
}

void write_region(const Contact& contact, const RolledRegion& rolled, FieldId field,
                  const damage::SheffieldWearLaw& wear, double* values) {
  if (row_of(field).over == FieldOver::cells) return write_cells(contact, rolled, field, values);
  std::copy_n(strips_of(contact, rolled, field, wear), rolled.strips.count, values);
}

}  // namespace

Fault region_field_size(const Contact& contact, std::int32_t index, FieldId field, FieldSize& size) {
  // The gap belongs to the stages, not to a region: it is there before any patch.
  size = {};
  const Row& row = row_of(field);
  if (row.over == FieldOver::gap_rows) {
    if (contact.newest != Solution::stages || contact.gap_rows == 0)
      return Fault::sequence("field", "the newest solution has no gap");
    size.rows = contact.gap_rows;
    return {};
  }
  Fault fault = check_region(contact, index, false);
  if (fault.status == WRC_OK) fault = check_needs(contact, row.needs);
  if (fault.status != WRC_OK) return fault;
  // Strips in contact: a wheel's are those kept, a patch's those pressed.
  size.rows = contact.newest == Solution::wheel
                  ? strip_run(surface_state(contact).kept, contact.wheel.wrench.region[index]).count
                  : contact.patch[index].count;
  if (row.over == FieldOver::cells) size.cells = cells_of_newest(contact);
  return {};
}

Fault region_field(Contact& contact, std::int32_t index, FieldId field, const damage::SheffieldWearLaw& wear,
                   double* values) {
  FieldSize size;
  const Fault fault = region_field_size(contact, index, field, size);
  if (fault.status != WRC_OK) return fault;
  // Tractions of a wheel's region take a march: it is done where the field needs them only.
  if (row_of(field).over == FieldOver::gap_rows) {
    copy_gap(contact, field, values);
  } else if (contact.newest == Solution::wheel) {
    const bool with_cells = row_of(field).needs == FieldNeeds::tractions;
    write_region(contact, RolledRegion(contact, contact.wheel.wrench.region[index], with_cells), field, wear,
                 values);
  } else {
    write_region(contact, RolledRegion(contact, contact.patch[index]), field, wear, values);
  }
  return {};
}

}  // namespace wrc::contact
