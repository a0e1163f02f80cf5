#include "rubsweep/integrate/exact/exact_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "rubsweep/numerics/certified_step.hpp"
#include "rubsweep/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact {

template <int N>
ExactMotion<N>::ExactMotion(const scene::Scene& scene, std::shared_ptr<MachineModes<N>> modes)
    : machine_(std::move(modes)), speed_(scene.speed_rad_per_s) {
  const Eigen::MatrixXcd inverse_mass =
      machine_->inverse_mass().template cast<Complex>() / scene.length_scale_m;
  unbalance_ = inverse_mass * scene.harmonic_n;
  kick_ = Eigen::VectorXcd::Zero(unbalance_.size());
  if (scene.pulse && scene.pulse->force_n != 0) {
    kick_rate_ = std::numbers::pi / scene.pulse->duration_s;
    kick_ =
        Complex(0, -scene.pulse->force_n) * (inverse_mass * scene.pulse->direction.template cast<Complex>());
  }
  for (const auto& contact : machine_->system().contacts) {
    const auto along = [&](const Eigen::VectorXcd& force) {
      return Complex(contact.first_row.dot(force.real()), contact.first_row.dot(force.imag()));
    };
    unbalance_closing_.push_back(along(unbalance_));
    kick_closing_.push_back(along(kick_));
  }
  free_.resize(2 * unbalance_.size());
}

template <int N>
bool ExactMotion<N>::enter(std::size_t joint, const State& physical) {
  const LinearMode<N>* next = machine_->mode(joint);
  if (next == nullptr) return false;
  if (mode_ != nullptr) tangents_.change(*mode_, *next);
  mode_ = next;
  if (cells_.size() <= mode_->index) cells_.resize(mode_->index + 1);
  ModeCell& cell = cells_[mode_->index];
  const bool usable = prepare(cell);
  cell_ = &cell;
  joint_ = joint;
  ++visits_;
  free_ = mode_->to_free(physical - forced(*mode_, cell, here()));
  return usable;
}

template <int N>
bool ExactMotion<N>::prepare(ModeCell& cell) const {
  return prepare(cell.shaft, unbalance_, speed_) && (!kick_on_ || prepare(cell.pulse, kick_, kick_rate_));
}

template <int N>
bool ExactMotion<N>::prepare(ModeResponse& response, const Eigen::VectorXcd& force,
                             double rate_rad_per_s) const {
  if (!response.made)
    response.usable = make_harmonic_response(*mode_, force, rate_rad_per_s, response.response);
  response.made = true;
  return response.usable;
}

template <int N>
void ExactMotion<N>::set_phases(double phase_rad, double kick_rad) {
  phasor_ = std::polar(1.0, phase_rad);
  kick_on_ = kick_rad >= 0 && kick_rate_ > 0;
  if (kick_on_) kick_phasor_ = std::polar(1.0, kick_rad);
}

template <int N>
typename ExactMotion<N>::State ExactMotion<N>::forced(const LinearMode<N>& mode, const ModeCell& cell,
                                                      const Instant& instant) const {
  State state = State::Zero(instant.free.size());
  state.template head<N>(mode.rest.size()) = mode.rest;
  cell.shaft.response.add_to(state, instant.phasor);
  if (kick_on_) cell.pulse.response.add_to(state, instant.kick_phasor);
  return state;
}

template <int N>
typename ExactMotion<N>::Stretch ExactMotion<N>::stretch(double duration_s) const {
  return {duration_s, flow_of_pairs(*mode_, duration_s), std::polar(1.0, speed_ * duration_s),
          std::polar(1.0, kick_rate_ * duration_s)};
}

template <int N>
void ExactMotion<N>::move(Instant& instant, const Stretch& stretch) {
  move_pairs(stretch.pairs, instant.free);
  instant.phasor = product(instant.phasor, stretch.turn);
  instant.kick_phasor = product(instant.kick_phasor, stretch.kick_turn);
}

template <int N>
void ExactMotion<N>::ahead(Instant& instant, double duration_s) const {
  if (duration_s > 0) move(instant, stretch(duration_s));
}

template <int N>
void ExactMotion<N>::ahead_by_table(Instant& instant, int k) const {
  const auto index = static_cast<std::size_t>(k);
  move_pairs(mode_->pair_steps[index], instant.free);
  instant.phasor = product(instant.phasor, cell_->shaft.response.turned_by(index, mode_->longest_step_s));
  if (kick_on_)
    instant.kick_phasor =
        product(instant.kick_phasor, cell_->pulse.response.turned_by(index, mode_->longest_step_s));
}

template <int N>
typename ExactMotion<N>::GuardValue ExactMotion<N>::force(std::size_t t, const Instant& instant) const {
  const TouchWatch<N>& touch = mode_->touches[t];
  const ModalSum free = sum_of(touch.force_of_free.list, instant.free.data(), mode_->paired);
  GuardValue force{touch.force_constant + free.value(), free.rate(), free.curvature()};
  const auto add = [&](const HarmonicResponse<N>& response, Complex phasor) {
    const Complex z = product(response.at_force[t], phasor);
    force.value += z.real();
    force.rate -= response.rate * z.imag();
    force.curvature += response.force_curvature[t];
  };
  add(cell_->shaft.response, instant.phasor);
  if (kick_on_) add(cell_->pulse.response, instant.kick_phasor);
  return force;
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
double ExactMotion<N>::closing_acceleration(std::size_t i, const State& physical) const {
  const Eigen::Index n = unbalance_.size();
  const typename ExactTypes<N>::Row& row = mode_->closing[i];
  double acceleration = row.dot(physical.transpose()) - row.template head<N>(n).dot(mode_->rest.transpose());
  acceleration += real_product(unbalance_closing_[i], phasor_);
  if (kick_on_) acceleration += real_product(kick_closing_[i], kick_phasor_);
  return acceleration;
}

template <int N>
typename ExactMotion<N>::GuardValue ExactMotion<N>::annular(std::size_t r, const State& sizes) const {
  const AnnularGuard<N>& guard = mode_->annular_guards[r];
  const auto& c = machine_->system().contacts[guard.contact];
  std::array<double, 2> d = guard.centre, v{};
  for (std::size_t i = 0; i < 2; ++i) {
    d[i] += guard.row[i].dot(free_.transpose());
    v[i] += guard.rate[i].dot(free_.transpose());
  }
  double speed = guard.speed_bound.dot(sizes.transpose());
  double curvature = guard.curvature_bound.dot(sizes.transpose());
  const auto add = [&](const HarmonicResponse<N>& response, Complex phasor) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Complex z = product(response.at_annular_guard[r][i], phasor);
      d[i] += z.real();
      v[i] -= response.rate * z.imag();
    }
    speed += response.annular_length[r] * response.rate;
    curvature += response.annular_length[r] * response.rate * response.rate;
  };
  add(cell_->shaft.response, phasor_);
  if (kick_on_) add(cell_->pulse.response, kick_phasor_);
  // (|d|^2)'' = 2 |d'|^2 + 2 d.d'' with |d| <= C until the first touch.
  return {(d[0] * d[0] + d[1] * d[1] - c.clearance * c.clearance) / (2 * c.clearance),
          (d[0] * v[0] + d[1] * v[1]) / c.clearance, speed * speed / c.clearance + curvature};
}

template <int N>
void ExactMotion<N>::turn_phasors(double duration_s) {
  phasor_ = product(phasor_, std::polar(1.0, speed_ * duration_s));
  if (kick_on_) kick_phasor_ = product(kick_phasor_, std::polar(1.0, kick_rate_ * duration_s));
}

template <int N>
void ExactMotion<N>::step_by(double duration_s) {
  step_by_series(table_steps(*mode_, fastest_rad_per_s(), duration_s, [this](int k) { step_by_table(k); }));
}

template <int N>
void ExactMotion<N>::step_by_series(double duration_s) {
  if (duration_s == 0) return;
  move_by_series(*mode_, duration_s, free_);
  tangents_.pass(duration_s);
  turn_phasors(duration_s);
}

template <int N>
double ExactMotion<N>::land(std::size_t e, double within_s) {
  std::array<double, numerics::series_rows> storage;
  const auto expand = [&](double duration_s, int highest) {
    const auto count = static_cast<std::size_t>(highest) + 1;
    const auto even = std::span(storage).first(count + count % 2), terms = even.first(count);
    expand_guard(mode_->guards[e], free_, even);
    cell_->shaft.response.expand(e, phasor_, even);
    if (kick_on_) cell_->pulse.response.expand(e, kick_phasor_, even);
    numerics::scale_terms(duration_s * mode_->fastest_rad_per_s, terms);
    return terms;
  };
  const double fastest = fastest_rad_per_s();
  double stepped_s = 0, size = within_s * fastest, root_s = 0;
  if (size > numerics::short_series) {
    const auto start = expand(1, 2);
    const double guess_s = std::clamp(numerics::next_root(start[0], start[1], 2 * start[2]), 0.0, within_s);
    // Steps of the table lead up to the parabola's root as far as they fit; the series reaches over what they
    // leave, with a quarter to spare, and over a twentieth of the whole, for the error of the parabola. Where
    // that is not enough the loop below takes a longer series, so that these two numbers decide the cost
    // alone. Measured: of 810 000 landings of configs/figure06_one_side.yaml and 770 000 of three other maps
    // none was farther from the parabola's root than a twentieth, and none needed a second series, at 10.3
    // terms each in the mean. A series that reaches no farther than the parabola's root needs a second one in
    // 42 % of them, 15.3 terms in the mean.
    stepped_s = guess_s - table_steps(*mode_, fastest, guess_s, [this](int k) { step_by_table(k); });
    size = fastest * (1.25 * (guess_s - stepped_s) + 0.05 * guess_s);
  }
  size += 1e-4;  // not zero where the root is here, and still the shortest of all series
  for (;; size = std::min(4 * size, numerics::longest_series)) {
    const double duration_s = size / fastest;
    root_s = duration_s * numerics::root_of_series(expand(duration_s, numerics::series_terms(size)));
    if (std::abs(root_s) * fastest <= size || size >= numerics::longest_series) break;
  }
  step_by_series(root_s);
  return stepped_s + root_s;
}

template <int N>
double ExactMotion<N>::sliding_rate_bound(const TouchWatch<N>& touch, const State& physical) const {
  if (!touch.friction_rate.empty()) return sliding_rate_bound_without_contact(touch, physical);
  const auto t = static_cast<std::size_t>(&touch - mode_->touches.data());
  double bound = touch.sliding_rate_bound.dot(sizes().transpose());
  bound += cell_->shaft.response.sliding[t];
  if (kick_on_) bound += cell_->pulse.response.sliding[t];
  return bound;
}

/// Every run has entered the open mode first, so that its flow and responses are there.
template <int N>
double ExactMotion<N>::sliding_rate_bound_without_contact(const TouchWatch<N>& touch,
                                                          const State& physical) const {
  const LinearMode<N>& open = *machine_->mode(0);
  const ModeCell& cell = cells_[open.index];
  const State free = open.to_free(physical - forced(open, cell, here()));
  const Eigen::Index n = unbalance_.size();
  double bound = 0;
  for (Eigen::Index j = 0; j < n; ++j)
    bound += touch.sliding_rate_bound(j) * std::hypot(free(j), free(n + j));
  const auto add = [&](const HarmonicResponse<N>& response) {
    Complex sliding = 0;
    for (Eigen::Index j = 0; j < n; ++j) sliding += touch.sliding(n + j) * response.amplitude(j);
    bound += std::abs(sliding) * response.rate * response.rate;
  };
  add(cell.shaft.response);
  if (kick_on_) add(cell.pulse.response);
  return bound;
}

template class ExactMotion<2>;
template class ExactMotion<4>;
template class ExactMotion<6>;
template class ExactMotion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
