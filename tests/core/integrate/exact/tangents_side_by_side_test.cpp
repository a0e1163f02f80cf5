#include "rubsweep/core/integrate/exact/tangents_side_by_side.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/tangents_one_by_one.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

constexpr Eigen::Index states = 8;

/// Both implementations, on which the same operations are performed.
template <int N>
struct Both {
  explicit Both(std::size_t count) { resize(count); }
  void resize(std::size_t count) {
    const std::size_t before = plain.size();
    plain.resize(states, count);
    tested.resize(states, count);
    for (std::size_t i = before; i < count; ++i) {
      const typename TangentsSideBySide<N>::State z = Eigen::VectorXd::Random(states);
      plain.set(i, z);
      tested.set(i, z);
    }
  }
  template <class Act>
  void each(const Act& act) {
    act(plain);
    act(tested);
  }
  void expect_same(const char* where) const {
    ASSERT_EQ(tested.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
      EXPECT_EQ(tested.get(i), plain.get(i)) << where << ' ' << i;
  }

  TangentsOneByOne<N> plain;
  TangentsSideBySide<N> tested;
};

template <int N>
void expect_the_bits_of_those_one_by_one(std::size_t joint) {
  modes::MachineModes<N> plan(test::cell_of({}).scene);
  const modes::LinearMode<N>& mode = *plan.mode(joint);
  for (const std::size_t count : {1u, 4u, 8u, 13u}) {
    Both<N> both(count);
    both.each([&](auto& tangents) {
      if (mode.paired)
        tangents.move(mode.pair_steps[3]);
      else
        tangents.move(mode.steps.of(3));
    });
    both.expect_same("table");
    if (!mode.paired) {
      both.each([&](auto& tangents) { tangents.move_by_series(mode, 0.4 / mode.fastest_rad_per_s); });
      both.expect_same("series");
    }
    for (const std::size_t other : {0u, 1u, 2u, 3u}) {
      both.each([&](auto& tangents) { tangents.change(mode, *plan.mode(other)); });
      both.expect_same("change");
    }
    for (const auto& guard : mode.guards) {
      modes::ModalSums plain, tested;
      both.plain.see(guard.terms, mode.paired, 3, plain);
      both.tested.see(guard.terms, mode.paired, 3, tested);
      EXPECT_EQ(tested.value, plain.value);
      EXPECT_EQ(tested.rate, plain.rate);
      EXPECT_EQ(tested.curvature, plain.curvature);
    }
  }
}

class TangentsSideBySideOfMode : public testing::TestWithParam<std::size_t> {};

TEST_P(TangentsSideBySideOfMode, HaveTheBitsOfThoseOneByOne) {
  expect_the_bits_of_those_one_by_one<4>(GetParam());
  expect_the_bits_of_those_one_by_one<Eigen::Dynamic>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(OfOneStop, TangentsSideBySideOfMode, testing::Values(0, 1, 2, 3));

/// Vectors keep their values when memory must grow, and after all were removed.
TEST(TangentsSideBySide, StayWhenOthersJoin) {
  Both<4> both(3);
  for (const std::size_t count : {4u, 9u, 40u}) {
    both.resize(count);
    both.expect_same("joined");
  }
  both.each([](auto& tangents) { tangents.clear(); });
  both.resize(5);
  both.expect_same("anew");
}

/// Turns with and without tangent vectors alternate in a proof. Memory that doubles each time would not
/// suffice.
TEST(TangentsSideBySide, NeedNoMoreMemoryWhenTheyComeAndGo) {
  Both<4> both(8);
  for (int i = 0; i < 60; ++i) {
    both.resize(0);
    both.tested.resize(0, 0);
    both.resize(8);
    both.expect_same("again");
  }
}

}  // namespace
}  // namespace rubsweep::integrate::exact
