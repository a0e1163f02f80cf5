#include "rubsweep/integrate/exact/linear_mode.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "rubsweep/integrate/exact/mode_flow.hpp"
#include "rubsweep/integrate/exact/released_slip.hpp"
#include "rubsweep/numerics/eigenvalues.hpp"
#include "rubsweep/numerics/matrix_flow.hpp"
#include "rubsweep/numerics/modal_form.hpp"
#include "rubsweep/numerics/pair_series.hpp"
#include "rubsweep/numerics/step_table.hpp"

namespace rubsweep::integrate::exact {
namespace {

using contact::Mode;
using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVectorXd;

constexpr double fast_over_slow = 3;  ///< frequency ratio from which a pair counts as fast

/// The slowest oscillator's natural frequency, as if undamped.
double slowest(const Matrix& stiffness) {
  return std::sqrt(numerics::eigenvalues(stiffness).cwiseAbs().minCoeff());
}

Row over_state(const Row& by_u, const Row& by_v) {
  Row row(by_u.size() + by_v.size());
  row << by_u, by_v;
  return row;
}

/// Builds the linear mode of one joint contact mode.
template <int N>
class ModeBuilder {
  /// Large structures would take longer than what it gains for them.
  static constexpr bool unrounded = N != Eigen::Dynamic;
  using Number = std::conditional_t<unrounded, long double, double>;
  using LongOrDouble = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  using Column = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

 public:
  ModeBuilder(const CommonToModes& common, const std::vector<Mode>& modes, const std::vector<bool>& backward)
      : common_(common),
        system_(common.system),
        backward_(backward),
        mode_(std::make_unique<LinearMode<N>>()) {
    mode_->modes = modes;
  }

  std::unique_ptr<LinearMode<N>> build() {
    assemble();
    if (!find_rest()) return nullptr;
    set_steps();
    for (std::size_t i = 0; i < mode_->modes.size(); ++i) {
      mode_->closing.push_back(by_v(system_.contacts[i].first_row) * mode_->generator);
      std::visit(overloaded{[&](const contact::FlatWall&) {
                              add_guards(i);
                              if (mode_->modes[i] != Mode::open) add_touch(i);
                            },
                            [&](const contact::AnnularWall&) { add_annular_guard(i); }},
                 system_.contacts[i].wall);
    }
    for (const auto& casing : system_.casings) add_casing(casing.map);
    return std::move(mode_);
  }

 private:
  bool open() const {
    for (const Mode mode : mode_->modes) {
      if (mode != Mode::open) return false;
    }
    return true;
  }

  double way(std::size_t i) const { return backward_[i] ? -1 : 1; }

  void assemble() {
    LongOrDouble stiffness = system_.stiffness.template cast<Number>(),
                 damping = system_.damping.template cast<Number>();
    constant_ = system_.constant.template cast<Number>();
    for (std::size_t i = 0; i < mode_->modes.size(); ++i) {
      const auto& c = system_.contacts[i];
      const Mode mode = mode_->modes[i];
      if (mode == Mode::open) continue;
      const contact::LinearLaw law = contact::law_of(mode);
      const Number coefficient = law.friction * way(i) * common_.friction[i].coefficient;
      const Column first_push = c.first_push.template cast<Number>(),
                   second_push = c.second_push.template cast<Number>();
      const Column push = Number{c.stiffness} * (Number{law.spring} * first_push + coefficient * second_push);
      const auto first_row = c.first_row.template cast<Number>();
      stiffness -= push * first_row;
      damping -= Number{law.damper * c.damping} * first_push * first_row;
      constant_ -= push * Number{c.clearance};
    }
    mode_->stiffness = stiffness.template cast<double>();
    mode_->damping = damping.template cast<double>();
    mode_->generator = numerics::generator_of(mode_->stiffness, mode_->damping);
    if constexpr (unrounded) {
      mode_->unrounded.stiffness = stiffness;
      mode_->unrounded.damping = damping;
    }
  }

  bool find_rest() {
    const Eigen::FullPivLU<Matrix> lu(mode_->stiffness);
    if (!lu.isInvertible() || lu.rcond() < 1e-14) return false;
    if constexpr (unrounded) {
      mode_->unrounded.rest = mode_->unrounded.stiffness.fullPivLu().solve(constant_);
      mode_->rest = mode_->unrounded.rest.template cast<double>();
    } else {
      mode_->rest = lu.solve(constant_);
    }
    return true;
  }

  std::optional<numerics::ModalForm> modal_form_in_contact() const {
    if constexpr (unrounded)
      return numerics::modal_form_of_unrounded(mode_->unrounded.stiffness, mode_->unrounded.damping);
    else
      return numerics::modal_form(mode_->stiffness, mode_->damping);
  }

  void set_steps() {
    mode_->fastest_rad_per_s = numerics::spectral_radius(mode_->generator);
    // Both limits decide the cost alone, since the bounds are made for whatever is the longest step. A
    // vibration of amplitude a and rate w has the bound M = a w^2, and M t^2 / 2 exceeds 2 a, all that it can
    // rise by, for t > 2 / w: steps much longer than a radian of the slowest one could not be certified. In
    // contact the fast vibration against the stop ends the mode within a few radians of its own, and where
    // the mode has no modal form its bounds are computed on a grid as fine as that. Measured for a limit of
    // 4, 8, 16, 32, 64 radians, on 8 speeds of a map: 5.8, 4.9, 4.5, 4.3, 4.3 steps per change of mode in
    // configs/figure06_set_b.yaml, and 9.2, 8.0, 7.7, 7.6, 8.0 in configs/rotor_kit.yaml. The first map takes
    // 0.37, 0.35, 0.35, 0.39, 1.2 s, and 4 s without a limit.
    mode_->longest_step_s = 1 / slowest(mode_->stiffness);
    if (!open()) mode_->longest_step_s = std::min(mode_->longest_step_s, 16 / mode_->fastest_rad_per_s);
    mode_->longest_steps_per_s = 1 / mode_->longest_step_s;
    form_ = open() ? common_.open_form : modal_form_in_contact();
    mode_->paired = form_.has_value();
    if (mode_->paired) {
      set_pairs();
    } else {
      basis_.setIdentity(mode_->generator.rows(), mode_->generator.rows());
      inverse_ = basis_;
      mode_->steps = {mode_->generator, mode_->longest_step_s};
      flow_bound_.emplace(mode_->generator, mode_->longest_step_s, mode_->fastest_rad_per_s);
    }
    if constexpr (unrounded) {
      mode_->unrounded.basis = form_ ? form_->unrounded_basis : basis_.template cast<long double>();
      mode_->unrounded.inverse = form_ ? form_->unrounded_inverse : inverse_.template cast<long double>();
    }
    mode_->diagonal_basis = basis_.isDiagonal(0) && inverse_.isDiagonal(0);
    mode_->basis = typename ExactTypes<N>::Factor(basis_);
    mode_->inverse = typename ExactTypes<N>::Factor(inverse_);
  }

  void set_pairs() {
    basis_ = form_->basis;
    inverse_ = form_->inverse;
    mode_->pairs.resize(system_.coordinates(), 4);
    for (Eigen::Index j = 0; j < system_.coordinates(); ++j) {
      const numerics::Pair& g = form_->pairs[static_cast<std::size_t>(j)];
      mode_->pairs.row(j) << g.uu, g.uv, g.vu, g.vv;
    }
    const numerics::PairSeries series = numerics::pair_series(form_->pairs, mode_->fastest_rad_per_s);
    mode_->unit_terms = series.unit;
    mode_->generator_terms = series.generator;
    determinant_ = mode_->pairs.col(0) * mode_->pairs.col(3) - mode_->pairs.col(1) * mode_->pairs.col(2);
    for (int k = 0; k < numerics::exact_step_count; ++k)
      mode_->pair_steps.push_back(
          flow_of_pairs(*mode_, mode_->longest_step_s * numerics::exact_step_size(k)));
  }

  /// Bound of |row . z(t)| over the longest step per size of z, for a row on z.
  Row bound(const Row& row) const {
    return form_ ? numerics::bound_of_row(*form_, row, mode_->longest_step_s) : flow_bound_->of(row);
  }

  /// Rate of a row on z, again as a row on z.
  Row rate(const Row& row) const {
    return form_ ? numerics::rate_of_row(*form_, row) : Row(row * mode_->generator);
  }

  ModalTerms terms_of(const Row& on_free, const std::vector<bool>& fast) const {
    const Row by_time = rate(on_free);
    Eigen::Matrix<double, 4, Eigen::Dynamic> rows(4, on_free.size());
    rows << on_free, by_time, bound(rate(by_time)), bound(on_free);
    return modal_terms(rows, fast);
  }

  std::vector<bool> all_pairs() const {
    return std::vector<bool>(static_cast<std::size_t>(system_.coordinates()), true);
  }

  Row by_u(const Row& row) const { return over_state(row, Row::Zero(row.size())); }
  Row by_v(const Row& row) const { return over_state(Row::Zero(row.size()), row); }

  void add_guards(std::size_t i) {
    const auto& c = system_.contacts[i];
    const Row p = by_u(c.first_row), v = by_v(c.first_row) * (c.damping / c.stiffness);
    const contact::GuardForms forms = contact::guard_forms(mode_->modes[i], c.damping > 0);
    for (int k = 0; k < forms.count; ++k) {
      const auto [spring, damper, next] = forms.list[static_cast<std::size_t>(k)];
      add_guard(i, next, damper == 0 ? Row(spring * p) : Row(spring * p + damper * v), -spring * c.clearance);
    }
  }

  void add_guard(std::size_t i, Mode next, const Row& row, double constant) {
    LinearGuard<N> guard;
    guard.contact = i;
    guard.next = next;
    guard.physical = row;
    const Row on_free = row * basis_;
    guard.terms = terms_of(on_free, fast_pairs(on_free));
    guard.constant = constant + row.head(mode_->rest.size()) * mode_->rest;
    set_taylor(guard, on_free);
    mode_->guards.push_back(guard);
  }

  void set_taylor(LinearGuard<N>& guard, Row row) const {
    guard.taylor.setZero(numerics::series_rows, row.size());
    for (std::size_t k = 0; k < numerics::most_series_terms; ++k) {
      guard.taylor.row(static_cast<Eigen::Index>(k)) = row;
      row = rate(row) * (numerics::reciprocals[k + 1] / mode_->fastest_rad_per_s);
    }
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      if (!guard.taylor.col(j).isZero(0)) guard.columns.push_back(j);
    }
  }

  /// Pairs much faster than the slowest that the row sees; all, unless it sees some that are.
  std::vector<bool> fast_pairs(const Row& row) const {
    const Eigen::Index n = mode_->rest.size();
    if (!mode_->paired) return all_pairs();
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

  void add_annular_guard(std::size_t i) {
    const auto& c = system_.contacts[i];
    AnnularGuard<N> guard;
    guard.contact = i;
    guard.speed_bound = guard.curvature_bound = Row::Zero(2 * mode_->rest.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const Row& on_u = k == 0 ? c.first_row : c.second_row;
      guard.physical[k] = by_u(on_u);
      guard.row[k] = guard.physical[k] * basis_;
      guard.rate[k] = rate(guard.row[k]);
      guard.centre[k] = c.offset[k] + on_u * mode_->rest;
      guard.speed_bound += bound(guard.rate[k]).cwiseAbs2();
      guard.curvature_bound += bound(rate(guard.rate[k])).cwiseAbs2();
    }
    guard.speed_bound = guard.speed_bound.cwiseSqrt().eval();
    guard.curvature_bound = guard.curvature_bound.cwiseSqrt().eval();
    mode_->annular_guards.push_back(guard);
  }

  void add_touch(std::size_t i) {
    const auto& c = system_.contacts[i];
    TouchWatch<N> touch;
    touch.contact = i;
    touch.way = way(i);
    const contact::LinearLaw law = contact::law_of(mode_->modes[i]);
    const Row force =
        law.spring * c.stiffness * by_u(c.first_row) + law.damper * c.damping * by_v(c.first_row);
    touch.force = force;
    touch.force_constant =
        force.head(mode_->rest.size()) * mode_->rest - law.spring * c.stiffness * c.clearance;
    touch.pushes = !force.isZero(0);
    if (touch.pushes) touch.force_of_free = terms_of(force * basis_, all_pairs());
    mode_->pushes = mode_->pushes || touch.pushes;
    const Row sliding = by_v(c.second_row);
    touch.sliding = sliding;
    touch.sliding_of_free = terms_of(sliding * basis_, all_pairs());
    touch.sliding_rate_bound = bound(rate(sliding * basis_));
    if (!mode_->paired && only_released()) {
      if (auto slip = released_slip(common_, mode_->modes, i, mode_->longest_step_s)) {
        touch.sliding_rate_bound = slip->sliding_rate_bound;
        touch.friction_rate = std::move(slip->friction_rate);
        touch.friction_swing = std::move(slip->friction_swing);
      }
    }
    mode_->touches.push_back(touch);
  }

  void add_casing(const Eigen::Matrix<double, 2, Eigen::Dynamic>& map) {
    CasingView<N> casing;
    casing.map = map;
    casing.rest = map * mode_->rest;
    Eigen::Matrix<double, 4, Eigen::Dynamic> rows = Matrix::Zero(4, 2 * map.cols());
    rows.topLeftCorner(2, map.cols()) = map;
    rows.bottomRightCorner(2, map.cols()) = map;
    casing.of_free = decltype(casing.of_free)(rows * basis_);
    mode_->casings.push_back(std::move(casing));
  }

  bool only_released() const {
    return std::all_of(mode_->modes.begin(), mode_->modes.end(),
                       [](Mode mode) { return mode == Mode::open || mode == Mode::released; });
  }

  const CommonToModes& common_;
  const run::ScaledSystem<Eigen::Dynamic>& system_;
  const std::vector<bool>& backward_;
  std::unique_ptr<LinearMode<N>> mode_;
  Column constant_;
  std::optional<numerics::ModalForm> form_;
  std::optional<numerics::FlowBound> flow_bound_;  ///< where there is none
  Eigen::ArrayXd determinant_;                     ///< of the pairs
  typename ExactTypes<N>::Flow basis_, inverse_;   ///< those of the mode
};

}  // namespace

template <int N>
std::unique_ptr<LinearMode<N>> make_linear_mode(const CommonToModes& common, const std::vector<Mode>& modes,
                                                const std::vector<bool>& backward) {
  return ModeBuilder<N>(common, modes, backward).build();
}

template std::unique_ptr<LinearMode<2>> make_linear_mode<2>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<4>> make_linear_mode<4>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<6>> make_linear_mode<6>(const CommonToModes&, const std::vector<Mode>&,
                                                            const std::vector<bool>&);
template std::unique_ptr<LinearMode<Eigen::Dynamic>> make_linear_mode<Eigen::Dynamic>(
    const CommonToModes&, const std::vector<Mode>&, const std::vector<bool>&);

}  // namespace rubsweep::integrate::exact
