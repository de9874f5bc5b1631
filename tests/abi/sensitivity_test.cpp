/// Sensitivities through the C interface: right, and without a trace in the contact.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "abi/reference_contact.hpp"
#include "presets.hpp"
#include "test_config.hpp"

namespace {

/// S1002 on UIC60, 80 kN, the paper's Case 2, in partial slip.
class Sensitivities : public ReferenceContact {
 protected:
  /// Everything the contact holds.
  std::vector<char> state() const {
    uint64_t bytes = 0;
    EXPECT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
    std::vector<char> copy(bytes);
    EXPECT_EQ(wrc_contact_save(contact, copy.data(), bytes), WRC_OK);
    return copy;
  }
};

TEST_F(Sensitivities, SensitivitiesAreThoseOfTheTangentialStage) {
  wrc_planar_derivatives s = sized<wrc_planar_derivatives>();
  EXPECT_EQ(wrc_planar_tangential_derivatives(contact, &s), WRC_ERROR_SEQUENCE);
  ASSERT_EQ(step(), WRC_OK) << error();
  const std::vector<char> before = state();
  ASSERT_EQ(wrc_planar_tangential_derivatives(contact, &s), WRC_OK) << error();
  EXPECT_EQ(before, state());

  double* const inputs[] = {&creepage.longitudinal, &creepage.lateral, &creepage.spin, &friction.coefficient};
  const int columns[] = {0, 1, 2, 4};
  for (int k = 0; k < 4; ++k) {
    const double value = *inputs[k], step = 1e-5 * std::fabs(value);
    wrc_planar_forces ends[2] = {forces, forces};
    for (int end = 0; end < 2; ++end) {
      *inputs[k] = value + (end == 0 ? -step : step);
      ASSERT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &ends[end]), WRC_OK);
    }
    *inputs[k] = value;
    const double scale = std::fabs(forces.fx) / std::fabs(value);
    EXPECT_NEAR(s.forces[0][columns[k]], (ends[1].fx - ends[0].fx) / (2.0 * step), 1e-5 * scale) << k;
    EXPECT_NEAR(s.forces[1][columns[k]], (ends[1].fy - ends[0].fy) / (2.0 * step), 1e-5 * scale) << k;
    EXPECT_NEAR(s.forces[2][columns[k]], (ends[1].mz - ends[0].mz) / (2.0 * step), 1e-7 * scale) << k;
  }
  EXPECT_NEAR(s.forces[0][3] * forces.fn, s.forces[0][4] * friction.coefficient, 1e-9 * std::fabs(forces.fx));
}

TEST_F(Sensitivities, OfAPatchOfTheCaller) {
  wrc_ellipse own = sized<wrc_ellipse>();
  own.a = 5e-3;
  own.b = 4e-3;
  own.normal_force = 80e3;
  ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK) << error();
  wrc_planar_derivatives s = sized<wrc_planar_derivatives>();
  EXPECT_EQ(wrc_planar_tangential_derivatives(contact, &s), WRC_OK) << error();
  EXPECT_LT(s.forces[0][0], 0.0);
}

TEST_F(Sensitivities, WithoutContactAreZeroAndFlagged) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  load.approach = -1e-3;
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
  wrc_planar_derivatives s = sized<wrc_planar_derivatives>();
  EXPECT_EQ(wrc_planar_tangential_derivatives(contact, &s), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(s.forces[0][0], 0.0);
  EXPECT_EQ(wrc_planar_tangential_derivatives(nullptr, &s), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_tangential_derivatives(contact, nullptr), WRC_FLAG_NO_CONTACT);
}

/// Methods and laws without derivatives of their own: against differences of wrc_planar_tangential with
/// steps of another size.
TEST_F(Sensitivities, DifferencesStandInWhereAMethodHasNoDerivatives) {
  struct Choice {
    int32_t preset, flexibility, speed_law;
  };
  for (const Choice& choice :
       {Choice{preset_modified_fastsim, WRC_FLEXIBILITY_SEPARATE, WRC_SPEED_LAW_NONE},
        Choice{preset_fastrip_sdec, WRC_FLEXIBILITY_SEPARATE, WRC_SPEED_LAW_NONE},
        Choice{preset_fastsim_sdec, WRC_FLEXIBILITY_BLENDED, WRC_SPEED_LAW_NONE},
        Choice{preset_strip_fastsim, WRC_FLEXIBILITY_SEPARATE, WRC_SPEED_LAW_EXPONENTIAL}}) {
    SCOPED_TRACE(presets[choice.preset].name);
    choose_tangential(config, choice.preset);
    config.tangential.flexibility = choice.flexibility;
    friction.speed_law = choice.speed_law;
    friction.slope_fall = slope_fall_for(choice.preset);
    creepage.speed = 20.0;
    create();
    ASSERT_GE(step(), 0) << error();
    const std::vector<char> before = state();
    wrc_planar_derivatives s = sized<wrc_planar_derivatives>();
    ASSERT_GE(wrc_planar_tangential_derivatives(contact, &s), 0) << error();
    EXPECT_EQ(state(), before);

    const double limit = forces.fn * friction.coefficient;
    double* const inputs[] = {&creepage.longitudinal, &creepage.lateral, &creepage.spin,
                              &friction.coefficient};
    const int columns[] = {0, 1, 2, 4};
    const double steps[] = {2e-5, 2e-5, 4e-3, 2e-3};
    for (int k = 0; k < 4; ++k) {
      const double at = *inputs[k];
      double ends[2][2];
      for (int end = 0; end < 2; ++end) {
        *inputs[k] = end == 0 ? at - steps[k] : at + steps[k];
        ASSERT_GE(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces), 0) << error();
        ends[end][0] = forces.fx;
        ends[end][1] = forces.fy;
      }
      *inputs[k] = at;
      for (int row = 0; row < 2; ++row) {
        // What changes over a step, against a hundredth of what friction allows.
        const double slope = (ends[1][row] - ends[0][row]) / (2.0 * steps[k]);
        EXPECT_NEAR(s.forces[row][columns[k]] * steps[k], slope * steps[k], 1e-3 * limit)
            << "row " << row << " input " << k;
        EXPECT_NE(s.forces[row][columns[k]], 0.0);
      }
      EXPECT_NEAR(s.forces[0][3] * forces.fn, s.forces[0][4] * friction.coefficient,
                  1e-6 * limit);  // load and friction act through their product
    }
  }
}

}  // namespace
