#include "rubsweep/integrate/exact_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubsweep::integrate {
namespace {

/// A forced amplitude beyond this many clearances comes from a resonance that nothing damps: the cancellation
/// against the free part would cost digits.
constexpr double largest_amplitude = 1e4;

using detail::product;
using detail::real_product;
using Complex = std::complex<double>;

/// Terms after which the series of e^{A t} is exact to rounding, |A t| = `size` <= 1/4.
int series_terms(double size) {
  if (size > 0.1) return 12;
  if (size > 0.02) return 10;
  if (size > 1e-3) return 7;
  if (size > 1e-4) return 4;
  return size > 1e-6 ? 3 : 2;
}

/// Length of (Re(a e^{it}), Re(b e^{it})) at its largest.
double longest(const Complex& a, const Complex& b) {
  const Complex i(0, 1);
  return (std::abs(a + i * b) + std::abs(a - i * b)) / 2;
}

template <class Row>
Complex row_on(const Row& row, const Eigen::VectorXcd& amplitude, double rate) {
  const Eigen::Index n = amplitude.size();
  Complex sum = 0;
  for (Eigen::Index j = 0; j < n; ++j) sum += (row(j) + Complex(0, rate) * row(n + j)) * amplitude(j);
  return sum;
}

}  // namespace

template <int N>
ExactMotion<N>::ExactMotion(const scene::Scene& scene, std::shared_ptr<ExactPlan<N>> plan)
    : plan_(std::move(plan)), speed_(scene.speed_rad_per_s) {
  const Eigen::MatrixXcd inverse_mass = plan_->inverse_mass().template cast<Complex>() / scene.length_scale_m;
  unbalance_ = inverse_mass * scene.harmonic_n;
  kick_ = Eigen::VectorXcd::Zero(unbalance_.size());
  if (scene.pulse && scene.pulse->force_n != 0) {
    kick_rate_ = std::numbers::pi / scene.pulse->duration_s;
    kick_ =
        Complex(0, -scene.pulse->force_n) * (inverse_mass * scene.pulse->direction.template cast<Complex>());
  }
  free_.resize(2 * unbalance_.size());
  transition_.resize(free_.size(), free_.size());
}

template <int N>
bool ExactMotion<N>::enter(std::size_t joint, const State& physical) {
  const ModePlan<N>* next = plan_->mode(joint);
  if (next == nullptr) return false;
  if (transition_wanted_ && mode_ != nullptr)
    transition_ = next->inverse * (mode_->basis * transition_).eval();
  mode_ = next;
  if (cells_.size() <= mode_->index) cells_.resize(mode_->index + 1);
  ModeCell& cell = cells_[mode_->index];
  if (!cell.made) make(cell);
  cell_ = &cell;
  joint_ = joint;
  free_ = mode_->to_free(physical - forced());
  return cell.usable;
}

template <int N>
void ExactMotion<N>::make(ModeCell& cell) const {
  cell.made = true;
  cell.usable = make(cell.unbalance, unbalance_, speed_) && make(cell.kick, kick_, kick_rate_);
}

template <int N>
bool ExactMotion<N>::make(Drive& drive, const Eigen::VectorXcd& force, double rate) const {
  const Eigen::Index n = force.size();
  drive.rate = rate;
  drive.amplitude = ComplexVector::Zero(n);
  if (!force.isZero(0)) {
    Eigen::Matrix<Complex, N, N> dynamic = mode_->stiffness.template cast<Complex>();
    dynamic.diagonal().array() -= rate * rate;
    dynamic += Complex(0, rate) * mode_->damping.template cast<Complex>();
    drive.amplitude = dynamic.partialPivLu().solve(ComplexVector(force));
    if (!drive.amplitude.allFinite() || drive.amplitude.cwiseAbs().maxCoeff() > largest_amplitude)
      return false;
  }
  for (const auto& exit : mode_->exits) {
    drive.at_exit.push_back(row_on(exit.physical, drive.amplitude, rate));
    drive.curvature.push_back(std::abs(drive.at_exit.back()) * rate * rate);
  }
  for (const auto& ring : mode_->rings) {
    drive.at_ring.push_back(
        {row_on(ring.physical[0], drive.amplitude, rate), row_on(ring.physical[1], drive.amplitude, rate)});
    drive.ring_length.push_back(longest(drive.at_ring.back()[0], drive.at_ring.back()[1]));
  }
  for (const auto& touch : mode_->touches)
    drive.sliding.push_back(std::abs(row_on(touch.sliding, drive.amplitude, rate)) * rate);
  for (int k = 0; k < exact_step_count; ++k)
    drive.steps[static_cast<std::size_t>(k)] =
        std::polar(1.0, rate * mode_->longest_step_s * exact_step_size(k));
  return true;
}

template <int N>
void ExactMotion<N>::set_phases(double phase_rad, double kick_rad) {
  phasor_ = std::polar(1.0, phase_rad);
  kick_on_ = kick_rad >= 0 && kick_rate_ > 0;
  if (kick_on_) kick_phasor_ = std::polar(1.0, kick_rad);
}

template <int N>
void ExactMotion<N>::add_forced(const Drive& drive, Complex phasor, State& state) const {
  const Eigen::Index n = drive.amplitude.size();
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex z = product(drive.amplitude(j), phasor);
    state(j) += z.real();
    state(n + j) -= drive.rate * z.imag();
  }
}

template <int N>
typename ExactMotion<N>::State ExactMotion<N>::forced() const {
  State state = State::Zero(free_.size());
  state.template head<N>(mode_->rest.size()) = mode_->rest;
  add_forced(cell_->unbalance, phasor_, state);
  if (kick_on_) add_forced(cell_->kick, kick_phasor_, state);
  return state;
}

template <int N>
typename ExactMotion<N>::State ExactMotion<N>::rate_of(const State& physical) const {
  const Eigen::Index n = unbalance_.size();
  State offset = physical;
  offset.template head<N>(n) -= mode_->rest;
  State rate(2 * n);
  rate = mode_->generator.lazyProduct(offset);
  for (Eigen::Index j = 0; j < n; ++j) {
    rate(n + j) += real_product(unbalance_(j), phasor_);
    if (kick_on_) rate(n + j) += real_product(kick_(j), kick_phasor_);
  }
  return rate;
}

template <int N>
typename ExactMotion<N>::Exit ExactMotion<N>::ring(std::size_t r, const State& sizes) const {
  const RingPlan<N>& plan = mode_->rings[r];
  const auto& c = plan_->system().contacts[plan.contact];
  std::array<double, 2> d = plan.centre, v{};
  for (std::size_t i = 0; i < 2; ++i) {
    d[i] += plan.row[i].dot(free_.transpose());
    v[i] += plan.rate[i].dot(free_.transpose());
  }
  double speed = plan.speed_bound.dot(sizes.transpose());
  double curvature = plan.curvature_bound.dot(sizes.transpose());
  const auto add = [&](const Drive& drive, Complex phasor) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Complex z = product(drive.at_ring[r][i], phasor);
      d[i] += z.real();
      v[i] -= drive.rate * z.imag();
    }
    speed += drive.ring_length[r] * drive.rate;
    curvature += drive.ring_length[r] * drive.rate * drive.rate;
  };
  add(cell_->unbalance, phasor_);
  if (kick_on_) add(cell_->kick, kick_phasor_);
  // (|d|^2)'' = 2 |d'|^2 + 2 d.d'' with |d| <= C until the first touch.
  return {(d[0] * d[0] + d[1] * d[1] - c.clearance * c.clearance) / (2 * c.clearance),
          (d[0] * v[0] + d[1] * v[1]) / c.clearance, speed * speed / c.clearance + curvature};
}

template <int N>
template <class Columns>
void ExactMotion<N>::apply(const Pair& flow, Eigen::Index j, Columns& columns) {
  const Eigen::Index n = columns.rows() / 2;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    const double u = columns(j, i), v = columns(n + j, i);
    columns(j, i) = flow.uu * u + flow.uv * v;
    columns(n + j, i) = flow.vu * u + flow.vv * v;
  }
}

template <int N>
void ExactMotion<N>::step_transition_by_table(std::size_t index) {
  if (!mode_->paired) {
    transition_ = (mode_->steps[index] * transition_).eval();
    return;
  }
  const auto& f = mode_->pair_steps[index];
  for (Eigen::Index j = 0; j < f.rows(); ++j) apply({f(j, 0), f(j, 1), f(j, 2), f(j, 3)}, j, transition_);
}

template <int N>
void ExactMotion<N>::turn_phasors(double duration_s) {
  phasor_ = product(phasor_, std::polar(1.0, speed_ * duration_s));
  if (kick_on_) kick_phasor_ = product(kick_phasor_, std::polar(1.0, kick_rate_ * duration_s));
}

template <int N>
void ExactMotion<N>::step_by(double duration_s) {
  // From about seven terms on the closed form costs less than the series.
  if (mode_->paired && std::abs(duration_s) > 0.08 * mode_->series_limit_s) {
    step_by_pairs(duration_s);
    return;
  }
  while (duration_s > mode_->series_limit_s) {
    const int k = exact_step_below(duration_s / mode_->longest_step_s);
    step_by_table(k);
    duration_s -= mode_->longest_step_s * exact_step_size(k);
  }
  step_by_series(duration_s);
}

template <int N>
void ExactMotion<N>::step_by_pairs(double duration_s) {
  const auto& pairs = mode_->pairs;
  Pair flow;
  for (Eigen::Index j = 0; j < pairs.rows(); ++j) {
    // The two directions of an isotropic body share one flow.
    if (j == 0 || (pairs.row(j) != pairs.row(j - 1)).any())
      flow = pair_flow({pairs(j, 0), pairs(j, 1), pairs(j, 2), pairs(j, 3)}, duration_s);
    apply(flow, j, free_);
    if (transition_wanted_) apply(flow, j, transition_);
  }
  turn_phasors(duration_s);
}

template <int N>
template <class Columns>
Columns ExactMotion<N>::rate_of_free(const Columns& columns) const {
  Columns rate(columns.rows(), columns.cols());
  const Eigen::Index n = unbalance_.size();
  if (!mode_->paired) {
    rate.topRows(n) = columns.bottomRows(n);
    rate.bottomRows(n) =
        mode_->generator.template block<N, ExactTypes<N>::states>(n, 0, n, 2 * n).lazyProduct(columns);
    return rate;
  }
  const auto& g = mode_->pairs;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    const Eigen::Array<double, N, 1> u = columns.col(i).template head<N>(n).array();
    const Eigen::Array<double, N, 1> v = columns.col(i).template segment<N>(n, n).array();
    rate.col(i).template head<N>(n) = (g.col(0) * u + g.col(1) * v).matrix();
    rate.col(i).template segment<N>(n, n) = (g.col(2) * u + g.col(3) * v).matrix();
  }
  return rate;
}

template <int N>
template <class Columns>
void ExactMotion<N>::apply_series(double duration_s, int terms, Columns& columns) const {
  Columns term = columns;
  for (int j = 1; j <= terms; ++j) {
    term = rate_of_free(term);
    term *= duration_s / j;
    columns += term;
  }
}

template <int N>
void ExactMotion<N>::step_by_series(double duration_s) {
  if (duration_s == 0) return;
  const int terms = series_terms(0.25 * std::abs(duration_s) / mode_->series_limit_s);
  apply_series(duration_s, terms, free_);
  if (transition_wanted_) apply_series(duration_s, terms, transition_);
  turn_phasors(duration_s);
}

template <int N>
double ExactMotion<N>::sliding_rate_bound(const TouchPlan<N>& touch) const {
  const auto t = static_cast<std::size_t>(&touch - mode_->touches.data());
  double bound = touch.sliding_rate_bound.dot(sizes().transpose());
  bound += cell_->unbalance.sliding[t];
  if (kick_on_) bound += cell_->kick.sliding[t];
  return bound;
}

template <int N>
void ExactMotion<N>::follow_transition(bool wanted) {
  transition_wanted_ = wanted;
  if (wanted && mode_ != nullptr) transition_ = mode_->inverse;
}

template class ExactMotion<2>;
template class ExactMotion<4>;
template class ExactMotion<6>;
template class ExactMotion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate
