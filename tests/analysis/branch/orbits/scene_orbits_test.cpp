#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"

#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "analysis/branch/orbits/full_rub.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::branch::orbits {
namespace {

constexpr double unbalance = 0.3;

/// Full annular rub without friction: ((1 + b - W^2) r - b)^2 + (2 zeta W r)^2 = (e W^2)^2 is a quadratic
/// equation for W^2 at each radius r. Returns its smaller or larger root W; empty where there is none.
std::optional<double> speed_at(double r, bool larger) {
  const double spring = (1 + stiffness) * r - stiffness;
  const double a = r * r - unbalance * unbalance, half_b = -r * spring + 2 * zeta * zeta * r * r,
               c = spring * spring;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return std::nullopt;
  return std::sqrt((-half_b + (larger ? 1 : -1) * std::sqrt(discriminant)) / a);
}

/// Largest multiplier over one turn on the circle of radius r, from hand-written linearised equations in the
/// frame that rotates with the shaft; small changes are radial and tangential.
double modulus_at(double r, double w) {
  Eigen::Matrix4d a;
  a << 0, 0, 1, 0,  //
      0, 0, 0, 1,   //
      -(1 - w * w + stiffness), 2 * zeta * w, -2 * zeta, 2 * w, -2 * zeta * w,
      -(1 - w * w + stiffness * (1 - 1 / r)), -2 * w, -2 * zeta;
  return std::exp(2 * std::numbers::pi / w * numerics::dense::eigenvalues(a).real().maxCoeff());
}

TEST(SceneOrbits, FullAnnularRubWithItsFoldAndItsStability) {
  integrate::exact::modes::ModeCache modes;
  OrbitProblem problem = scene_orbits(
      [](double speed) -> std::optional<scene::Scene> {
        return test::annular_scene(1, zeta, speed, unbalance, 0, stiffness, 0);
      },
      1, {}, modes);
  problem.low = 1;
  problem.high = 4;
  // The start is a circle in closed form.
  const double radius = 1.3, speed = speed_at(radius, false).value();
  const std::complex<double> needed((1 + stiffness - speed * speed) * radius - stiffness,
                                    2 * zeta * speed * radius);
  scene::Scene scene = test::annular_scene(1, zeta, speed, unbalance, 0, stiffness, 0);
  const std::complex<double> z = radius * std::polar(1.0, -std::arg(needed));
  test::start_at(scene, z, std::complex<double>(0, speed) * z);
  const auto section = integrate::run::scaled_initial_state(scene);
  const auto start =
      continuation::orbit_from(problem, Eigen::Map<const Eigen::VectorXd>(section.data(), 4), speed);
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->facts.amplitude_m, radius, 1e-9);
  const continuation::Branch branch = continuation::follow_both_ways(problem, *start, {});

  // Checks along the whole branch.
  double largest_radius = 0;
  for (const continuation::BranchPoint& point : branch.points) {
    if (!point.facts.touched) continue;
    const double r = point.facts.amplitude_m;
    largest_radius = std::max(largest_radius, r);
    const double slow = speed_at(r, false).value_or(0), fast = speed_at(r, true).value_or(0);
    EXPECT_LT(std::min(std::abs(point.parameter - slow), std::abs(point.parameter - fast)), 1e-7) << r;
    EXPECT_NEAR(std::abs(point.multipliers(0)), modulus_at(r, point.parameter), 1e-6) << r;
  }

  // The fold is at the extremum, over the radius, of the larger or the smaller root.
  const auto [turn, negative] = boost::math::tools::brent_find_minima(
      [](double r) { return -speed_at(r, true).value_or(0); }, 1.0001, largest_radius, 50);
  int folds = 0;
  for (const continuation::BranchEvent& event : branch.events) {
    if (event.kind != continuation::EventKind::fold || event.point.facts.amplitude_m < 1.001) continue;
    ++folds;
    EXPECT_NEAR(event.point.parameter, -negative, 1e-9) << turn;
  }
  EXPECT_EQ(folds, 1);
}

/// The gyroscopic rotor in a frictionless elastic ring of Zilli, Battelino and Rosero and of Shaw, Champneys
/// and Friswell: z'' + (2 zeta - i J W) z' + z + beta (r - 1)(z / r) = m eps W^2 e^{i W t} for r > 1. Its
/// quiet circle begins to touch at W = 1.36128 above the resonance, according to AUTO and in closed form. It
/// touches all around, and the branch turns back in a corner there.
TEST(SceneOrbits, GyroscopicRotorInARingTurnsBackWhereItTouchesAllAlong) {
  constexpr double damping = 0.01, polar = 0.143, drive = 0.9 * 0.353, beta = 10;
  integrate::exact::modes::ModeCache modes;
  OrbitProblem problem = scene_orbits(
      [](double speed) -> std::optional<scene::Scene> {
        scene::Scene scene = test::annular_scene(1, damping, speed, drive, 0, beta, 0);
        scene.structure.damping(0, 1) = polar * speed;
        scene.structure.damping(1, 0) = -polar * speed;
        return scene;
      },
      1, {}, modes);
  problem.low = 1.2;
  problem.high = 3;
  const auto start = continuation::orbit_from(problem, Eigen::VectorXd::Zero(4), 2.5);
  ASSERT_TRUE(start);
  const continuation::HalfBranch half = continuation::follow(problem, turned_about(*start), {});
  const auto graze =
      std::ranges::find(half.events, continuation::EventKind::graze, &continuation::BranchEvent::kind);
  ASSERT_NE(graze, half.events.end());
  const double w = graze->point.parameter;
  EXPECT_NEAR(w, 1.36128, 5e-6);
  EXPECT_NEAR(std::hypot(1 - w * w * (1 - polar), 2 * damping * w), drive * w * w, 1e-12);
  EXPECT_LT(graze->parameter_error, 1e-11);
  bool quiet = true;
  for (const continuation::BranchPoint& point : half.points) {
    EXPECT_GE(point.parameter, w - 1e-12);
    EXPECT_EQ(point.facts.touched, point.arclength > graze->point.arclength);
    if (!point.facts.touched) continue;
    // Full annular rub satisfies ((1 + beta - W^2 (1 - J)) r - beta)^2 + (2 zeta W r)^2 = (m eps W^2)^2.
    const double r = point.facts.amplitude_m, at = point.parameter;
    EXPECT_NEAR(std::hypot((1 + beta - at * at * (1 - polar)) * r - beta, 2 * damping * at * r),
                drive * at * at, 1e-8);
    quiet = false;
  }
  EXPECT_FALSE(quiet);
}

TEST(SceneOrbits, ImpulsesThatDifferFromTurnToTurnHaveNoOrbits) {
  integrate::exact::modes::ModeCache modes;
  const OrbitProblem problem = scene_orbits(
      [](double speed) -> std::optional<scene::Scene> {
        scene::Scene scene = test::annular_scene(1, zeta, speed, unbalance, 0, stiffness, 0);
        scene.impulses.push_back({Eigen::Vector2d(0.1, 0), 0.37, 0});
        return scene;
      },
      1, {}, modes);
  EXPECT_THROW(continuation::orbit_from(problem, Eigen::VectorXd::Zero(4), 1.2), ConfigError);
}

/// A short stiff rotor on two equal films without cross stiffness, given by a table. Its quiet circle
/// satisfies m z'' + 2 c z' + 2 k z = m_d e w^2 e^{iwt}, and the derivative of its radius by the speed
/// contains k'(w) and c'(w).
TEST(SceneOrbits, SlopesOverTheSpeedGoThroughTheTableOfASupport) {
  using std::numbers::pi;
  constexpr double eccentricity_m = 1e-4, disc_kg = 0.8, mass_kg = disc_kg + pi / 4 * 0.2 * 0.2 * 0.4;
  model::Machine machine = scene::table_machine(2);
  model::RotorKit& kit = *model::kit_of(machine);
  kit.shaft[0].outer_diameter_m = 0.2;
  kit.shaft[0].density_kg_per_m3 = 1;
  kit.damping_ratio = {0};
  model::SupportTable table = scene::film_table();
  table.columns[3] = table.columns[0];
  table.columns[7] = table.columns[4];
  for (const std::size_t cross : {1U, 2U, 5U, 6U}) table.columns[cross].assign(5, 0);
  for (model::Support& support : kit.supports) support = model::with_table(support, table);
  const structure::SupportCurves curves = structure::curves_of(table);
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const auto scene_at = [&](double hz) {
    return scene::build_cell(prepared, hz, scene::Eccentricity{eccentricity_m}).scene;
  };
  integrate::exact::modes::ModeCache modes;
  OrbitProblem problem =
      scene_orbits([&](double hz) -> std::optional<scene::Scene> { return scene_at(hz); }, 1, {}, modes);
  problem.low = 20;
  problem.high = 120;
  problem.parameter_scale = 100;
  for (const double hz : {27.3, 33.0, 66.6, 101.0}) {
    const scene::Scene scene = scene_at(hz);
    const auto section = integrate::run::scaled_initial_state(scene);
    const auto n = static_cast<Eigen::Index>(section.size());
    const auto point =
        continuation::orbit_from(problem, Eigen::Map<const Eigen::VectorXd>(section.data(), n), hz);
    ASSERT_TRUE(point) << hz;
    const double w = 2 * pi * hz, k = curves[0](hz), c = curves[4](hz);
    const std::complex<double> i(0, 1), stiff = 2 * k - mass_kg * w * w + 2.0 * i * c * w;
    const std::complex<double> stiff_slope =
        2 * curves[0].slope(hz) - 4 * pi * mass_kg * w + 2.0 * i * (curves[4].slope(hz) * w + 2 * pi * c);
    const double radius_m = disc_kg * eccentricity_m * w * w / std::abs(stiff);
    const double slope_m_per_hz = radius_m * (4 * pi / w - (stiff_slope / stiff).real());
    EXPECT_NEAR(point->facts.amplitude_m, radius_m, 2e-4 * radius_m) << hz;
    // At t = 0 the rotor is closest to the wall, vertically above the centre: its height is the radius.
    const Eigen::RowVectorXd height =
        scene.length_scale_m *
        scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map.row(1);
    const double found = height.dot(point->tangent.head(n / 2).transpose()) *
                         std::sqrt(static_cast<double>(n)) / (point->tangent(n) * problem.parameter_scale);
    EXPECT_NEAR(found, slope_m_per_hz, 1e-3 * std::abs(slope_m_per_hz)) << hz;
  }
}

/// Largest distance from the mean position, and the largest multiplier, of a rub.
struct Rub {
  double amplitude_m = 0, modulus = 0;
};

/// Rub of the family at a speed, found from the motion on which the cell settles.
Rub rub_at(const std::function<scene::Cell(double)>& cell_at, double hz) {
  response::motion::Workspace workspace;
  const SettledStart settled = settle_on_orbit(cell_at(hz), {}, {}, workspace);
  if (!settled.order) return {};
  OrbitProblem problem =
      scene_orbits([&](double at) -> std::optional<scene::Scene> { return cell_at(at).scene; },
                   *settled.order, {}, workspace.modes);
  problem.low = hz - 1;
  problem.high = hz + 1;
  const auto point = continuation::orbit_from(problem, settled.state, hz);
  if (!point || !point->facts.touched) return {};
  return {point->facts.amplitude_m, std::abs(point->multipliers(0))};
}

/// Rubs of one and two turns at speeds in a table and between them, once in coordinates common to all speeds,
/// once with constant supports and the coordinates of each speed.
TEST(SceneOrbits, RubsFollowTheTableOfASupport) {
  model::Machine machine = scene::table_machine(6);
  model::kit_of(machine)->damping_ratio = {0};
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  for (const auto& place :
       {scene::Place{55, scene::Eccentricity{1.26e-3}}, scene::Place{57.5, scene::Eccentricity{1.26e-3}},
        scene::Place{80, scene::Eccentricity{1.526e-3}}}) {
    const double hz = place.speed_hz;
    const Rub followed =
        rub_at([&](double at) { return scene::build_cell(prepared, at, place.unbalance); }, hz);
    const Rub typed_in =
        rub_at([&](double at) { return scene::build_cell(machine, at, place.unbalance); }, hz);
    ASSERT_GT(typed_in.amplitude_m, 0) << hz;
    EXPECT_NEAR(followed.amplitude_m, typed_in.amplitude_m, 1e-3 * typed_in.amplitude_m) << hz;
    EXPECT_NEAR(followed.modulus, typed_in.modulus, 0.02 * typed_in.modulus) << hz;
  }
}

/// Full annular rub with a static load has no rotational symmetry: it repeats after a turn of the shaft, but
/// not in the rotating frame.
TEST(SceneOrbitsClosedOrbits, EachInItsFrame) {
  const SceneFamily family = [](double load) -> std::optional<scene::Scene> {
    scene::Scene scene = test::FullRub{}.scene();
    scene.constant_n(0) = load;
    return scene;
  };
  integrate::exact::modes::ModeCache modes;
  const Eigen::VectorXd section = Eigen::VectorXd::Constant(4, 0.1);
  for (const double load : {0.0, 0.01}) {
    Eigen::VectorXd state = section;
    const OrbitProblem turns = closed_orbits(Closing::with_the_shaft, family, 2, {}, modes);
    EXPECT_EQ(turns.returns(load, state, nullptr), Evaluation::ok);
    EXPECT_EQ(state.size(), 4);
    EXPECT_EQ(turns.order, 2);
    EXPECT_TRUE(turns.half_returns);
  }
  Eigen::VectorXd state(5);
  state << section, 1;
  const OrbitProblem loops = closed_orbits(Closing::in_the_turning_frame, family, 1, {}, modes);
  EXPECT_EQ(loops.returns(0.01, state, nullptr), Evaluation::infeasible);
  EXPECT_NE(loops.returns(0, state, nullptr), Evaluation::infeasible);
  EXPECT_EQ(loops.order, 1);
}

}  // namespace

}  // namespace rubsweep::branch::orbits
