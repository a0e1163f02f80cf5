#include "rubsweep/integrate/mode_plan.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "rubsweep/integrate/matrix_flow.hpp"
#include "rubsweep/integrate/modal_form.hpp"
#include "rubsweep/integrate/mode_flow.hpp"
#include "rubsweep/integrate/pair_series.hpp"
#include "rubsweep/integrate/released_slip.hpp"
#include "rubsweep/integrate/step_table.hpp"

namespace rubsweep::integrate {
namespace {

using contact::Mode;
using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVectorXd;
using System = ScaledSystem<Eigen::Dynamic>;
using Frictions = std::vector<contact::SaturatedFriction>;

constexpr double fast_over_slow = 3;  ///< frequency ratio from which a pair counts as fast

double fastest(const Matrix& generator) { return generator.eigenvalues().cwiseAbs().maxCoeff(); }

/// The slowest oscillator's natural frequency, as if undamped.
double slowest(const Matrix& stiffness) { return std::sqrt(stiffness.eigenvalues().cwiseAbs().minCoeff()); }

Row over_state(const Row& by_u, const Row& by_v) {
  Row row(by_u.size() + by_v.size());
  row << by_u, by_v;
  return row;
}

/// Builds one joint mode of a plan.
template <int N>
class ModeBuilder {
 public:
  ModeBuilder(const System& system, const Frictions& friction, std::vector<Mode> modes)
      : system_(system), friction_(friction), plan_(std::make_unique<ModePlan<N>>()) {
    plan_->modes = std::move(modes);
  }

  std::unique_ptr<ModePlan<N>> build() {
    assemble();
    if (!find_rest()) return nullptr;
    set_steps();
    for (std::size_t i = 0; i < plan_->modes.size(); ++i) {
      plan_->closing.push_back(by_v(system_.contacts[i].first_row) * plan_->generator);
      if (system_.contacts[i].ring) {
        add_ring(i);
      } else {
        add_exits(i);
        if (plan_->modes[i] != Mode::open) add_touch(i);
      }
    }
    return std::move(plan_);
  }

 private:
  bool open() const {
    for (const Mode mode : plan_->modes) {
      if (mode != Mode::open) return false;
    }
    return true;
  }

  /// Normal force = stiffness * spring_factor * p + damping * damper_factor * v.
  static double spring_factor(Mode mode) { return mode == Mode::clamped ? 2 : mode == Mode::sprung ? 1 : 0; }
  static double damper_factor(Mode mode) { return mode == Mode::sprung ? 1 : 0; }

  void assemble() {
    plan_->stiffness = system_.stiffness;
    plan_->damping = system_.damping;
    constant_ = system_.constant;
    for (std::size_t i = 0; i < plan_->modes.size(); ++i) {
      const auto& c = system_.contacts[i];
      const Mode mode = plan_->modes[i];
      if (mode == Mode::open) continue;
      const Eigen::VectorXd push =
          c.stiffness * (spring_factor(mode) * c.first_push + friction_[i].coefficient * c.second_push);
      plan_->stiffness -= push * c.first_row;
      plan_->damping -= damper_factor(mode) * c.damping * c.first_push * c.first_row;
      constant_ -= push * c.clearance;
    }
    plan_->generator = generator_of(plan_->stiffness, plan_->damping);
  }

  bool find_rest() {
    const Eigen::FullPivLU<Matrix> lu(plan_->stiffness);
    if (!lu.isInvertible() || lu.rcond() < 1e-14) return false;
    plan_->rest = lu.solve(constant_);
    return true;
  }

  void set_steps() {
    plan_->fastest_rad_per_s = fastest(plan_->generator);
    // Both limits decide the cost alone, since the bounds are made for whatever is the longest step. A
    // vibration of amplitude a and rate w has the bound M = a w^2, and M t^2 / 2 exceeds 2 a, all that it can
    // rise by, for t > 2 / w: steps much longer than a radian of the slowest one could not be certified. In
    // contact the fast vibration against the stop ends the mode within a few radians of its own, and where
    // the mode has no modal form its bounds are computed on a grid as fine as that. Measured for a limit of
    // 4, 8, 16, 32, 64 radians, on 8 speeds of a map: 5.8, 4.9, 4.5, 4.3, 4.3 steps per change of mode in
    // configs/figure06_set_b.yaml, and 9.2, 8.0, 7.7, 7.6, 8.0 in configs/rotor_kit.yaml. The first map takes
    // 0.37, 0.35, 0.35, 0.39, 1.2 s, and 4 s without a limit.
    plan_->longest_step_s = 1 / slowest(plan_->stiffness);
    if (!open()) plan_->longest_step_s = std::min(plan_->longest_step_s, 16 / plan_->fastest_rad_per_s);
    plan_->longest_steps_per_s = 1 / plan_->longest_step_s;
    form_ = modal_form(plan_->stiffness, plan_->damping);
    plan_->paired = form_.has_value();
    if (plan_->paired) {
      set_pairs();
    } else {
      plan_->basis.setIdentity(plan_->generator.rows(), plan_->generator.rows());
      plan_->inverse = plan_->basis;
      for (const Matrix& flow : matrix_flows(plan_->generator, plan_->longest_step_s))
        plan_->steps.emplace_back(flow);
    }
    plan_->diagonal_basis = plan_->basis.isDiagonal(0) && plan_->inverse.isDiagonal(0);
  }

  void set_pairs() {
    plan_->basis = form_->basis;
    plan_->inverse = form_->inverse;
    plan_->pairs.resize(system_.coordinates(), 4);
    for (Eigen::Index j = 0; j < system_.coordinates(); ++j) {
      const Pair& g = form_->pairs[static_cast<std::size_t>(j)];
      plan_->pairs.row(j) << g.uu, g.uv, g.vu, g.vv;
    }
    const PairSeries series = pair_series(form_->pairs, plan_->fastest_rad_per_s);
    plan_->unit_terms = series.unit;
    plan_->generator_terms = series.generator;
    determinant_ = plan_->pairs.col(0) * plan_->pairs.col(3) - plan_->pairs.col(1) * plan_->pairs.col(2);
    for (int k = 0; k < exact_step_count; ++k)
      plan_->pair_steps.push_back(flow_of_pairs(*plan_, plan_->longest_step_s * exact_step_size(k)));
  }

  /// Bound of |row . z(t)| over the longest step per size of z, for a row on z.
  Row bound(const Row& row) const {
    return form_ ? bound_of_row(*form_, row, plan_->longest_step_s)
                 : bound_of_flow(plan_->generator, row, plan_->longest_step_s, plan_->fastest_rad_per_s);
  }

  /// Rate of a row on z, again as a row on z.
  Row rate(const Row& row) const { return form_ ? rate_of_row(*form_, row) : Row(row * plan_->generator); }

  SeenPairs seen(const Row& on_free, const std::vector<bool>& fast) const {
    const Row by_time = rate(on_free);
    Eigen::Matrix<double, 4, Eigen::Dynamic> rows(4, on_free.size());
    rows << on_free, by_time, bound(rate(by_time)), bound(on_free);
    return seen_pairs(rows, fast);
  }

  std::vector<bool> all_pairs() const {
    return std::vector<bool>(static_cast<std::size_t>(system_.coordinates()), true);
  }

  Row by_u(const Row& row) const { return over_state(row, Row::Zero(row.size())); }
  Row by_v(const Row& row) const { return over_state(Row::Zero(row.size()), row); }

  void add_exits(std::size_t i) {
    const auto& c = system_.contacts[i];
    const Row p = by_u(c.first_row), v = by_v(c.first_row) * (c.damping / c.stiffness);
    switch (plan_->modes[i]) {
      case Mode::open:
        add_exit(i, c.damping > 0 ? Mode::clamped : Mode::sprung, p, -c.clearance);
        break;
      case Mode::clamped:
        add_exit(i, Mode::sprung, p - v, -c.clearance);
        break;
      case Mode::sprung:
        if (c.damping == 0) {
          add_exit(i, Mode::open, -p, c.clearance);
        } else {
          add_exit(i, Mode::clamped, v - p, c.clearance);
          add_exit(i, Mode::released, -p - v, c.clearance);
        }
        break;
      case Mode::released:
        add_exit(i, Mode::open, -p, c.clearance);
        add_exit(i, Mode::sprung, p + v, -c.clearance);
        break;
    }
  }

  void add_exit(std::size_t i, Mode next, const Row& row, double constant) {
    ExitPlan<N> exit;
    exit.contact = i;
    exit.next = next;
    exit.physical = row;
    const Row on_free = row * plan_->basis;
    exit.seen = seen(on_free, fast_pairs(on_free));
    exit.constant = constant + row.head(plan_->rest.size()) * plan_->rest;
    set_taylor(exit, on_free);
    plan_->exits.push_back(exit);
  }

  void set_taylor(ExitPlan<N>& exit, Row row) const {
    exit.taylor.setZero(series_rows, row.size());
    for (std::size_t k = 0; k < most_series_terms; ++k) {
      exit.taylor.row(static_cast<Eigen::Index>(k)) = row;
      row = rate(row) * (reciprocals[k + 1] / plan_->fastest_rad_per_s);
    }
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      if (!exit.taylor.col(j).isZero(0)) exit.columns.push_back(j);
    }
  }

  /// Pairs much faster than the slowest that the row sees; all, unless it sees some that are.
  std::vector<bool> fast_pairs(const Row& row) const {
    const Eigen::Index n = plan_->rest.size();
    if (!plan_->paired) return all_pairs();
    const auto size = [&](Eigen::Index j) { return std::hypot(row(j), row(n + j)); };
    const auto frequency = [&](Eigen::Index j) { return std::sqrt(std::abs(determinant_(j))); };
    double largest = 0, slowest_seen = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < n; ++j) largest = std::max(largest, size(j));
    for (Eigen::Index j = 0; j < n; ++j) {
      if (size(j) > 1e-6 * largest) slowest_seen = std::min(slowest_seen, frequency(j));
    }
    std::vector<bool> fast;
    bool split = false;
    for (Eigen::Index j = 0; j < n; ++j) {
      fast.push_back(frequency(j) >= fast_over_slow * slowest_seen);
      split = split || (fast.back() && size(j) > 0);
    }
    return split ? fast : all_pairs();
  }

  void add_ring(std::size_t i) {
    const auto& c = system_.contacts[i];
    RingPlan<N> ring;
    ring.contact = i;
    ring.speed_bound = ring.curvature_bound = Row::Zero(2 * plan_->rest.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const Row& on_u = k == 0 ? c.first_row : c.second_row;
      ring.physical[k] = by_u(on_u);
      ring.row[k] = ring.physical[k] * plan_->basis;
      ring.rate[k] = rate(ring.row[k]);
      ring.centre[k] = c.offset[k] + on_u * plan_->rest;
      ring.speed_bound += bound(ring.rate[k]).cwiseAbs2();
      ring.curvature_bound += bound(rate(ring.rate[k])).cwiseAbs2();
    }
    ring.speed_bound = ring.speed_bound.cwiseSqrt().eval();
    ring.curvature_bound = ring.curvature_bound.cwiseSqrt().eval();
    plan_->rings.push_back(ring);
  }

  void add_touch(std::size_t i) {
    const auto& c = system_.contacts[i];
    const Mode mode = plan_->modes[i];
    TouchPlan<N> touch;
    touch.contact = i;
    const Row force = spring_factor(mode) * c.stiffness * by_u(c.first_row) +
                      damper_factor(mode) * c.damping * by_v(c.first_row);
    touch.force = force;
    touch.force_constant =
        force.head(plan_->rest.size()) * plan_->rest - spring_factor(mode) * c.stiffness * c.clearance;
    touch.pushes = !force.isZero(0);
    if (touch.pushes) touch.force_of_free = seen(force * plan_->basis, all_pairs());
    plan_->pushes = plan_->pushes || touch.pushes;
    const Row sliding = by_v(c.second_row);
    touch.sliding = sliding;
    touch.sliding_rate_bound = bound(rate(sliding * plan_->basis));
    if (!plan_->paired && only_released()) {
      if (auto slip = released_slip(system_, friction_, plan_->modes, i, plan_->longest_step_s)) {
        touch.sliding_rate_bound = slip->sliding_rate_bound;
        touch.friction_rate = std::move(slip->friction_rate);
        touch.friction_swing = std::move(slip->friction_swing);
      }
    }
    plan_->touches.push_back(touch);
  }

  bool only_released() const {
    return std::all_of(plan_->modes.begin(), plan_->modes.end(),
                       [](Mode mode) { return mode == Mode::open || mode == Mode::released; });
  }

  const System& system_;
  const Frictions& friction_;
  std::unique_ptr<ModePlan<N>> plan_;
  Eigen::VectorXd constant_;
  std::optional<ModalForm> form_;
  Eigen::ArrayXd determinant_;  ///< of the pairs
};

}  // namespace

template <int N>
std::unique_ptr<ModePlan<N>> make_mode_plan(const System& system, const Frictions& friction,
                                            std::vector<Mode> modes) {
  return ModeBuilder<N>(system, friction, std::move(modes)).build();
}

template std::unique_ptr<ModePlan<2>> make_mode_plan<2>(const System&, const Frictions&, std::vector<Mode>);
template std::unique_ptr<ModePlan<4>> make_mode_plan<4>(const System&, const Frictions&, std::vector<Mode>);
template std::unique_ptr<ModePlan<6>> make_mode_plan<6>(const System&, const Frictions&, std::vector<Mode>);
template std::unique_ptr<ModePlan<Eigen::Dynamic>> make_mode_plan<Eigen::Dynamic>(const System&,
                                                                                  const Frictions&,
                                                                                  std::vector<Mode>);

}  // namespace rubsweep::integrate
