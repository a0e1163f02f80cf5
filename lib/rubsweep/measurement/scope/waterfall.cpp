#include "rubsweep/measurement/scope/waterfall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/spectrum/discrete_lines.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using batch::csv_number;
using recording::Recording;
using recording::samples_per_revolution;

constexpr int most_spectra = 120;
constexpr int spectrum_turns = 2 * history_turns;
constexpr double most_waterfall_order = 8;

/// Instant and speed in the middle of some turns.
OrderPoint middle_of(const Recording& recording, int begin, int count) {
  const auto mark = [&](int turn) { return recording.turn_begin_s[static_cast<std::size_t>(turn)]; };
  const double middle_s =
      count % 2 == 0 ? mark(begin + count / 2) : (mark(begin + count / 2) + mark(begin + count / 2 + 1)) / 2;
  return {middle_s, recording.mean_speed_hz(begin, count)};
}

/// Means of x e^{-i angle} and y e^{-i angle} over whole periods; the signal's mean adds nothing to them.
void add_component(std::span<const Complex> samples, double step_rad, double begin_rad, OrderPoint& point) {
  const auto count = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Complex turn = 2.0 / count * std::polar(1.0, -(begin_rad + step_rad * static_cast<double>(k)));
    point.x_m += samples[k].real() * turn;
    point.y_m += samples[k].imag() * turn;
  }
}

double lag_deg(Complex amplitude) {
  const double phase = std::arg(amplitude) * 180 / std::numbers::pi;
  return phase > 0 ? phase - 360 : phase;
}

}  // namespace

bool speed_changes(const Recording& recording) {
  double slowest = INFINITY, fastest = 0;
  for (int begin = 0; begin + history_turns <= recording.turns(); begin += history_turns / 2) {
    const double speed_hz = middle_of(recording, begin, history_turns).speed_hz;
    slowest = std::fmin(slowest, speed_hz);
    fastest = std::fmax(fastest, speed_hz);
  }
  return fastest > (1 + steady_share) * slowest;
}

std::vector<OrderPoint> order_history(const Recording& recording, double order, int turns) {
  const double eighths = 8 * order;
  if (eighths != std::round(eighths) || order <= 0) throw SolverError("order_history: no multiple of 1/8");
  while (std::fmod(order * turns, 1.0) != 0) ++turns;
  const bool windowed = order != 1 && 2 * turns <= recording.turns();
  if (windowed) turns *= 2;
  std::vector<OrderPoint> points;
  const double step_rad = 2 * std::numbers::pi * order / samples_per_revolution;
  for (int begin = 0; begin + turns <= recording.turns(); ++begin) {
    points.push_back(middle_of(recording, begin, turns));
    const std::span<const Complex> samples = recording.samples(begin, turns);
    const double begin_rad = 2 * std::numbers::pi * order * begin;
    if (windowed)
      add_component(response::spectrum::under_hann_window_of_growing(samples), step_rad, begin_rad,
                    points.back());
    else
      add_component(samples, step_rad, begin_rad, points.back());
  }
  return points;
}

std::string bode_csv(const Recording& recording, const std::vector<double>& orders) {
  std::string text = "t_s,speed_hz,order,x_amplitude_m,x_phase_deg";
  text += recording.plane ? ",y_amplitude_m,y_phase_deg\n" : "\n";
  // A speed that follows the line of the shaft leaves the phase of this line unknown.
  const auto phase = [&](std::complex<double> z) {
    return csv_number(recording.phased ? lag_deg(z) : std::numeric_limits<double>::quiet_NaN());
  };
  for (const double order : orders) {
    for (const OrderPoint& point : order_history(recording, order)) {
      text += fmt::format("{},{},{},{},{}", csv_number(point.t_s), csv_number(point.speed_hz),
                          csv_number(order), csv_number(std::abs(point.x_m)), phase(point.x_m));
      if (recording.plane) text += fmt::format(",{},{}", csv_number(std::abs(point.y_m)), phase(point.y_m));
      text += '\n';
    }
  }
  return text;
}

std::string waterfall_csv(const Recording& recording) {
  std::string text = "t_s,speed_hz,order,amplitude_m\n";
  const int turns = std::min(recording.turns(), spectrum_turns) / history_turns * history_turns;
  const int windows = turns == 0 ? 0 : 1 + (recording.turns() - turns) / history_turns;
  const int every = (windows + most_spectra - 1) / most_spectra;
  response::spectrum::SpectrumWorkspace workspace;
  const int last = static_cast<int>(most_waterfall_order * turns);
  for (int window = 0; window < windows; window += every) {
    const OrderPoint middle = middle_of(recording, window * history_turns, turns);
    const auto spectrum = response::spectrum::windowed_spectrum(
        recording.samples(window * history_turns, turns), turns, workspace);
    for (int k = -last; k <= last; ++k) {
      if (k == 0) continue;
      text += fmt::format("{},{},{},{}\n", csv_number(middle.t_s), csv_number(middle.speed_hz),
                          csv_number(spectrum.order(k)), csv_number(spectrum.amplitude(k)));
    }
  }
  return text;
}

}  // namespace rubsweep::scope
