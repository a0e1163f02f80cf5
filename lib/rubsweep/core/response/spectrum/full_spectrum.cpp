#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

#include <fftw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <new>

#include "rubsweep/core/error.hpp"

namespace rubsweep::response::spectrum {
namespace {

// FFTW guarantees that std::complex<double> and fftw_complex have the same layout.
fftw_complex* as_fftw(std::complex<double>* buffer) { return reinterpret_cast<fftw_complex*>(buffer); }

// FFTW's planner is not thread-safe, executing a plan is. A plan fits every pair of distinct aligned buffers.
class PlanCache {
 public:
  PlanCache() = default;
  PlanCache(const PlanCache&) = delete;
  PlanCache& operator=(const PlanCache&) = delete;
  ~PlanCache() {
    for (const auto& [length, plan] : modes_) fftw_destroy_plan(plan);
  }

  fftw_plan plan(int length, fftw_complex* samples, fftw_complex* lines) {
    const std::scoped_lock lock(mutex_);
    if (const auto known = modes_.find(length); known != modes_.end()) return known->second;
    // Wisdom from earlier plans may influence even an estimated plan.
    fftw_forget_wisdom();
    fftw_plan made =
        fftw_plan_dft_1d(length, samples, lines, FFTW_FORWARD, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
    if (made == nullptr) throw SolverError(fmt::format("FFTW has no plan for {} samples", length));
    return modes_.emplace(length, made).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<int, fftw_plan> modes_;
};

PlanCache& plan_cache() {
  static PlanCache cache;
  return cache;
}

}  // namespace

void SpectrumWorkspace::Free::operator()(std::complex<double>* buffer) const noexcept { fftw_free(buffer); }

void SpectrumWorkspace::reserve(std::size_t length) {
  if (length <= capacity_) return;
  const auto aligned = [length] {
    auto* buffer = reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(length));
    if (buffer == nullptr) throw std::bad_alloc();
    return Buffer(buffer);
  };
  capacity_ = 0;
  samples_ = aligned();
  lines_ = aligned();
  capacity_ = length;
}

void FullSpectrum::refuse(int k) const {
  throw SolverError(
      fmt::format("spectrum has lines {} to {}, line {} was asked for", first_line(), last_line(), k));
}

double FullSpectrum::energy_without_mean() const {
  double sum = 0;
  for (int k = first_line(); k <= last_line(); ++k) {
    if (k != 0) sum += amplitude(k) * amplitude(k);
  }
  return sum;
}

int dominant_line(const FullSpectrum& spectrum) {
  constexpr double equal_within = 1e-9;
  int dominant = 0;
  double largest = -1;
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    if (k == 0 || spectrum.amplitude(k) <= largest) continue;
    dominant = k;
    largest = spectrum.amplitude(k);
  }
  const bool has_forward_twin = dominant < 0 && -dominant <= spectrum.last_line() &&
                                spectrum.amplitude(-dominant) >= (1 - equal_within) * largest;
  return has_forward_twin ? -dominant : dominant;
}

std::span<const std::complex<double>> transform(std::span<const std::complex<double>> z,
                                                SpectrumWorkspace& workspace) {
  if (z.empty()) throw SolverError("a transform of 0 samples");
  workspace.reserve(z.size());
  fftw_complex* samples = as_fftw(workspace.samples_.get());
  fftw_complex* lines = as_fftw(workspace.lines_.get());
  fftw_plan plan = plan_cache().plan(static_cast<int>(z.size()), samples, lines);
  std::ranges::copy(z, workspace.samples_.get());
  fftw_execute_dft(plan, samples, lines);
  return {workspace.lines_.get(), z.size()};
}

FullSpectrum full_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                           SpectrumWorkspace& workspace) {
  const std::size_t count = displacement_m.size();
  if (turns < 1 || count == 0 || count % static_cast<std::size_t>(turns) != 0) {
    throw SolverError(fmt::format("{} samples cannot cover {} turns", count, turns));
  }
  const int length = static_cast<int>(count);
  const auto lines = transform(displacement_m, workspace);
  FullSpectrum spectrum{.turns = turns, .samples_per_revolution = length / turns, .amplitude_m = {}};
  spectrum.amplitude_m.resize(count);
  // FFTW lists k = 0, 1, ... and then the negative k; this spectrum starts at the most negative k.
  const std::size_t negative = count / 2;
  for (std::size_t j = 0; j < count; ++j) {
    spectrum.amplitude_m[(j + negative) % count] =
        std::sqrt(std::norm(lines[j])) / static_cast<double>(length);
  }
  return spectrum;
}

}  // namespace rubsweep::response::spectrum
