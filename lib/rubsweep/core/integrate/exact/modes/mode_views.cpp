#include "rubsweep/core/integrate/exact/modes/mode_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/exact/modes/released_slip.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using contact::Mode;
using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVectorXd;

constexpr double fast_over_slow = 3;  ///< smallest frequency ratio of a fast pair

Row over_state(const Row& by_u, const Row& by_v) {
  Row row(by_u.size() + by_v.size());
  row << by_u, by_v;
  return row;
}

template <int N>
class ViewBuilder {
 public:
  ViewBuilder(const CommonToModes& common, const std::vector<bool>& backward,
              const FreeVibration<N>& vibration, LinearMode<N>& mode)
      : common_(common), system_(common.system), backward_(backward), vibration_(vibration), mode_(mode) {
    if (mode.paired)
      determinant_ = mode.pairs.col(0) * mode.pairs.col(3) - mode.pairs.col(1) * mode.pairs.col(2);
  }

  void build() {
    for (std::size_t i = 0; i < mode_.modes.size(); ++i) {
      mode_.closing.push_back(by_v(system_.contacts[i].first_row) * mode_.generator);
      const contact::Wall& wall = system_.contacts[i].wall;
      if (contact::annular(wall)) {
        add_annular_guard(i);
        continue;
      }
      if (!contact::linear(wall))
        throw ConfigError("solver.method: exact knows no stop of this kind, allowed: auto");
      add_guards(i);
      if (mode_.modes[i] != Mode::open) add_touch(i);
    }
    for (const auto& casing : system_.casings) add_casing(casing.map);
  }

 private:
  /// Bound of |row . z(t)| over the longest step, per size of z.
  Row bound(const Row& row) const {
    return vibration_.form ? numerics::bound_of_row(*vibration_.form, row, mode_.longest_step_s)
                           : vibration_.flow_bound->of(row);
  }

  /// Row on z that gives the time derivative of row . z.
  Row rate(const Row& row) const {
    return vibration_.form ? numerics::rate_of_row(*vibration_.form, row) : Row(row * mode_.generator);
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
    const contact::GuardForms forms = contact::guard_forms(mode_.modes[i], c.damping > 0);
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
    const Row on_free = row * vibration_.basis;
    guard.terms = terms_of(on_free, fast_pairs(on_free));
    guard.constant = constant + row.head(mode_.rest.size()) * mode_.rest;
    set_taylor(guard, on_free);
    mode_.guards.push_back(guard);
  }

  void set_taylor(LinearGuard<N>& guard, Row row) const {
    guard.taylor.setZero(numerics::series_rows, row.size());
    for (std::size_t k = 0; k < numerics::most_series_terms; ++k) {
      guard.taylor.row(static_cast<Eigen::Index>(k)) = row;
      row = rate(row) * (numerics::reciprocals[k + 1] / mode_.fastest_rad_per_s);
    }
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      if (!guard.taylor.col(j).isZero(0)) guard.columns.push_back(j);
    }
  }

  /// Whether each pair is much faster than the slowest pair in the row; all true if none is.
  std::vector<bool> fast_pairs(const Row& row) const {
    const Eigen::Index n = mode_.rest.size();
    if (!mode_.paired) return all_pairs();
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
    guard.speed_bound = guard.curvature_bound = Row::Zero(2 * mode_.rest.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const Row& on_u = k == 0 ? c.first_row : c.second_row;
      guard.physical[k] = by_u(on_u);
      guard.row[k] = guard.physical[k] * vibration_.basis;
      guard.rate[k] = rate(guard.row[k]);
      guard.centre[k] = c.offset[k] + on_u * mode_.rest;
      guard.speed_bound += bound(guard.rate[k]).cwiseAbs2();
      guard.curvature_bound += bound(rate(guard.rate[k])).cwiseAbs2();
    }
    guard.speed_bound = guard.speed_bound.cwiseSqrt().eval();
    guard.curvature_bound = guard.curvature_bound.cwiseSqrt().eval();
    mode_.annular_guards.push_back(guard);
  }

  void add_touch(std::size_t i) {
    const auto& c = system_.contacts[i];
    TouchWatch<N> touch;
    touch.contact = i;
    touch.way = backward_[i] ? -1 : 1;
    const contact::LinearLaw law = contact::law_of(mode_.modes[i]);
    const Row force =
        law.spring * c.stiffness * by_u(c.first_row) + law.damper * c.damping * by_v(c.first_row);
    touch.force = force;
    touch.force_constant =
        force.head(mode_.rest.size()) * mode_.rest - law.spring * c.stiffness * c.clearance;
    touch.pushes = !force.isZero(0);
    if (touch.pushes) touch.force_of_free = terms_of(force * vibration_.basis, all_pairs());
    mode_.pushes = mode_.pushes || touch.pushes;
    const Row sliding = by_v(c.second_row);
    touch.sliding = sliding;
    touch.sliding_of_free = terms_of(sliding * vibration_.basis, all_pairs());
    touch.sliding_rate_bound = bound(rate(sliding * vibration_.basis));
    if (!mode_.paired && only_released()) {
      if (auto slip = released_slip(common_, mode_.modes, i, mode_.longest_step_s)) {
        touch.sliding_rate_bound = slip->sliding_rate_bound;
        touch.friction_rate = std::move(slip->friction_rate);
        touch.friction_swing = std::move(slip->friction_swing);
      }
    }
    mode_.touches.push_back(touch);
  }

  void add_casing(const Eigen::Matrix<double, 2, Eigen::Dynamic>& map) {
    CasingView<N> casing;
    casing.map = map;
    casing.rest = map * mode_.rest;
    Eigen::Matrix<double, 4, Eigen::Dynamic> rows = Matrix::Zero(4, 2 * map.cols());
    rows.topLeftCorner(2, map.cols()) = map;
    rows.bottomRightCorner(2, map.cols()) = map;
    casing.of_free = decltype(casing.of_free)(rows * vibration_.basis);
    mode_.casings.push_back(std::move(casing));
  }

  bool only_released() const {
    return std::all_of(mode_.modes.begin(), mode_.modes.end(),
                       [](Mode mode) { return mode == Mode::open || mode == Mode::released; });
  }

  const CommonToModes& common_;
  const run::ScaledSystem<Eigen::Dynamic>& system_;
  const std::vector<bool>& backward_;
  const FreeVibration<N>& vibration_;
  LinearMode<N>& mode_;
  Eigen::ArrayXd determinant_;  ///< determinant of each pair
};

}  // namespace

template <int N>
void add_views(const CommonToModes& common, const std::vector<bool>& backward,
               const FreeVibration<N>& vibration, LinearMode<N>& mode) {
  ViewBuilder<N>(common, backward, vibration, mode).build();
}

template void add_views(const CommonToModes&, const std::vector<bool>&, const FreeVibration<2>&,
                        LinearMode<2>&);
template void add_views(const CommonToModes&, const std::vector<bool>&, const FreeVibration<4>&,
                        LinearMode<4>&);
template void add_views(const CommonToModes&, const std::vector<bool>&, const FreeVibration<6>&,
                        LinearMode<6>&);
template void add_views(const CommonToModes&, const std::vector<bool>&, const FreeVibration<Eigen::Dynamic>&,
                        LinearMode<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate::exact::modes
