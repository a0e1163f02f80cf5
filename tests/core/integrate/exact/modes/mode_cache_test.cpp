#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

scene::Scene scene_with(double stiffness_n_per_m, double whirl_ratio = 0.4) {
  test::OneSideRotor rotor;
  rotor.stiffness_n_per_m = stiffness_n_per_m;
  rotor.whirl_ratio = whirl_ratio;
  return test::cell_of(rotor).scene;
}

/// A map goes through its speeds row by row: modes of each speed must still be cached in the next row.
TEST(ModeCache, KeepsSeveralMachines) {
  ModeCache cache;
  const auto first = cache.modes_of<4>(scene_with(1e5)), second = cache.modes_of<4>(scene_with(2e5));
  EXPECT_NE(first, second);
  EXPECT_EQ(cache.modes_of<4>(scene_with(1e5, 0.7)), first);
  EXPECT_EQ(cache.modes_of<4>(scene_with(2e5, 0.7)), second);
}

TEST(ModeCache, DropsWhatWasNotUsedForLongest) {
  const auto bytes = [] {
    ModeCache all;
    const auto modes = all.modes_of<4>(scene_with(1e5));
    EXPECT_NE(modes->mode(1), nullptr);
    return modes->bytes();
  }();
  ModeCache cache(2 * bytes + bytes / 2);
  const auto filled = [&](double stiffness_n_per_m) {
    const auto modes = cache.modes_of<4>(scene_with(stiffness_n_per_m));
    EXPECT_NE(modes->mode(1), nullptr);
    return modes;
  };
  const auto first = filled(1e5), second = filled(2e5);
  filled(1e5);
  const auto third = filled(3e5);
  filled(3e5);
  EXPECT_EQ(filled(1e5), first);
  EXPECT_EQ(filled(3e5), third);
  EXPECT_NE(filled(2e5), second);
}

/// Size used for memory estimates, with all modes of the machine computed.
TEST(ModeCache, HoldsNoMoreThanTheModesOfItsMachinesTakeAtMost) {
  ModeCache cache;
  const auto modes = cache.modes_of<4>(scene_with(1e5));
  for (std::size_t joint = 0; joint < 4; ++joint) EXPECT_NE(modes->mode(joint), nullptr);
  EXPECT_LE(modes->bytes(), most_bytes_of_modes(4, 1));
  EXPECT_GT(modes->bytes(), most_bytes_of_modes(4, 1) / 8);
}

TEST(ModeCache, KeepsTheMachineAskedForWhateverItsSize) {
  ModeCache cache(0);
  const auto only = cache.modes_of<4>(scene_with(1e5));
  EXPECT_NE(only->mode(1), nullptr);
  EXPECT_EQ(cache.modes_of<4>(scene_with(1e5)), only);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
