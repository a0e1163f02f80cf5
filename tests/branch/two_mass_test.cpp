#include "branch/two_mass.hpp"
#include <gtest/gtest.h>
#include <fmt/format.h>
namespace rubsweep::branch {
namespace {
TEST(TwoMass, Show) {
  integrate::exact::ModeCache modes;
  integrate::run::SolverOptions solver;
  auto problem = scene_orbits([](double w) -> std::optional<scene::Scene> { return test::two_mass_scene(w); }, 1, solver, modes);
  problem.low = 0.3; problem.high = 0.9; problem.parameter_scale = 1;
  auto start = orbit_from(problem, Eigen::VectorXd::Zero(4), 0.5);
  ASSERT_TRUE(start);
  FollowOptions options;
  auto half = follow(problem, *start, options);
  fmt::print("{} points, {}\n", half.points.size(), to_string(half.ending));
  for (auto& p : half.points) fmt::print("{:.6f} {:.5f} {} {:.3g} {} {:.4f} {:.1e}\n", p.parameter, p.arclength, p.unstable, std::abs(p.multipliers(0)), p.facts.hits, p.facts.amplitude_m, p.slope_difference);
  for (auto& e : half.events) fmt::print("{} {:.13f} +- {:.1e} {} U={} {}\n", to_string(e.kind), e.point.parameter, e.parameter_error, e.detail, e.point.unstable, e.point.facts.hits);
}
}
}
