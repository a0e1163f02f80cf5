#include "rubsweep/report/map_summary.hpp"

#include <gtest/gtest.h>

#include "rubsweep/report/map_csv.hpp"

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

MapSummary summary_of(const std::vector<Row>& rows) {
  MapSummary summary;
  for (const Row& row : rows) summary.add(map_line(row));
  return summary;
}

TEST(MapSummary, CountsClassesByOrderAndStatuses) {
  const MapSummary summary =
      summary_of({row(MotionClass::subharmonic, 3), row(MotionClass::synchronous, 1),
                  row(MotionClass::subharmonic, 2), row(MotionClass::non_contact),
                  row(MotionClass::subharmonic, 2, "slip_reversal"), row(MotionClass::subharmonic, 2),
                  row(MotionClass::failed, {}, "step_limit"), row(MotionClass::failed, {}, "step_limit")});
  EXPECT_EQ(summary.text(),
            "       3   37.5 %  subharmonic 1/2\n"
            "       2   25.0 %  failed\n"
            "       1   12.5 %  non_contact\n"
            "       1   12.5 %  subharmonic 1/3\n"
            "       1   12.5 %  synchronous\n"
            "       1  status slip_reversal\n"
            "       2  status step_limit\n");
  EXPECT_TRUE(summary.has_failed_cells());
}

TEST(MapSummary, OnlyTheClassTellsAFailedCell) {
  EXPECT_FALSE(summary_of({row(MotionClass::subharmonic, 2, "slip_reversal")}).has_failed_cells());
}

TEST(MapSummary, OfNothingIsEmpty) { EXPECT_EQ(MapSummary().text(), ""); }

}  // namespace
}  // namespace rubsweep::report
