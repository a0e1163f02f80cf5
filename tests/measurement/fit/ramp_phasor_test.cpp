#include "rubsweep/measurement/fit/ramp_phasor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

using Complex = std::complex<double>;

/// 1X with this eccentricity.
Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns) {
  const RampParts parts = ramp_parts(prepared, rows, ramp, t_s, window_turns);
  return eccentricity_m * parts.per_eccentricity + parts.bow_m;
}

/// A kit with a bow and gyroscopic discs away from midspan.
model::Machine bowed_kit() {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.discs.front().position_m = 0.12;
  kit.discs.front().polar_inertia_kg_m2 = 2e-3;
  kit.discs.front().diametral_inertia_kg_m2 = 1.2e-3;
  kit.supports.front().stiffness_y_n_per_m = 3.6e4;
  kit.modes = 1;
  kit.bow = model::Bow{.shape = model::BowMode{.mode = 1, .amplitude_m = 2e-5}, .phase_deg = 70};
  return machine;
}

/// 1X from two runs of a Runge-Kutta method whose phases differ by a quarter turn.
Eigen::MatrixXcd by_steps(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                          linear::LinearRun run) {
  run.driven = linear::Driven::in_phase;
  const Eigen::MatrixXd real = linear::run_linear(prepared, run, rows);
  run.driven = linear::Driven::quarter_behind;
  const Eigen::MatrixXd behind = linear::run_linear(prepared, run, rows);
  Eigen::MatrixXcd phasor(real.rows(), real.cols());
  for (Eigen::Index k = 0; k < real.rows(); ++k)
    for (Eigen::Index i = 0; i < real.cols(); ++i)
      phasor(k, i) = Complex(real(k, i), behind(k, i)) *
                     std::polar(1.0, -linear::shaft_angle_rad(run, static_cast<double>(k) * run.sample_s));
  return phasor;
}

TEST(RampPhasor, IsThatOfStepsUpAndDown) {
  for (const model::Machine& machine : {scene::one_side_machine(), bowed_kit()}) {
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    const Eigen::MatrixXd rows = linear::sensor_rows(prepared).rows;
    for (const double rate : {4.0, -4.0}) {
      const linear::LinearRun run{.from_hz = rate > 0 ? 15.0 : 45.0,
                                  .rate_hz_per_s = rate,
                                  .eccentricity_m = 1e-5,
                                  .sample_s = 5e-3,
                                  .samples = 1500};
      std::vector<double> t_s;
      for (int k = 0; k < run.samples; ++k) t_s.push_back(k * run.sample_s);
      const Eigen::MatrixXcd steps = by_steps(prepared, rows, run);
      const Eigen::MatrixXcd found = ramp_phasors(prepared, rows, 1e-5, {run.from_hz, rate}, t_s, 0);
      // The reference starts on the motion of a steady speed, so the beginning is left out.
      EXPECT_LT((found - steps).bottomRows(1300).cwiseAbs().maxCoeff(), 2e-3 * steps.cwiseAbs().maxCoeff())
          << rate;
    }
  }
}

TEST(RampPhasor, AnUnevenSpeedIsThatOfSteps) {
  const model::Machine machine = scene::one_side_machine();
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  const double w = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  Ramp ramp;
  // A ramp that is fast, slow at the resonance, and fast again.
  ramp.knot_s = {0, 1.5, 3.5, 5};
  ramp.knot_hz = {20, 29, 31, 42};
  double phi = 0, t = 0;
  const auto rate = [&](const std::array<Complex, 2>& z, double at, double angle) {
    const double speed = 2 * std::numbers::pi * speed_hz(ramp, at);
    const double gain = (2 * std::numbers::pi * speed_hz(ramp, at + 1e-9) - speed) / 1e-9;
    return std::array<Complex, 2>{z[1], -w * w * z[0] - 2 * rotor.damping_ratio * w * z[1] +
                                            1e-5 * Complex(speed * speed, -gain) * std::polar(1.0, angle)};
  };
  const auto angle_after = [&](double step) {
    return phi + 2 * std::numbers::pi * step * (speed_hz(ramp, t) + speed_hz(ramp, t + step)) / 2;
  };
  constexpr double step = 1e-3;
  const double begin = 2 * std::numbers::pi * 20;
  const Complex start =
      1e-5 * begin * begin / Complex(w * w - begin * begin, 2 * rotor.damping_ratio * w * begin);
  std::array<Complex, 2> z{start, Complex(0, begin) * start};
  std::vector<double> t_s;
  std::vector<Complex> steps;
  while (t < 4.9) {
    t_s.push_back(t);
    steps.push_back(z[0] * std::polar(1.0, -phi));
    const auto moved = [&](const std::array<Complex, 2>& by, double h) {
      return std::array<Complex, 2>{z[0] + h * by[0], z[1] + h * by[1]};
    };
    const auto a = rate(z, t, phi), b = rate(moved(a, step / 2), t + step / 2, angle_after(step / 2));
    const auto c = rate(moved(b, step / 2), t + step / 2, angle_after(step / 2));
    const auto d = rate(moved(c, step), t + step, angle_after(step));
    for (std::size_t i = 0; i < 2; ++i) z[i] += step / 6 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    phi = angle_after(step);
    t += step;
  }
  const Eigen::MatrixXcd found =
      ramp_phasors(prepared, linear::sensor_rows(prepared).rows, 1e-5, ramp, t_s, 0);
  double largest = 0, most = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    largest = std::max(largest, std::abs(steps[k]));
    if (t_s[k] > 1) most = std::max(most, std::abs(steps[k] - found(static_cast<Eigen::Index>(k), 0)));
  }
  EXPECT_LT(most, 2e-3 * largest);
  EXPECT_GT(largest, 1.5e-4) << "it hesitates at the resonance";
}

TEST(RampPhasor, ASpeedThatTurnsWithinAStretchMeetsItsResonance) {
  // A slow passage through the resonance and back, within one of the 64 stretches of a very long run at much
  // lower speed. With constant modes the result equals that of a single stretch.
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz = 60;
  const scene::PreparedMachine straight = scene::prepare_machine(machine);
  scene::PreparedMachine stretched = straight;
  const Eigen::Index n = straight.assembly.system.coordinates();
  stretched.assembly.gyroscopic = Eigen::MatrixXd::Zero(n, n);
  Ramp ramp;
  ramp.knot_s = {0, 4815, 4877.5, 4940, 9600};
  ramp.knot_hz = {20, 20, 70, 20, 20};
  const Eigen::MatrixXd rows = linear::sensor_rows(straight).rows;
  std::vector<double> t_s{0};
  for (int k = 0; k <= 60; ++k) t_s.push_back(4850.0 + k);
  t_s.push_back(9600);
  const Eigen::MatrixXcd one = ramp_phasors(straight, rows, 1e-5, ramp, t_s, 0),
                         many = ramp_phasors(stretched, rows, 1e-5, ramp, t_s, 0);
  EXPECT_GT(one.cwiseAbs().maxCoeff(), 1e-4) << "it passes its resonance";
  EXPECT_LT((many - one).cwiseAbs().maxCoeff(), 1e-3 * one.cwiseAbs().maxCoeff());
}

TEST(RampPhasor, KnotsOnALineAreAnEvenRamp) {
  const scene::PreparedMachine prepared = scene::prepare_machine(bowed_kit());
  const Eigen::MatrixXd rows = linear::sensor_rows(prepared).rows;
  Ramp knots;
  knots.knot_s = {0, 1, 1.7, 4};
  knots.knot_hz = {20, 24, 26.8, 36};
  const std::vector<double> t_s{0.5, 1.2, 2, 3, 3.9};
  const Eigen::MatrixXcd line = ramp_phasors(prepared, rows, 1e-5, {20, 4}, t_s, 2);
  EXPECT_LT((ramp_phasors(prepared, rows, 1e-5, knots, t_s, 2) - line).norm(), 1e-8 * line.norm());
}

TEST(RampPhasor, SupportsFollowTheirTables) {
  const scene::PreparedMachine tabled = scene::prepare_machine(scene::table_machine());
  const Eigen::MatrixXd rows = linear::sensor_rows(tabled).rows;
  for (const std::size_t row : {0u, 4u}) {
    const double hz = scene::table_speeds_hz[row];
    const auto typed = steady_phasors(scene::prepare_machine(scene::typed_machine(row)), rows, 1e-5, hz);
    const auto steady = steady_phasors(tabled, rows, 1e-5, hz);
    // Two modes and the static deflections of the middle speed approximate the motion at all speeds.
    EXPECT_LT((steady - typed).norm(), 2e-2 * typed.norm()) << hz;
  }
  const linear::LinearRun run{
      .from_hz = 25, .rate_hz_per_s = 4, .eccentricity_m = 1e-5, .sample_s = 5e-3, .samples = 1500};
  std::vector<double> t_s;
  for (int k = 0; k < run.samples; ++k) t_s.push_back(k * run.sample_s);
  const Eigen::MatrixXcd steps = by_steps(tabled, rows, run);
  const Eigen::MatrixXcd found = ramp_phasors(tabled, rows, 1e-5, {25, 4}, t_s, 0);
  EXPECT_LT((found - steps).bottomRows(1300).cwiseAbs().maxCoeff(), 2e-3 * steps.cwiseAbs().maxCoeff());
  EXPECT_THROW(steady_phasors(tabled, rows, 1e-5, 10), ConfigError);
  EXPECT_THROW(ramp_phasors(tabled, rows, 1e-5, {25, 4}, {0, 30}, 0), ConfigError);
}

TEST(RampPhasor, AWindowIsTheMeanOverIt) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  const Eigen::MatrixXd rows = linear::sensor_rows(prepared).rows;
  const Ramp ramp{20, 4};
  std::vector<double> fine;
  for (int k = 0; k <= 400; ++k) fine.push_back(2.6 + (k - 200) / 400.0 * 2 / (20 + 4 * 2.6));
  const Eigen::MatrixXcd inside = ramp_phasors(prepared, rows, 1e-5, ramp, fine, 0);
  const Eigen::MatrixXcd mean = ramp_phasors(prepared, rows, 1e-5, ramp, {2.6}, 2);
  EXPECT_LT((mean.row(0) - inside.colwise().mean()).cwiseAbs().maxCoeff(),
            2e-3 * inside.cwiseAbs().maxCoeff());
  EXPECT_GT((mean.row(0) - inside.row(200)).cwiseAbs().maxCoeff(), 1e-3 * inside.cwiseAbs().maxCoeff());
}

TEST(RampPhasor, ReadingsFromMarkToMarkHaveAMirroredPart) {
  const scene::PreparedMachine prepared = scene::prepare_machine(bowed_kit());
  const Eigen::MatrixXd rows = linear::sensor_rows(prepared).rows;
  const Ramp ramp{20, 4};
  // Above the resonance, where free and forced vibration beat. The reference uses the middles of equal
  // angular steps.
  constexpr double middle_s = 3.4, turns = 2, e = 1e-5;
  constexpr int steps = 400;
  const double now_hz = speed_hz(ramp, middle_s);
  std::vector<double> t_s, turned;
  for (int k = 0; k < steps; ++k) {
    turned.push_back(turns * ((k + 0.5) / steps - 0.5));
    const double root = std::sqrt(now_hz * now_hz + 2 * ramp.rate_hz_per_s * turned.back());
    t_s.push_back(middle_s + (root - now_hz) / ramp.rate_hz_per_s);
  }
  const Eigen::MatrixXcd inside = ramp_phasors(prepared, rows, e, ramp, t_s, 0);
  Eigen::RowVectorXcd found = Eigen::RowVectorXcd::Zero(rows.rows());
  for (int k = 0; k < steps; ++k) {
    const Complex turn = std::polar(1.0, 2 * std::numbers::pi * turned[static_cast<std::size_t>(k)]);
    const Eigen::RowVectorXd readings = (turn * inside.row(k)).real();
    found += 2.0 / steps * std::conj(turn) * readings.cast<Complex>();
  }
  const RampParts parts = ramp_parts(prepared, rows, ramp, {middle_s}, turns);
  const Eigen::RowVectorXcd mean = e * parts.per_eccentricity.row(0) + parts.bow_m.row(0);
  const Eigen::RowVectorXcd mirrored =
      e * parts.per_eccentricity_mirrored.row(0) + parts.bow_mirrored_m.row(0);
  const double size = mean.cwiseAbs().maxCoeff();
  EXPECT_LT((mean + mirrored - found).cwiseAbs().maxCoeff(), 1e-3 * size);
  EXPECT_GT(mirrored.cwiseAbs().maxCoeff(), 5e-3 * size) << "it would not be missed";
}

TEST(RampPhasor, ASlowRampIsASteadySpeed) {
  const scene::PreparedMachine prepared = scene::prepare_machine(bowed_kit());
  const Eigen::MatrixXd rows = linear::sensor_rows(prepared).rows;
  const auto steady = steady_phasors(prepared, rows, 1e-5, 25);
  const auto slow = ramp_phasors(prepared, rows, 1e-5, {25, 1e-4}, {0}, 0);
  EXPECT_LT((slow.row(0) - steady).norm(), 1e-4 * steady.norm());
  EXPECT_THROW(ramp_phasors(prepared, rows, 1e-5, {5, -1}, {0, 6}, 0), ConfigError);
}

using std::numbers::pi;

const Ramp steady{.from_hz = 10, .rate_hz_per_s = 0};

/// Mean of t^3 + t^4 over two turns about t = 0, with or without the factor e^{-2i phi}, by the midpoint
/// rule.
Complex mean_of(bool mirrored) {
  constexpr int steps = 20'000;
  Complex sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = 0.1 * (2.0 * (k + 0.5) / steps - 1);
    const double value = std::pow(t, 3) + std::pow(t, 4);
    sum +=
        value * (mirrored ? std::polar(1.0, -2 * 2 * pi * 10 * t) : Complex(1)) / static_cast<double>(steps);
  }
  return sum;
}

TEST(RampPhasor, HasTheMeansOfPolynomials) {
  Complex mean = 0, mirrored = 0;
  for (const WindowNode& node : window_nodes(steady, {0}, 2)) {
    const double value = std::pow(node.t_s, 3) + std::pow(node.t_s, 4);
    mean += node.weight * value;
    mirrored += node.mirrored * value;
  }
  EXPECT_NEAR(std::abs(mean - mean_of(false)), 0, 1e-10);
  EXPECT_NEAR(std::abs(mirrored - mean_of(true)), 0, 1e-10);
}

TEST(RampPhasor, OfNoTurnsIsTheInstantItself) {
  const auto nodes = window_nodes(steady, {1, 2}, 0);
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(nodes[1].t_s, 2);
  EXPECT_EQ(nodes[1].weight, 1);
  EXPECT_EQ(nodes[1].point, 1);
}

TEST(RampPhasor, ListsTheNodesOfAllWindowsInTime) {
  const auto nodes = window_nodes({.from_hz = 10, .rate_hz_per_s = 1}, {1, 1.05}, 2);
  EXPECT_EQ(nodes.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(nodes, {}, &WindowNode::t_s));
}

TEST(RampPhasor, RefusesAStandstill) {
  EXPECT_THROW(window_nodes({.from_hz = 1, .rate_hz_per_s = -1}, {2}, 2), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
