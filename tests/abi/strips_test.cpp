/// Pressure of the caller as strips through the C interface: each number of each array is checked, and what
/// is wrong is named with its unit and likely cause.
#include <gtest/gtest.h>

#include "reference_contact.hpp"
#include "test_config.hpp"

namespace {

class StripsOfTheCaller : public ReferenceContact {
 protected:
  std::vector<double> y{-1e-3, 0.0, 1e-3}, width{1e-3, 1e-3, 1e-3}, centre{0.0, 1e-4, 0.0},
      half{4e-3, 5e-3, 4e-3}, peak{8e8, 9e8, 8e8};
  wrc_planar_strips strips = sized<wrc_planar_strips>();

  int32_t take() {
    strips.count = 3;
    strips.y = y.data();
    strips.width = width.data();
    strips.centre = centre.data();
    strips.half_length = half.data();
    strips.peak = peak.data();
    return wrc_planar_regularise(contact, &strips, &normal);
  }
  /// Refused with this number in the middle of this array; as good as before without it.
  void expect_refused_number(std::vector<double>& values, double wrong, int32_t status,
                             const std::vector<std::string>& words) {
    const double kept = values[1];
    values[1] = wrong;
    EXPECT_EQ(take(), status) << wrong;
    expect_words(error(), words);
    EXPECT_EQ(normal.area, 0.0);
    values[1] = kept;
    EXPECT_EQ(take(), WRC_OK) << error();
  }
};

TEST_F(StripsOfTheCaller, NumbersThatAreNoneAreNamed) {
  for (double none : {nan_value, infinity, -infinity}) {
    expect_refused_number(y, none, WRC_ERROR_NOT_FINITE, {"strips.y[1]"});
    expect_refused_number(width, none, WRC_ERROR_NOT_FINITE, {"strips.width[1]"});
    expect_refused_number(centre, none, WRC_ERROR_NOT_FINITE, {"strips.centre[1]"});
    expect_refused_number(half, none, WRC_ERROR_NOT_FINITE, {"strips.half_length[1]"});
    expect_refused_number(peak, none, WRC_ERROR_NOT_FINITE, {"strips.peak[1]"});
  }
}

TEST_F(StripsOfTheCaller, AbsurdSizesAreRefusedWithUnitAndLikelyCause) {
  for (double wrong : {1e300, 4.0}) {
    expect_refused_number(y, wrong, WRC_ERROR_RANGE, {"strips.y[1]", " m is outside -0.3 .. 0.3 m", "mm?"});
    expect_refused_number(width, wrong, WRC_ERROR_RANGE, {"strips.width[1]", " m is outside", "mm?"});
    expect_refused_number(centre, wrong, WRC_ERROR_RANGE, {"strips.centre[1]", " m is outside", "mm?"});
    expect_refused_number(half, wrong, WRC_ERROR_RANGE, {"strips.half_length[1]", " m is outside", "mm?"});
  }
  expect_refused_number(width, 0.0, WRC_ERROR_RANGE, {"strips.width[1]", "without width"});
  expect_refused_number(half, -1e-3, WRC_ERROR_RANGE, {"strips.half_length[1]", "without length"});
  expect_refused_number(peak, 1e300, WRC_ERROR_RANGE, {"strips.peak[1]", " Pa is outside", "yields"});
  expect_refused_number(peak, -1.0, WRC_ERROR_RANGE, {"strips.peak[1]", "compressive positive"});
}

TEST_F(StripsOfTheCaller, ArraysThatAreMissingAreNamed) {
  ASSERT_EQ(take(), WRC_OK) << error();
  const double** const needed[] = {&strips.y, &strips.width, &strips.half_length, &strips.peak};
  const char* const names[] = {"strips.y", "strips.width", "strips.half_length", "strips.peak"};
  for (int i = 0; i < 4; ++i) {
    const double* const kept = *needed[i];
    *needed[i] = nullptr;
    EXPECT_EQ(wrc_planar_regularise(contact, &strips, &normal), WRC_ERROR_NULL);
    expect_words(error(), {names[i]});
    *needed[i] = kept;
  }
  strips.centre = nullptr;  // zero
  EXPECT_EQ(wrc_planar_regularise(contact, &strips, &normal), WRC_OK) << error();
}

}  // namespace
