/// The public interface with C++ comfort for the report commands: initialised structs, owned handles.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "csv.hpp"
#include "test_config.hpp"
#include "wrc/wrc_planar.h"

namespace compare {

/// Inputs of wrc_planar_tangential for one row of a file with the columns of sdec_cases.csv.
struct Rolling {
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  wrc_creepage creepage = wrc_creepage_default();
  wrc_friction friction = wrc_friction_default();
};
inline Rolling rolling_of(const Csv& file, std::size_t row) {
  Rolling rolling;
  rolling.ellipse.a = 1e-3 * file(row, "a_mm");
  rolling.ellipse.b = 1e-3 * file(row, "b_mm");
  rolling.ellipse.psi = file(row, "psi");
  rolling.ellipse.normal_force = 1e3 * file(row, "N_kN");
  rolling.creepage.longitudinal = file(row, "cx");
  rolling.creepage.lateral = file(row, "cy");
  rolling.creepage.spin = file(row, "phi_per_m");
  rolling.friction.coefficient = file(row, "mu");
  return rolling;
}

/// A model and one contact of it.
class Solver {
 public:
  explicit Solver(const wrc_config& config, int32_t side = WRC_SIDE_RIGHT) {
    char text[256];
    if (wrc_config_check(&config, text, sizeof text) < 0) throw std::runtime_error(text);
    if (wrc_model_create(&config, nullptr, &model_, nullptr, 0) < 0)
      throw std::runtime_error("out of memory");
    if (wrc_contact_create(model_, side, nullptr, &contact_, nullptr, 0) < 0)
      throw std::runtime_error("out of memory");
  }
  ~Solver() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  wrc_contact* contact() const { return contact_; }
  const wrc_model* model() const { return model_; }

  /// Status name and sentence of the last call.
  std::string reason(int32_t status) const {
    char text[256] = "";
    wrc_contact_last_error(contact_, text, sizeof text);
    return std::string(wrc_status_name(status)) + " " + text;
  }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

}  // namespace compare
