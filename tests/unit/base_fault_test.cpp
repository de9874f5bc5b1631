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

TEST(Fault, KindsPutPlaceNumberAndCauseWhereTheSentenceTakesThemFrom) {
  const std::size_t third = 2;
  const Fault fault = Fault::range({"strips", "y", third}, {7u, "m", 1, 5.5}, "cause");
  EXPECT_EQ(fault.status, WRC_ERROR_RANGE);
  EXPECT_STREQ(fault.of, "strips");
  EXPECT_STREQ(fault.field, "y");
  EXPECT_EQ(fault.index, 2);
  EXPECT_EQ(fault.value, 7.0);
  EXPECT_STREQ(fault.unit, "m");
  EXPECT_EQ(fault.low, 1.0);
  EXPECT_EQ(fault.high, 5.5);
  EXPECT_STREQ(fault.cause, "cause");
}

TEST(Fault, PlacesWithoutStructOrIndexLeaveBothOut) {
  const Fault field = Fault::null("gap"), member = Fault::gap({"gap", "y"}), element = Fault::gap({"y", 0});
  EXPECT_EQ(field.of, nullptr);
  EXPECT_EQ(field.index, -1);
  EXPECT_EQ(field.unit, nullptr);  // no number to name
  EXPECT_STREQ(member.of, "gap");
  EXPECT_EQ(member.index, -1);
  EXPECT_EQ(element.of, nullptr);
  EXPECT_EQ(element.index, 0);
}

TEST(Fault, ReturnIfFailedKeepsFlagsInTheFunction) {
  const auto run = [](const Fault& first) -> Fault {
    RETURN_IF_FAILED(first);
    return Fault::no_contact();
  };
  EXPECT_EQ(run(Fault::memory()).status, WRC_ERROR_MEMORY);
  EXPECT_EQ(run(Fault::climbing()).status, WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(run({}).status, WRC_FLAG_NO_CONTACT);
}

}  // namespace
}  // namespace wrc
