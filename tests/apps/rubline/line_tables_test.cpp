#include "rubline/line_tables.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::apps {

using namespace line;

namespace {

using response::motion::MotionClass;

LineCell cell(double value) {
  auto study = std::make_shared<sweep::Study>();
  study->machine = scene::one_side_machine();  // clearance 1 mm
  return {value, study, nullptr, {}};
}

LinePoint point(Pass pass, std::size_t number, MotionClass motion_class, std::optional<int> order = {}) {
  LinePoint made{pass, number, {}, std::nullopt};
  made.row.speed_hz = 50;
  made.row.motion_class = motion_class;
  made.row.order = order;
  return made;
}

TEST(LineTables, HaveARowForEachCellPointAndLine) {
  const std::vector<LineCell> cells{cell(1.5)};
  LinePoint made = point(Pass::up, 0, MotionClass::subharmonic, 2);
  made.motion.emplace();
  made.motion->section = {{{1e-3, 2e-3}, {3, 4}}, {{5e-3, 6e-3}, {7, 8}}};
  // Two turns of four samples: lines at -2, -1.5, ..., 1.5. A line is left out below a thousandth of the
  // largest line, or below a millionth of the clearance; 0X does not count as the largest.
  made.motion->spectrum = {2, 4, {0.9e-9, 0, 1e-6, 0, 1, 0.9e-6, 1e-3, 0}};
  const LineTables tables = tables_of(std::vector{made}, cells, "stops.0.clearance_m");
  EXPECT_EQ(tables.line_csv, report::map_comments() + "# along stops.0.clearance_m\npass,value," +
                                 report::map_header() + "\nup,1.5," + report::map_line(made.row) + "\n");
  EXPECT_EQ(tables.bifurcation_csv,
            "pass,value,speed_hz,class,order,point,x_m,y_m,vx_m_per_s,vy_m_per_s\n"
            "up,1.5,50,subharmonic,2,0,0.001,0.002,3,4\nup,1.5,50,subharmonic,2,1,0.005,0.006,7,8\n");
  EXPECT_EQ(tables.cascade_csv,
            "pass,value,speed_hz,order,frequency_hz,amplitude_m\nup,1.5,50,0,0,1\nup,1.5,50,1,50,0.001\n");
}

TEST(LineTables, ACellWithoutMotionHasOnlyItsRow) {
  const LineTables tables =
      tables_of(std::vector{point(Pass::kick, 0, MotionClass::failed)}, std::vector{cell(1)}, "speed_hz");
  EXPECT_NE(tables.line_csv.find("\nkick,1,50,"), std::string::npos);
  EXPECT_EQ(tables.bifurcation_csv.find('\n') + 1, tables.bifurcation_csv.size());
  EXPECT_EQ(tables.cascade_csv.find('\n') + 1, tables.cascade_csv.size());
}

TEST(LineTablesSummary, PutsNeighboursOfOneMotionTogether) {
  const std::vector<LineCell> cells{cell(1), cell(2), cell(3)};
  const std::vector points{
      point(Pass::kick, 0, MotionClass::non_contact), point(Pass::kick, 1, MotionClass::subharmonic, 3),
      point(Pass::kick, 2, MotionClass::subharmonic, 3), point(Pass::up, 0, MotionClass::subharmonic, 3)};
  EXPECT_EQ(line_summary(points, cells),
            "kick      1 to 1  non_contact\nkick      2 to 3  subharmonic 1/3\nup        1 to 1  subharmonic "
            "1/3\n");
}

}  // namespace
}  // namespace rubsweep::apps
