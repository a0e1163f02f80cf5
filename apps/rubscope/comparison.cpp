#include "rubscope/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace scope;

namespace {

using Complex = std::complex<double>;
using batch::csv_number;
constexpr double degrees = 180 / std::numbers::pi;

/// Fourier component e^{2 pi i k j / N} of a period.
Complex component(std::span<const Complex> period, int k) {
  Complex sum = 0;
  const auto count = static_cast<double>(period.size());
  for (std::size_t j = 0; j < period.size(); ++j)
    sum += period[j] * std::polar(1.0, -2 * std::numbers::pi * k * static_cast<double>(j) / count);
  return sum / count;
}

/// Pairs of measured and simulated lines; the key is their order in multiples of 1 / `common`.
std::map<int, ComparedLine> pairs_of(const Verdict& measured, std::span<const Complex> simulated_m, int turns,
                                     int common) {
  std::map<int, ComparedLine> pairs;
  for (const MeasuredLine& line : measured.lines)
    pairs[static_cast<int>(std::lround(line.order * common))].measured_m = line.amplitude_m;
  const int last =
      std::min(static_cast<int>(most_order * turns), static_cast<int>(simulated_m.size()) / 2 - 1);
  for (int k = -last; k <= last; ++k) pairs[k * (common / turns)].simulated_m = component(simulated_m, k);
  for (auto& [k, pair] : pairs) pair.order = static_cast<double>(k) / common;
  pairs.erase(0);
  return pairs;
}

double squares(const std::map<int, ComparedLine>& pairs, double turned_by) {
  double sum = 0;
  for (const auto& [k, pair] : pairs)
    sum += std::norm(pair.measured_m -
                     pair.simulated_m * std::polar(1.0, 2 * std::numbers::pi * pair.order * turned_by));
  return sum;
}

/// Angle in turns with the smallest difference: a fine grid over the period, then repeated refinement of its
/// best cell.
double best_turn(const std::map<int, ComparedLine>& pairs, int period) {
  constexpr int steps_a_turn = 256;
  int best = 0;
  for (int k = 0; k < period * steps_a_turn; ++k) {
    if (squares(pairs, static_cast<double>(k) / steps_a_turn) <
        squares(pairs, static_cast<double>(best) / steps_a_turn))
      best = k;
  }
  double low = (best - 1.0) / steps_a_turn, high = (best + 1.0) / steps_a_turn;
  for (int round = 0; round < 80; ++round) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (squares(pairs, a) < squares(pairs, b) ? high : low) = squares(pairs, a) < squares(pairs, b) ? b : a;
  }
  return (low + high) / 2;
}

}  // namespace

Comparison compare(const Verdict& measured, std::span<const Complex> simulated_m, int turns, bool plane) {
  std::vector<Complex> simulated(simulated_m.begin(), simulated_m.end());
  if (!plane)
    for (Complex& z : simulated) z = z.real();
  const int common = std::lcm(measured.period.value_or(1), turns);
  auto pairs = pairs_of(measured, simulated, turns, common);
  Comparison comparison{.turned_by = best_turn(pairs, common)};
  double sum = 0, left = 0, all = 0;
  for (auto& [k, pair] : pairs) {
    pair.simulated_m *= std::polar(1.0, 2 * std::numbers::pi * pair.order * comparison.turned_by);
    const double difference_m = std::abs(pair.measured_m - pair.simulated_m);
    pair.difference =
        difference_m / std::max(measured.noise_at(pair.order), std::numeric_limits<double>::min());
    sum += pair.difference * pair.difference;
    left += difference_m * difference_m;
    all += std::norm(pair.measured_m);
    comparison.lines.push_back(pair);
  }
  comparison.misfit = std::sqrt(sum / static_cast<double>(pairs.size()));
  comparison.unexplained = all > 0 ? left / all : 0;
  // Simulated orbit from the mark on, computed from its lines.
  comparison.simulated_m.resize(simulated.size());
  const double step = 2 * std::numbers::pi * turns / static_cast<double>(simulated.size());
  for (std::size_t j = 0; j < simulated.size(); ++j) {
    for (const ComparedLine& line : comparison.lines)
      comparison.simulated_m[j] +=
          line.simulated_m * std::polar(1.0, line.order * step * static_cast<double>(j));
  }
  return comparison;
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "order,measured_m,measured_phase_deg,simulated_m,simulated_phase_deg,difference\n";
  for (const ComparedLine& line : comparison.lines) {
    text +=
        fmt::format("{},{},{},{},{},{}\n", csv_number(line.order), csv_number(std::abs(line.measured_m)),
                    csv_number(std::arg(line.measured_m) * degrees), csv_number(std::abs(line.simulated_m)),
                    csv_number(std::arg(line.simulated_m) * degrees), csv_number(line.difference));
  }
  return text;
}

std::string simulated_orbit_csv(const Comparison& comparison, int turns, bool plane) {
  std::string text = plane ? "turns,x_m,y_m\n" : "turns,x_m\n";
  for (std::size_t j = 0; j < comparison.simulated_m.size(); ++j) {
    text += csv_number(static_cast<double>(j) * turns / static_cast<double>(comparison.simulated_m.size()));
    text.append(",").append(csv_number(comparison.simulated_m[j].real()));
    if (plane) text.append(",").append(csv_number(comparison.simulated_m[j].imag()));
    text += '\n';
  }
  return text;
}

std::string comparison_summary(const Comparison& comparison, const model::ShownLengths& shown) {
  const auto amplitude = [&](std::complex<double> line_m) {
    return model::amplitude_text(std::abs(line_m), shown, model::LengthUnit::um);
  };
  std::string text = fmt::format(
      "compared  the simulated motion leaves {:.3g} % of the energy; its lines are off by {:.3g} standard "
      "uncertainties (root mean square of {}), with the mark {:.4g} turns behind its begin\n",
      100 * comparison.unexplained, comparison.misfit, comparison.lines.size(), comparison.turned_by);
  std::vector<ComparedLine> lines = comparison.lines;
  std::ranges::sort(lines, std::greater{}, &ComparedLine::difference);
  lines.resize(std::min<std::size_t>(lines.size(), 3));
  for (const ComparedLine& line : lines) {
    text += fmt::format("          {:+.4g}X: measured {}, simulated {}, {:.3g} uncertainties apart\n",
                        line.order, amplitude(line.measured_m), amplitude(line.simulated_m), line.difference);
  }
  return text;
}

}  // namespace rubsweep::apps
