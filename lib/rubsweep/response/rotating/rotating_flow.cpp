#include "rubsweep/response/rotating/rotating_flow.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "rubsweep/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/response/rotating/rotating_frame.hpp"
#include "rubsweep/response/rotating/variational_dynamics.hpp"

namespace rubsweep::response::rotating {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Adds the states sampled in a turn before `end_phase`.
void append_samples(const integrate::run::Turn& turn, double end_phase, Eigen::Index states,
                    RotatingArc& arc) {
  const Eigen::Index whole = states * (states + 1), old = arc.samples.cols();
  int count = 0;
  while (count < turn.samples_per_revolution && full_turn * count / turn.samples_per_revolution < end_phase)
    ++count;
  arc.samples.conservativeResize(states, old + count);
  arc.samples.rightCols(count) =
      Eigen::Map<const Eigen::MatrixXd>(turn.samples.data(), whole, turn.samples_per_revolution)
          .topLeftCorner(states, count);
}

template <class State, int N, bool Smoothed>
std::optional<RotatingArc> follow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                                  int samples_per_revolution, double angle_rad) {
  integrate::adaptive::AdaptiveRun<integrate::adaptive::Dopri5<State>, N, Smoothed,
                                   VariationalDynamics<N, Smoothed>>
      run(scene, options);
  const Eigen::Index states = 2 * scene.structure.coordinates();
  RotatingArc arc;
  arc.angle_rad = angle_rad;
  integrate::run::Turn turn;
  turn.samples_per_revolution = samples_per_revolution;
  turn.peaks = samples_per_revolution > 0;
  for (double left = angle_rad; left > 0; left -= full_turn) {
    const double end_phase = std::min(left, full_turn);
    if (run.advance(turn, end_phase) != integrate::run::Outcome::ok) return std::nullopt;
    if (samples_per_revolution > 0) append_samples(turn, end_phase, states, arc);
    arc.hits += turn.hits;
    arc.contact_fraction += turn.contact_fraction * full_turn / angle_rad;
    arc.peak_displacement_m = std::max(arc.peak_displacement_m, turn.peak_displacement_m);
    arc.peak_contact_force_n = std::max(arc.peak_contact_force_n, turn.peak_contact_force_n);
  }
  const double* end = turn.section.data();
  arc.end = turned(Eigen::Map<const Eigen::VectorXd>(end, states), -angle_rad);
  arc.transition = turned(Eigen::Map<const Eigen::MatrixXd>(end + states, states, states), -angle_rad);
  return arc;
}

template <class State, int N, bool Smoothed>
std::optional<Eigen::VectorXd> end_of(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                                      double angle_rad) {
  integrate::adaptive::AdaptiveRun<integrate::adaptive::Dopri5<State>, N, Smoothed> run(scene, options);
  integrate::run::Turn turn;
  for (double left = angle_rad; left > 0; left -= full_turn) {
    if (run.advance(turn, std::min(left, full_turn)) != integrate::run::Outcome::ok) return std::nullopt;
  }
  const Eigen::Map<const Eigen::VectorXd> end(turn.section.data(), 2 * scene.structure.coordinates());
  return turned(end, -angle_rad);
}

}  // namespace

RotatingFlow::RotatingFlow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                           int samples_per_revolution)
    : scene_(scene), options_(options), samples_per_revolution_(samples_per_revolution) {
  scene_.pulse.reset();
}

scene::Scene RotatingFlow::scene_at(const Eigen::VectorXd& state) const {
  scene::Scene scene = scene_;
  const Eigen::Index n = scene.structure.coordinates();
  scene.displacement_m = scene.length_scale_m * state.head(n);
  scene.velocity_m_per_s = scene.length_scale_m * scene.speed_rad_per_s * state.tail(n);
  return scene;
}

// The usual scene, a rotor and one casing, gets a fixed size.

std::optional<RotatingArc> RotatingFlow::from(const Eigen::VectorXd& state, double angle_rad) const {
  const scene::Scene scene = scene_at(state);
  constexpr int any = Eigen::Dynamic;
  const int samples = samples_per_revolution_;
  if (options_.contact == integrate::run::ContactHandling::smoothed)
    return follow<std::vector<double>, any, true>(scene, options_, samples, angle_rad);
  if (state.size() == 8) return follow<std::array<double, 72>, 4, false>(scene, options_, samples, angle_rad);
  return follow<std::vector<double>, any, false>(scene, options_, samples, angle_rad);
}

std::optional<Eigen::VectorXd> RotatingFlow::end_from(const Eigen::VectorXd& state, double angle_rad) const {
  const scene::Scene scene = scene_at(state);
  constexpr int any = Eigen::Dynamic;
  if (options_.contact == integrate::run::ContactHandling::smoothed)
    return end_of<std::vector<double>, any, true>(scene, options_, angle_rad);
  if (state.size() == 8) return end_of<std::array<double, 8>, 4, false>(scene, options_, angle_rad);
  return end_of<std::vector<double>, any, false>(scene, options_, angle_rad);
}

}  // namespace rubsweep::response::rotating
