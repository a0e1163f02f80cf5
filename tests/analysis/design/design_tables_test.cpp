#include "rubsweep/analysis/design/design_tables.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rubsweep::design {
namespace {

DesignCheck some_check() {
  DesignCheck check;
  check.operating = {50, 200};
  check.whole = {0.2, 200};
  check.eccentricity_m = 2e-6;
  check.vibration_limit_m = 25.4e-6;
  check.probes = {{0.1, {50, 10e-6}}, {0.3, {60, 30e-6}}};
  check.scale = 6;
  check.clearances = {
      {0, 0.2, 30, 1e-4, 2e-4, 1 - 1 / 1.5}, {1, {}, 31, 1e-4, 1e-4, 1 - 1 / 0.75}, {2, {}, 0.2, 1, 0, -1}};
  check.whips = {{0, 0.1, DryWhip{0.2, 70, 50}}, {1, 0.3, DryWhip{0.2, 70, 50}}, {2, 0.3, {}}};
  check.locks = {{2, 1, 3, 1, 60}};
  check.kicks = {{50, {}, "", 8, 0}, {60, 17.5, "subharmonic 1/2", 12, 1}, {70, 20, "chaotic", 10, 0}};
  return check;
}

void expect_line(const std::string& text, const std::string& line) {
  EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nis not in\n" << text;
}

TEST(DesignTablesDesignPage, SaysWhereAndAtWhichSpeedWithWhatMargin) {
  const std::string page = design_page(some_check());
  expect_line(page, "operating 50 Hz (3000 rpm) to 200 Hz (12000 rpm), clearances from 0.2 Hz (12 rpm) on");
  expect_line(page, "  probe 0 at 0.1 m: 10 um at 50 Hz (3000 rpm): ok");
  expect_line(page, "  probe 1 at 0.3 m: 30 um at 60 Hz (3600 rpm): NOT MET");
  expect_line(page, "scale     x 6, the most, eccentricity 12 um in all that follows");
  expect_line(page, "  stop 0 at 0.2 m: 100 um of 150 um at 30 Hz (1800 rpm), margin 33.3 %: ok");
  expect_line(page, "  stop 1: 100 um of 75 um at 31 Hz (1860 rpm), margin -33.3 %: NOT MET");
  expect_line(page, "  stop 2: the rotor rests on it at 0.2 Hz (12 rpm): NOT MET");
  expect_line(page, "  stop 0: friction 0.1 of 0.2, 70 Hz backward at 50 Hz (3000 rpm), margin 50.0 %: ok");
  expect_line(page,
              "  stop 1: friction 0.3 of 0.2, 70 Hz backward at 50 Hz (3000 rpm), margin -50.0 %: NOT MET");
  expect_line(page, "  stop 2: none at any friction: ok");
  expect_line(page, "  60 Hz (3600 rpm): 3 turns of mode 2 to 1 of mode 1 in the turning frame");
  expect_line(page, "  17.5 N at 60 Hz (3600 rpm): subharmonic 1/2");
  expect_line(page, "  30 runs at 3 speeds, 1 failed");
}

TEST(DesignTablesDesignPage, SaysWhatThereIsNot) {
  DesignCheck check = some_check();
  check.whips.clear();
  check.locks.clear();
  check.kicks.resize(1);
  check.scale = 0.5;
  std::string page = design_page(check);
  expect_line(page, "  no annular stop");
  expect_line(page, "  none in the operating range");
  expect_line(page, "  none at any of 1 speeds");
  expect_line(page, "scale     x 0.5, the least, eccentricity 1 um in all that follows");
  check.kicks[0].force_n = 0;
  check.kicks[0].motion = "synchronous 1";
  expect_line(design_page(check), "  none is needed at 50 Hz (3000 rpm): synchronous 1");
  check.kicks.clear();
  check.no_kicks = "the configuration has no kick";
  expect_line(design_page(check), "  not tried: the configuration has no kick");
}

DesignCheck tabled_check() {
  DesignCheck check;
  check.operating = {50, 200};
  check.vibration_limit_m = 2e-5;
  check.probes = {{0.25, {50, 1e-5}}};
  check.clearances = {{0, {}, 30, 3e-5, 2e-4, 0.8}};
  check.whips = {{0, 0.25, DryWhip{0.125, 70, 50}}, {1, 0.25, {}}};
  check.locks = {{2, 1, 3, 1, 60}};
  check.kicks = {{50, {}, "", 8, 0}, {60, 17.5, "subharmonic 1/2", 12, 1}};
  check.curves = {{true, 0, 0.25, {10, 50}, {1e-6, 2e-6}}, {false, 0, {}, {10}, {3e-6}}};
  return check;
}

TEST(DesignTables, HaveALineForEachCheck) {
  EXPECT_EQ(tables_of(tabled_check()).design_check_csv,
            "check,place,position_m,speed_hz,value,limit,unit,margin,verdict,name\n"
            "vibration,probe 0,0.25,50,1e-05,2e-05,m,0.5,ok,\n"
            "clearance,stop 0,,30,3e-05,0.00015000000000000001,m,0.8,ok,\n"
            "dry_whip,stop 0,,50,0.25,0.125,1,-1,not_met,\n"
            "dry_whip,stop 1,,,0.25,,1,1,ok,\n"
            "stability,,,,0,0,1/s,,ok,\n"
            "kick,,,60,17.5,,N,,,\n");
}

/// If an unstable rotor stays below a limit, there is no verdict; if it exceeds the limit, the verdict is
/// that the limit is exceeded.
TEST(DesignTables, NothingIsOkOfAnUnstableRotorButItsDryWhip) {
  DesignCheck check = tabled_check();
  check.growth = check.whole_growth = {140, 201};
  check.clearances.push_back({1, {}, 30, 0, 0, -std::numeric_limits<double>::infinity()});
  EXPECT_EQ(tables_of(check).design_check_csv,
            "check,place,position_m,speed_hz,value,limit,unit,margin,verdict,name\n"
            "vibration,probe 0,0.25,50,1e-05,2e-05,m,0.5,,\n"
            "clearance,stop 0,,30,3e-05,0.00015000000000000001,m,0.8,,\n"
            "clearance,stop 1,,30,0,0,m,,not_met,\n"
            "dry_whip,stop 0,,50,0.25,0.125,1,-1,not_met,\n"
            "dry_whip,stop 1,,,0.25,,1,1,ok,\n"
            "stability,,,140,201,0,1/s,,not_met,\n"
            "kick,,,60,17.5,,N,,,\n");
}

TEST(DesignTables, NamesOfStopsStandBehindTheirNumbers) {
  DesignCheck check = tabled_check();
  check.stop_names = {"", "catcher"};
  check.clearances.push_back({1, 0.4, 30, 3e-5, 2e-4, 0.8});
  const std::string page = design_page(check), csv = tables_of(check).design_check_csv;
  EXPECT_NE(page.find("  stop 0: 30 um of"), std::string::npos) << page;
  EXPECT_NE(page.find("  stop 1 (catcher) at 0.4 m: 30 um of"), std::string::npos) << page;
  EXPECT_NE(page.find("  stop 1 (catcher): none at any friction: ok\n"), std::string::npos) << page;
  EXPECT_NE(csv.find("clearance,stop 1,0.4,30,3e-05,0.00015000000000000001,m,0.8,ok,catcher\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("dry_whip,stop 1,,,0.25,,1,1,ok,catcher\n"), std::string::npos) << csv;
}

TEST(DesignTables, LimitOfTheProbesIsThatOfTheOperatingRange) {
  EXPECT_EQ(tables_of(tabled_check()).unbalance_response_csv,
            "place,position_m,speed_hz,major_axis_m,limit_m\n"
            "probe 0,0.25,10,1e-06,\n"
            "probe 0,0.25,50,2e-06,2e-05\n"
            "stop 0,,10,3e-06,0.00015000000000000001\n");
}

TEST(DesignTables, KicksAreEmptyWhereNoneStartsARub) {
  EXPECT_EQ(tables_of(tabled_check()).kicks_csv,
            "speed_hz,force_n,motion,runs,failed\n50,,,8,0\n60,17.5,subharmonic 1/2,12,1\n");
  EXPECT_EQ(tables_of(tabled_check()).lock_speeds_csv, "speed_hz,p,first_mode,q,second_mode\n60,3,2,1,1\n");
  DesignCheck check = tabled_check();
  check.kicks.clear();
  EXPECT_EQ(tables_of(check).kicks_csv, "") << "no file";
}

}  // namespace
}  // namespace rubsweep::design
