#include "rubsweep/measurement/recording/integrated.hpp"

#include <cstddef>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::recording {

std::vector<std::complex<double>> integrated(std::vector<std::complex<double>> samples, int turns,
                                             const Integration& integration) {
  using Complex = std::complex<double>;
  if (integration.times == 0) return samples;
  response::spectrum::SpectrumWorkspace workspace;
  const auto lines = response::spectrum::transform(samples, workspace);
  const auto count = static_cast<long>(samples.size());
  for (long k = 0; k < count; ++k) {
    const double order = static_cast<double>(2 * k < count ? k : k - count) / turns;
    const bool kept = 2 * k != count && std::abs(order) >= integration.lowest_order;
    const auto place = static_cast<std::size_t>(k);
    // The inverse transform is the conjugate of the transform of the conjugates.
    samples[place] = kept ? std::conj(lines[place] / std::pow(Complex(0, order), integration.times)) /
                                static_cast<double>(count)
                          : Complex();
  }
  const auto back = response::spectrum::transform(samples, workspace);
  std::ranges::transform(back, samples.begin(), [](Complex z) { return std::conj(z); });
  return samples;
}

}  // namespace rubsweep::recording
