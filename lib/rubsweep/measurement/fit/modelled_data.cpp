#include "rubsweep/measurement/fit/modelled_data.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::fit {
namespace {

using Complex = std::complex<double>;

/// Response a(t) of a' = value a + sin(pi t / duration) for 0 < t < duration, from rest; free after the
/// pulse.
Complex answer(Complex value, double t, double duration_s) {
  if (t <= 0) return 0;
  const double w = std::numbers::pi / duration_s;
  const Complex denominator = value * value + w * w;
  if (t < duration_s)
    return (w * std::exp(value * t) - value * std::sin(w * t) - w * std::cos(w * t)) / denominator;
  return w * (std::exp(value * t) + std::exp(value * (t - duration_s))) / denominator;
}

/// Real parts, then imaginary parts, in one column, sensor by sensor.
Eigen::VectorXd stacked(const Eigen::MatrixXcd& phasors) {
  const Eigen::Map<const Eigen::VectorXcd> all(phasors.data(), phasors.size());
  Eigen::VectorXd parts(2 * all.size());
  parts << all.real(), all.imag();
  return parts;
}

/// Model values with the scale of the kick and an offset per sensor from linear least squares.
Eigen::VectorXd with_scale(const Eigen::MatrixXd& measured, const Eigen::MatrixXd& shape) {
  const Eigen::MatrixXd centred = measured.rowwise() - measured.colwise().mean();
  const Eigen::MatrixXd moved = shape.rowwise() - shape.colwise().mean();
  const double square = moved.squaredNorm();
  const double scale = square > 0 ? (moved.array() * centred.array()).sum() / square : 0;
  const Eigen::MatrixXd model = (scale * moved).rowwise() + measured.colwise().mean();
  return model.reshaped();
}

Eigen::VectorXd with_run_out(const Eigen::MatrixXcd& measured, Eigen::MatrixXcd model, bool run_out) {
  if (run_out) model.rowwise() += (measured - model).colwise().mean().eval();
  return stacked(model);
}

/// Lines of a rub, rotated to the measured mark. A period of several turns may begin at any of these turns;
/// the turn with the smallest residual is taken.
Eigen::VectorXd with_first_turn(const RubLines& rub, const Eigen::VectorXcd& lines_m, double mark_rad) {
  Eigen::VectorXcd best;
  for (int turn = 0; turn < rub.turns; ++turn) {
    Eigen::VectorXcd turned = lines_m;
    for (Eigen::Index i = 0; i < turned.size(); ++i)
      turned(i) *=
          std::polar(1.0, rub.order[static_cast<std::size_t>(i)] * (mark_rad + 2 * std::numbers::pi * turn));
    if (turn == 0 || (turned - rub.line_m).squaredNorm() < (best - rub.line_m).squaredNorm())
      best = std::move(turned);
  }
  return stacked(best);
}

}  // namespace

double value_named(const MachineFit& problem, const Eigen::VectorXd& values, const char* name,
                   double otherwise) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i)
    if (problem.parameters[i].name == name) return values(static_cast<Eigen::Index>(i));
  return otherwise;
}

scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first) {
  if (!std::holds_alternative<model::RotorKit>(machine.rotor) || !first.reduction)
    return scene::prepare_machine(machine);
  return scene::prepare_with_modes(machine, first.reduction->modes);
}

RampParts LastRamps::of(const MachineFit& problem, const RunUp& run, Eigen::VectorXd values,
                        const std::function<RampParts()>& make) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    const std::string& name = problem.parameters[i].name;
    if (name == eccentricity_name || name == mark_name || name == hit_name)
      values(static_cast<Eigen::Index>(i)) = 0;
  }
  {
    const std::lock_guard lock(mutex_);
    const auto* known =
        known_.find([&](const Known& one) { return one.run == &run && one.values == values; });
    if (known != nullptr) return known->parts;
  }
  RampParts parts = make();
  const std::lock_guard lock(mutex_);
  known_.emplace(Known{&run, std::move(values), parts});
  known_.trim();
  return parts;
}

Eigen::VectorXd measured_of(const MeasuredData& data) {
  return std::visit(
      overloaded{[](const RingDown& ring) -> Eigen::VectorXd { return ring.signal_m.reshaped(); },
                 [](const RunUp& run) { return stacked(run.phasor_m); },
                 [](const Steady& steady) { return stacked(steady.phasor_m); },
                 [](const RubLines& rub) { return stacked(rub.line_m); }},
      data.data);
}

Eigen::VectorXd modelled_of(const MachineFit& problem, const MeasuredData& data,
                            const scene::PreparedMachine& machine, const Eigen::VectorXd& values,
                            LastRamps& ramps) {
  const linear::SensorRows sensors = linear::sensor_rows(machine);
  const auto rows_for = [&](Eigen::Index count) {
    if (count > sensors.rows.rows())
      throw ConfigError(data.name + ": has " + std::to_string(count) +
                        " sensors, allowed: as many as the configuration, " +
                        std::to_string(sensors.rows.rows()) + ", or fewer");
    return Eigen::MatrixXd(sensors.rows.topRows(count));
  };
  const double eccentricity_m = value_named(problem, values, eccentricity_name, problem.eccentricity_m);
  const Complex turn =
      std::polar(1.0, value_named(problem, values, mark_name, problem.mark_deg) * std::numbers::pi / 180);
  return std::visit(
      overloaded{[&](const RingDown& ring) {
                   const double hit_s = value_named(problem, values, hit_name, problem.hit_s);
                   std::vector<double> since_s = ring.t_s;
                   for (double& t : since_s) t -= hit_s;
                   return with_scale(ring.signal_m,
                                     free_vibration(machine, rows_for(ring.signal_m.cols()), since_s));
                 },
                 [&](const RunUp& run) {
                   Ramp ramp = run.ramp;
                   std::vector<double> t_s = run.t_s;
                   const double rate = value_named(problem, values, rate_name, ramp.rate_hz_per_s);
                   if (rate != ramp.rate_hz_per_s) {
                     // The speeds stay the same, so the instants change with the rate.
                     for (double& t : t_s) t = t * ramp.rate_hz_per_s / rate;
                     ramp.rate_hz_per_s = rate;
                   }
                   const RampParts parts = ramps.of(problem, run, values, [&] {
                     return ramp_parts(machine, rows_for(run.phasor_m.cols()), ramp, t_s, run.window_turns);
                   });
                   Eigen::MatrixXcd model = turn * (eccentricity_m * parts.per_eccentricity + parts.bow_m);
                   if (run.from_readings)
                     model += std::conj(turn) *
                              (eccentricity_m * parts.per_eccentricity_mirrored + parts.bow_mirrored_m);
                   return with_run_out(run.phasor_m, std::move(model), data.run_out);
                 },
                 [&](const Steady& steady) {
                   Eigen::MatrixXcd model(steady.phasor_m.rows(), steady.phasor_m.cols());
                   const Eigen::MatrixXd rows = rows_for(steady.phasor_m.cols());
                   for (Eigen::Index k = 0; k < model.rows(); ++k)
                     model.row(k) = turn * steady_phasors(machine, rows, eccentricity_m,
                                                          steady.speed_hz[static_cast<std::size_t>(k)]);
                   return with_run_out(steady.phasor_m, model, data.run_out);
                 },
                 [&](const RubLines& rub) {
                   return with_first_turn(rub, problem.rub_lines(machine, rub, eccentricity_m),
                                          std::arg(turn));
                 }},
      data.data);
}

int eliminated_of(const MeasuredData& data) {
  return std::visit(
      overloaded{
          [](const RingDown& ring) { return 1 + static_cast<int>(ring.signal_m.cols()); },
          [&](const RunUp& run) { return data.run_out ? 2 * static_cast<int>(run.phasor_m.cols()) : 0; },
          [&](const Steady& steady) {
            return data.run_out ? 2 * static_cast<int>(steady.phasor_m.cols()) : 0;
          },
          [](const RubLines&) { return 0; }},
      data.data);
}

ModelledData modelled(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values) {
  LastRamps ramps(problem);
  const MeasuredData& measured = problem.data[data];
  return {measured_of(measured), modelled_of(problem, measured, problem.machine(values), values, ramps)};
}

WhatIsLeft what_is_left(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values) {
  const MeasuredData& measured = problem.data[data];
  const ModelledData both = modelled(problem, data, values);
  Eigen::VectorXd without_offsets = both.measured_m;
  const auto* ring = std::get_if<RingDown>(&measured.data);
  if (ring != nullptr || measured.run_out) {
    // One column for each offset.
    const Eigen::Index offsets = ring != nullptr ? ring->signal_m.cols() : eliminated_of(measured);
    auto columns = without_offsets.reshaped(without_offsets.size() / std::max<Eigen::Index>(offsets, 1),
                                            std::max<Eigen::Index>(offsets, 1));
    columns.rowwise() -= columns.colwise().mean().eval();
  }
  const double count = std::sqrt(static_cast<double>(both.measured_m.size()));
  return {(both.measured_m - both.modelled_m).norm() / count, without_offsets.norm() / count};
}

Eigen::MatrixXd free_vibration(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                               const std::vector<double>& since_s) {
  structure::refuse_beyond_tables(prepared.machine, 0, 0);
  const auto pulses = scene::build_cell(prepared, 1, scene::Eccentricity{0}).scene.pulses;
  if (pulses.empty())
    throw ConfigError("kick: is not there, allowed with a ring-down: where and how it was struck");
  const ModeSet modes = modes_at(prepared, 0);
  const Eigen::MatrixXcd seen = rows.cast<Complex>() * modes.vectors.topRows(rows.cols());
  Eigen::MatrixXd signal = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(since_s.size()), rows.rows());
  for (const scene::Pulse& pulse : pulses) {
    const Eigen::VectorXcd push = modes.force((pulse.force_n * pulse.direction).cast<Complex>());
    Eigen::VectorXcd state(push.size());
    for (std::size_t k = 0; k < since_s.size(); ++k) {
      for (Eigen::Index i = 0; i < push.size(); ++i)
        state(i) = push(i) * answer(modes.values(i), since_s[k] + pulse.elapsed_s, pulse.duration_s);
      signal.row(static_cast<Eigen::Index>(k)) += (seen * state).real().transpose();
    }
  }
  return signal;
}

}  // namespace rubsweep::fit
