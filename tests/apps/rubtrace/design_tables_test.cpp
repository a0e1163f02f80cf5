#include "rubtrace/design_tables.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rubsweep::apps {
namespace {

using design::DesignCheck;
using design::DryWhip;

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

TEST(DesignTables, NamesOfStopsHaveTheirColumn) {
  DesignCheck check = tabled_check();
  check.stop_names = {"", "catcher"};
  check.clearances.push_back({1, 0.4, 30, 3e-5, 2e-4, 0.8});
  const std::string csv = tables_of(check).design_check_csv;
  EXPECT_NE(csv.find("clearance,stop 1,0.4,30,3e-05,0.00015000000000000001,m,0.8,ok,catcher\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("dry_whip,stop 1,,,0.25,,1,1,ok,catcher\n"), std::string::npos) << csv;
}

TEST(DesignTables, NamesWithCommasAndQuotesAreQuoted) {
  DesignCheck check = tabled_check();
  design::Term& term = check.lateral.emplace_back();
  term.check = "bearing_force";
  term.place = "support 0";
  term.name = "Drive end, \"A\"";
  const std::string csv = tables_of(check).design_check_csv;
  EXPECT_NE(csv.find("\nbearing_force,support 0,,,,,,,,\"Drive end, \"\"A\"\"\"\n"), std::string::npos)
      << csv;
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
}  // namespace rubsweep::apps
