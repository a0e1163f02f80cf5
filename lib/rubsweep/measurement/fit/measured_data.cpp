#include "rubsweep/measurement/fit/measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/measurement/fit/measured_table.hpp"

namespace rubsweep::fit {
namespace {

using batch::CsvReader;
using Complex = std::complex<double>;
using std::numbers::pi;

/// Index of the piece, of a ramp with knots, that contains an instant or is nearest to it.
std::size_t piece_of(const Ramp& ramp, double t_s) {
  const auto above = std::ranges::upper_bound(ramp.knot_s, t_s) - ramp.knot_s.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(ramp.knot_s) - 2));
}

double rate_hz_per_s(const Ramp& ramp, std::size_t piece) {
  return (ramp.knot_hz[piece + 1] - ramp.knot_hz[piece]) / (ramp.knot_s[piece + 1] - ramp.knot_s[piece]);
}

constexpr double degree = pi / 180;
/// Longest period of a rub, in turns.
constexpr int most_turns = 64;

/// Number in a cell of the row; throws for an empty cell.
template <class Table>
double number(const Table& table, std::size_t column) {
  const double value = table.number(column);
  if (std::isfinite(value)) return value;
  throw ConfigError(fmt::format("{}:{}: {}: is no number, allowed: a finite number", table.path().string(),
                                table.place().line, table.header()[column]));
}

bool has(const MeasuredTable& table, const std::string& name) {
  return std::ranges::find(table.header(), name) != table.header().end();
}

Eigen::MatrixXcd matrix_of(const std::vector<std::vector<Complex>>& rows) {
  Eigen::MatrixXcd matrix(static_cast<Eigen::Index>(rows.size()),
                          static_cast<Eigen::Index>(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
  return matrix;
}

/// Converts phases from one convention to another. One of the two must be `mark`, whose phases are the angles
/// of A in Re(A e^{i phi}).
void recount(PhaseConvention from, PhaseConvention to, const std::vector<double>& angle_deg,
             Eigen::MatrixXcd& phasor_m) {
  if (from == PhaseConvention::lag || to == PhaseConvention::lag) phasor_m = phasor_m.conjugate().eval();
  const double sign = from == PhaseConvention::sensor ? 1 : to == PhaseConvention::sensor ? -1 : 0;
  for (Eigen::Index i = 0; i < phasor_m.cols(); ++i)
    phasor_m.col(i) *= std::polar(1.0, sign * angle_deg[static_cast<std::size_t>(i)] * degree);
}

void require_rows(const std::filesystem::path& file, std::size_t rows, std::size_t fewest) {
  if (rows < fewest)
    throw ConfigError(
        fmt::format("{}: has {} rows of such data, allowed: {} or more", file.string(), rows, fewest));
}

}  // namespace

double speed_hz(const Ramp& ramp, double t_s) {
  if (ramp.even()) return ramp.from_hz + ramp.rate_hz_per_s * t_s;
  const std::size_t piece = piece_of(ramp, t_s);
  return ramp.knot_hz[piece] + rate_hz_per_s(ramp, piece) * (t_s - ramp.knot_s[piece]);
}

RampTurning::RampTurning(const Ramp& ramp) : ramp_(ramp) {
  if (ramp.even()) {
    most_gain_ = std::abs(2 * pi * ramp.rate_hz_per_s);
    return;
  }
  turns_.push_back(0);
  for (std::size_t k = 0; k + 1 < ramp.knot_s.size(); ++k) {
    turns_.push_back(turns_.back() +
                     (ramp.knot_hz[k] + ramp.knot_hz[k + 1]) / 2 * (ramp.knot_s[k + 1] - ramp.knot_s[k]));
    most_gain_ = std::max(most_gain_, std::abs(2 * pi * rate_hz_per_s(ramp, k)));
  }
}

double RampTurning::speed(double t_s) const { return 2 * pi * speed_hz(ramp_, t_s); }

double RampTurning::gain(double t_s) const {
  return 2 * pi * (ramp_.even() ? ramp_.rate_hz_per_s : rate_hz_per_s(ramp_, piece_of(ramp_, t_s)));
}

double RampTurning::angle(double t_s) const {
  if (ramp_.even()) return 2 * pi * (ramp_.from_hz * t_s + ramp_.rate_hz_per_s * t_s * t_s / 2);
  const std::size_t piece = piece_of(ramp_, t_s);
  const double since = t_s - ramp_.knot_s[piece];
  return 2 * pi *
         (turns_[piece] + ramp_.knot_hz[piece] * since + rate_hz_per_s(ramp_, piece) * since * since / 2);
}

std::pair<double, double> RampTurning::speeds_between(double from_s, double to_s) const {
  auto [low, high] = std::minmax({speed(from_s), speed(to_s)});
  for (std::size_t k = 0; k < ramp_.knot_s.size(); ++k) {
    if (ramp_.knot_s[k] <= from_s || ramp_.knot_s[k] >= to_s) continue;
    low = std::min(low, 2 * pi * ramp_.knot_hz[k]);
    high = std::max(high, 2 * pi * ramp_.knot_hz[k]);
  }
  return {low, high};
}

RingDown read_ring_down(const std::filesystem::path& file, double from_s) {
  MeasuredTable table(file, "t_s");
  const std::size_t time = table.column("t_s");
  std::vector<std::size_t> sensors;
  for (int i = 0; i == 0 || has(table, fmt::format("sensor_{}_m", i)); ++i)
    sensors.push_back(table.column(fmt::format("sensor_{}_m", i)));
  RingDown data;
  std::vector<double> values;
  while (table.next()) {
    const double t = number(table, time);
    if (t < from_s) continue;
    if (!data.t_s.empty() && !(t > data.t_s.back()))
      throw ConfigError(fmt::format("{}:{}: t_s: does not rise, allowed: more than {}", file.string(),
                                    table.place().line, data.t_s.back()));
    data.t_s.push_back(t);
    for (const std::size_t sensor : sensors) values.push_back(number(table, sensor));
  }
  require_rows(file, data.t_s.size(), 8);
  const auto columns = static_cast<Eigen::Index>(sensors.size());
  data.signal_m = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), static_cast<Eigen::Index>(data.t_s.size()), columns);
  return data;
}

RunUp read_run_up(const std::filesystem::path& file) {
  MeasuredTable table(file, "t_s");
  const std::size_t time = table.column("t_s"), speed = table.column("speed_hz"),
                    order = table.column("order");
  std::vector<std::size_t> amplitudes{table.column("x_amplitude_m")}, phases{table.column("x_phase_deg")};
  if (has(table, "y_amplitude_m")) {
    amplitudes.push_back(table.column("y_amplitude_m"));
    phases.push_back(table.column("y_phase_deg"));
  }
  RunUp data{.ramp = {}, .t_s = {}, .phasor_m = {}, .window_turns = 2, .from_readings = true};
  std::vector<double> speeds;
  std::vector<std::vector<Complex>> rows;
  double last_s = -INFINITY;
  for (bool taken = true; table.next();) {
    if (number(table, order) != 1) continue;
    const double t_s = number(table, time);
    if (!(t_s > last_s))
      throw ConfigError(fmt::format("{}:{}: t_s: does not rise, allowed: more than {}", file.string(),
                                    table.place().line, last_s));
    last_s = t_s;
    if (taken) {
      data.t_s.push_back(t_s);
      speeds.push_back(number(table, speed));
      rows.emplace_back();
      for (std::size_t i = 0; i < amplitudes.size(); ++i)
        rows.back().push_back(std::polar(number(table, amplitudes[i]), number(table, phases[i]) * degree));
    }
    taken = !taken;
  }
  require_rows(file, rows.size(), 16);
  data.ramp = measured_ramp(data.t_s, speeds);
  data.phasor_m = matrix_of(rows);
  return data;
}

Steady read_steady(const std::filesystem::path& file, const std::vector<double>& angle_deg,
                   PhaseConvention convention) {
  MeasuredTable table(file, "speed_hz");
  const std::size_t speed = table.column("speed_hz");
  std::vector<std::size_t> amplitudes, phases;
  for (std::size_t i = 0;
       i == 0 || (i < angle_deg.size() && has(table, fmt::format("sensor_{}_amplitude_m", i))); ++i) {
    amplitudes.push_back(table.column(fmt::format("sensor_{}_amplitude_m", i)));
    phases.push_back(table.column(fmt::format("sensor_{}_phase_deg", i)));
  }
  Steady data;
  std::vector<std::vector<Complex>> rows;
  while (table.next()) {
    data.speed_hz.push_back(number(table, speed));
    if (!(data.speed_hz.back() > 0))
      throw ConfigError(fmt::format("{}:{}: speed_hz: is {}, allowed: above 0", file.string(),
                                    table.place().line, data.speed_hz.back()));
    rows.emplace_back();
    for (std::size_t i = 0; i < amplitudes.size(); ++i)
      rows.back().push_back(std::polar(number(table, amplitudes[i]), number(table, phases[i]) * degree));
  }
  require_rows(file, rows.size(), 1);
  data.phasor_m = matrix_of(rows);
  recount(PhaseConvention::mark, convention, angle_deg, data.phasor_m);
  return data;
}

bool has_phases_of_a_table(const MeasuredData& data) {
  const auto* run = std::get_if<RunUp>(&data.data);
  return std::holds_alternative<Steady>(data.data) || (run != nullptr && !run->from_readings);
}

void take_phases_as(PhaseConvention other, PhaseConvention read_as, const std::vector<double>& angle_deg,
                    MeasuredData& data) {
  if (!has_phases_of_a_table(data)) return;
  auto* steady = std::get_if<Steady>(&data.data);
  Eigen::MatrixXcd& phasor_m = steady != nullptr ? steady->phasor_m : std::get<RunUp>(data.data).phasor_m;
  recount(read_as, PhaseConvention::mark, angle_deg, phasor_m);
  recount(PhaseConvention::mark, other, angle_deg, phasor_m);
}

RubLines read_rub(const std::filesystem::path& directory) {
  CsvReader measures(directory / "measures.csv");
  const std::size_t quantity = measures.column("quantity"), value = measures.column("value");
  double speed_hz = NAN, period_turns = NAN;
  while (measures.next()) {
    if (measures.cells()[quantity] == "speed_hz") speed_hz = number(measures, value);
    if (measures.cells()[quantity] == "period_turns") period_turns = number(measures, value);
  }
  if (!(speed_hz > 0) || !std::isfinite(period_turns))
    throw ConfigError(
        measures.path().string() +
        ": holds no speed_hz and period_turns, allowed: a steady recording whose motion repeats");
  if (!(period_turns >= 1 && period_turns <= most_turns) || period_turns != std::floor(period_turns))
    throw ConfigError(fmt::format("{}: period_turns: is {}, allowed: a whole number from 1 to {}",
                                  measures.path().string(), period_turns, most_turns));
  RubLines data{.speed_hz = speed_hz, .turns = static_cast<int>(period_turns), .order = {}, .line_m = {}};
  CsvReader table(directory / "lines.csv");
  const std::size_t order = table.column("order"), amplitude = table.column("amplitude_m"),
                    phase = table.column("phase_deg");
  std::vector<Complex> lines;
  bool backward = false;
  while (table.next()) {
    backward = backward || number(table, order) < 0;
    if (number(table, order) == 0 || std::isnan(table.number(phase))) continue;
    data.order.push_back(number(table, order));
    lines.push_back(std::polar(number(table, amplitude), number(table, phase) * degree));
  }
  require_rows(table.path(), lines.size(), 2);
  if (!backward)
    throw ConfigError(table.path().string() + ": has the lines of one probe, allowed: those of two, x + iy");
  data.line_m = Eigen::Map<const Eigen::VectorXcd>(lines.data(), static_cast<Eigen::Index>(lines.size()));
  return data;
}

RunUp as_run_up(const Steady& steady, double rate_hz_per_s, double window_turns) {
  const bool rising = rate_hz_per_s > 0;
  if (rate_hz_per_s == 0 ||
      !std::ranges::is_sorted(steady.speed_hz, [&](double a, double b) { return rising ? a < b : a > b; }))
    throw ConfigError(
        "the speeds of a run-up do not all change in the direction of its rate, allowed: rising speeds with "
        "a rate above 0, falling ones with one below");
  RunUp data{.ramp = {steady.speed_hz.front(), rate_hz_per_s},
             .t_s = {},
             .phasor_m = steady.phasor_m,
             .window_turns = window_turns};
  for (const double speed : steady.speed_hz)
    data.t_s.push_back((speed - steady.speed_hz.front()) / rate_hz_per_s);
  return data;
}

}  // namespace rubsweep::fit
