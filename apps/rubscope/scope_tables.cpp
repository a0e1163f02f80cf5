#include "rubscope/scope_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rubscope/overall_values.hpp"
#include "rubscope/verdict_text.hpp"
#include "rubsweep/analysis/linear/bode.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/numerics/straight_line.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"
#include "rubsweep/measurement/scope/waterfall.hpp"

namespace rubsweep::apps {

using namespace scope;

namespace {

using batch::csv_number;
using model::LengthUnit;
using recording::Recording;
using recording::samples_per_revolution;

std::string point(std::complex<double> z, bool plane) {
  return plane ? csv_number(z.real()) + ',' + csv_number(z.imag()) : csv_number(z.real());
}

/// Mean of a turn: the centre of the orbit, if the probes are DC coupled.
std::complex<double> centre_of(const Recording& recording, std::size_t turn) {
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < samples_per_revolution; ++k)
    sum += recording.displacement_m[turn * samples_per_revolution + k];
  return sum / static_cast<double>(samples_per_revolution);
}

std::string turns_csv(const Recording& recording, const std::vector<double>& speeds_hz) {
  std::string text = recording.plane ? "turn,t_s,speed_hz,x_m,y_m,centre_x_m,centre_y_m\n"
                                     : "turn,t_s,speed_hz,x_m,centre_x_m\n";
  for (std::size_t turn = 0; turn < speeds_hz.size(); ++turn) {
    text += fmt::format("{},{},{},{},{}\n", turn, csv_number(recording.turn_begin_s[turn]),
                        csv_number(speeds_hz[turn]),
                        point(recording.displacement_m[turn * samples_per_revolution], recording.plane),
                        point(centre_of(recording, turn), recording.plane));
  }
  return text;
}

std::string orbit_csv(const Verdict& verdict, bool plane) {
  std::string text = plane ? "turns,x_m,y_m\n" : "turns,x_m\n";
  for (std::size_t k = 0; k < verdict.orbit_m.size(); ++k) {
    text += fmt::format("{},{}\n", csv_number(static_cast<double>(k) / samples_per_revolution),
                        point(verdict.orbit_m[k], plane));
  }
  return text;
}

std::string lines_csv(const Verdict& verdict) {
  constexpr double degrees = 180 / std::numbers::pi;
  std::string text =
      "order,amplitude_m,uncertainty_m,phase_deg,phase_uncertainty_deg,line_order,line_order_uncertainty,"
      "line_amplitude_m,line_amplitude_uncertainty_m\n";
  for (const MeasuredLine& line : verdict.lines) {
    const double amplitude_m = std::abs(line.amplitude_m);
    // A line below the noise has no phase.
    const double phase_rad =
        amplitude_m > verdict.noise_at(line.order) ? line.uncertainty_m / amplitude_m : NAN;
    // Lines between the whole orders are within two uncertainties of the multiples of 1 / period.
    const bool whole = line.order == std::round(line.order);
    DiscreteLine own{line.order, whole ? 0 : verdict.order_room.value_or(0) / 2, amplitude_m,
                     line.uncertainty_m};
    if (!verdict.period && line.order != 0) {
      const DiscreteLine* found = line_of_bin(verdict, line.order);
      own = found ? *found : DiscreteLine{NAN, NAN, NAN, NAN};
    }
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_number(line.order), csv_number(amplitude_m),
                    csv_number(line.uncertainty_m),
                    csv_number(std::isnan(phase_rad) ? NAN : std::arg(line.amplitude_m) * degrees),
                    csv_number(phase_rad * degrees), csv_number(own.order), csv_number(own.order_uncertainty),
                    csv_number(own.amplitude_m), csv_number(own.amplitude_uncertainty_m));
  }
  return text;
}

/// Difference between the largest and the smallest value of the orbit in one direction, m.
double peak_to_peak_m(const Verdict& verdict, bool y) {
  const auto part = [&](std::complex<double> z) { return y ? z.imag() : z.real(); };
  const auto [low, high] = std::ranges::minmax_element(verdict.orbit_m, {}, part);
  return part(*high) - part(*low);
}

std::string speed_text(const Recording& recording, const std::vector<double>& speeds_hz) {
  const auto [slowest, fastest] = std::ranges::minmax(speeds_hz);
  const double mean_hz = recording.mean_speed_hz();
  return fmt::format("speed     {}, {}, {} turns, {:.4g} readings a turn\n", model::speed_text(mean_hz),
                     model::speed_range_text(slowest, fastest, 5), recording.turns(),
                     recording.sampling_rate_hz / mean_hz);
}

/// Text about readings that were integrated.
std::string integration_text(const Recording& recording) {
  const int times = recording.integration.times;
  if (times == 0) return {};
  const double lowest = recording.integration.lowest_order;
  return fmt::format(
      "measured  {} of the {}, integrated {}: orders below {:.3g}X ({:.3g} Hz) are lost, and so is the "
      "centre\n",
      times == 1 ? "velocity" : "acceleration",
      recording.place == recording::Place::casing ? "casing" : "shaft", times == 1 ? "once" : "twice", lowest,
      lowest * recording.mean_speed_hz());
}

std::string findings_text(const Recording& recording) {
  std::string text;
  for (const std::string& finding : recording.findings) text += fmt::format("warning   {}\n", finding);
  return text;
}

/// Linear change of the speed, fitted by least squares.
struct Ramp {
  double rate_hz_per_s = 0;
  double largest_error = 0;  ///< largest error of the speed, relative to its whole change
};

Ramp ramp_of(const std::vector<OrderPoint>& points) {
  std::vector<double> t_s, speed_hz;
  for (const OrderPoint& point : points) {
    t_s.push_back(point.t_s);
    speed_hz.push_back(point.speed_hz);
  }
  const numerics::StraightLine line = numerics::line_through(t_s, speed_hz);
  const double change_hz = std::abs(line.slope * (t_s.back() - t_s.front()));
  return {.rate_hz_per_s = line.slope,
          .largest_error = numerics::largest_distance(line, t_s, speed_hz) / change_hz};
}

/// Text about the largest 1X in one direction and, where the speed changes evenly, about its mode.
std::string run_text(const std::vector<OrderPoint>& points, bool y, bool phased,
                     const model::ShownLengths& shown, std::string& measures) {
  constexpr double even = 0.02;
  std::vector<linear::BodePoint> plot;
  for (const OrderPoint& point : points) {
    const std::complex<double> amplitude_m = y ? point.y_m : point.x_m;
    plot.push_back({point.speed_hz, std::abs(amplitude_m), std::arg(amplitude_m) * 180 / std::numbers::pi});
  }
  const char name = y ? 'y' : 'x';
  const auto top = std::ranges::max_element(plot, {}, &linear::BodePoint::amplitude_m);
  std::string text = fmt::format("1X in {}    largest at {}, {}", name, model::speed_text(top->speed_hz, 5),
                                 model::amplitude_text(top->amplitude_m, shown, LengthUnit::um));
  measures += fmt::format("speed_of_largest_1x_{}_hz,{},\n", name, csv_number(top->speed_hz));
  if (!phased) return text + "; without its phase no mode is fitted\n";
  const Ramp ramp = ramp_of(points);
  if (ramp.largest_error > even)
    return text + fmt::format("; the speed does not change evenly ({:.2g} % off), no mode is fitted\n",
                              100 * ramp.largest_error);
  const auto fit = linear::fit_ramp_resonance(plot, ramp.rate_hz_per_s);
  if (!fit) return text + "; no single mode fits\n";
  measures +=
      fmt::format("resonance_{0}_hz,{1},\ndamping_ratio_{0},{2},\nmisfit_{0},{3},\n", name,
                  csv_number(fit->frequency_hz), csv_number(fit->damping_ratio), csv_number(fit->misfit));
  return text + fmt::format("; a mode of {:.5g} Hz, damping ratio {:.3g}, explains {} but for {:.2g} %\n",
                            fit->frequency_hz, fit->damping_ratio,
                            model::speed_range_text(fit->from_hz, fit->to_hz, 4), 100 * fit->misfit);
}

/// Tables of any recording.
ScopeTables begin_tables(const Recording& recording, const std::vector<double>& orders) {
  const std::vector<double> speeds_hz = recording::turn_speeds_hz(recording.turn_begin_s);
  return {.turns_csv = turns_csv(recording, speeds_hz),
          .orbit_csv = {},
          .lines_csv = {},
          .bode_csv = bode_csv(recording, orders),
          .waterfall_csv = waterfall_csv(recording),
          .measures_csv = "quantity,value,uncertainty\n",
          .summary = speed_text(recording, speeds_hz) + integration_text(recording)};
}

}  // namespace

ScopeTables tables_of(const Recording& recording, const Verdict& verdict, const std::vector<double>& orders,
                      const model::ShownLengths& shown) {
  const double mean_hz = recording.mean_speed_hz();
  // With one probe, the noise of a line comes from half as many numbers as with two probes.
  const double numbers = (recording.plane ? 1.0 : 2.0) * verdict.turns * samples_per_revolution;
  const double sample_noise_m = verdict.noise_m * std::sqrt(numbers);
  ScopeTables tables = begin_tables(recording, orders);
  tables.orbit_csv = orbit_csv(verdict, recording.plane);
  tables.lines_csv = lines_csv(verdict);
  const auto measure = [&](const char* quantity, double value, double uncertainty) {
    tables.measures_csv += fmt::format("{},{},{}\n", quantity, csv_number(value), csv_number(uncertainty));
  };
  measure("turns", verdict.turns, NAN);
  measure("speed_hz", mean_hz, NAN);
  if (verdict.period) measure("period_turns", *verdict.period, NAN);
  measure("line_noise_m", verdict.noise_m, NAN);
  measure("visible_line_m", verdict.visible_m, NAN);
  // Noise at both ends of the range; averaging over periods reduces it.
  const double periods = static_cast<double>(verdict.turns) / verdict.period.value_or(verdict.turns);
  const double end_noise_m = sample_noise_m * std::sqrt(2 / periods);
  measure("peak_to_peak_x_m", peak_to_peak_m(verdict, false), end_noise_m);
  if (recording.plane) measure("peak_to_peak_y_m", peak_to_peak_m(verdict, true), end_noise_m);
  if (verdict.whirl) measure("forward_share", verdict.forward_share, verdict.forward_share_uncertainty);
  if (verdict.period) measure("slow_modulation_m", verdict.modulation_m, NAN);
  if (verdict.period) measure("largest_line_beside_m", verdict.beside_m, NAN);
  tables.summary +=
      fmt::format("motion    {}\n          {}", motion_text(verdict), doubt_text(verdict, mean_hz, shown));
  tables.summary += fmt::format("size      {} peak to peak",
                                model::length_text(peak_to_peak_m(verdict, false), shown, LengthUnit::um));
  if (recording.plane)
    tables.summary +=
        " in x, " + model::length_text(peak_to_peak_m(verdict, true), shown, LengthUnit::um) + " in y";
  tables.summary += fmt::format("; a line has {} of noise\n",
                                model::amplitude_text(verdict.noise_m, shown, LengthUnit::um, 2));
  tables.summary += content_text(verdict, shown);
  const std::vector<OverallValue> overall = overall_values(recording);
  tables.measures_csv += overall_csv(recording, overall);
  tables.summary += overall_text(recording, overall, shown);
  tables.summary += findings_text(recording);
  return tables;
}

ScopeTables tables_of_run(const Recording& recording, const std::vector<double>& orders,
                          const model::ShownLengths& shown) {
  ScopeTables tables = begin_tables(recording, orders);
  const std::vector<OrderPoint> one_x = order_history(recording, 1);
  const Ramp ramp = ramp_of(one_x);
  tables.measures_csv +=
      fmt::format("turns,{},\nrate_hz_per_s,{},\n", recording.turns(), csv_number(ramp.rate_hz_per_s));
  tables.summary += fmt::format(
      "motion    changes with the speed, by {:.4g} Hz a second; from_s and to_s in the description take a "
      "steady stretch\n",
      ramp.rate_hz_per_s);
  tables.summary += run_text(one_x, false, recording.phased, shown, tables.measures_csv);
  if (recording.plane) tables.summary += run_text(one_x, true, recording.phased, shown, tables.measures_csv);
  tables.summary += findings_text(recording);
  return tables;
}

}  // namespace rubsweep::apps
