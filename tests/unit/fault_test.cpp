#include "fault.hpp"

#include <gtest/gtest.h>

namespace wrc {
namespace {

TEST(Fault, FailureOutranksFlagAndFirstOfEqualsStays) {
  Fault kept;
  worsen(kept, Fault{.status = WRC_FLAG_ITERATION_CAP});
  EXPECT_EQ(kept.status, WRC_FLAG_ITERATION_CAP);
  worsen(kept, Fault{.status = WRC_FLAG_PATCH_AT_EDGE});
  EXPECT_EQ(kept.status, WRC_FLAG_ITERATION_CAP);
  worsen(kept, Fault{.status = WRC_ERROR_GAP});
  EXPECT_EQ(kept.status, WRC_ERROR_GAP);
  worsen(kept, Fault{.status = WRC_ERROR_LOAD});
  EXPECT_EQ(kept.status, WRC_ERROR_GAP);
}

}  // namespace
}  // namespace wrc
