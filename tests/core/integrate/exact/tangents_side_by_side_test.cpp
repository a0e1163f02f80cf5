#include "rubsweep/core/integrate/exact/tangents_side_by_side.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/tangents_one_by_one.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

constexpr Eigen::Index states = 8;

/// Both implementations, on which the same operations are performed.
struct Both {
  explicit Both(std::size_t count) { resize(count); }
  void resize(std::size_t count) {
    const std::size_t before = plain.size();
    plain.resize(states, count);
    tested.resize(states, count);
    for (std::size_t i = before; i < count; ++i) {
      const TangentsSideBySide::State z = Eigen::VectorXd::Random(states);
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

  TangentsOneByOne<Eigen::Dynamic> plain;
  TangentsSideBySide tested;
};

class TangentsSideBySideOfMode : public testing::TestWithParam<std::size_t> {
 protected:
  modes::MachineModes<Eigen::Dynamic> plan_{test::cell_of({}).scene};
  const modes::LinearMode<Eigen::Dynamic>& mode_ = *plan_.mode(GetParam());
};

TEST_P(TangentsSideBySideOfMode, HaveTheBitsOfThoseOneByOne) {
  for (const std::size_t count : {1u, 4u, 8u, 13u}) {
    Both both(count);
    both.each([&](auto& tangents) {
      if (mode_.paired)
        tangents.move(mode_.pair_steps[3]);
      else
        tangents.move(mode_.steps.of(3));
    });
    both.expect_same("table");
    if (!mode_.paired) {
      both.each([&](auto& tangents) { tangents.move_by_series(mode_, 0.4 / mode_.fastest_rad_per_s); });
      both.expect_same("series");
    }
    for (const std::size_t other : {0u, 1u, 2u, 3u}) {
      both.each([&](auto& tangents) { tangents.change(mode_, *plan_.mode(other)); });
      both.expect_same("change");
    }
    for (const auto& guard : mode_.guards) {
      modes::ModalSums plain, tested;
      both.plain.see(guard.terms, mode_.paired, 3, plain);
      both.tested.see(guard.terms, mode_.paired, 3, tested);
      EXPECT_EQ(tested.value, plain.value);
      EXPECT_EQ(tested.rate, plain.rate);
      EXPECT_EQ(tested.curvature, plain.curvature);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfOneStop, TangentsSideBySideOfMode, testing::Values(0, 1, 2, 3));

/// Vectors keep their values when memory must grow, and after all were removed.
TEST(TangentsSideBySide, StayWhenOthersJoin) {
  Both both(3);
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
  Both both(8);
  for (int i = 0; i < 60; ++i) {
    both.resize(0);
    both.tested.resize(0, 0);
    both.resize(8);
    both.expect_same("again");
  }
}

}  // namespace
}  // namespace rubsweep::integrate::exact
