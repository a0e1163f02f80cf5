#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/kit_machine.hpp"
#include "core/structure/written_rotor.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr double gravity_m_per_s2 = 9.81;
constexpr run::Method both_methods[]{run::Method::exact, run::Method::adaptive};

model::Machine at_rest(model::Machine machine) {
  machine.kick.reset();
  machine.start = {.at_rest = true};
  machine.gravity_m_per_s2 = gravity_m_per_s2;
  return machine;
}

/// Displacement of the observed point after each turn.
std::vector<Eigen::Vector2d> places_m(const scene::Scene& scene, run::Method method, int turns) {
  run::SolverOptions options{.method = method, .relative_tolerance = 1e-12};
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, options, modes);
  const auto& observed = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  std::vector<Eigen::Vector2d> places;
  run::TurnReport report;
  for (int turn = 0; turn < turns; ++turn) {
    EXPECT_EQ(run.advance({}, report), run::Outcome::ok);
    places.emplace_back(observed * run::state_scale(scene).displacement_m(report.section));
  }
  return places;
}

/// A damped oscillator at rest, on which constant and rotating accelerations act from t = 0 on.
struct Oscillator {
  double rad_per_s, ratio;

  double after(double t_s, double constant, Complex turning, double w) const {
    const double decay = ratio * rad_per_s, own = rad_per_s * std::sqrt(1 - ratio * ratio);
    const Complex steady = turning / Complex(rad_per_s * rad_per_s - w * w, 2 * decay * w);
    const double mean = constant / (rad_per_s * rad_per_s);
    const double cosine = -mean - steady.real();
    const double sine = (decay * cosine + w * steady.imag()) / own;
    return mean + (steady * std::polar(1.0, w * t_s)).real() +
           std::exp(-decay * t_s) * (cosine * std::cos(own * t_s) + sine * std::sin(own * t_s));
  }
};

TEST(RestStart, OfALinearRotorIsItsClosedForm) {
  model::Machine machine = at_rest(scene::one_side_machine());
  machine.stops[0].clearance_m = 0.02;
  const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  const Oscillator oscillator{2 * pi * rotor.natural_frequency_hz, rotor.damping_ratio};
  constexpr double e_m = 1e-3, speed_hz = 23, w = 2 * pi * speed_hz;
  const scene::Scene scene = scene::build_cell(machine, speed_hz, scene::Eccentricity{e_m}).scene;
  for (const run::Method method : both_methods) {
    const auto found = places_m(scene, method, 30);
    const double scale_m = 5e-3, within = method == run::Method::exact ? 1e-12 : 1e-9;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double t_s = static_cast<double>(i + 1) / speed_hz;
      const Complex turning = e_m * w * w;
      EXPECT_NEAR(found[i].x(), oscillator.after(t_s, 0, turning, w), within * scale_m);
      EXPECT_NEAR(found[i].y(), oscillator.after(t_s, -gravity_m_per_s2, turning * Complex(0, -1), w),
                  within * scale_m);
    }
  }
}

/// One fixed step of the classical fourth-order Runge-Kutta method.
Eigen::Vector4d stepped(const auto& rate, Eigen::Vector4d state, double t, double h) {
  const Eigen::Vector4d a = rate(state, t), b = rate(state + h / 2 * a, t + h / 2),
                        c = rate(state + h / 2 * b, t + h / 2), d = rate(state + h * c, t + h);
  return state + h / 6 * (a + 2 * b + 2 * c + d);
}

TEST(RestStart, OfARotorThatFallsOnARingIsThatOfFixedSteps) {
  model::Machine machine = at_rest(scene::one_side_machine());
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 12, .damping_ratio = 0.05};
  model::Stop& stop = machine.stops[0];
  stop = {};
  stop.geometry = model::AnnularGeometry{};
  stop.clearance_m = 1.2e-3;
  stop.stiffness_n_per_m = 2e5;
  stop.contact_radius_m = 0.02;
  stop.damping = model::ExplicitDamping{0};
  constexpr double e_m = 2e-4, speed_hz = 20, w = 2 * pi * speed_hz, mass_kg = 0.8, own = 2 * pi * 12;
  const auto rate = [&](const Eigen::Vector4d& s, double t) {
    const Eigen::Vector2d q = s.head<2>(), v = s.tail<2>();
    Eigen::Vector2d a = e_m * w * w * Eigen::Vector2d(std::cos(w * t), std::sin(w * t)) -
                        Eigen::Vector2d(0, gravity_m_per_s2) - own * own * q - 2 * 0.05 * own * v;
    if (q.norm() > 1.2e-3) a -= 2e5 / mass_kg * (q.norm() - 1.2e-3) * q.normalized();
    return Eigen::Vector4d(v.x(), v.y(), a.x(), a.y());
  };
  const scene::Scene scene = scene::build_cell(machine, speed_hz, scene::Eccentricity{e_m}).scene;
  constexpr int turns = 8, steps = 100000;
  const auto exact = places_m(scene, run::Method::exact, turns),
             adaptive = places_m(scene, run::Method::adaptive, turns);
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  double furthest_m = 0;
  constexpr double h = 1 / (speed_hz * steps);
  for (int k = 0; k < turns * steps; ++k) {
    state = stepped(rate, state, k * h, h);
    furthest_m = std::max(furthest_m, state.head<2>().norm());
    if ((k + 1) % steps != 0) continue;
    const auto turn = static_cast<std::size_t>((k + 1) / steps - 1);
    EXPECT_LT((exact[turn] - state.head<2>()).norm(), 1e-9) << turn;
    EXPECT_LT((adaptive[turn] - state.head<2>()).norm(), 1e-9) << turn;
  }
  EXPECT_GT(furthest_m, 1.21e-3);
}

/// Matrix exponential exp(A t) by scaling and squaring of its series.
Eigen::MatrixXd exponential(const Eigen::MatrixXd& a, double t) {
  int squarings = 0;
  double h = t;
  for (; h * a.cwiseAbs().rowwise().sum().maxCoeff() > 0.25; h /= 2) ++squarings;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Identity(a.rows(), a.cols()), term = sum;
  for (int k = 1; k < 16; ++k) sum += term = (h / k) * a * term;
  for (; squarings > 0; --squarings) sum = Eigen::MatrixXd(sum * sum);
  return sum;
}

/// A kit with two discs and different, coupled planes; all modes are kept.
model::Machine coupled_kit() {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.shaft[0].density_kg_per_m3 = 7850;
  kit.elements = 2;
  kit.modes = 6;
  kit.supports[0].stiffness_y_n_per_m = 5e4;
  kit.supports[0].damping_x_ns_per_m = 30;
  kit.supports[1].stiffness_xy_n_per_m = 2e3, kit.supports[1].stiffness_yx_n_per_m = -1e3;
  kit.discs[0].polar_inertia_kg_m2 = 3e-4;
  kit.discs.push_back({.position_m = 0.4,
                       .mass_kg = 0.3,
                       .polar_inertia_kg_m2 = 1e-4,
                       .diametral_inertia_kg_m2 = 1e-4,
                       .eccentricity_ratio = 2,
                       .eccentricity_phase_deg = 70});
  machine.stops[0].clearance_m = 0.05;
  machine.stops[0].casing.reset();
  return at_rest(machine);
}

/// Position of a point of the shaft after each turn from rest, computed with full matrices that the tests
/// assemble.
std::vector<Eigen::Vector2d> written_places_m(const model::Machine& machine, double place_m, double speed_hz,
                                              double e_m, int turns) {
  const model::RotorKit& kit = *model::kit_of(machine);
  const structure::WrittenRotor full(kit, structure::assemble_beam_shaft(kit, {0.2}));
  const Eigen::Index n = full.mass().rows();
  const double w = 2 * pi * speed_hz, unit = 1000;  // displacements are scaled to have the size of velocities
  Eigen::VectorXcd unbalance = Eigen::VectorXcd::Zero(n);
  Eigen::VectorXd along_y = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 2; i < n; i += 4) along_y(i) = 1;
  for (const model::Disc& disc : kit.discs) {
    const Complex force = disc.mass_kg * disc.eccentricity_ratio * e_m * w * w *
                          std::polar(1.0, disc.eccentricity_phase_deg * pi / 180);
    unbalance(full.at(disc.position_m)) += force;
    unbalance(full.at(disc.position_m) + 2) -= Complex(0, 1) * force;
  }
  // The state is followed by cosine and sine of the shaft angle and by 1.
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n + 3, 2 * n + 3);
  const Eigen::MatrixXd inverse = full.mass().inverse();
  a.block(0, n, n, n).diagonal().setConstant(unit);
  a.block(n, 0, n, n) = -inverse * full.stiffness() / unit;
  a.block(n, n, n, n) = -inverse * (full.damping() + w * full.gyroscopic());
  a.block(n, 2 * n, n, 1) = inverse * unbalance.real();
  a.block(n, 2 * n + 1, n, 1) = -inverse * unbalance.imag();
  a.block(n, 2 * n + 2, n, 1) = -gravity_m_per_s2 * along_y;
  a(2 * n, 2 * n + 1) = -w, a(2 * n + 1, 2 * n) = w;
  Eigen::VectorXd state = Eigen::VectorXd::Zero(2 * n + 3);
  state(2 * n) = state(2 * n + 2) = 1;
  const Eigen::MatrixXd turn = exponential(a, 1 / speed_hz);
  std::vector<Eigen::Vector2d> places;
  for (int k = 0; k < turns; ++k) {
    state = turn * state;
    places.emplace_back(state(full.at(place_m)) / unit, state(full.at(place_m) + 2) / unit);
  }
  return places;
}

TEST(RestStart, OfAKitIsThatOfItsFullMatrices) {
  model::Machine machine = coupled_kit();
  constexpr double e_m = 3e-4, speed_hz = 17;
  constexpr int turns = 12;
  const auto truth = written_places_m(machine, 0.2, speed_hz, e_m, turns);
  ASSERT_GT(truth[0].norm(), 1e-4);
  for (const bool from_sag : {false, true}) {
    model::kit_of(machine)->clearances_from_sag = from_sag;
    const auto prepared = scene::prepare_machine(machine);
    const scene::Cell cell = scene::build_cell(prepared, speed_hz, scene::Eccentricity{e_m});
    // Displacements measured from the sag start above it.
    const auto& observed =
        cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
    const Eigen::Vector2d begin_m = observed * cell.scene.displacement_m;
    EXPECT_EQ(begin_m.y() > 1e-4, from_sag);
    for (const run::Method method : both_methods) {
      const auto found = places_m(cell.scene, method, turns);
      for (std::size_t i = 0; i < truth.size(); ++i)
        EXPECT_LT((found[i] - begin_m - truth[i]).norm(), 1e-9 * truth[0].norm()) << i;
    }
  }
}

/// Largest distance from the truth over the turns, as a share of the largest displacement.
double error_of(const model::Machine& machine, const std::vector<Eigen::Vector2d>& truth, double speed_hz,
                double e_m) {
  const scene::Cell cell = scene::build_cell(machine, speed_hz, scene::Eccentricity{e_m});
  const auto found = places_m(cell.scene, run::Method::exact, static_cast<int>(truth.size()));
  double error_m = 0, size_m = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    error_m = std::max(error_m, (found[i] - truth[i]).norm());
    size_m = std::max(size_m, truth[i].norm());
  }
  return error_m / size_m;
}

/// The probe stands away from the stop, whose attachment mode therefore does not answer for it.
TEST(RestStart, OfAReducedKitTendsToThatOfItsFullMatrices) {
  model::Machine machine = coupled_kit();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.elements = 8;
  kit.shaft[0].density_kg_per_m3 = 30000;
  kit.damping_ratio = kit.rotating_damping_ratio = {0.0};
  kit.supports[1].damping_y_ns_per_m = 20;
  kit.sensors = {{.position_m = 0.3, .angle_deg = 0}};
  constexpr double e_m = 3e-4, speed_hz = 31;
  const auto truth = written_places_m(machine, 0.3, speed_hz, e_m, 20);
  double before = 1;
  for (const int modes : {1, 2, 4, 6}) {
    kit.modes = modes;
    const double error = error_of(machine, truth, speed_hz, e_m);
    EXPECT_LT(error, before) << modes;
    before = error;
  }
  EXPECT_LT(before, 2e-4);
  kit.modes.reset();
  EXPECT_LT(error_of(machine, truth, speed_hz, e_m), 1e-3);
}

/// Without damping the resonance has no quiet motion, but a run from rest does not need one: the whirl grows
/// by pi times the eccentricity in each turn, a quarter turn behind the mark.
TEST(RestStart, AtAnUndampedResonanceGrowsTurnByTurn) {
  model::Machine machine = at_rest(scene::one_side_machine());
  machine.stops[0].clearance_m = 0.05;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.7, .natural_frequency_hz = 37, .damping_ratio = 0};
  constexpr double e_m = 1e-4;
  const scene::Cell cell = scene::build_cell(machine, 37, scene::Eccentricity{e_m});
  ASSERT_TRUE(scene::can_run(cell.start));
  EXPECT_TRUE(std::isnan(cell.whirl_ratio));
  for (const run::Method method : both_methods) {
    const auto found = places_m(cell.scene, method, 40);
    for (std::size_t turn = 1; turn <= found.size(); ++turn) {
      const Eigen::Vector2d truth(0, -pi * e_m * static_cast<double>(turn));
      EXPECT_LT((found[turn - 1] - truth).norm(), 1e-8 * e_m * 40) << turn;
    }
  }
  EXPECT_EQ(scene::build_cell(machine, 37, scene::WhirlRatio{0.5}).start, scene::Start::unreachable);
}

}  // namespace
}  // namespace rubsweep::integrate
