#include "rubsweep/analysis/trace/probe.hpp"

#include <algorithm>
#include <numbers>
#include <random>
#include <utility>

namespace rubsweep::trace {
namespace {

constexpr std::uint64_t noise_seed = 1;

}  // namespace

int probe_refinement(int samples_per_revolution) {
  return std::max(1, probe_samples_per_revolution / samples_per_revolution);
}

ProbeReader::ProbeReader(const scene::Scene& scene, double speed_hz, Probes probes)
    : probes_(std::move(probes)),
      length_m_(scene.length_scale_m),
      speed_hz_(speed_hz),
      states_(2 * static_cast<std::size_t>(scene.structure.coordinates())) {}

void ProbeReader::add(const integrate::run::TurnReport& turn) {
  for (;; ++count_) {
    const double turns =
        static_cast<double>(count_) * probes_.sample_s * speed_hz_ - static_cast<double>(turn_);
    if (turns >= 1) break;
    for (Eigen::Index probe = 0; probe < probes_.rows.rows(); ++probe)
      readings_m_.push_back(reading(turn, std::max(0.0, turns), probe));
  }
  ++turn_;
}

/// Reading by the cubic through values and rates of the neighbouring samples, the last one the section.
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
  return length_m_ *
         (y * y * ((1 + 2 * x) * a + x * h * a_rate) + x * x * ((1 + 2 * y) * b - y * h * b_rate));
}

Eigen::MatrixXd ProbeReader::readings_m() const {
  const Eigen::Index probes = probes_.rows.rows();
  const auto count = static_cast<Eigen::Index>(readings_m_.size()) / std::max<Eigen::Index>(1, probes);
  Eigen::MatrixXd readings(count, probes);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index i = 0; i < probes; ++i)
      readings(k, i) = readings_m_[static_cast<std::size_t>(k * probes + i)];
  }
  if (probes_.noise_m == 0) return readings;
  std::mt19937_64 random(noise_seed);
  std::normal_distribution<double> noise(0, probes_.noise_m);
  for (Eigen::Index i = 0; i < probes; ++i) {
    for (double& value : readings.col(i)) value += noise(random);
  }
  return readings;
}

}  // namespace rubsweep::trace
