#include "rubsweep/analysis/trace/probe.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>

namespace rubsweep::trace {
namespace {

constexpr std::uint64_t noise_seed = 1;

using Complex = std::complex<double>;

constexpr double least_angle = 0.17;  ///< smallest |sin| of the angle between two probes: sin 10 degrees
constexpr double highest_order = 8;
constexpr double below_folding = 0.49;  ///< highest frequency of a line, as a share of the sampling rate
constexpr double unexplained = 1e-3;
constexpr double noise_share = 1.5;
constexpr double degree = std::numbers::pi / 180;

/// Sum of e^{i step j} over j = 0 .. count - 1.
Complex geometric(double step_rad, std::size_t count) {
  Complex sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += std::polar(1.0, step_rad * static_cast<double>(j));
  return sum;
}

/// Energy per reading that remains of `z` after a fit of lines at multiples of 1/n, including 0X. Since
/// readings are equidistant, the normal equations depend only on the difference between the orders of two
/// lines.
double left_by_lines(std::span<const Complex> z, double turns_per_reading, int n) {
  const double highest = std::min(highest_order, below_folding / turns_per_reading);
  const int k_most = static_cast<int>(std::floor(highest * n));
  const Eigen::Index lines = 2 * k_most + 1;
  if (lines >= static_cast<Eigen::Index>(z.size())) return std::numeric_limits<double>::infinity();
  const double spacing_rad = 2 * std::numbers::pi * turns_per_reading / n;
  std::vector<Complex> overlap;
  for (Eigen::Index d = 0; d < lines; ++d)
    overlap.push_back(geometric(spacing_rad * static_cast<double>(d), z.size()));
  Eigen::MatrixXcd normal(lines, lines);
  Eigen::VectorXcd seen(lines);
  for (Eigen::Index a = 0; a < lines; ++a) {
    for (Eigen::Index b = 0; b < lines; ++b) {
      const auto d = static_cast<std::size_t>(std::abs(b - a));
      normal(a, b) = b >= a ? overlap[d] : std::conj(overlap[d]);
    }
    const double rate = spacing_rad * static_cast<double>(a - k_most);
    Complex sum = 0;
    for (std::size_t j = 0; j < z.size(); ++j) sum += z[j] * std::polar(1.0, -rate * static_cast<double>(j));
    seen(a) = sum;
  }
  double energy = 0;
  for (const Complex& value : z) energy += std::norm(value);
  const double explained = seen.dot(normal.ldlt().solve(seen)).real();
  return std::max(0.0, energy - explained) / static_cast<double>(z.size());
}

double energy_without_mean(std::span<const Complex> z) {
  Complex mean = 0;
  for (const Complex& value : z) mean += value;
  mean /= static_cast<double>(z.size());
  double energy = 0;
  for (const Complex& value : z) energy += std::norm(value - mean);
  return energy / static_cast<double>(z.size());
}

std::span<const Complex> last_of(const std::vector<Complex>& z, double turns_per_reading, int turns) {
  const auto wanted = static_cast<std::size_t>(std::floor(turns / turns_per_reading));
  return std::span(z).last(std::min(wanted, z.size()));
}

}  // namespace

int probe_refinement(int samples_per_revolution) {
  return std::max(1, probe_samples_per_revolution / samples_per_revolution);
}

ProbeReader::ProbeReader(const scene::Scene& scene, double speed_hz, Probes probes)
    : probes_(std::move(probes)),
      length_m_(scene.length_scale_m),
      speed_hz_(speed_hz),
      speed_rad_per_s_(scene.speed_rad_per_s),
      states_(2 * static_cast<std::size_t>(scene.structure.coordinates())) {}

void ProbeReader::add(const integrate::run::TurnReport& turn) {
  for (;; ++count_) {
    const double turns =
        static_cast<double>(count_) * probes_.sample_s * speed_hz_ - static_cast<double>(turn_);
    if (turns >= 1) break;
    for (Eigen::Index probe = 0; probe < probes_.rows.rows(); ++probe)
      readings_.push_back(reading(turn, std::max(0.0, turns), probe));
  }
  ++turn_;
}

/// Reading by the cubic through values and rates of the neighbouring samples. The last sample is the section.
double ProbeReader::reading(const integrate::run::TurnReport& turn, double turns, Eigen::Index probe) const {
  const auto n = static_cast<Eigen::Index>(states_ / 2);
  const double place = turns * turn.sample_count;
  const int k = std::min(static_cast<int>(place), turn.sample_count - 1);
  const double x = place - k, y = 1 - x, h = 2 * std::numbers::pi / turn.sample_count;
  const double* from =
      turn.samples.data() + static_cast<std::ptrdiff_t>(k) * static_cast<std::ptrdiff_t>(states_);
  const double* to = k + 1 < turn.sample_count ? from + states_ : turn.section.data();
  using Part = Eigen::Map<const Eigen::VectorXd>;
  const auto row = probes_.rows.row(probe);
  const double a = row.dot(Part(from, n)), a_rate = row.dot(Part(from + n, n)), b = row.dot(Part(to, n)),
               b_rate = row.dot(Part(to + n, n));
  const int derivative = probes_.derivative.empty() ? 0 : probes_.derivative[static_cast<std::size_t>(probe)];
  if (derivative == 2)
    return length_m_ * speed_rad_per_s_ * speed_rad_per_s_ / h *
           (6 * (y - x) * (b - a) / h + (2 * x - 4 * y) * a_rate + (4 * x - 2 * y) * b_rate);
  if (derivative == 1)
    return length_m_ * speed_rad_per_s_ *
           (6 * x * y * (b - a) / h + y * (y - 2 * x) * a_rate + x * (x - 2 * y) * b_rate);
  return length_m_ *
         (y * y * ((1 + 2 * x) * a + x * h * a_rate) + x * x * ((1 + 2 * y) * b - y * h * b_rate));
}

double Probes::noise_m() const {
  double largest_m = 0;
  for (std::size_t i = 0; i < noise.size(); ++i)
    if (derivative.empty() || derivative[i] == 0) largest_m = std::max(largest_m, noise[i]);
  return largest_m;
}

Eigen::MatrixXd ProbeReader::readings() const {
  const Eigen::Index probes = probes_.rows.rows();
  const auto count = static_cast<Eigen::Index>(readings_.size()) / std::max<Eigen::Index>(1, probes);
  Eigen::MatrixXd readings(count, probes);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index i = 0; i < probes; ++i)
      readings(k, i) = readings_[static_cast<std::size_t>(k * probes + i)];
  }
  std::mt19937_64 random(noise_seed);
  std::normal_distribution<double> noise;
  for (Eigen::Index i = 0; i < probes; ++i) {
    const double deviation = probes_.noise.empty() ? 0 : probes_.noise[static_cast<std::size_t>(i)];
    if (deviation == 0) continue;
    for (double& value : readings.col(i)) value += deviation * noise(random);
  }
  return readings;
}

std::optional<ProbePair> pair_of(const std::vector<double>& angle_deg, const std::vector<double>& places_m) {
  for (std::size_t i = 0; i < angle_deg.size(); ++i) {
    for (std::size_t j = i + 1; j < angle_deg.size(); ++j) {
      const bool same_place = places_m.empty() || places_m[i] == places_m[j];
      if (same_place && std::abs(std::sin((angle_deg[j] - angle_deg[i]) * degree)) > least_angle)
        return ProbePair{i, j};
    }
  }
  return std::nullopt;
}

std::vector<Complex> displacement_of(const Eigen::MatrixXd& readings_m, const ProbePair& pair,
                                     const std::vector<double>& angle_deg) {
  const double a = angle_deg[pair.first] * degree, b = angle_deg[pair.second] * degree,
               sine = std::sin(b - a);
  std::vector<Complex> z;
  for (Eigen::Index k = 0; k < readings_m.rows(); ++k) {
    const double first = readings_m(k, static_cast<Eigen::Index>(pair.first)),
                 second = readings_m(k, static_cast<Eigen::Index>(pair.second));
    z.emplace_back((first * std::sin(b) - second * std::sin(a)) / sine,
                   (second * std::cos(a) - first * std::cos(b)) / sine);
  }
  return z;
}

ProbePeriod find_period(const std::vector<Complex>& displacement_m, double sample_s, double speed_hz,
                        double noise_m, int turns, int max_order) {
  const double turns_per_reading = sample_s * speed_hz;
  const auto z = last_of(displacement_m, turns_per_reading, turns);
  ProbePeriod found;
  found.readings = static_cast<int>(z.size());
  found.unexplained_share = 1;
  if (z.empty()) return found;
  const double energy = energy_without_mean(z);
  if (!(energy > 0)) return found;
  found.allowed_share = unexplained + noise_share * 2 * noise_m * noise_m / energy;
  for (int n = 1; n <= max_order; ++n) {
    const double share = left_by_lines(z, turns_per_reading, n) / energy;
    if (share <= found.allowed_share) {
      found.period = n;
      found.unexplained_share = share;
      return found;
    }
    found.unexplained_share = std::min(found.unexplained_share, share);
  }
  return found;
}

response::spectrum::FullSpectrum probe_spectrum(const std::vector<Complex>& displacement_m, double sample_s,
                                                double speed_hz, int turns, int period,
                                                response::spectrum::SpectrumWorkspace& workspace) {
  const double turns_per_reading = sample_s * speed_hz;
  const auto z = last_of(displacement_m, turns_per_reading, turns);
  std::size_t best = 0;
  double best_off = std::numeric_limits<double>::infinity();
  int best_turns = 0;
  for (std::size_t count = z.size(); count > z.size() / 2 && count > 0; --count) {
    const double there = static_cast<double>(count) * turns_per_reading;
    const double whole = period * std::round(there / period), off = std::abs(there - whole);
    if (whole < 1 || !(off < best_off - 1e-9)) continue;
    best = count;
    best_off = off;
    best_turns = static_cast<int>(whole);
  }
  if (best == 0) return {};
  auto spectrum = response::spectrum::full_spectrum(z.last(best), 1, workspace);
  spectrum.turns = best_turns;
  return spectrum;
}

}  // namespace rubsweep::trace
