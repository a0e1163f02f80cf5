// What event location is for: through contact a located stepper keeps the order it has in flight, while
// smoothing leaves an error of its own that no tolerance removes.
#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int turns = 6;

struct Point {
  double error = 0;      ///< of the section after 6 turns, largest component, scaled
  double rhs_calls = 0;  ///< per turn
};

Point measure(const run::SolverOptions& options) {
  const test::OneSideRotor rotor;  // 75 Hz, whirl ratio 0.4: the 1/2 motion, three hits in six turns
  static const auto reference = test::long_double_sections(rotor, turns);
  const run::Cursor advance = adaptive::start_adaptive(test::cell_of(rotor).scene, options);
  run::Turn turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(advance(turn), run::Outcome::ok);
  return {test::section_error(turn.section, reference[turns], rotor),
          static_cast<double>(turn.effort.rhs_calls) / turns};
}

Point located(run::Stepper stepper, double tolerance) {
  run::SolverOptions options;
  options.stepper = stepper;
  options.relative_tolerance = tolerance;
  return measure(options);
}

Point smoothed(double tolerance, double width_m) {
  run::SolverOptions options;
  options.contact = run::ContactHandling::smoothed;
  options.relative_tolerance = tolerance;
  options.smoothing_m = width_m;
  return measure(options);
}

/// Decades of error per decade of work: the order.
double order_between(const Point& loose, const Point& tight) {
  return std::log(loose.error / tight.error) / std::log(tight.rhs_calls / loose.rhs_calls);
}

TEST(ContactOrder, LocatedKeepsTheOrderOfTheStepper) {
  EXPECT_GT(order_between(located(run::Stepper::dopri5, 1e-7), located(run::Stepper::dopri5, 1e-11)), 4.7);
  EXPECT_GT(
      order_between(located(run::Stepper::cash_karp54, 1e-7), located(run::Stepper::cash_karp54, 1e-11)),
      4.7);
  EXPECT_GT(order_between(located(run::Stepper::rkf78, 1e-7), located(run::Stepper::rkf78, 1e-11)), 7.5);
  EXPECT_GT(order_between(located(run::Stepper::bulirsch_stoer, 1e-7),
                          located(run::Stepper::bulirsch_stoer, 1e-11)),
            7.5);
  EXPECT_GT(order_between(located(run::Stepper::rosenbrock4, 1e-6), located(run::Stepper::rosenbrock4, 1e-9)),
            3.6);
}

TEST(ContactOrder, SmoothedStopsAtItsOwnError) {
  const Point loose = smoothed(1e-10, 1e-7), tight = smoothed(1e-12, 1e-7);
  EXPECT_GT(tight.error, 1e-8);  // located reaches 1e-12 there
  EXPECT_NEAR(tight.error / loose.error, 1, 0.1);
  EXPECT_LT(located(run::Stepper::dopri5, 1e-12).error, 1e-3 * tight.error);
}

TEST(ContactOrder, SmoothingErrorGoesWithTheWidth) {
  const double ratio = smoothed(1e-12, 4e-7).error / smoothed(1e-12, 1e-7).error;
  EXPECT_GT(ratio, 3);   // at least with the width
  EXPECT_LT(ratio, 20);  // at best with its square
}

TEST(ContactOrder, LocatedNeedsFewerCallsThanThePlainStepper) {
  // Plain dopri5 without event location takes about 1450 calls a turn at 1e-6, for an error of some 1e-6.
  const Point point = located(run::Stepper::dopri5, 1e-6);
  EXPECT_LT(point.rhs_calls, 1450);
  EXPECT_LT(point.error, 4e-6);
}

}  // namespace
}  // namespace rubsweep::integrate
