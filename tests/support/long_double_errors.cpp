#include "support/long_double_errors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/long_double_run.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::test {
namespace {

using bench::LongDoubleRun;

constexpr LongDoubleRun::Real tolerance = 1e-17L;

double largest_difference(const auto& a, const LongDoubleRun::State& b) {
  double largest = 0;
  for (std::size_t k = 0; k < b.size(); ++k)
    largest = std::max(largest, static_cast<double>(std::abs(LongDoubleRun::Real(a[k]) - b[k])));
  return largest;
}

LongDoubleRun::State long_double_section(const scene::Scene& scene, int turns, LongDoubleRun::Real allowed) {
  LongDoubleRun run(scene, allowed);
  for (int k = 0; k < turns; ++k) run.advance_turn();
  return run.section();
}

void advance(const integrate::run::Run& run, const integrate::run::TurnRequest& request,
             integrate::run::TurnReport& turn) {
  if (run.advance(request, turn) != integrate::run::Outcome::ok) throw std::runtime_error("a turn failed");
}

}  // namespace

LongDoubleErrors errors_against_long_double(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver, int turns) {
  integrate::exact::modes::ModeCache modes;
  LongDoubleErrors errors;
  integrate::run::TurnReport turn;
  const integrate::run::Run run = integrate::start(scene, solver, modes);
  for (int k = 0; k < turns; ++k) {
    advance(run, {}, turn);
    errors.touched = errors.touched || turn.touched;
  }
  const LongDoubleRun::State reference = long_double_section(scene, turns, tolerance);
  errors.section = largest_difference(turn.section, reference);
  errors.reference = largest_difference(reference, long_double_section(scene, turns, 100 * tolerance));

  const auto states = static_cast<Eigen::Index>(turn.section.size());
  integrate::run::TurnRequest with_tangents;
  with_tangents.tangent_vectors = Eigen::MatrixXd::Identity(states, states);
  const integrate::run::Run moving = integrate::start(scene, solver, modes);
  Eigen::MatrixXd growth = with_tangents.tangent_vectors, last = growth;
  LongDoubleRun::State before;
  for (int k = 0; k < turns; ++k) {
    before.assign(turn.section.begin(), turn.section.end());
    advance(moving, with_tangents, turn);
    if (turn.tangent_vectors.get() == nullptr) throw std::runtime_error("no tangent vectors were moved");
    last = *turn.tangent_vectors.get();
    growth = last * growth;
  }
  errors.over_growth = errors.section / std::max(1.0, growth.cwiseAbs().maxCoeff());
  LongDoubleRun moved(scene, tolerance);
  const Eigen::MatrixXd right = bench::monodromy(moved, before, turns - 1).cast<double>();
  errors.monodromy = (last - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff();
  return errors;
}

}  // namespace rubsweep::test
