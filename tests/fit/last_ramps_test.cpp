#include "rubsweep/fit/last_ramps.hpp"

#include <gtest/gtest.h>

namespace rubsweep::fit {
namespace {

TEST(LastRamps, AreMadeOnceForAllEccentricitiesAndMarks) {
  MachineFit problem;
  problem.parameters = {{.name = "rotor.damping_ratio"}, {.name = eccentricity_name}, {.name = mark_name}};
  problem.data.resize(1);
  LastRamps ramps(problem);
  const RunUp run;
  int made = 0;
  const auto ask = [&](double damping_ratio, double eccentricity_m, double mark_deg) {
    ramps.of(problem, run, Eigen::Vector3d(damping_ratio, eccentricity_m, mark_deg), [&] {
      ++made;
      return RampParts{};
    });
  };
  ask(0.02, 1e-5, 10);
  ask(0.02, 2e-5, 70);
  EXPECT_EQ(made, 1);
  ask(0.03, 1e-5, 10);
  EXPECT_EQ(made, 2);
  ask(0.02, 5e-5, 0);
  EXPECT_EQ(made, 2);
  const RunUp other;
  ramps.of(problem, other, Eigen::Vector3d(0.02, 1e-5, 10), [&] {
    ++made;
    return RampParts{};
  });
  EXPECT_EQ(made, 3);
}

}  // namespace
}  // namespace rubsweep::fit
