// Series of a regular time, over the instants at which a contact by a power of the penetration begins and
// ends: closed forms of Hertz' impact, and the order of the error.
#include "rubsweep/core/integrate/taylor/regular_expansion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/taylor/series_options.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using std::numbers::pi;

/// A mass of 2 kg that touches a wall of 1e4 N/m^1.5 at one clearance per radian, a millimetre in a second.
struct Impact {
  explicit Impact(scene::Scene made = touching())
      : scene(std::move(made)),
        system(run::scale<2>(scene)),
        law(system, 0),
        pulses(scene, system.scale, 2 * pi) {
    law.follow(pulses);
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      law.modes()[i] = contact::Mode::sprung;
      law.begin_impact(i, 1);
    }
  }

  static scene::Scene touching() {
    scene::Scene scene = test::one_mass_scene(2, 0, 0, 2 * pi, 1e-3);
    scene.contacts.push_back(test::wall_across_x(1, 1e-3, 1, 0));
    test_curved::give_law(test_curved::power_stop(1e4, 1.5), scene.contacts[0]);
    return scene;
  }

  /// Expands from `state`, with the rate there.
  bool expand(RegularExpansion<2>& motion, const std::vector<double>& state) {
    std::vector<double> rate(4);
    law(state, rate, 0);
    return motion.expand(state, rate, 0, law);
  }

  scene::Scene scene;
  run::ScaledSystem<2> system;
  law::Dynamics<2, false> law;
  run::PulseTimes pulses;
  const std::vector<double> start{1, 0, 1, 0};
};

TEST(RegularExpansion, CarriesAContactFromItsBeginningToItsEnd) {
  Impact impact;
  RegularExpansion<2> motion(impact.system, rounding_of_series);
  std::vector<double> state = impact.start;
  double duration = 0, deepest = 0;
  int pieces = 0;
  for (bool over = false; !over; ++pieces) {
    ASSERT_LT(pieces, 20);
    ASSERT_TRUE(impact.expand(motion, state));
    double end = motion.converged();
    RegularExpansion<2>::Event event;
    ASSERT_TRUE(motion.find_event(end, event));
    const double speed = state[2];
    motion.put_state(end, state.data());
    if (speed > 0 && state[2] <= 0) {
      double low = 0, high = end;
      std::vector<double> inside(4);
      for (int k = 0; k < 100; ++k) {
        motion.put_state((low + high) / 2, inside.data());
        (inside[2] > 0 ? low : high) = (low + high) / 2;
      }
      deepest = inside[0] - 1;
    }
    duration += motion.time().phase_after(end);
    over = event.contact.has_value();
    if (over) {
      EXPECT_EQ(event.next, contact::Mode::open);
    }
  }
  const double stiffness = 1e4, m = 2, v = 1e-3, peak_m = std::pow(5 * m * v * v / (4 * stiffness), 0.4);
  const double constant = 2 * std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9);
  EXPECT_NEAR(constant, 2.9432, 1e-4);
  EXPECT_NEAR(deepest * 1e-3 / peak_m, 1, 1e-12);
  EXPECT_NEAR(duration / (constant * peak_m / v), 1, 1e-12);
  EXPECT_NEAR(state[0], 1, 1e-14);
  EXPECT_NEAR(state[2], -1, 1e-13);
}

/// The error of a polynomial of order 24 grows with the power 25 of its time.
TEST(RegularExpansion, IsOfOrderTwentyFourWhereTheContactBegins) {
  Impact impact;
  RegularExpansion<2> motion(impact.system, rounding_of_series), piece(impact.system, rounding_of_series);
  ASSERT_TRUE(impact.expand(motion, impact.start));
  const double converged = motion.converged();
  const auto error_at = [&](double s) {
    std::vector<double> state = impact.start, coarse(4);
    motion.put_state(s, coarse.data());
    for (double left = motion.time().phase_after(s); left > 0;) {
      EXPECT_TRUE(impact.expand(piece, state));
      double end = piece.converged() / 2;
      if (piece.time().phase_after(end) > left) end = piece.time().parameter_at(left, end);
      piece.put_state(end, state.data());
      left = piece.time().phase_after(end) < left ? left - piece.time().phase_after(end) : 0;
    }
    return std::abs(coarse[2] - state[2]);
  };
  const double far = error_at(2.6 * converged), near = error_at(2.2 * converged);
  EXPECT_GT(near, 1e-13);
  EXPECT_NEAR(std::log(far / near) / std::log(2.6 / 2.2), 25, 3);
}

TEST(RegularExpansion, LeavesOutWhatHasNoSeries) {
  Impact impact;
  RegularExpansion<2> motion(impact.system, rounding_of_series);
  EXPECT_FALSE(impact.expand(motion, {1, 0, 0, 0}));
  test_curved::give_law(test_curved::power_stop(1e4, 1.3), impact.scene.contacts[0]);
  impact.system.contacts[0].law = impact.scene.contacts[0].law;
  RegularExpansion<2> other(impact.system, rounding_of_series);
  EXPECT_FALSE(impact.expand(other, impact.start));
}

TEST(RegularExpansion, InvertsItsTime) {
  Impact impact;
  RegularExpansion<2> motion(impact.system, rounding_of_series);
  ASSERT_TRUE(impact.expand(motion, impact.start));
  const double end = motion.converged();
  for (const double share : {1e-9, 1e-3, 0.5, 0.999})
    EXPECT_NEAR(motion.time().parameter_at(motion.time().phase_after(share * end), end), share * end,
                1e-14 * end);
  EXPECT_EQ(motion.time().parameter_at(0, end), 0);
}

/// A second wall, already pressed. Where 2 n is no integer, the recurrence of its force holds by the phase,
/// not by the time of the contact that begins.
TEST(RegularExpansion, HasNoBeginningBesideAContactWhoseSeriesAreOfThePhase) {
  for (const double exponent : {1.3, 2.0}) {
    scene::Scene scene = Impact::touching();
    scene.contacts.push_back(test::wall_across_x(1, 0.9e-3, 1, 0));
    test_curved::give_law(test_curved::power_stop(1e4, exponent), scene.contacts[1]);
    Impact impact(scene);
    RegularExpansion<2> motion(impact.system, rounding_of_series);
    EXPECT_EQ(impact.expand(motion, impact.start), exponent == 2) << exponent;
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
