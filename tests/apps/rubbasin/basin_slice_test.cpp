#include "rubbasin/basin_slice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::apps {
namespace {

using report::map_header, report::map_line;
using response::motion::MotionClass;

sweep::Row row_of(MotionClass motion_class, double length_m) {
  sweep::Row row;
  row.motion_class = motion_class;
  if (motion_class == MotionClass::subharmonic) row.order = 2;
  if (motion_class == MotionClass::failed) {
    row.status = "step_limit";
    return row;
  }
  row.measures.emplace();
  row.measures->contact.peak_displacement_m = length_m;
  row.measures->amplitude_1x_forward_m = length_m / 3;
  return row;
}

/// Writes `rows` as the map of a plane, in the order of its initial states or in reverse order.
class BasinSliceTest : public testing::Test {
 protected:
  BasinSlice read(const std::vector<sweep::Row>& rows, std::vector<double> across, std::vector<double> up,
                  bool backwards = false) {
    sweep::Study study;
    study.grid = {{50}, sweep::UnbalanceMeasure::whirl_ratio, {0.5}};
    study.grid.axes = {{{"start.x_m"}, {1}, across}, {{"start.casings.0.vy_m_per_s"}, {1}, up}};
    std::vector<std::string> lines;
    for (std::size_t start = 0; start < rows.size(); ++start) {
      sweep::Row row = rows[start];
      row.speed_hz = 50;
      row.whirl_ratio = 0.5;
      row.key_values = {across[start % across.size()], up[start / across.size()]};
      lines.push_back(map_line(row, study));
    }
    if (backwards) std::ranges::reverse(lines);
    const auto file = directory_.path() / "map.csv";
    std::ofstream stream(file);
    stream << "# a comment\n" << map_header(study) << '\n';
    for (const std::string& line : lines) stream << line << '\n';
    stream.close();
    return read_basin_slice(file, {{"x_m", "casing0_vy_m_per_s"}, {std::move(across), std::move(up)}},
                            study.grid);
  }

  TemporaryDirectory directory_;
};

TEST_F(BasinSliceTest, TakesARowForWhatItSays) {
  const std::vector<sweep::Row> rows{row_of(MotionClass::non_contact, 1e-4),
                                     row_of(MotionClass::subharmonic, 2e-3),
                                     row_of(MotionClass::subharmonic, 2e-3), row_of(MotionClass::failed, 0)};
  EXPECT_EQ(slice_csv(read(rows, {-1e-3, 1e-3}, {0, 0.5}, true)),
            slice_csv(read(rows, {-1e-3, 1e-3}, {0, 0.5})));
}

TEST_F(BasinSliceTest, NumbersTheAttractorsOfItsRows) {
  const BasinSlice slice =
      read({row_of(MotionClass::non_contact, 1e-4), row_of(MotionClass::subharmonic, 2e-3),
            row_of(MotionClass::subharmonic, 2e-3), row_of(MotionClass::failed, 0)},
           {-1e-3, 1e-3}, {0, 0.5});
  EXPECT_EQ(slice_csv(slice),
            "x_m,casing0_vy_m_per_s,attractor,label,status\n"
            "-0.001,0,2,non_contact,ok\n"
            "0.001,0,1,subharmonic 1/2,ok\n"
            "-0.001,0.5,1,subharmonic 1/2,ok\n"
            "0.001,0.5,,failed,step_limit\n");
  EXPECT_EQ(attractors_csv(slice),
            "attractor,label,starts,share,standard_error,peak_displacement_m,amplitude_1x_forward_m,"
            "amplitude_1x_backward_m,x_m,casing0_vy_m_per_s\n"
            "1,subharmonic 1/2,2,0.5,0.25,0.002,0.0006666666666666666,0,0.001,0\n"
            "2,non_contact,1,0.25,0.21650635094610965,1e-04,3.3333333333333335e-05,0,-0.001,0\n");
  const std::string summary = slice_summary(slice);
  EXPECT_NE(summary.find("2   50.0 +- 25.0 %  attractor 1: subharmonic 1/2, largest displacement 2 mm"),
            std::string::npos);
  EXPECT_NE(summary.find("1   25.0 %         failed"), std::string::npos);
  EXPECT_NE(summary.find("basin entropy: none, the slice has fewer than 5 x 5 starts"), std::string::npos);
  EXPECT_NE(summary.find("uncertainty exponent: none"), std::string::npos);
}

std::vector<double> places(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i));
  return values;
}

/// Two halves divided by a straight line within a column of boxes: every sixth box is mixed, in the ratio 2
/// to 3.
TEST_F(BasinSliceTest, SaysTheEntropiesAndTheExponentOfALine) {
  std::vector<sweep::Row> rows;
  for (std::size_t i = 0; i < 30 * 30; ++i)
    rows.push_back(row_of(i % 30 < 12 ? MotionClass::non_contact : MotionClass::subharmonic, 1e-3));
  const std::string summary = slice_summary(read(rows, places(30), places(30)));
  EXPECT_NE(summary.find("basin entropy 0.112 (0: every box of 5 x 5"), std::string::npos) << summary;
  EXPECT_NE(summary.find("boundary basin entropy 0.673 (not above log 2 = 0.693: it does not show a fractal"),
            std::string::npos);
  EXPECT_NE(summary.find("uncertainty exponent 1.0"), std::string::npos);
}

TEST_F(BasinSliceTest, OfOneAttractorHasNoBoundary) {
  const std::vector<sweep::Row> rows(36, row_of(MotionClass::non_contact, 1e-3));
  EXPECT_NE(slice_summary(read(rows, places(6), places(6))).find("one attractor: no boundary"),
            std::string::npos);
}

TEST_F(BasinSliceTest, RefusesTheMapOfAnotherPlane) {
  const std::vector<sweep::Row> rows(3, row_of(MotionClass::non_contact, 1e-3));
  EXPECT_NE(
      message_of<IoError>([&] { read(rows, places(2), places(2)); })
          .find("map.csv: holds 3 cells of 4, there is no row of speed_hz 50, whirl_ratio 0.5, start.x_m 1, "
                "start.casings.0.vy_m_per_s 1"),
      std::string::npos);
}

}  // namespace
}  // namespace rubsweep::apps
