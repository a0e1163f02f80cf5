#include "rubsweep/measurement/diagnose/motion_lines.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose {

MotionLines lines_of(std::span<const std::complex<double>> samples, int turns, double most_order,
                     response::spectrum::SpectrumWorkspace& workspace) {
  const int last = static_cast<int>(most_order * turns), count = static_cast<int>(samples.size());
  if (turns < 1 || 2 * last >= count) throw SolverError("too few samples for lines of that order");
  const auto transformed = response::spectrum::transform(samples, workspace);
  MotionLines lines{turns, Eigen::VectorXcd(2 * last + 1)};
  for (int k = -last; k <= last; ++k)
    lines.at(k) = transformed[static_cast<std::size_t>(k < 0 ? k + count : k)] / static_cast<double>(count);
  return lines;
}

MotionLines up_to(const MotionLines& lines, double most_order) {
  const int last = std::min(lines.last(), static_cast<int>(most_order * lines.turns));
  return {lines.turns, lines.amplitude.segment(lines.last() - last, 2 * last + 1)};
}

Eigen::VectorXcd waveform_of(const MotionLines& lines, int samples_per_revolution,
                             response::spectrum::SpectrumWorkspace& workspace) {
  const int count = samples_per_revolution * lines.turns, last = lines.last();
  if (2 * last >= count) throw SolverError("too few samples for these lines");
  // The inverse transform is the conjugate of the transform of the conjugates.
  std::vector<std::complex<double>> conjugates(static_cast<std::size_t>(count));
  for (int k = -last; k <= last; ++k)
    if (k != 0) conjugates[static_cast<std::size_t>(k < 0 ? k + count : k)] = std::conj(lines.at(k));
  const auto transformed = response::spectrum::transform(conjugates, workspace);
  return Eigen::Map<const Eigen::VectorXcd>(transformed.data(), count).conjugate();
}

double size_of(const MotionLines& lines) {
  return std::sqrt(std::max(0.0, lines.amplitude.squaredNorm() - std::norm(lines.at(0))));
}

}  // namespace rubsweep::diagnose
