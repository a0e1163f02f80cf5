// Hard cases computed by the solver of `auto` and by dopri5 at 1e-8: error of the section after six turns,
// compared with a closed form or else with rkf78 at 1e-13, and processor time per turn. The numbers of turns
// by each solver tell which one was used.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "rubsweep/core/integrate/start.hpp"
#include "support/annular_scene.hpp"
#include "support/rolling_scene.hpp"
#include "support/simple_scenes.hpp"

namespace {

using namespace rubsweep;
using integrate::run::SolverOptions;

constexpr int turns = 6;
constexpr int repeats = 15;

struct Case {
  std::string name;
  scene::Scene scene;
  std::vector<double> section{};  ///< closed-form section after six turns; empty: none
};

struct Made {
  std::vector<double> section;
  integrate::run::Effort effort;
  bool ok = true;
};

Made run(const scene::Scene& scene, const SolverOptions& options) {
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, options, modes);
  integrate::run::TurnReport turn;
  Made made;
  for (int k = 0; k < turns; ++k) made.ok = made.ok && run.advance({}, turn) == integrate::run::Outcome::ok;
  made.section = turn.section;
  made.effort = turn.effort;
  return made;
}

double microseconds_per_turn(const scene::Scene& scene, const SolverOptions& options) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    run(scene, options);
    times.push_back(1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / turns);
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[repeats / 2];
}

double error(const Made& made, const std::vector<double>& answer) {
  if (!made.ok) return NAN;
  double largest = 0;
  for (std::size_t k = 0; k < answer.size(); ++k)
    largest = std::max(largest, std::abs(made.section[k] - answer[k]));
  return largest;
}

/// Growth factor of a small change in the initial state over the turns.
double growth(const scene::Scene& scene, const Made& made) {
  constexpr double change = 1e-9;
  scene::Scene changed = scene;
  changed.displacement_m *= 1 + change;
  return error(run(changed, {}), made.section) / change;
}

SolverOptions stepper(integrate::run::Stepper which, double tolerance) {
  SolverOptions options;
  options.method = integrate::run::Method::adaptive;
  options.stepper = which;
  options.relative_tolerance = tolerance;
  return options;
}

void print(const Case& hard) {
  const std::vector<double> answer =
      hard.section.empty() ? run(hard.scene, stepper(integrate::run::Stepper::rkf78, 1e-13)).section
                           : hard.section;
  const SolverOptions usual, by_dopri5 = stepper(integrate::run::Stepper::dopri5, 1e-8);
  const Made a = run(hard.scene, usual), b = run(hard.scene, by_dopri5);
  std::printf("%-34s %6ld %5ld %9.1e %9.1e %10.1f %10.1e %10.1f\n", hard.name.c_str(), a.effort.taylor_turns,
              a.effort.adaptive_turns, error(a, answer), growth(hard.scene, a),
              microseconds_per_turn(hard.scene, usual), error(b, answer),
              microseconds_per_turn(hard.scene, by_dopri5));
}

/// A driven mass pressed onto a moving belt by a constant force: it sticks, slips, and slips back.
Case stick_slip() {
  auto scene = test::one_mass_scene(1, 1, 0.1, 4, 1);
  scene.structure.stiffness(0, 0) = 0;
  scene.constant_n << 2, 0;
  scene.harmonic_n << 0, 1.5;
  scene::Contact belt = test::wall_across_x(1, 1, 100, 0);
  belt.friction = model::ConstantFriction{0.25};
  belt.surface_speed_m_per_s = 0.5;
  scene.contacts.push_back(belt);
  scene.displacement_m << 1.02, 0.3;
  return {"stick-slip, dry friction", scene};
}

scene::Scene annulus(double mu, double surface_m_per_s, double unbalance) {
  auto scene = test::annular_scene(1, 0.05, 1.2, unbalance, 0, 40, 0);
  scene.contacts[0].friction = model::ConstantFriction{mu};
  scene.contacts[0].surface_speed_m_per_s = surface_m_per_s;
  return scene;
}

/// Backward whirl with friction 1 % above the minimum for dry whip, started at a share of its radius.
Case dry_whip_onset() {
  const double b = 40, zeta = 0.05, least = 2 * zeta * std::sqrt(1 + b) / b, mu = 1.01 * least;
  const double whirl = zeta / mu + std::sqrt(zeta * zeta / (mu * mu) + 1);
  scene::Scene scene = annulus(mu, 30, 0);
  test::start_at(scene, {1.02, 0}, {0, -whirl * 1.02});
  return {"dry whip onset, dry friction", scene};
}

/// The same whirl with a surface so slow that it changes to rolling.
Case whip_that_rolls() {
  scene::Scene scene = annulus(0.3, 1.2, 0.1);
  test::start_at(scene, {1.05, 0}, {0, -1});
  return {"whip that comes to roll", scene};
}

/// A circle whose radius exceeds the clearance by a millionth.
Case graze_along_annulus() {
  test::FullRub rub;
  rub.radius = 1 + 1e-6;
  const scene::Scene scene = rub.scene();
  const double speed = scene.speed_rad_per_s;
  // It returns to the same state after every turn.
  return {"graze along an annular stop",
          scene,
          {scene.displacement_m(0), scene.displacement_m(1), scene.velocity_m_per_s(0) / speed,
           scene.velocity_m_per_s(1) / speed}};
}

/// A straight motion through the centre, where the normal reverses at once.
Case centre_of_annulus() {
  scene::Scene scene = annulus(0.1, 5, 0);
  test::start_at(scene, {-0.9, 0}, {2, 0});
  return {"through the centre of an annular stop", scene};
}

Case rolling(double steepness) {
  const test::RollingScene rolling = test::rolling_scene(steepness);
  const auto z = rolling.displacement(turns), v = rolling.velocity(turns);
  char name[40];
  std::snprintf(name, sizeof name, "rolling, gamma5 = %.0e s/m", steepness);
  return {name, rolling.scene, {z.real(), z.imag(), v.real(), v.imag()}};
}

Case dry_rolling() {
  Case hard = rolling(1e3);
  test::RollingScene closed = test::rolling_scene(1e3);
  hard.name = "rolling, dry friction";
  hard.scene.contacts[0].friction = model::ConstantFriction{0.2};
  hard.scene.contacts[0].surface_speed_m_per_s = closed.radius * closed.whirl;
  return hard;
}

}  // namespace

int main() {
  std::printf("%-34s %6s %5s %9s %9s %10s %10s %10s\n", "case", "series", "steps", "error", "growth",
              "us/turn", "dopri5", "us/turn");
  for (const auto& make :
       {stick_slip, dry_whip_onset, whip_that_rolls, graze_along_annulus, centre_of_annulus})
    print(make());
  for (const double steepness : {1e2, 1e3, 1e4, 1e5}) print(rolling(steepness));
  print(dry_rolling());
}
