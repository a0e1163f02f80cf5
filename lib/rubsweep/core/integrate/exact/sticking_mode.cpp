#include "rubsweep/core/integrate/exact/sticking_mode.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::integrate::exact {
namespace {

using Complex = std::complex<double>;
using Row = Eigen::RowVectorXd;

constexpr double independent = 1e-10;       ///< smallest independent mobility, as a share of the largest
constexpr double largest_amplitude = 1e4;   ///< largest forced amplitude in clearances
constexpr double least_reciprocal = 1e-14;  ///< least reciprocal condition of a stiffness with an equilibrium

}  // namespace

Eigen::MatrixXd StickingMode::take_contacts(const System& system, const std::vector<contact::Mode>& modes,
                                            const std::vector<bool>& sticks, const std::vector<double>& ways,
                                            Eigen::Index count) {
  stiffness_ = system.stiffness;
  damping_ = system.damping;
  constant_ = system.constant;
  drive_ = system.cosine.cast<Complex>() - Complex(0, 1) * system.sine.cast<Complex>();
  rows_.resize(count, system.coordinates());
  Eigen::MatrixXd pushes(system.coordinates(), count);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& c = system.contacts[i];
    if (modes[i] == contact::Mode::open) continue;
    const contact::LinearLaw law = contact::law_of(modes[i]);
    const double friction = ways[i] * contact::dry_coefficient(c.friction) * law.friction;
    const Eigen::VectorXd push = law.spring * c.first_push + friction * c.second_push;
    stiffness_ -= c.stiffness * push * c.first_row;
    damping_ -= law.damper * c.damping * c.first_push * c.first_row;
    constant_ -= c.stiffness * c.clearance * push;
    if (!sticks[i]) continue;
    rows_.row(next) = c.second_row;
    pushes.col(next++) = c.second_push;
  }
  return pushes;
}

bool StickingMode::solve_vibration(const Eigen::MatrixXd& q, const Eigen::MatrixXd& along) {
  const Eigen::Index k = q.cols();
  const Eigen::MatrixXd a = to_y_ * stiffness_ * q, c = to_y_ * damping_ * q;
  const numerics::dense::FullPivotFactors lu(a);
  if (!lu.invertible() || lu.reciprocal_condition() < least_reciprocal) return false;
  const Eigen::MatrixXd by_drift = -lu.solve(Eigen::MatrixXd(to_y_ * stiffness_ * along));
  on_drift_ += q * by_drift;
  on_drift_rate_ = -q * lu.solve(Eigen::MatrixXd(to_y_ * damping_ * along + c * by_drift));
  rest_ = q * lu.solve(Eigen::VectorXd(to_y_ * constant_));
  Eigen::MatrixXcd dynamic = a.cast<Complex>() + Complex(0, 1) * c.cast<Complex>();
  dynamic.diagonal().array() -= 1.0;
  const Eigen::VectorXcd side = to_y_.cast<Complex>() * drive_;
  if (!side.isZero(0)) {
    amplitude_ = q.cast<Complex>() * numerics::dense::solve_full_pivot(dynamic, side);
    if (!amplitude_.allFinite() || amplitude_.cwiseAbs().maxCoeff() > largest_amplitude) return false;
  }
  form_ = numerics::modal_form(a, c);
  if (!form_) return false;
  basis_u_ = q * form_->basis.topRows(k);
  basis_v_ = q * form_->basis.bottomRows(k);
  for (Eigen::Index j = 0; j < k; ++j) {
    const numerics::Pair& g = form_->pairs[static_cast<std::size_t>(j)];
    rates_(j) = std::max(std::hypot(g.uu, g.uv), std::hypot(g.vu, g.vv));
  }
  return true;
}

std::optional<StickingMode> StickingMode::make(const System& system, const std::vector<contact::Mode>& modes,
                                               const std::vector<bool>& sticks,
                                               const std::vector<double>& ways) {
  const Eigen::Index n = system.coordinates();
  const auto m = static_cast<Eigen::Index>(std::ranges::count(sticks, true));
  if (m == 0 || m > n) return std::nullopt;
  const auto always = [](const auto& pulse) { return pulse.always_elapsed.has_value(); };
  if (std::ranges::any_of(system.pulses, always)) return std::nullopt;
  StickingMode mode;
  const Eigen::MatrixXd pushes = mode.take_contacts(system, modes, sticks, ways, m);
  const numerics::dense::FullPivotFactors mobility(mode.rows_ * pushes);
  if (mobility.reciprocal_condition() < independent) return std::nullopt;
  mode.hold_ = mobility.solve(mode.rows_);
  const Eigen::MatrixXd along = pushes * mobility.inverse();

  const Eigen::Index k = n - m;
  const Eigen::MatrixXd q =
      k > 0 ? numerics::dense::FullPivotFactors(mode.rows_).kernel() : Eigen::MatrixXd(n, 0);
  if (q.cols() != k) return std::nullopt;
  mode.project_ = Eigen::MatrixXd::Identity(n, n) - along * mode.rows_;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Row row = system.contacts[i].second_row;
    if (ways[i] != 0 && (row * mode.project_).norm() > independent * row.norm()) return std::nullopt;
  }
  mode.on_drift_ = along;
  mode.on_drift_rate_ = Eigen::MatrixXd::Zero(n, m);
  mode.rest_ = Eigen::VectorXd::Zero(n);
  mode.amplitude_ = Eigen::VectorXcd::Zero(n);
  mode.basis_u_ = mode.basis_v_ = Eigen::MatrixXd(n, 2 * k);
  mode.rates_.resize(k);
  mode.to_y_.resize(k, n);
  if (k > 0) {
    mode.to_y_ = numerics::dense::SymmetricFactors(q.transpose() * q).solve(Eigen::MatrixXd(q.transpose())) *
                 mode.project_;
    if (!mode.solve_vibration(q, along)) return std::nullopt;
  }
  mode.add_guards(system, modes, sticks);
  mode.add_rings(system, sticks, along);
  return mode;
}

/// Along a turned tangent, the friction lambda also pushes along -n. The slip stays zero if t . d'' is the
/// angle times n . d''. The normal force along a turned normal has a component along t, which friction
/// balances.
void StickingMode::add_rings(const System& system, const std::vector<bool>& sticks,
                             const Eigen::MatrixXd& along) {
  Eigen::Index held = 0;
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    if (!sticks[i]) continue;
    const auto& c = system.contacts[i];
    if (contact::annular(c.wall))
      rings_.push_back(
          {held, c.first_row, c.offset[0],
           project_ * c.first_push * hold_.row(held) + along.col(held) * c.first_row * project_});
    ++held;
  }
}

void StickingMode::add_guards(const System& system, const std::vector<contact::Mode>& modes,
                              const std::vector<bool>& sticks) {
  const Row none = Row::Zero(system.coordinates());
  Eigen::Index held = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& c = system.contacts[i];
    const contact::GuardForms forms = contact::guard_forms(modes[i], c.damping > 0);
    for (int e = 0; e < forms.count; ++e) {
      const auto [spring, damper, to] = forms.list[static_cast<std::size_t>(e)];
      guards_.push_back({i, view(spring * c.stiffness * c.first_row,
                                 damper == 0 ? none : Row(damper * c.damping * c.first_row),
                                 -spring * c.stiffness * c.clearance, 0)});
    }
    if (modes[i] == contact::Mode::open) continue;
    const contact::LinearLaw law = contact::law_of(modes[i]);
    forces_.push_back(view(law.spring * c.stiffness * c.first_row, law.damper * c.damping * c.first_row,
                           -law.spring * c.stiffness * c.clearance, 0));
    if (!sticks[i]) continue;
    const double limit = contact::holding_coefficient(c.friction) * law.friction * c.stiffness;
    const Row hold = hold_.row(held++);
    const Complex drive = -(hold.cast<Complex>() * drive_)(0);
    for (const double way : {1.0, -1.0})
      guards_.push_back({i, view(way * hold * stiffness_ - limit * c.first_row, way * hold * damping_,
                                 limit * c.clearance - way * hold.dot(constant_.transpose()), way * drive)});
  }
}

StickingView StickingMode::view(const Row& by_u, const Row& by_v, double constant, Complex direct) const {
  StickingView view;
  view.constant = constant + by_u.dot(rest_.transpose());
  view.on_drift = by_u * on_drift_;
  view.on_drift_rate = by_u * on_drift_rate_ + by_v * on_drift_;
  view.harmonic = direct + (by_u.cast<Complex>() * amplitude_)(0) +
                  Complex(0, 1) * (by_v.cast<Complex>() * amplitude_)(0);
  view.on_free = by_u * basis_u_ + by_v * basis_v_;
  if (!form_) return view;
  view.rate_on_free = numerics::rate_of_row(*form_, view.on_free);
  view.size = numerics::bound_of_row(*form_, view.on_free, 0).head(pairs());
  view.curvature =
      numerics::bound_of_row(*form_, numerics::rate_of_row(*form_, view.rate_on_free), 0).head(pairs());
  return view;
}

void StickingMode::begin(double phase_rad, const Eigen::Ref<const Eigen::VectorXd>& state,
                         StickingMotion& motion) const {
  const Eigen::Index n = rest_.size(), k = pairs();
  motion.phase_rad = phase_rad;
  motion.drift = rows_ * state.head(n);
  motion.drift_rate = rows_ * state.tail(n);
  // Taylor pieces leave a slip of the size of rounding, which would add up over a whole turn.
  for (const Ring& ring : rings_) motion.drift_rate(ring.held) = 0;
  motion.free.resize(2 * k);
  if (k == 0) return;
  const Complex phasor = std::polar(1.0, phase_rad);
  const Eigen::VectorXd u = state.head(n) - rest_ - on_drift_ * motion.drift -
                            on_drift_rate_ * motion.drift_rate - (amplitude_ * phasor).real();
  const Eigen::VectorXd v =
      state.tail(n) - on_drift_ * motion.drift_rate - (amplitude_ * (Complex(0, 1) * phasor)).real();
  motion.free = form_->inverse.leftCols(k) * (to_y_ * u) + form_->inverse.rightCols(k) * (to_y_ * v);
}

void StickingMode::put_flows(double duration_rad, std::vector<numerics::Pair>& flows) const {
  flows.clear();
  if (!form_) return;
  for (const numerics::Pair& generator : form_->pairs)
    flows.push_back(numerics::pair_flow(generator, duration_rad));
}

void StickingMode::move_free(const std::vector<numerics::Pair>& flows,
                             Eigen::Ref<Eigen::VectorXd> free) const {
  const Eigen::Index k = pairs();
  for (Eigen::Index j = 0; j < k; ++j) {
    const numerics::Pair& f = flows[static_cast<std::size_t>(j)];
    const double a = free(j), b = free(k + j);
    free(j) = f.uu * a + f.uv * b;
    free(k + j) = f.vu * a + f.vv * b;
  }
}

void StickingMode::move(double duration_rad, const std::vector<numerics::Pair>& flows,
                        StickingMotion& motion) const {
  move_free(flows, motion.free);
  motion.drift += duration_rad * motion.drift_rate;
  motion.phase_rad += duration_rad;
}

void StickingMode::put_state(const StickingMotion& motion, Eigen::Ref<Eigen::VectorXd> state) const {
  const Eigen::Index n = rest_.size();
  const Complex phasor = std::polar(1.0, motion.phase_rad);
  state.head(n) = rest_ + on_drift_ * motion.drift + on_drift_rate_ * motion.drift_rate +
                  (amplitude_ * phasor).real() + basis_u_ * motion.free;
  state.tail(n) =
      on_drift_ * motion.drift_rate + (amplitude_ * (Complex(0, 1) * phasor)).real() + basis_v_ * motion.free;
}

/// Tangent vector of the motion, zero at first, excited by `force` times the accelerations without friction:
/// a part of the exponential of one matrix for w, u, 1, w', u', cos, sin.
Eigen::VectorXd StickingMode::by_turned_normal(const Eigen::MatrixXd& force, double duration_rad,
                                               const StickingMotion& motion) const {
  const Eigen::Index n = rest_.size(), half = 2 * n + 1, size = 2 * half + 1;
  Eigen::MatrixXd loose = Eigen::MatrixXd::Zero(n, size);
  loose.middleCols(n, n) = -stiffness_;
  loose.col(2 * n) = constant_;
  loose.middleCols(half + n, n) = -damping_;
  loose.col(size - 2) = drive_.real();
  loose.col(size - 1) = -drive_.imag();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(size, size);
  generator.block(0, half, 2 * n, 2 * n).setIdentity();
  generator.middleRows(half, n) = force * loose;
  generator.block(half, 0, n, n) = -project_ * stiffness_;
  generator.block(half, half, n, n) = -project_ * damping_;
  generator.middleRows(half + n, n) = project_ * loose;
  generator(size - 2, size - 1) = -1;
  generator(size - 1, size - 2) = 1;
  Eigen::VectorXd state(2 * n), all = Eigen::VectorXd::Zero(size);
  put_state(motion, state);
  all.segment(n, n) = state.head(n);
  all(2 * n) = 1;
  all.segment(half + n, n) = state.tail(n);
  all.tail(2) << std::cos(motion.phase_rad), std::sin(motion.phase_rad);
  const Eigen::VectorXd moved = numerics::matrix_flow(generator, duration_rad) * all;
  Eigen::VectorXd change(2 * n);
  change << moved.head(n), moved.segment(half, n);
  return change;
}

void StickingMode::move_tangents(double duration_rad, const std::vector<numerics::Pair>& flows,
                                 const StickingMotion& motion, Eigen::MatrixXd& tangents) const {
  if (tangents.cols() == 0) return;
  const Eigen::Index n = rest_.size(), k = pairs();
  Eigen::MatrixXd by_rings = Eigen::MatrixXd::Zero(2 * n, rings_.empty() ? 0 : tangents.cols());
  for (const Ring& ring : rings_) {
    Eigen::VectorXd state(2 * n);
    put_state(motion, state);
    const double distance = ring.first_row.dot(state.head(n).transpose()) + ring.offset;
    by_rings += by_turned_normal(ring.change, duration_rad, motion) * rows_.row(ring.held) *
                tangents.topRows(n) / distance;
  }
  for (Eigen::Index column = 0; column < tangents.cols(); ++column) {
    Eigen::VectorXd drift = rows_ * tangents.col(column).head(n);
    const Eigen::VectorXd drift_rate = rows_ * tangents.col(column).tail(n);
    const Eigen::VectorXd u = tangents.col(column).head(n) - on_drift_ * drift - on_drift_rate_ * drift_rate;
    const Eigen::VectorXd v = tangents.col(column).tail(n) - on_drift_ * drift_rate;
    Eigen::VectorXd free(2 * k);
    if (k > 0) free = form_->inverse.leftCols(k) * (to_y_ * u) + form_->inverse.rightCols(k) * (to_y_ * v);
    move_free(flows, free);
    drift += duration_rad * drift_rate;
    tangents.col(column).head(n) = on_drift_ * drift + on_drift_rate_ * drift_rate + basis_u_ * free;
    tangents.col(column).tail(n) = on_drift_ * drift_rate + basis_v_ * free;
  }
  if (!rings_.empty()) tangents += by_rings;
}

ValueAndRate value_of(const StickingView& view, const StickingMotion& motion) {
  const Complex harmonic = view.harmonic * std::polar(1.0, motion.phase_rad);
  ValueAndRate sum{view.constant + view.on_drift.dot(motion.drift.transpose()) +
                       view.on_drift_rate.dot(motion.drift_rate.transpose()) + harmonic.real(),
                   view.on_drift.dot(motion.drift_rate.transpose()) - harmonic.imag()};
  if (motion.free.size() == 0) return sum;
  sum.value += view.on_free.dot(motion.free.transpose());
  sum.rate += view.rate_on_free.dot(motion.free.transpose());
  return sum;
}

}  // namespace rubsweep::integrate::exact
