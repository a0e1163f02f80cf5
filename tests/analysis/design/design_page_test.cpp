#include "rubsweep/analysis/design/design_page.hpp"

#include <gtest/gtest.h>

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

TEST(DesignPage, SaysWhereAndAtWhichSpeedWithWhatMargin) {
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

TEST(DesignPage, SaysWhatThereIsNot) {
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

TEST(DesignPage, NamesOfStopsStandBehindTheirNumbers) {
  DesignCheck check = some_check();
  check.clearances.resize(1);
  check.whips.resize(1);
  check.stop_names = {"", "catcher"};
  check.clearances.push_back({1, 0.4, 30, 3e-5, 2e-4, 0.8});
  check.whips.push_back({1, 0.25, {}});
  const std::string page = design_page(check);
  EXPECT_NE(page.find("  stop 0 at 0.2 m: 100 um of"), std::string::npos) << page;
  EXPECT_NE(page.find("  stop 1 (catcher) at 0.4 m: 30 um of"), std::string::npos) << page;
  EXPECT_NE(page.find("  stop 1 (catcher): none at any friction: ok\n"), std::string::npos) << page;
}

}  // namespace
}  // namespace rubsweep::design
