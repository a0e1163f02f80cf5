#include "rubsweep/report/map_summary.hpp"

#include <gtest/gtest.h>

namespace rubsweep::report {
namespace {

using response::MotionClass;
using sweep::Row;

Row row(MotionClass motion_class, std::optional<int> order = {}, const std::string& status = "ok") {
  Row result;
  result.motion_class = motion_class;
  result.order = order;
  result.status = status;
  return result;
}

TEST(MapSummary, CountsClassesByOrderAndStatuses) {
  const std::vector<std::optional<Row>> rows{row(MotionClass::subharmonic, 3),
                                             row(MotionClass::synchronous, 1),
                                             std::nullopt,
                                             row(MotionClass::subharmonic, 2),
                                             row(MotionClass::non_contact),
                                             row(MotionClass::subharmonic, 2, "slip_reversal"),
                                             row(MotionClass::subharmonic, 2),
                                             row(MotionClass::failed, {}, "step_limit"),
                                             row(MotionClass::failed, {}, "step_limit")};
  EXPECT_EQ(map_summary(rows),
            "       3   37.5 %  subharmonic 1/2\n"
            "       2   25.0 %  failed\n"
            "       1   12.5 %  non_contact\n"
            "       1   12.5 %  subharmonic 1/3\n"
            "       1   12.5 %  synchronous\n"
            "       1  status slip_reversal\n"
            "       2  status step_limit\n");
}

TEST(MapSummary, OfNothingIsEmpty) { EXPECT_EQ(map_summary({std::nullopt, std::nullopt}), ""); }

}  // namespace
}  // namespace rubsweep::report
