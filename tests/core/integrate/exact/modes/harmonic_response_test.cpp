#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"

#include <gtest/gtest.h>

#include <array>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using Complex = std::complex<double>;
using State = ExactTypes<4>::State;

struct OpenMode {
  MachineModes<4> plan{test::cell_of({}).scene};
  const LinearMode<4>& mode = *plan.mode(0);
  Eigen::VectorXcd force = (Eigen::VectorXcd(4) << Complex(3, 1), Complex(1, -3), 0.2, 0).finished();
  double rate = 500;
};

State forced(const HarmonicResponse<4>& response, double time_s) {
  State state = State::Zero();
  response.add_to(state, std::polar(1.0, response.rate * time_s));
  return state;
}

/// Central differences of the forced motion satisfy the equation of motion.
TEST(HarmonicResponse, ForcedMotionSolvesTheEquation) {
  OpenMode open;
  HarmonicResponse<4> response;
  ASSERT_TRUE(make_harmonic_response(open.mode, open.force, open.rate, response));
  constexpr double h = 1e-7;
  for (const double t : {0.0, 0.004, 0.013}) {
    const State rate = (forced(response, t + h) - forced(response, t - h)) / (2 * h);
    State expected = open.mode.generator * forced(response, t);
    expected.tail<4>() += (open.force * std::polar(1.0, open.rate * t)).real();
    EXPECT_LT((rate - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff()) << t;
  }
}

TEST(HarmonicResponse, TermsSumToItsPartOfTheGuard) {
  OpenMode open;
  HarmonicResponse<4> response;
  ASSERT_TRUE(make_harmonic_response(open.mode, open.force, open.rate, response));
  const double duration_s = 1e-3, start_s = 0.002;
  std::array<double, numerics::series_rows> terms{};
  response.expand(0, std::polar(1.0, response.rate * start_s), terms);
  numerics::scale_terms(duration_s * open.mode.fastest_rad_per_s, terms);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    double sum = 0;
    for (std::size_t k = terms.size(); k-- > 0;) sum = sum * fraction + terms[k];
    const double expected = open.mode.guards[0].physical * forced(response, start_s + fraction * duration_s);
    EXPECT_NEAR(sum, expected, 1e-13 * std::abs(response.at_guard[0])) << fraction;
  }
}

TEST(HarmonicResponse, TurnsByTheStepsOfTheTable) {
  OpenMode open;
  HarmonicResponse<4> response;
  ASSERT_TRUE(make_harmonic_response(open.mode, open.force, open.rate, response));
  for (const int k : {0, 3, 20, numerics::exact_step_count - 1}) {
    const double step = open.mode.longest_step_s * numerics::exact_step_size(k);
    for (int asked = 0; asked < 2; ++asked)
      EXPECT_EQ(response.turned_by(static_cast<std::size_t>(k), open.mode.longest_step_s),
                std::polar(1.0, open.rate * step));
  }
}

TEST(HarmonicResponse, AResonanceThatNothingDampsIsRefused) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0;
  MachineModes<4> plan{test::cell_of(rotor).scene};
  const OpenMode open;
  HarmonicResponse<4> response;
  const double resonance = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  EXPECT_FALSE(make_harmonic_response(*plan.mode(0), open.force, resonance, response));
  HarmonicResponse<4> beside;
  EXPECT_TRUE(make_harmonic_response(*plan.mode(0), open.force, 1.01 * resonance, beside));
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
