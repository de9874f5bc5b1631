#include <gtest/gtest.h>

#include "base/fault.hpp"

namespace wrc {
namespace {

TEST(Fault, FailureOutranksFlagAndFirstOfEqualsStays) {
  Fault kept;
  keep_worst(kept, Fault{.status = WRC_FLAG_ITERATION_CAP});
  EXPECT_EQ(kept.status, WRC_FLAG_ITERATION_CAP);
  keep_worst(kept, Fault{.status = WRC_FLAG_PATCH_AT_EDGE});
  EXPECT_EQ(kept.status, WRC_FLAG_ITERATION_CAP);
  keep_worst(kept, Fault{.status = WRC_ERROR_GAP});
  EXPECT_EQ(kept.status, WRC_ERROR_GAP);
  keep_worst(kept, Fault{.status = WRC_ERROR_LOAD});
  EXPECT_EQ(kept.status, WRC_ERROR_GAP);
}

}  // namespace
}  // namespace wrc
