#include "rubsweep/maps/report/require_plane.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

/// Two speeds, `unbalances` and `forces` values of the other two axes.
sweep::Grid grid_of(std::size_t unbalances, std::size_t forces) {
  sweep::Grid grid;
  grid.speed_hz = {60, 70};
  grid.unbalance.assign(unbalances, 0.4);
  sweep::KeyAxis& axis = grid.axes.emplace_back();
  axis.keys = {"kick.force_n"};
  axis.values.assign(forces, 100.0);
  return grid;
}

TEST(RequirePlane, TakesTwoAxesWithSeveralValues) {
  EXPECT_NO_THROW(require_plane(grid_of(1, 3), "a report"));
  EXPECT_NO_THROW(require_plane(grid_of(3, 1), "a report"));
  sweep::Grid plain = grid_of(3, 1);
  plain.axes.clear();
  EXPECT_NO_THROW(require_plane(plain, "a report"));
}

TEST(RequirePlane, NamesTheAxesOfAnyOther) {
  try {
    require_plane(grid_of(2, 2), "a picture");
    FAIL() << "three axes are taken";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "sweep: speed_hz, whirl_ratio, kick.force_n have several values, "
                 "allowed: two axes with several values in a picture");
  }
}

}  // namespace
}  // namespace rubsweep::report
