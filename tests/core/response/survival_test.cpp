#include "rubsweep/core/response/survival.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/response/followed.hpp"

namespace rubsweep::response {
namespace {

TEST(Survival, ItsBoundIsThatOfThePoissonLaw) {
  // Without an escape exp(-turns / life) = 0.05; with one escape (1 + m) exp(-m) = 0.05 at m = 4.7439.
  EXPECT_NEAR((Survival{.turns = 1000, .escapes = 0}.least_mean_life()), 1000 / std::log(20.0), 1e-9);
  const double mean = 1000 / Survival{.turns = 1000, .escapes = 1}.least_mean_life();
  EXPECT_NEAR((1 + mean) * std::exp(-mean), 0.05, 1e-9);
  EXPECT_EQ((Survival{}.least_mean_life()), 0);
}

/// The tent map of slope s > 2: a uniform density on [0, 1] stays uniform, and the share 1 - 2 / s of it
/// escapes every turn. The mean life is therefore s / (s - 2) turns. States that escaped continue without
/// contact.
class Tent {
 public:
  explicit Tent(double slope) : slope_(slope) {}

  bool operator()(std::span<double> s) {
    inside_ = s[0] >= 0 && s[0] <= 1;
    if (inside_) s[0] = slope_ * std::min(s[0], 1 - s[0]);
    // The small term replaces the binary digits that the map would lose.
    if (inside_) s[0] += 1e-13 * std::sin(1e6 * s[0]);
    return true;
  }
  bool touched() const { return inside_; }

 private:
  double slope_;
  bool inside_ = false;
};

/// Chaotic motion from `start`; empty where it escapes.
Followed chaos_from(double start, double slope, int turns) {
  Tent tent(slope);
  Followed motion{.states = 1, .rows = {}, .contributions = {}};
  double x = start;
  for (int k = 0; k < turns; ++k) {
    tent(std::span(&x, 1));
    if (x < 0 || x > 1) return {.states = 1, .rows = {}, .contributions = {}};
    motion.add(std::span(&x, 1), std::log(slope), true);
  }
  return motion;
}

TEST(SurvivalSurvive, CountsTheEscapesOfTheTentMapAtItsRate) {
  for (const double slope : {2.004, 2.02, 2.1}) {
    const double life = slope / (slope - 2);
    double turns = 0;
    int escapes = 0, trials = 0, below = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const Followed motion = chaos_from(0.1 + 0.7 * trial / 400, slope, 10);
      if (motion.turns() == 0) continue;
      Tent tent(slope);
      const Survival seen =
          survive([&tent](std::span<double> s) { return tent(s); }, [&tent] { return tent.touched(); },
                  motion, {.companions = 8, .turns = 400, .window = 16, .max_order = 4});
      turns += seen.turns;
      escapes += seen.escapes;
      ++trials;
      below += seen.least_mean_life() <= life;
    }
    ASSERT_GT(escapes, 50) << slope;
    EXPECT_NEAR(turns / escapes / life, 1, 4 / std::sqrt(escapes)) << slope;
    // The bound holds in at least 95 % of the trials; in more, because companions share part of their path.
    EXPECT_GT(below, 0.92 * trials) << slope;
  }
}

TEST(SurvivalSurvive, ChaosThatIsAnAttractorHasNoEscape) {
  const auto logistic = [](std::span<double> s) {
    s[0] = 4 * s[0] * (1 - s[0]);
    s[0] = std::clamp(s[0], 1e-9, 1 - 1e-9);
    return true;
  };
  Followed motion{.states = 1, .rows = {}, .contributions = {}};
  double x = 0.3;
  for (int k = 0; k < 500; ++k) {
    logistic(std::span(&x, 1));
    motion.add(std::span(&x, 1), std::log(2.0), true);
  }
  const Survival seen = survive(logistic, [] { return true; }, motion, {});
  EXPECT_EQ(seen.escapes, 0);
  EXPECT_EQ(seen.turns, 500 - 64 + 2 * (320 - 64));
}

/// Beyond the interior crisis, chaos of the logistic map falls into the window of period three.
TEST(SurvivalSurvive, APeriodIsAnEscapeToo) {
  const auto logistic = [](std::span<double> s) {
    s[0] = 3.8325 * s[0] * (1 - s[0]);
    return true;
  };
  Followed motion{.states = 1, .rows = {}, .contributions = {}};
  double x = 0.3;
  for (int k = 0; k < 20; ++k) {
    logistic(std::span(&x, 1));
    motion.add(std::span(&x, 1), 0.3, true);
  }
  const Survival seen = survive(logistic, [] { return true; }, motion, {.companions = 4, .turns = 2000});
  EXPECT_EQ(seen.escapes, 4);
  EXPECT_LT(seen.turns, 4 * 2000);
}

TEST(SurvivalSurvive, AFailedTurnIsNoEscape) {
  Followed motion{.states = 1, .rows = {}, .contributions = {}};
  const double x = 0.3;
  for (int k = 0; k < 100; ++k) motion.add(std::span(&x, 1), 0.3, true);
  const Survival seen = survive([](std::span<double>) { return false; }, [] { return true; }, motion, {});
  EXPECT_EQ(seen.escapes, 0);
  EXPECT_EQ(seen.turns, 36);
}

}  // namespace
}  // namespace rubsweep::response
