// Series of a structure without contacts, in the phase and in a time of another pace, against closed forms.
#include "rubsweep/core/integrate/taylor/regular_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

/// A mass of 1 kg on springs of three times the angular frequency of rotation: u'' = -9 u.
template <int N>
void follows_a_cosine() {
  const double revolution_s = 0.1, rate = 3 * 2 * std::numbers::pi / revolution_s;
  const auto system = run::scale<N>(test::one_mass_scene(1, rate * rate, 0, revolution_s, 1e-3));
  const std::vector<double> start{1, 0.5, 0, 3};
  for (const double slope : {0.0, 0.5}) {
    RegularSeries<N> series(system);
    series.begin(start.data(), numerics::Twin{});
    numerics::Series pace;
    for (int k = 0; k < RegularSeries<N>::order; ++k) {
      pace.set(k, k == 0 ? 1 : k == 1 ? slope : 0);
      series.begin_rate(k);
      series.advance(k, slope == 0 ? nullptr : &pace);
    }
    for (const double s : {0.1, 0.4}) {
      const double angle = 3 * (s + slope * s * s / 2);
      std::vector<double> state(4);
      series.put_state(s, RegularSeries<N>::order, state.data());
      EXPECT_NEAR(state[0], std::cos(angle), 1e-14) << slope;
      EXPECT_NEAR(state[1], 0.5 * std::cos(angle) + std::sin(angle), 1e-14) << slope;
      EXPECT_NEAR(state[2], -3 * std::sin(angle), 1e-14) << slope;
      EXPECT_NEAR(state[3], 3 * std::cos(angle) - 1.5 * std::sin(angle), 1e-14) << slope;
    }
    EXPECT_EQ(series.size(0, 0), 1);
    EXPECT_EQ(series.size(1, 0), 3);
  }
}

TEST(RegularSeries, FollowsASpringInAnyTime) {
  follows_a_cosine<2>();
  follows_a_cosine<Eigen::Dynamic>();
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
