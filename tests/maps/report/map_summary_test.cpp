#include "rubsweep/maps/report/map_summary.hpp"

#include <gtest/gtest.h>

#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::report {
namespace {

using response::motion::MotionClass;
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

TEST(MapSummary, CountsCellsByTheNameOfTheirMotion) {
  const MapSummary summary = summary_of(
      {row(MotionClass::subharmonic, 3), row(MotionClass::non_contact), row(MotionClass::subharmonic, 3)});
  EXPECT_EQ(summary.cells(), 3u);
  EXPECT_EQ(summary.cells_by_name(),
            (std::map<std::string, std::size_t>{{"non_contact", 1}, {"subharmonic 1/3", 2}}));
}

TEST(MapSummary, OnlyTheClassTellsAFailedCell) {
  EXPECT_FALSE(summary_of({row(MotionClass::subharmonic, 2, "slip_reversal")}).has_failed_cells());
}

Row measured(MotionClass motion_class, response::spectrum::OrbitKind orbit,
             response::spectrum::WhirlKind whirl, bool comb) {
  Row result = row(motion_class);
  result.measures.emplace();
  result.measures->turns = 64;
  result.measures->orbit = orbit;
  result.measures->whirl = whirl;
  if (comb) result.measures->comb_spacing = 2.5;
  return result;
}

TEST(MapSummary, TellsAWhipFromAnOvalAndCirclesByTheirSense) {
  using response::spectrum::OrbitKind, response::spectrum::WhirlKind;
  const MapSummary summary =
      summary_of({measured(MotionClass::quasi_periodic, OrbitKind::circle, WhirlKind::backward, true),
                  measured(MotionClass::quasi_periodic, OrbitKind::oval, WhirlKind::backward, true),
                  measured(MotionClass::quasi_periodic, OrbitKind::oval, WhirlKind::forward, true),
                  measured(MotionClass::quasi_periodic, OrbitKind::complex, WhirlKind::backward, false),
                  measured(MotionClass::synchronous, OrbitKind::circle, WhirlKind::forward, false),
                  measured(MotionClass::synchronous, OrbitKind::circle, WhirlKind::backward, false),
                  measured(MotionClass::synchronous, OrbitKind::oval, WhirlKind::forward, false),
                  row(MotionClass::failed, {}, "step_limit")});
  EXPECT_EQ(summary.text(),
            "       2   25.0 %  quasi_periodic dry whip, backward\n"
            "       1   12.5 %  failed\n"
            "       1   12.5 %  quasi_periodic\n"
            "       1   12.5 %  quasi_periodic oval, forward\n"
            "       1   12.5 %  synchronous\n"
            "       1   12.5 %  synchronous circle, backward\n"
            "       1   12.5 %  synchronous circle, forward\n"
            "       1  status step_limit\n");
  EXPECT_TRUE(summary.has_failed_cells());
}

TEST(MapSummaryMotionName, OfARowIsThatOfItsLine) {
  using response::spectrum::OrbitKind, response::spectrum::WhirlKind;
  const std::pair<Row, const char*> named[] = {
      {measured(MotionClass::quasi_periodic, OrbitKind::oval, WhirlKind::backward, true),
       "quasi_periodic dry whip, backward"},
      {measured(MotionClass::quasi_periodic, OrbitKind::complex, WhirlKind::mixed, true),
       "quasi_periodic oval, mixed"},
      {measured(MotionClass::quasi_periodic, OrbitKind::complex, WhirlKind::backward, false),
       "quasi_periodic"},
      {measured(MotionClass::synchronous, OrbitKind::circle, WhirlKind::backward, false),
       "synchronous circle, backward"},
      {row(MotionClass::synchronous, 1), "synchronous"},
      {row(MotionClass::subharmonic, 3), "subharmonic 1/3"},
      {row(MotionClass::failed, {}, "step_limit"), "failed"}};
  for (const auto& [row, name] : named) {
    EXPECT_EQ(motion_name(row), name);
    EXPECT_EQ(motion_name(map_line(row)), name);
  }
}

Row untouched(sweep::RunStart start) {
  Row result = row(MotionClass::non_contact);
  result.start = start;
  return result;
}

TEST(MapSummary, SaysWhyNothingRubs) {
  const Row quiet = untouched(sweep::RunStart::quiet), kicked = untouched(sweep::RunStart::kick);
  Row came_free = kicked;
  came_free.last_contact_revolution = 3;
  EXPECT_NE(summary_of({quiet, quiet}).text().find("no wall was ever touched: there is no kick"),
            std::string::npos);
  EXPECT_NE(summary_of({kicked}).text().find("no wall was ever touched: the kick is too weak"),
            std::string::npos);
  EXPECT_NE(summary_of({kicked, came_free}).text().find("nothing rubs on: the kick reached a wall"),
            std::string::npos);
  Row started = untouched(sweep::RunStart::state);
  EXPECT_NE(summary_of({started}).text().find("no wall was ever touched: no start"), std::string::npos);
  started.last_contact_revolution = 3;
  EXPECT_NE(summary_of({started}).text().find("nothing rubs on: the rotor reached a wall"),
            std::string::npos);
  EXPECT_EQ(summary_of({kicked, row(MotionClass::synchronous, 1)}).text().find("touched"), std::string::npos);
}

TEST(MapSummary, WarnsOfCellsThatMoveFartherThanTheLimit) {
  Row near = row(MotionClass::subharmonic, 2), far = near, farther = near;
  near.peak_over_clearance = 10;
  far.peak_over_clearance = 10.5;
  farther.peak_over_clearance = 39.25;
  const MapSummary summary = summary_of({near, far, farther, row(MotionClass::non_contact)});
  EXPECT_NE(summary.text().find("       2  move farther than 10 clearances, at most 39.2\n"),
            std::string::npos)
      << summary.text();
  EXPECT_TRUE(summary.warning().starts_with(
      "warning: in 2 of 4 cells the rotor moves farther than 10 clearances, at most 39.2;"))
      << summary.warning();
  EXPECT_EQ(summary_of({near}).warning(), "");
  EXPECT_EQ(summary_of({near}).text().find("clearances"), std::string::npos);
  MapSummary strict(5);
  strict.add(map_line(near));
  EXPECT_NE(strict.warning().find("in 1 of 1 cells the rotor moves farther than 5 clearances"),
            std::string::npos);
}

TEST(MapSummary, OfNothingIsEmpty) { EXPECT_EQ(MapSummary().text(), ""); }

}  // namespace
}  // namespace rubsweep::report
