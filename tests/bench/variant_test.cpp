#include "bench/variant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::bench {
namespace {

constexpr std::array coarse_tolerances{1e-4, 1e-6};
const std::size_t stepper_count = integrate::adaptive::single_steppers().size();

std::size_t exact_ones(const std::vector<Variant>& variants) {
  return static_cast<std::size_t>(std::count_if(variants.begin(), variants.end(), [](const Variant& v) {
    return v.method == integrate::run::Method::exact;
  }));
}

TEST(Variants, ClosedFormsAreOneLine) {
  const auto variants =
      variants_of(test::cell_of({}).scene, {}, 6, integrate::adaptive::single_steppers(), coarse_tolerances);
  EXPECT_EQ(variants.size(), 1 + stepper_count * 2 * 2);
  EXPECT_EQ(exact_ones(variants), 1u);
  EXPECT_FALSE(variants.front().stepper);
  EXPECT_FALSE(variants.front().relative_tolerance);
}

TEST(Variants, SteppersInsideTheExactSolverHaveALineEachBehindTaylorPieces) {
  model::Machine machine = test::machine_of({});
  machine.stops[0].geometry = model::AnnularGeometry{};
  const auto cell = scene::build_cell(machine, 75, scene::WhirlRatio{0.5});
  const auto variants =
      variants_of(cell.scene, {}, 6, integrate::adaptive::single_steppers(), coarse_tolerances);
  EXPECT_EQ(variants.size(), 1 + stepper_count * 2 * 3);
  EXPECT_EQ(exact_ones(variants), 1 + stepper_count * 2);
  EXPECT_FALSE(variants.front().stepper);
  for (const Variant& v : variants) {
    EXPECT_TRUE(v.method == integrate::run::Method::adaptive ||
                v.contact == integrate::run::ContactHandling::located);
  }
}

TEST(Variants, SayWhatTheyChange) {
  integrate::run::SolverOptions base;
  base.relative_tolerance = 3e-5;
  base.stepper = integrate::run::Stepper::rosenbrock4;
  base.max_steps_per_revolution = 4711;
  const auto exact =
      options_of({integrate::run::Method::exact, {}, integrate::run::ContactHandling::located, {}}, base);
  EXPECT_EQ(exact.method, integrate::run::Method::exact);
  EXPECT_EQ(exact.relative_tolerance, 3e-5);
  EXPECT_EQ(exact.stepper, integrate::run::Stepper::automatic);
  const auto other = options_of({integrate::run::Method::adaptive, integrate::run::Stepper::rkf78,
                                 integrate::run::ContactHandling::smoothed, 1e-7},
                                base);
  EXPECT_EQ(other.stepper, integrate::run::Stepper::rkf78);
  EXPECT_EQ(other.contact, integrate::run::ContactHandling::smoothed);
  EXPECT_EQ(other.relative_tolerance, 1e-7);
  EXPECT_EQ(other.max_steps_per_revolution, 4711);
}

}  // namespace
}  // namespace rubsweep::bench
