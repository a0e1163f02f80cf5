#include "rubsweep/integrate/exact_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "rubsweep/integrate/certified_step.hpp"
#include "rubsweep/integrate/exponential_series.hpp"

namespace rubsweep::integrate {
namespace {

/// A forced amplitude beyond this many clearances comes from a resonance that nothing damps: the cancellation
/// against the free part would cost digits.
constexpr double largest_amplitude = 1e4;

using detail::product;
using detail::real_product;
using Complex = std::complex<double>;

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
  step_transition();
  if (transition_wanted_ && mode_ != nullptr)
    transition_ = next->inverse.lazyProduct(mode_->basis.lazyProduct(transition_).eval()).eval();
  mode_ = next;
  if (cells_.size() <= mode_->index) cells_.resize(mode_->index + 1);
  ModeCell& cell = cells_[mode_->index];
  if (!cell.made) make(cell);
  cell_ = &cell;
  joint_ = joint;
  free_ = mode_->to_free(physical - forced(here()));
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
typename ExactMotion<N>::State ExactMotion<N>::forced(const Instant& instant) const {
  State state = State::Zero(instant.free.size());
  state.template head<N>(mode_->rest.size()) = mode_->rest;
  add_forced(cell_->unbalance, instant.phasor, state);
  if (kick_on_) add_forced(cell_->kick, instant.kick_phasor, state);
  return state;
}

template <int N>
Eigen::Array<double, N, 4> ExactMotion<N>::flow_of_pairs(double duration_s) const {
  Eigen::Array<double, N, 4> flow(mode_->pairs.rows(), 4);
  for (Eigen::Index j = 0; j < flow.rows(); ++j) {
    const auto g = mode_->pairs.row(j);
    // The two directions of an isotropic body share one flow.
    if (j > 0 && (g == mode_->pairs.row(j - 1)).all()) {
      flow.row(j) = flow.row(j - 1);
    } else {
      const Pair f = pair_flow({g(0), g(1), g(2), g(3)}, duration_s);
      flow.row(j) << f.uu, f.uv, f.vu, f.vv;
    }
  }
  return flow;
}

template <int N>
typename ExactMotion<N>::Stretch ExactMotion<N>::stretch(double duration_s) const {
  return {duration_s, flow_of_pairs(duration_s), std::polar(1.0, speed_ * duration_s),
          std::polar(1.0, kick_rate_ * duration_s)};
}

template <int N>
void ExactMotion<N>::move(Instant& instant, const Stretch& stretch) {
  apply_pairs(stretch.pairs, instant.free);
  instant.phasor = product(instant.phasor, stretch.turn);
  instant.kick_phasor = product(instant.kick_phasor, stretch.kick_turn);
}

template <int N>
void ExactMotion<N>::ahead(Instant& instant, double duration_s) const {
  if (duration_s > 0) move(instant, stretch(duration_s));
}

template <int N>
void ExactMotion<N>::ahead_by_interval(Instant& instant, double interval_s) {
  if (cell_->interval.duration_s != interval_s) cell_->interval = stretch(interval_s);
  move(instant, cell_->interval);
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

/// Takes the transition to where the state is: once per visit to a mode, not once per step.
template <int N>
void ExactMotion<N>::step_transition() {
  const double duration_s = std::exchange(transition_lag_s_, 0);
  if (!transition_wanted_ || duration_s == 0) return;
  if (mode_->paired) {
    const auto flow = flow_of_pairs(duration_s);
    for (Eigen::Index i = 0; i < transition_.cols(); ++i) apply_pairs(flow, transition_.col(i));
  } else {
    step_transition_by_matrices(duration_s);
  }
}

template <int N>
void ExactMotion<N>::step_transition_by_matrices(double duration_s) {
  double rest = duration_s;
  while (rest > short_series / mode_->fastest_rad_per_s) {
    const int k = exact_step_below(rest / mode_->longest_step_s);
    if (k == exact_step_count) break;
    transition_ = mode_->steps[static_cast<std::size_t>(k)].lazyProduct(transition_).eval();
    rest -= mode_->longest_step_s * exact_step_size(k);
  }
  const int terms = series_terms(std::abs(rest) * mode_->fastest_rad_per_s);
  State column;
  for (Eigen::Index i = 0; i < transition_.cols(); ++i) {
    column = transition_.col(i);
    apply_series(rest, terms, column);
    transition_.col(i) = column;
  }
}

template <int N>
void ExactMotion<N>::turn_phasors(double duration_s) {
  phasor_ = product(phasor_, std::polar(1.0, speed_ * duration_s));
  if (kick_on_) kick_phasor_ = product(kick_phasor_, std::polar(1.0, kick_rate_ * duration_s));
}

template <int N>
void ExactMotion<N>::step_by(double duration_s) {
  duration_s -= step_close_to(duration_s);
  step_by_series(duration_s);
}

/// Steps of the table as far as they fit, until the rest is short. Returns how far.
template <int N>
double ExactMotion<N>::step_close_to(double duration_s) {
  double rest = duration_s;
  while (rest > short_series / mode_->fastest_rad_per_s) {
    const int k = exact_step_below(rest / mode_->longest_step_s);
    if (k == exact_step_count) break;
    step_by_table(k);
    rest -= mode_->longest_step_s * exact_step_size(k);
  }
  return duration_s - rest;
}

template <int N>
void ExactMotion<N>::step_by_series(double duration_s) {
  if (duration_s == 0) return;
  const int terms = series_terms(std::abs(duration_s) * mode_->fastest_rad_per_s);
  apply_series(duration_s, terms, free_);
  transition_lag_s_ += duration_s;
  turn_phasors(duration_s);
}

template <int N>
void ExactMotion<N>::apply_series(double duration_s, int terms, State& z) const {
  const Eigen::Index n = mode_->rest.size();
  Part u = z.template head<N>(n).array(), v = z.template segment<N>(n, n).array(), sum_u = u, sum_v = v;
  if (mode_->paired) {
    const Eigen::Array<double, N, 4> step = duration_s * mode_->pairs;
    for (int k = 1; k <= terms; ++k) {
      const double factor = reciprocals[static_cast<std::size_t>(k)];
      const Part next = factor * (step.col(0) * u + step.col(1) * v);
      v = factor * (step.col(2) * u + step.col(3) * v);
      u = next;
      sum_u += u;
      sum_v += v;
    }
  } else {
    for (int k = 1; k <= terms; ++k) {
      differentiate(duration_s * reciprocals[static_cast<std::size_t>(k)], u, v);
      sum_u += u;
      sum_v += v;
    }
  }
  z.template head<N>(n) = sum_u.matrix();
  z.template segment<N>(n, n) = sum_v.matrix();
}

/// (u, v) becomes factor * its rate, by full matrices.
template <int N>
inline void ExactMotion<N>::differentiate(double factor, Part& u, Part& v) const {
  typename ExactTypes<N>::Vector push = mode_->stiffness.lazyProduct(u.matrix());
  push += mode_->damping.lazyProduct(v.matrix());
  u = factor * v;
  v = -factor * push.array();
}

template <int N>
double ExactMotion<N>::land(std::size_t e, double within_s) {
  std::array<double, most_series_terms> storage;
  const auto expand = [&](double duration_s, int highest) {
    const auto terms = std::span(storage).first(static_cast<std::size_t>(highest) + 1);
    expand_free(mode_->exits[e], duration_s, terms);
    expand_drive(cell_->unbalance, e, phasor_, duration_s, terms);
    if (kick_on_) expand_drive(cell_->kick, e, kick_phasor_, duration_s, terms);
    return terms;
  };
  const double fastest = mode_->fastest_rad_per_s;
  double stepped_s = 0, size = within_s * fastest, root_s = 0;
  if (size > short_series) {
    const auto start = expand(1, 2);
    const double guess_s = std::clamp(next_root(start[0], start[1], 2 * start[2]), 0.0, within_s);
    stepped_s = step_close_to(guess_s);
    size = fastest * (1.25 * (guess_s - stepped_s) + 0.05 * guess_s);
  }
  size += 1e-4;
  do {
    const double duration_s = size / fastest;
    root_s = duration_s * root_of_series(expand(duration_s, series_terms(size)));
    size *= 4;
  } while (std::abs(root_s) * fastest > size / 4 && size <= longest_series);
  step_by_series(root_s);
  return stepped_s + root_s;
}

/// Taylor coefficients of the exit but for its forced part, time in units of `within_s`. A pair's part obeys
/// y'' = trace y' - determinant y.
template <int N>
void ExactMotion<N>::expand_free(const ExitPlan<N>& exit, double within_s, std::span<double> terms) const {
  const auto& both = exit.whole.row_and_rate;
  if (!mode_->paired) {
    const Eigen::Index n = mode_->rest.size();
    const typename ExactTypes<N>::Row row = both.row(0);
    Part u = free_.template head<N>(n).array(), v = free_.template segment<N>(n, n).array();
    for (std::size_t k = 0; k < terms.size(); ++k) {
      terms[k] = (row.template head<N>(n).transpose().array() * u +
                  row.template segment<N>(n, n).transpose().array() * v)
                     .sum();
      differentiate(within_s * reciprocals[k + 1], u, v);
    }
  } else {
    const Eigen::Index n = mode_->rest.size();
    const auto parts = [&](Eigen::Index row) -> Part {
      return both.row(row).template head<N>(n).transpose().array() * free_.template head<N>(n).array() +
             both.row(row).template segment<N>(n, n).transpose().array() *
                 free_.template segment<N>(n, n).array();
    };
    const Part trace = within_s * mode_->trace, determinant = within_s * within_s * mode_->determinant;
    Part last = parts(0), now = within_s * parts(1);
    terms[0] = last.sum();
    terms[1] = now.sum();
    for (std::size_t k = 1; k + 1 < terms.size(); ++k) {
      const Part next =
          (reciprocals[k + 1] * trace) * now - (reciprocals[k] * reciprocals[k + 1] * determinant) * last;
      terms[k + 1] = next.sum();
      last = now;
      now = next;
    }
  }
  terms[0] += exit.constant;
}

template <int N>
void ExactMotion<N>::expand_drive(const Drive& drive, std::size_t e, Complex phasor, double within_s,
                                  std::span<double> terms) {
  const Complex start = product(drive.at_exit[e], phasor);
  const double angle = drive.rate * within_s, minus_square = -angle * angle;
  double last = start.real(), now = -angle * start.imag();
  terms[0] += last;
  terms[1] += now;
  for (std::size_t k = 1; k + 1 < terms.size(); ++k) {
    last = std::exchange(now, minus_square * (reciprocals[k] * reciprocals[k + 1]) * last);
    terms[k + 1] += now;
  }
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
  transition_lag_s_ = 0;
  if (wanted && mode_ != nullptr) transition_ = mode_->inverse;
}

template class ExactMotion<2>;
template class ExactMotion<4>;
template class ExactMotion<6>;
template class ExactMotion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate
