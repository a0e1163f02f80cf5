#include "rubsweep/core/response/rotating/rotating_flow.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"

namespace rubsweep::response::rotating {
namespace {

/// A flow with a tolerance of `rough_from` or more is rough. The accuracy of its series is then only this
/// share of the tolerance, so that fewer terms and longer steps suffice. Each step of Newton's iteration
/// still reduces the error a thousandfold.
constexpr double rough_from = 1e-7, share_of_tolerance = 1e-3;

double series_accuracy_for(double tolerance) {
  return tolerance >= rough_from ? share_of_tolerance * tolerance : integrate::taylor::rounding_of_series;
}

/// Adds the states sampled in a turn: the first `states` of `whole` numbers each.
void append_samples(const integrate::run::TurnReport& turn, Eigen::Index states, Eigen::Index whole,
                    RotatingArc& arc) {
  const Eigen::Index old = arc.samples.cols();
  arc.samples.conservativeResize(states, old + turn.sample_count);
  arc.samples.rightCols(turn.sample_count) =
      Eigen::Map<const Eigen::MatrixXd>(turn.samples.data(), whole, turn.sample_count).topRows(states);
}

/// Adds the measures of a turn, or of the part of a turn that ends an arc; `left_rad`: remainder of the arc
/// when the turn began.
void add_measures(const integrate::run::TurnReport& turn, double left_rad, RotatingArc& arc) {
  for (integrate::run::ModeSwitch change : turn.switches) {
    change.phase_rad += arc.angle_rad - left_rad;
    arc.switches.push_back(change);
  }
  arc.slip_reversed = arc.slip_reversed || turn.slip_reversed;
  arc.hits += turn.hits;
  arc.contact_fraction += turn.contact_fraction * numerics::full_turn / arc.angle_rad;
  arc.peak_displacement_m = std::max(arc.peak_displacement_m, turn.peak_displacement_m);
  arc.peak_contact_force_n = std::max(arc.peak_contact_force_n, turn.peak_contact_force_n);
  arc.peak_casing_displacement_m = std::max(arc.peak_casing_displacement_m, turn.peak_casing_displacement_m);
}

integrate::run::TurnRequest sampled(int samples_per_revolution) {
  return {.samples_per_revolution = samples_per_revolution,
          .peaks = samples_per_revolution > 0,
          .switches = true};
}

/// Follows by Taylor pieces, with the transition matrix if requested.
template <int N>
HowFollowed follow_by_series(integrate::taylor::TaylorRun<N>& run, const Eigen::VectorXd& state,
                             double tolerance, int samples_per_revolution, bool transition,
                             RotatingArc& arc) {
  const Eigen::Index states = state.size();
  integrate::run::TurnRequest request = sampled(samples_per_revolution);
  integrate::run::TurnReport turn;
  if (transition) request.tangent_vectors.setIdentity(states, states);
  if (tolerance >= rough_from) request.tangent_accuracy = tolerance;
  run.set_series_accuracy(series_accuracy_for(tolerance));
  run.resume({state.data(), static_cast<std::size_t>(states)}, 0);
  for (double left = arc.angle_rad; left > 0; left -= numerics::full_turn) {
    const integrate::run::Outcome ending = run.advance(request, turn, std::min(left, numerics::full_turn));
    if (ending != integrate::run::Outcome::ok) return HowFollowed::failed;
    if (transition) request.tangent_vectors = *turn.tangent_vectors.get();
    if (samples_per_revolution > 0) append_samples(turn, states, states, arc);
    add_measures(turn, left, arc);
  }
  arc.end = turned(Eigen::Map<const Eigen::VectorXd>(turn.section.data(), states), -arc.angle_rad);
  if (transition) arc.transition = turned(request.tangent_vectors, -arc.angle_rad);
  return HowFollowed::made;
}

/// Whether Taylor series apply; a stepper chosen by name makes every turn instead.
bool series_apply(const integrate::run::SolverOptions& options) {
  return options.method != integrate::run::Method::adaptive &&
         options.stepper == integrate::run::Stepper::automatic &&
         options.contact == integrate::run::ContactHandling::located;
}

/// One method for all arcs: the variational equations have no Jacobian, which an implicit step would need.
integrate::run::SolverOptions by_dopri5(integrate::run::SolverOptions options) {
  options.stepper = integrate::run::Stepper::dopri5;
  return options;
}

template <int N, bool Smoothed>
std::optional<RotatingArc> follow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                                  int samples_per_revolution, double angle_rad) {
  integrate::adaptive::AdaptiveRun<VariationalDynamics<N, Smoothed>> run(scene, by_dopri5(options));
  const Eigen::Index states = 2 * scene.structure.coordinates();
  RotatingArc arc;
  arc.angle_rad = angle_rad;
  const integrate::run::TurnRequest request = sampled(samples_per_revolution);
  integrate::run::TurnReport turn;
  for (double left = angle_rad; left > 0; left -= numerics::full_turn) {
    const double end_phase = std::min(left, numerics::full_turn);
    if (run.advance(request, turn, end_phase) != integrate::run::Outcome::ok) return std::nullopt;
    if (samples_per_revolution > 0) append_samples(turn, states, states * (states + 1), arc);
    add_measures(turn, left, arc);
  }
  const double* end = turn.section.data();
  arc.end = turned(Eigen::Map<const Eigen::VectorXd>(end, states), -angle_rad);
  arc.transition = turned(Eigen::Map<const Eigen::MatrixXd>(end + states, states, states), -angle_rad);
  return arc;
}

template <int N, bool Smoothed>
std::optional<Eigen::VectorXd> end_of(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                                      double angle_rad) {
  integrate::adaptive::AdaptiveRun<integrate::law::Dynamics<N, Smoothed>> run(scene, by_dopri5(options));
  integrate::run::TurnReport turn;
  for (double left = angle_rad; left > 0; left -= numerics::full_turn) {
    if (run.advance({}, turn, std::min(left, numerics::full_turn)) != integrate::run::Outcome::ok)
      return std::nullopt;
  }
  const Eigen::Map<const Eigen::VectorXd> end(turn.section.data(), 2 * scene.structure.coordinates());
  return turned(end, -angle_rad);
}

}  // namespace

/// One run for all arcs of all tolerances, because its data do not depend on the start. It is made when first
/// needed. The most common scene, a rotor and one casing, gets a fixed size.
struct RotatingFlow::Common {
  using Usual = integrate::taylor::TaylorRun<4>;
  using Other = integrate::taylor::TaylorRun<Eigen::Dynamic>;

  explicit Common(scene::Scene of) : scene(std::move(of)) { scene.pulses.clear(); }

  scene::Scene scene;
  std::variant<std::monostate, Usual, Other> series;

  template <class Follow>
  HowFollowed by_series(const integrate::run::SolverOptions& options, const Follow& follow) {
    if (std::holds_alternative<std::monostate>(series)) {
      if (scene.structure.coordinates() == 4) {
        series.emplace<Usual>(scene, options);
      } else {
        series.emplace<Other>(scene, options);
      }
    }
    if (auto* usual = std::get_if<Usual>(&series)) return follow(*usual);
    return follow(std::get<Other>(series));
  }
};

RotatingFlow::RotatingFlow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
                           int samples_per_revolution)
    : common_(std::make_shared<Common>(scene)),
      options_(options),
      samples_per_revolution_(samples_per_revolution) {}

RotatingFlow RotatingFlow::with(double relative_tolerance, int samples_per_revolution) const {
  RotatingFlow other = *this;
  other.options_.relative_tolerance = relative_tolerance;
  other.samples_per_revolution_ = samples_per_revolution;
  return other;
}

scene::Scene RotatingFlow::scene_at(const Eigen::VectorXd& state) const {
  scene::Scene scene = common_->scene;
  integrate::run::set_initial_state(scene, {state.data(), static_cast<std::size_t>(state.size())});
  return scene;
}

HowFollowed RotatingFlow::by_series(const Eigen::VectorXd& state, int samples_per_revolution, bool transition,
                                    RotatingArc& arc) const {
  if (!series_apply(options_)) return HowFollowed::by_stepper;
  return common_->by_series(options_, [&](auto& run) {
    return follow_by_series(run, state, options_.relative_tolerance, samples_per_revolution, transition, arc);
  });
}

std::optional<RotatingArc> RotatingFlow::from(const Eigen::VectorXd& state, double angle_rad) const {
  constexpr int any = Eigen::Dynamic;
  const int samples = samples_per_revolution_;
  RotatingArc arc;
  arc.angle_rad = angle_rad;
  const HowFollowed followed = by_series(state, samples, true, arc);
  if (followed == HowFollowed::made) return arc;
  if (followed == HowFollowed::failed) return std::nullopt;
  const scene::Scene scene = scene_at(state);
  if (options_.contact == integrate::run::ContactHandling::smoothed)
    return follow<any, true>(scene, options_, samples, angle_rad);
  if (state.size() == 8) return follow<4, false>(scene, options_, samples, angle_rad);
  return follow<any, false>(scene, options_, samples, angle_rad);
}

std::optional<Eigen::VectorXd> RotatingFlow::end_from(const Eigen::VectorXd& state, double angle_rad) const {
  constexpr int any = Eigen::Dynamic;
  RotatingArc arc;
  arc.angle_rad = angle_rad;
  const HowFollowed followed = by_series(state, 0, false, arc);
  if (followed == HowFollowed::made) return arc.end;
  if (followed == HowFollowed::failed) return std::nullopt;
  const scene::Scene scene = scene_at(state);
  if (options_.contact == integrate::run::ContactHandling::smoothed)
    return end_of<any, true>(scene, options_, angle_rad);
  if (state.size() == 8) return end_of<4, false>(scene, options_, angle_rad);
  return end_of<any, false>(scene, options_, angle_rad);
}

}  // namespace rubsweep::response::rotating
