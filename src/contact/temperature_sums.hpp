/// Temperatures over the cells of one patch or several: largest and mean rise, heat into both bodies.
#pragma once

#include "contact/assessments.hpp"
#include "tangential/friction/flash_temperature.hpp"

namespace wrc::contact {

class TemperatureSums {
 public:
  /// speed: of rolling [m/s]
  TemperatureSums(const tangential::Effusivities& bodies, const tangential::BulkTemperatures& bulk,
                  std::int32_t cells, double speed)
      : bodies_(bodies), cells_(cells), speed_(speed), difference_(bulk.rail - bulk.wheel), weights_(cells) {
    numbers_.at_entry = bulk.at_entry(bodies);
  }

  /// Fills `rise`, which may be one of the slips, and adds a patch: x_of(cell, strip) where its cells lie.
  template <class Place>
  void add(const patch::Strips& region, const tangential::TangentialFields& fields, double* rise,
           Place&& x_of) {
    const auto area_of = [&](std::int32_t j) {
      return 2.0 * region.half_length[j] / cells_ * region.width[j];
    };
    // Frictional power -V s . p of all cells [W].
    for (std::int32_t j = 0; j < region.count; ++j)
      for (std::int32_t i = 0; i < cells_; ++i) {
        const std::int32_t at = i * region.count + j;
        power_ -= speed_ * area_of(j) *
                  (fields.slip_x[at] * fields.traction_x[at] + fields.slip_y[at] * fields.traction_y[at]);
      }
    // Rise of the surface temperature in each cell [K]: its mean over the area, and the largest with its
    // place.
    tangential::flash_rise(region, fields, cells_, speed_, bodies_, weights_, rise);
    for (std::int32_t j = 0; j < region.count; ++j) {
      for (std::int32_t i = 0; i < cells_; ++i) {
        const std::int32_t at = i * region.count + j;
        warmth_ += rise[at] * area_of(j);
        area_ += area_of(j);
        if (rise[at] <= numbers_.rise) continue;
        numbers_.rise = rise[at];
        numbers_.x = x_of(i, j);
        numbers_.y = region.y[j];
      }
      // Heat from the rail into the wheel because one is warmer, without friction [W].
      into_wheel_ += region.width[j] *
                     tangential::heat_by_touching(bodies_, difference_, speed_, 2.0 * region.half_length[j]);
    }
  }

  TemperatureNumbers numbers() const {
    // Frictional heat is shared by the effusivities; heat by touching goes from one body to the other.
    TemperatureNumbers all = numbers_;
    all.mean_rise = area_ > 0.0 ? warmth_ / area_ : 0.0;
    all.wheel_heat = bodies_.wheel / bodies_.sum() * power_ + into_wheel_;
    all.rail_heat = bodies_.rail / bodies_.sum() * power_ - into_wheel_;
    return all;
  }

 private:
  const tangential::Effusivities& bodies_;
  std::int32_t cells_;
  double speed_, difference_;
  tangential::FlashWeights weights_;
  TemperatureNumbers numbers_;
  double power_ = 0.0, into_wheel_ = 0.0, warmth_ = 0.0, area_ = 0.0;
};

}  // namespace wrc::contact
