#include "rubsweep/integrate/drive.hpp"

#include <gtest/gtest.h>

#include <array>

#include "rubsweep/integrate/exact_plan.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;
using State = ExactTypes<4>::State;

struct OpenMode {
  ExactPlan<4> plan{test::cell_of({}).scene};
  const ModePlan<4>& mode = *plan.mode(0);
  Eigen::VectorXcd force = (Eigen::VectorXcd(4) << Complex(3, 1), Complex(1, -3), 0.2, 0).finished();
  double rate = 500;
};

State forced(const Drive<4>& drive, double time_s) {
  State state = State::Zero();
  drive.add_to(state, std::polar(1.0, drive.rate * time_s));
  return state;
}

/// Central differences of the forced motion obey the equation of motion.
TEST(Drive, ForcedMotionSolvesTheEquation) {
  OpenMode open;
  Drive<4> drive;
  ASSERT_TRUE(make_drive(open.mode, open.force, open.rate, drive));
  constexpr double h = 1e-7;
  for (const double t : {0.0, 0.004, 0.013}) {
    const State rate = (forced(drive, t + h) - forced(drive, t - h)) / (2 * h);
    State expected = open.mode.generator * forced(drive, t);
    expected.tail<4>() += (open.force * std::polar(1.0, open.rate * t)).real();
    EXPECT_LT((rate - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff()) << t;
  }
}

TEST(Drive, TermsSumToItsPartOfTheExit) {
  OpenMode open;
  Drive<4> drive;
  ASSERT_TRUE(make_drive(open.mode, open.force, open.rate, drive));
  const double duration_s = 1e-3, start_s = 0.002;
  std::array<double, series_rows> terms{};
  drive.expand(0, std::polar(1.0, drive.rate * start_s), terms);
  scale_terms(duration_s * open.mode.fastest_rad_per_s, terms);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    double sum = 0;
    for (std::size_t k = terms.size(); k-- > 0;) sum = sum * fraction + terms[k];
    const double expected = open.mode.exits[0].physical * forced(drive, start_s + fraction * duration_s);
    EXPECT_NEAR(sum, expected, 1e-13 * std::abs(drive.at_exit[0])) << fraction;
  }
}

TEST(Drive, TurnsByTheStepsOfTheTable) {
  OpenMode open;
  Drive<4> drive;
  ASSERT_TRUE(make_drive(open.mode, open.force, open.rate, drive));
  for (const int k : {0, 3, 20, exact_step_count - 1}) {
    const double step = open.mode.longest_step_s * exact_step_size(k);
    for (int asked = 0; asked < 2; ++asked)
      EXPECT_EQ(drive.turned_by(static_cast<std::size_t>(k), open.mode.longest_step_s),
                std::polar(1.0, open.rate * step));
  }
}

TEST(Drive, AResonanceThatNothingDampsIsRefused) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0;
  ExactPlan<4> plan{test::cell_of(rotor).scene};
  const OpenMode open;
  Drive<4> drive;
  const double resonance = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  EXPECT_FALSE(make_drive(*plan.mode(0), open.force, resonance, drive));
  Drive<4> beside;
  EXPECT_TRUE(make_drive(*plan.mode(0), open.force, 1.01 * resonance, beside));
}

}  // namespace
}  // namespace rubsweep::integrate
