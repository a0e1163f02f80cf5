#include "rubsweep/core/response/spectrum/orbit_shape.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/response/synthetic_motion.hpp"

namespace rubsweep::response::testing {
namespace {

struct Named {
  std::string orbit;
  std::string whirl;
  bool operator==(const Named&) const = default;
};

Named name(const std::vector<Line>& lines) {
  constexpr int turns = 12;
  const auto z = sample(lines, turns, 64);
  spectrum::SpectrumWorkspace workspace;
  const auto spectrum = spectrum::full_spectrum(z, turns, workspace);
  return {std::string(to_string(spectrum::orbit_kind(z, spectrum))),
          std::string(to_string(spectrum::whirl_kind(spectrum)))};
}

void PrintTo(const Named& named, std::ostream* out) { *out << named.orbit << ' ' << named.whirl; }

TEST(OrbitShape, CirclesOfEitherDirectionAboutAnyMean) {
  EXPECT_EQ(name({{1, 1, 0.3}}), (Named{"circle", "forward"}));
  EXPECT_EQ(name({{-1, 1, 0.3}}), (Named{"circle", "backward"}));
  EXPECT_EQ(name({{1, 1, 0.3}, {0, 1, Complex(5, -7)}}), (Named{"circle", "forward"}));
  EXPECT_EQ(name({{-3, 4, 0.3}}), (Named{"circle", "backward"}));
}

TEST(OrbitShape, CircleEndsWhereTheDistanceVariesByFivePercent) {
  // Forward 1, backward b: largest / smallest radius = (1 + b) / (1 - b) = 1.05 at b = 0.05 / 2.05.
  EXPECT_EQ(name({{1, 1, 1}, {-1, 1, 0.024}}).orbit, "circle");
  EXPECT_EQ(name({{1, 1, 1}, {-1, 1, 0.0245}}).orbit, "oval");
}

TEST(OrbitShape, EllipseOfAnyOrderIsOvalAndAStraightLineToo) {
  EXPECT_EQ(name({{1, 1, 1}, {-1, 1, Complex(0.2, 0.1)}}), (Named{"oval", "forward"}));
  EXPECT_EQ(name({{1, 2, 0.1}, {-1, 2, 1}}), (Named{"oval", "backward"}));
  EXPECT_EQ(name({{1, 1, 0.5}, {-1, 1, 0.5}}), (Named{"oval", "mixed"}));
  EXPECT_EQ(name({{1, 1, 0.5}, {-1, 1, 0.5}, {0, 1, 30}}), (Named{"oval", "mixed"}));
}

TEST(OrbitShape, OvalHoldsNinetyFivePercentOfTheEnergy) {
  // The ellipse has the energy 1.25. A third line of energy e leaves the share 1.25 / (1.25 + e): 95 % at e =
  // 0.0658 = 0.2565^2.
  EXPECT_EQ(name({{1, 1, 1}, {-1, 1, 0.5}, {2, 1, 0.256}}).orbit, "oval");
  EXPECT_EQ(name({{1, 1, 1}, {-1, 1, 0.5}, {2, 1, 0.257}}).orbit, "complex");
}

TEST(OrbitShape, TheTwoLargestLinesMustBePartners) {
  // 99.9 % of the energy is in +1X and -1X, but the second largest line is +2X.
  EXPECT_EQ(name({{1, 1, 1}, {2, 1, 0.03}, {-1, 1, 0.02}}), (Named{"complex", "forward"}));
  EXPECT_EQ(name({{1, 1, 1}, {1, 2, 0.9}}), (Named{"complex", "forward"}));
}

TEST(OrbitShape, WhirlNeedsEightyPercentOnOneSide) {
  // Energies of 1 forward and 0.25 backward: exactly 80 % forward.
  EXPECT_EQ(name({{1, 1, 1}, {-1, 2, 0.499}}).whirl, "forward");
  EXPECT_EQ(name({{1, 1, 1}, {-1, 2, 0.501}}).whirl, "mixed");
  EXPECT_EQ(name({{-1, 1, 1}, {1, 2, 0.501}}).whirl, "mixed");
  EXPECT_EQ(name({{-1, 1, 1}, {1, 2, 0.499}}).whirl, "backward");
}

TEST(OrbitShape, APointIsNoCircleAndHasNoDirection) {
  EXPECT_EQ(name({{0, 1, 0}}), (Named{"complex", "mixed"}));
}

}  // namespace
}  // namespace rubsweep::response::testing
