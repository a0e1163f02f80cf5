#include "rubsweep/maps/report/describe_grid.hpp"

#include <gtest/gtest.h>

#include "maps/batch/message_of.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

/// A grid of two speeds and these numbers of values on its other two axes.
sweep::Grid grid_of(std::size_t unbalances, std::size_t forces) {
  sweep::Grid grid;
  grid.speed_hz = {60, 70};
  grid.unbalance.assign(unbalances, 0.4);
  sweep::KeyAxis& axis = grid.axes.emplace_back();
  axis.keys = {"kick.force_n"};
  axis.values.assign(forces, 100.0);
  return grid;
}

TEST(DescribeGridRequirePlane, TakesTwoAxesWithSeveralValues) {
  EXPECT_NO_THROW(require_plane(grid_of(1, 3), "a report"));
  EXPECT_NO_THROW(require_plane(grid_of(3, 1), "a report"));
  sweep::Grid plain = grid_of(3, 1);
  plain.axes.clear();
  EXPECT_NO_THROW(require_plane(plain, "a report"));
}

TEST(DescribeGridRequirePlane, NamesTheAxesOfAnyOther) {
  try {
    require_plane(grid_of(2, 2), "a picture");
    FAIL() << "three axes are taken";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "sweep: speed_hz, whirl_ratio, kick.force_n have several values, "
                 "allowed: two axes with several values in a picture");
  }
}

TEST(DescribeGridDescribeFootprint, OfTheLargestGridStaysSmallAndIsSaidInWords) {
  sweep::Study study = sweep::one_side_study({50}, {0.1});
  study.grid.speed_hz.resize(2000);
  study.grid.unbalance.resize(2000);
  EXPECT_EQ(describe_footprint(study, scene::prepare_machine(study.machine), {2}),
            "4000000 cells on 2 threads: up to 111 MB of memory, 4.08 GB of disk");
}

TEST(DescribeGridDescribeFootprint, OfRanksIsThatOfEach) {
  const sweep::Study study = sweep::one_side_study({50, 60}, {0.1});
  EXPECT_EQ(describe_footprint(study, scene::prepare_machine(study.machine), {2, 9}),
            "2 cells on 9 ranks of 2 threads: up to 45 MB of memory each, 0.1 MB of disk");
}

TEST(DescribeGridDescribeFootprint, WhatDoesNotFitIsRefused) {
  const sweep::Study study = sweep::one_side_study({50, 60}, {0.1});
  const std::size_t needed = sweep::footprint(study, scene::prepare_machine(study.machine), {2}).memory_bytes;
  refuse_more_memory_than(needed, study, {2});
  EXPECT_EQ(message_of<ConfigError>([&] { refuse_more_memory_than(needed - 1, study, {2}); }),
            "2 cells on 2 threads: up to 15 MB of memory, 0.1 MB of disk, this machine has 14 MB, allowed: "
            "fewer --threads, response.window_revolutions or response.samples_per_revolution");
  EXPECT_EQ(
      message_of<ConfigError>([&] {
        refuse_more_memory_than(10'000'000, study, {2, 3});
      }),
      "2 cells on 3 ranks of 2 threads: up to 45 MB of memory each, 0.1 MB of disk, this machine has 10 "
      "MB for each, allowed: fewer ranks, --threads, response.window_revolutions or "
      "response.samples_per_revolution");
}

}  // namespace
}  // namespace rubsweep::report
