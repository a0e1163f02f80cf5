#include "rubsweep/core/integrate/exact/exact_motion.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact {
namespace {

constexpr double at_zero = 1e-12;  ///< clearances: a smaller excess of a guard over zero is rounding

/// Cell of the mode with this index, made for a new one; references to other cells may then be lost.
template <class Cell>
Cell& cell_at(std::size_t index, std::vector<Cell>& cells) {
  if (cells.size() <= index) cells.resize(index + 1);
  return cells[index];
}

}  // namespace

template <int N>
ExactMotion<N>::ExactMotion(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes)
    : machine_(std::move(modes)),
      scale_(run::state_scale(scene)),
      drives_(scene, machine_->inverse_mass(), machine_->system()),
      responses_(machine_->responses_to(drives_.unbalance().acceleration, drives_.unbalance().rate)) {
  now_.phasors.pulses.reserve(drives_.pulses().size());
  now_.free.resize(2 * drives_.unbalance().acceleration.size());
}

template <int N>
bool ExactMotion<N>::enter(std::size_t joint, const State& physical) {
  const modes::LinearMode<N>* next = machine_->mode(joint);
  if (next == nullptr) return false;
  if (mode_ != nullptr) tangents_.change(*mode_, *next);
  mode_ = next;
  bool usable = prepare(*mode_, cell_at(mode_->index, cells_));
  // A pulse may begin in contact, and the bounds on released slips then need the responses of the open mode.
  if (joint != 0 && !drives_.acting().empty()) {
    const modes::LinearMode<N>& open = *machine_->mode(0);
    usable = usable && prepare(open, cell_at(open.index, cells_));
  }
  cell_ = &cells_[mode_->index];
  joint_ = joint;
  ++visits_;
  now_.free = mode_->to_free(physical - forced(*mode_, *cell_, here()));
  return usable;
}

template <int N>
bool ExactMotion<N>::change(std::size_t joint) {
  if constexpr (N != Eigen::Dynamic) {
    const modes::LinearMode<N>* next = machine_->mode(joint);
    if (next == nullptr) return false;
    ModeCell& cell = cell_at(next->index, cells_);
    cell_ = &cells_[mode_->index];
    if (drives_.acting().empty() && prepare(*next, cell)) {
      const auto& way = transition(*next);
      tangents_.change(*mode_, way.change->by);
      State z;
      numerics::put_product(way.change->by, now_.free, z);
      now_.free = z + way.change->constant + now_.phasors.shaft.real() * way.unbalance.real +
                  now_.phasors.shaft.imag() * way.unbalance.imaginary;
      mode_ = next;
      cell_ = &cell;
      joint_ = joint;
      ++visits_;
      return true;
    }
  }
  return enter(joint, physical());
}

template <int N>
const typename modes::UnbalanceResponses<N>::Transition& ExactMotion<N>::transition(
    const modes::LinearMode<N>& to) {
  const std::size_t from = mode_->index;
  auto& ways = responses_->transitions;
  if (ways.size() <= from) ways.resize(from + 1);
  if (ways[from].size() <= to.index) ways[from].resize(to.index + 1);
  auto& way = ways[from][to.index];
  if (way.change == nullptr)
    way = {&machine_->change(*mode_, to),
           modes::make_harmonic_change(to, cell_->shaft->response, cells_[to.index].shaft->response)};
  return way;
}

template <int N>
bool ExactMotion<N>::prepare(const modes::LinearMode<N>& mode, ModeCell& cell) {
  if (cell.shaft == nullptr) cell.shaft = &responses_->of(mode);
  if (drives_.acting().empty()) return cell.shaft->usable;
  cell.pulses.resize(drives_.pulses().size());
  return cell.shaft->usable && std::ranges::all_of(drives_.acting(), [&](std::size_t i) {
           ModeResponse& response = cell.pulses[i];
           const Drive& drive = drives_.pulses()[i];
           if (!response.made)
             response.usable =
                 modes::make_harmonic_response(mode, drive.acceleration, drive.rate, response.response);
           response.made = true;
           return response.usable;
         });
}

template <int N>
typename ExactMotion<N>::State ExactMotion<N>::forced(const modes::LinearMode<N>& mode, const ModeCell& cell,
                                                      const Instant& instant) const {
  State state = State::Zero(instant.free.size());
  state.template head<N>(mode.rest.size()) = mode.rest;
  for_each_response(cell, instant,
                    [&](const auto& response, Complex phasor) { response.add_to(state, phasor); });
  return state;
}

template <int N>
void ExactMotion<N>::ahead(Instant& instant, double duration_s) const {
  if (!(duration_s > 0)) return;
  modes::move_pairs(modes::flow_of_pairs(*mode_, duration_s), instant.free);
  drives_.turn(instant.phasors, duration_s);
}

template <int N>
void ExactMotion<N>::ahead_by_table(Instant& instant, int k) const {
  const auto index = static_cast<std::size_t>(k);
  modes::move_pairs(mode_->pair_steps[index], instant.free);
  turn_by_table(instant.phasors, index);
}

template <int N>
void ExactMotion<N>::ahead_by_interval(Instant& instant, double interval_s) {
  PairFlow& interval = cell_->interval;
  if (interval.duration_s != interval_s)
    interval = {interval_s, modes::flow_of_pairs(*mode_, interval_s), drives_.turns(interval_s)};
  modes::move_pairs(interval.pairs, instant.free);
  drives_.turn(instant.phasors, interval.turns);
}

template <int N>
typename ExactMotion<N>::GuardValue ExactMotion<N>::force(std::size_t t, const Instant& instant) const {
  const modes::TouchWatch<N>& touch = mode_->touches[t];
  const modes::ModalSum free = modes::sum_of(touch.force_of_free.list, instant.free.data(), mode_->paired);
  GuardValue force{touch.force_constant + free.value(), free.rate(), free.curvature()};
  for_each_response(*cell_, instant, [&](const auto& response, Complex phasor) {
    const Complex z = modes::product(response.at_force[t], phasor);
    force.value += z.real();
    force.rate -= response.rate * z.imag();
    force.curvature += response.force_curvature[t];
  });
  return force;
}

template <int N>
typename ExactMotion<N>::CasingMotion ExactMotion<N>::casing(std::size_t c, const Instant& instant) const {
  const modes::CasingView<N>& view = mode_->casings[c];
  Eigen::Vector2d displacement = view.rest, velocity = Eigen::Vector2d::Zero();
  for_each_response(*cell_, instant, [&](const auto& response, Complex phasor) {
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Complex z = modes::product(response.at_casing[c][static_cast<std::size_t>(i)], phasor);
      displacement(i) += z.real();
      velocity(i) -= response.rate * z.imag();
    }
  });
  Eigen::Vector4d free;
  numerics::put_product(view.of_free, instant.free, free);
  return {displacement + free.head<2>(), velocity + free.tail<2>()};
}

template <int N>
typename ExactMotion<N>::State ExactMotion<N>::rate_of(const State& physical) const {
  const Eigen::Index n = mode_->rest.size();
  State offset = physical;
  offset.template head<N>(n) -= mode_->rest;
  State rate = numerics::product_of<State>(mode_->generator, offset);
  for (Eigen::Index j = 0; j < n; ++j) drives_.add_acceleration(j, now_.phasors, rate(n + j));
  return rate;
}

template <int N>
double ExactMotion<N>::closing_acceleration(std::size_t i, const State& physical) const {
  const Eigen::Index n = mode_->rest.size();
  const typename modes::ExactTypes<N>::Row& row = mode_->closing[i];
  double acceleration = row.dot(physical.transpose()) - row.template head<N>(n).dot(mode_->rest.transpose());
  drives_.add_closing(i, now_.phasors, acceleration);
  return acceleration;
}

template <int N>
typename ExactMotion<N>::GuardValue ExactMotion<N>::annular(std::size_t r, const State& sizes) const {
  const modes::AnnularGuard<N>& guard = mode_->annular_guards[r];
  const auto& c = machine_->system().contacts[guard.contact];
  std::array<double, 2> d = guard.centre, v{};
  for (std::size_t i = 0; i < 2; ++i) {
    d[i] += guard.row[i].dot(now_.free.transpose());
    v[i] += guard.rate[i].dot(now_.free.transpose());
  }
  double speed = guard.speed_bound.dot(sizes.transpose());
  double curvature = guard.curvature_bound.dot(sizes.transpose());
  for_each_response(*cell_, now_, [&](const auto& response, Complex phasor) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Complex z = modes::product(response.at_annular_guard[r][i], phasor);
      d[i] += z.real();
      v[i] -= response.rate * z.imag();
    }
    speed += response.annular_length[r] * response.rate;
    curvature += response.annular_length[r] * response.rate * response.rate;
  });
  // (|d|^2)'' = 2 |d'|^2 + 2 d.d'', where |d| <= C until the first touch.
  return {(d[0] * d[0] + d[1] * d[1] - c.clearance * c.clearance) / (2 * c.clearance),
          (d[0] * v[0] + d[1] * v[1]) / c.clearance, speed * speed / c.clearance + curvature};
}

template <int N>
void ExactMotion<N>::step_by(double duration_s) {
  step_by_series(
      modes::table_steps(*mode_, fastest_rad_per_s(), duration_s, [this](int k) { step_by_table(k); }));
}

template <int N>
void ExactMotion<N>::step_by_series(double duration_s) {
  if (duration_s == 0) return;
  modes::move_by_series(*mode_, duration_s, now_.free);
  tangents_.pass(duration_s);
  drives_.turn(now_.phasors, duration_s);
}

template <int N>
double ExactMotion<N>::land(std::size_t e, double within_s) {
  std::array<double, numerics::series_rows> storage;
  const auto expand = [&](double duration_s, int highest) {
    const auto count = static_cast<std::size_t>(highest) + 1;
    const auto even = std::span(storage).first(count + count % 2), terms = even.first(count);
    modes::expand_guard(mode_->guards[e], now_.free, even);
    for_each_response(*cell_, now_,
                      [&](const auto& response, Complex phasor) { response.expand(e, phasor, even); });
    numerics::scale_terms(duration_s * mode_->fastest_rad_per_s, terms);
    return terms;
  };
  const double fastest = fastest_rad_per_s();
  double stepped_s = 0, size = within_s * fastest, root_s = 0;
  if (size > numerics::short_series) {
    const auto start = expand(1, 2);
    const double guess_s = std::clamp(numerics::next_root(start[0], start[1], 2 * start[2]), 0.0, within_s);
    // Table steps cover the time up to the parabola's root as far as they fit. The series covers the
    // remaining time plus a quarter of it, and a twentieth of the whole time for the error of the parabola.
    // If this is too short, the loop below takes a longer series, so that the two numbers affect only the
    // cost: none of 1.6 million landings of four maps needed a second series. If the series ended at the
    // parabola's root, 42 % would need one.
    stepped_s = guess_s - modes::table_steps(*mode_, fastest, guess_s, [this](int k) { step_by_table(k); });
    size = fastest * (1.25 * (guess_s - stepped_s) + 0.05 * guess_s);
  }
  size += 1e-4;  // not zero where the root is exactly here, but still among the shortest series
  for (;; size = std::min(4 * size, numerics::longest_series)) {
    const double duration_s = size / fastest;
    const auto terms = expand(duration_s, numerics::series_terms(size));
    root_s = duration_s * numerics::root_of_series(terms);
    if (std::abs(root_s) * fastest <= size || size >= numerics::longest_series) break;
    if (within_s > 0 || terms[0] > at_zero) continue;
    // The rate is rounding, too, as where a rotor starts at rest at a wall. A root at another place would
    // then be meaningless.
    root_s = 0;
    break;
  }
  step_by_series(root_s);
  return stepped_s + root_s;
}

template <int N>
typename ExactMotion<N>::SlidingRate ExactMotion<N>::sliding_rate(std::size_t t) const {
  SlidingRate sliding;
  for (const modes::ModalTerm& pair : mode_->touches[t].sliding_of_free.list) {
    const double u = now_.free(pair.u), v = now_.free(pair.v);
    sliding.rate += pair.rate[0] * u + pair.rate[1] * v;
    sliding.curvature += mode_->paired ? pair.bound[0] * modes::pair_size(u, v)
                                       : pair.bound[0] * std::abs(u) + pair.bound[1] * std::abs(v);
  }
  for_each_response(*cell_, now_, [&](const auto& response, Complex phasor) {
    sliding.rate -= response.rate * modes::product(response.at_sliding[t], phasor).imag();
    sliding.curvature += response.sliding_curvature[t];
  });
  return sliding;
}

/// Every run has entered the open mode first, so that the flow and the responses of this mode exist.
template <int N>
double ExactMotion<N>::sliding_rate_bound(const modes::TouchWatch<N>& touch, const State& physical) const {
  const modes::LinearMode<N>& open = *machine_->mode(0);
  const ModeCell& cell = cells_[open.index];
  const State free = open.to_free(physical - forced(open, cell, here()));
  const Eigen::Index n = mode_->rest.size();
  double bound = 0;
  for (Eigen::Index j = 0; j < n; ++j)
    bound += touch.sliding_rate_bound(j) * std::hypot(free(j), free(n + j));
  for_each_response(cell, now_, [&](const auto& response, Complex) {
    Complex sliding = 0;
    for (Eigen::Index j = 0; j < n; ++j) sliding += touch.sliding(n + j) * response.amplitude(j);
    bound += std::abs(sliding) * response.rate * response.rate;
  });
  return bound;
}

template class ExactMotion<2>;
template class ExactMotion<4>;
template class ExactMotion<6>;
template class ExactMotion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
