#include "rubsweep/core/response/rotating/rotating_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/newton.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"
#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/response/rotating/cycle_measures.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits equilibrium_newton{.iterations = 12,
                                                    .growth = std::numeric_limits<double>::infinity()};
constexpr double closed = 1e-13;  ///< size of a Newton step, in (clearance, clearance omega)

/// Newton's iteration for a fixed point; see numerics::newton. Its error is the size of the latest step.
struct EquilibriumNewton {
  const RotatingEquations& equations;
  const VectorXd& start;
  VectorXd x = start;

  std::optional<double> error(int, double) {
    const VectorXd step = numerics::dense::solve(equations.jacobian(x), equations.rate(x));
    x -= step;
    if (!x.allFinite() || (x - start).cwiseAbs().maxCoeff() > proof::farthest_orbit) return std::nullopt;
    return step.cwiseAbs().maxCoeff();
  }
  bool converged(int, double error, double) const { return error < closed; }
  bool step(int) const { return true; }
};

constexpr int free_for_long = 16;  ///< number of turns without contact

/// Samples per turn, enough for a good start of Newton's iteration between two samples. The coarse number is
/// used where an occasional turn with the fine number has few maxima.
constexpr int fine_samples = 64, coarse_samples = 32, fine_turn_every = 8, few_maxima = 4;

/// Ratio of the samples of a cycle to those of a turn. A cubic between the samples of a turn reduces the
/// radius of a whirl at four times the speed by 1.5e-6, which matters for a slip that is a small difference.
constexpr int finer = 4;

/// Share of its distance from a circle down to which a transient is followed. The largest number of turns
/// follows; a later attempt starts nearer.
constexpr double followed_to = 1e-4;
constexpr proof::Patience patience_for_a_circle{.start = 200, .most = 200};

/// Turns that Newton's iteration may follow without a proof, each of which costs about two turns of the
/// transient.
constexpr double turns_for_cycles = 32, share_for_cycles = 0.15;

/// Order above which a whirl has fewer than four fine samples, and the largest that is looked for.
constexpr double fast_whirl = fine_samples / 4.0, most_order = 1e5;

/// Mean order of the whirl in a turn; its whole revolutions are nearest to the rate of the state `after`.
double mean_order(const scene::Scene& scene, const VectorXd& before, const VectorXd& after) {
  const auto observed = [&](const VectorXd& part) {
    const Eigen::Vector2d z = scene::observed(scene) * part;
    return std::complex(z.x(), z.y());
  };
  const Eigen::Index n = after.size() / 2;
  const std::complex<double> z = observed(after.head(n));
  const double rate = (observed(after.tail(n)) / z).imag(),
               angle = std::arg(z / observed(before.head(n))) / numerics::full_turn;
  return angle + std::round(rate - angle);
}

}  // namespace

RotatingProof::RotatingProof(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                             const motion::ResponseOptions& options, motion::Workspace& workspace,
                             integrate::run::WorkBudget& budget)
    : scene_(proof::after_the_kick(scene)),
      solver_(solver),
      options_(options),
      workspace_(workspace),
      budget_(budget),
      field_(scene_, solver),
      flows_(scene_, solver, finer * options.samples_per_revolution),
      turns_(2 * static_cast<std::size_t>(scene.structure.coordinates()), 1) {}

int RotatingProof::samples_wanted() const {
  if (free_turns_ >= free_for_long) return 0;
  const bool fine = many_maxima_ || looked_at_ % fine_turn_every == 0;
  return std::min(fine ? fine_samples : coarse_samples, options_.samples_per_revolution);
}

std::optional<motion::ProvenMotion> RotatingProof::look(const integrate::run::TurnReport& turn) {
  ++looked_at_;
  const double allowed = turns_for_cycles + share_for_cycles * static_cast<double>(looked_at_);
  may_try_cycles_ = spent_on_cycles_rad_ <= numerics::full_turn * allowed;
  free_turns_ = turn.touched ? 0 : free_turns_ + 1;
  const VectorXd section =
      Eigen::Map<const VectorXd>(turn.section.data(), static_cast<Eigen::Index>(turn.section.size()));
  auto found = look_for_circle(section, turn);
  if (!found) found = look_for_cycle(section, turn);
  if (!found) found = look_for_fast_whirl(section, turn);
  last_section_ = section;
  return found;
}

std::optional<motion::ProvenMotion> RotatingProof::look_for_circle(const VectorXd& section,
                                                                   const integrate::run::TurnReport& turn) {
  turns_.add(turn.section, turn.touched);
  const auto candidate = turns_.candidate();
  if (!candidate) return std::nullopt;
  const auto circle =
      find_rotating_equilibrium({[this](const VectorXd& state) { return field_.rate(state); },
                                 [this](const VectorXd& state) { return field_.jacobian(state); }},
                                section);
  if (circle && field_.touches(circle->state) && comes_near_to(*circle, turn.section))
    return measured(*circle);
  turns_.refuse(*candidate);
  return std::nullopt;
}

/// At phase 0 of every turn the two frames coincide, so that a section is a state of the rotating frame.
bool RotatingProof::comes_near_to(const RotatingEquilibrium& circle, std::span<const double> section) {
  const proof::StableOrbit orbit{1, {circle.state}, {circle.transition}, circle.floquet_modulus};
  const auto norms = proof::adapted_norms(orbit.transitions);
  if (!norms) return false;
  if (!turn_map_) turn_map_.emplace(scene_, solver_, workspace_.modes, &budget_);
  const proof::Nearness wanted{followed_to * proof::adapted_distance(section, orbit, *norms),
                               proof::on_the_orbit, true};
  return proof::comes_near([this](std::span<double> state, Eigen::MatrixXd*) { return (*turn_map_)(state); },
                           section, orbit, *norms, wanted, patience_for_a_circle);
}

motion::ProvenMotion RotatingProof::measured(const RotatingEquilibrium& circle) {
  const VectorXd& state = circle.state;
  const auto& map = scene::observed(scene_);
  const Eigen::Vector2d z = scene_.length_scale_m * (map * state.head(map.cols()));
  const double casing_m = field_.casing_displacement_m(state);
  std::vector<std::complex<double>> displacement_m;
  displacement_m.reserve(static_cast<std::size_t>(options_.samples_per_revolution));
  for (int k = 0; k < options_.samples_per_revolution; ++k) {
    displacement_m.push_back(std::complex(z.x(), z.y()) *
                             std::polar(1.0, numerics::full_turn * k / options_.samples_per_revolution));
  }
  std::vector<double> section(state.data(), state.data() + state.size());
  section.insert(section.end(), state.data(), state.data() + state.size());
  motion::Window window;
  window.turns = 1;
  window.samples_per_revolution = options_.samples_per_revolution;
  window.clearance_m = scene_.length_scale_m;
  window.displacement_m = displacement_m;
  window.states = static_cast<int>(state.size());
  window.section = section;
  const std::array<motion::ContactFacts, 1> facts{{{.hits = 0,
                                                    .contact_fraction = 1,
                                                    .peak_displacement_m = z.norm(),
                                                    .peak_contact_force_n = field_.contact_force_n(state),
                                                    .peak_casing_displacement_m = casing_m}}};
  window.contact = facts;
  const motion::Measures measures = motion::measure_window(window, workspace_.spectrum);
  return {motion::class_of_period(1, measures), 1, measures, circle.floquet_modulus};
}

std::optional<motion::ProvenMotion> RotatingProof::look_for_cycle(const VectorXd& section,
                                                                  const integrate::run::TurnReport& turn) {
  if (turn.sample_count == 0) {
    maxima_.reset();
    return std::nullopt;
  }
  if (!maxima_) maxima_.emplace(scene_);
  maxima_->add(turn);
  if (turn.sample_count >= fine_samples) many_maxima_ = maxima_->maxima_in_turn() > few_maxima;
  if (!may_try_cycles_) return std::nullopt;
  const auto candidate = maxima_->candidate();
  if (!candidate) return std::nullopt;
  auto proven =
      proven_cycle(flows_, finer * options_.samples_per_revolution, section, candidate->periods_rad);
  if (!proven) maxima_->refuse(*candidate);
  return proven;
}

/// The samples of a turn do not resolve a whirl many times as fast as the shaft, such as rolling. Its period
/// follows from the angle of whole turns.
std::optional<motion::ProvenMotion> RotatingProof::look_for_fast_whirl(
    const VectorXd& section, const integrate::run::TurnReport& turn) {
  if (last_section_.size() == 0 || turn.hits > 0 || !turn.touching_at_end) return std::nullopt;
  const double order = mean_order(scene_, last_section_, section), size = std::abs(order);
  if (!(size > fast_whirl && size < most_order && may_try_cycles_)) return std::nullopt;
  const int samples = static_cast<int>(size) * options_.samples_per_revolution;
  CycleFlows flows(scene_, solver_, samples);
  return proven_cycle(flows, samples, section, {numerics::full_turn / std::abs(order - 1)});
}

std::optional<motion::ProvenMotion> RotatingProof::proven_cycle(CycleFlows& flows, int samples_per_revolution,
                                                                const VectorXd& section,
                                                                const std::vector<double>& periods_rad) {
  RotatingMotion motion = flows.motion(field_);
  for (RotatingMotion::Flow* flow : {&motion.at_first, &motion.roughly, &motion.exactly}) {
    *flow = [this, follow = std::move(*flow)](const VectorXd& state, double angle_rad) {
      spent_on_cycles_rad_ += angle_rad;
      return follow(state, angle_rad);
    };
  }
  const auto cycle = prove_limit_cycle(motion, section, periods_rad);
  if (!cycle || !(cycle->once.contact_fraction > 0) || returns_with_the_shaft(*cycle)) return std::nullopt;
  motion::ResponseOptions fine = options_;
  fine.samples_per_revolution = samples_per_revolution;
  const motion::Measures measures = measure_cycle(scene_, cycle->once, fine, workspace_);
  return motion::ProvenMotion{motion::MotionClass::quasi_periodic, {}, measures, cycle->floquet_modulus};
}

/// Whether a whole number of periods fits into a few turns, within the accuracy of a section. The motion is
/// then called subharmonic (or synchronous), which only its recorded windows may decide.
bool RotatingProof::returns_with_the_shaft(const LimitCycle& cycle) const {
  const double fastest = field_.rate(cycle.state).cwiseAbs().maxCoeff();
  for (int n = 1; n <= options_.max_order; ++n) {
    const double off_rad = std::abs(std::remainder(numerics::full_turn * n, cycle.once.angle_rad));
    if (off_rad * fastest < motion::section_tolerance) return true;
  }
  return false;
}

std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const VectorXd& start) {
  EquilibriumNewton found{.equations = equations, .start = start};
  if (!numerics::newton(found, equilibrium_newton)) return std::nullopt;
  const MatrixXd jacobian = equations.jacobian(found.x);
  const double modulus =
      std::exp(numerics::full_turn * numerics::dense::eigenvalues(jacobian).real().maxCoeff());
  if (!(modulus < proof::largest_floquet_modulus)) return std::nullopt;
  return RotatingEquilibrium{found.x, numerics::matrix_flow(jacobian, numerics::full_turn), modulus};
}

}  // namespace rubsweep::response::rotating
