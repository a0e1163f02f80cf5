#include "rubsweep/core/response/rotating/apex_return_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>

#include "rubsweep/core/numerics/full_turn.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::response::rotating {
namespace {

using Complex = std::complex<double>;
constexpr int samples = 128;

/// Turn `k` of the motion z = w(phase) e^{i phase} of one mass.
integrate::run::TurnReport turn_of(const std::function<Complex(double)>& w, int k, bool touched = true) {
  integrate::run::TurnReport turn;
  turn.sample_count = samples;
  turn.touched = touched;
  const auto z = [&](double phase) { return w(phase) * std::polar(1.0, phase); };
  for (int j = 0; j < samples; ++j) {
    const double phase = numerics::full_turn * (k + static_cast<double>(j) / samples);
    const Complex place = z(phase), velocity = (z(phase + 1e-5) - z(phase - 1e-5)) / 2e-5;
    turn.samples.insert(turn.samples.end(), {place.real(), place.imag(), velocity.real(), velocity.imag()});
  }
  return turn;
}

std::optional<ApexReturnSearch::Return> search_for(const std::function<Complex(double)>& w, int turns,
                                                   bool touched = true) {
  ApexReturnSearch search(test::one_mass_scene(1, 1, 0, 1, 1));
  for (int k = 0; k < turns; ++k) search.add(turn_of(w, k, touched));
  return search.candidate();
}

/// A motion that approaches an oval about the point 1, with lines at multiples of `spacing`. `alternation`:
/// amplitude at half of this spacing.
std::function<Complex(double)> oval(double spacing, double alternation = 0) {
  return [=](double phase) {
    return Complex(1 + (0.2 + 0.02 * std::exp(-0.02 * phase)) * std::cos(spacing * phase) +
                       alternation * std::cos(spacing * phase / 2),
                   0.1 * std::sin(spacing * phase));
  };
}

TEST(ApexReturnSearch, NamesTheTimeBetweenMaximaThatReturn) {
  const auto found = search_for(oval(0.61), 10);  // one maximum every 1.64 turns
  ASSERT_TRUE(found);
  EXPECT_EQ(found->maxima, 1);
  ASSERT_EQ(found->periods_rad.size(), 1u);
  EXPECT_NEAR(found->periods_rad[0], numerics::full_turn / 0.61, 5e-3);
}

TEST(ApexReturnSearch, OffersTheHalfOfAReturnThatIsNearToo) {
  const auto found = search_for(oval(0.61, 0.02), 10);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->maxima, 2);
  ASSERT_EQ(found->periods_rad.size(), 2u);
  EXPECT_NEAR(found->periods_rad[0], numerics::full_turn / 0.61, 5e-3);
  EXPECT_NEAR(found->periods_rad[1], 2 * numerics::full_turn / 0.61, 5e-3);
}

TEST(ApexReturnSearch, FindsNothingWithoutAMaximumInTheLastTurnOrWithoutContact) {
  EXPECT_FALSE(search_for(oval(0.1), 35));  // one maximum every 10 turns, the last one in turn 30
  EXPECT_TRUE(search_for(oval(0.1), 31));
  EXPECT_FALSE(search_for(oval(0.61), 10, false));
}

TEST(ApexReturnSearch, FindsNothingThatDoesNotReturn) {
  EXPECT_FALSE(search_for(
      [](double phase) { return 1.0 + 0.2 * std::cos(0.61 * phase) * std::polar(1.0, 0.2113 * phase); }, 10));
}

TEST(ApexReturnSearch, DoesNotAskTwiceForWhatWasRefused) {
  ApexReturnSearch search(test::one_mass_scene(1, 1, 0, 1, 1));
  int asked = 0;
  for (int k = 0; k < 16; ++k) {
    search.add(turn_of(oval(0.61, 0.008), k));
    const auto found = search.candidate();
    if (!found) continue;
    ++asked;
    search.refuse(*found);
  }
  EXPECT_GE(asked, 1);
  EXPECT_LE(asked, 4);
}

}  // namespace
}  // namespace rubsweep::response::rotating
