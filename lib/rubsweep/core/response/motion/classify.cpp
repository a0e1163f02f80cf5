#include "rubsweep/core/response/motion/classify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "rubsweep/core/error.hpp"

namespace rubsweep::response::motion {
namespace {

void require_shape(const Window& window) {
  if (window.turns < 1 || window.samples_per_revolution < 4 || window.states < 1 ||
      !(window.clearance_m > 0)) {
    throw SolverError(fmt::format("a window cannot have {} turns of {} samples, {} states and clearance {} m",
                                  window.turns, window.samples_per_revolution, window.states,
                                  window.clearance_m));
  }
  const auto turns = static_cast<std::size_t>(window.turns);
  const std::size_t samples = turns * static_cast<std::size_t>(window.samples_per_revolution);
  const std::size_t numbers = (turns + 1) * static_cast<std::size_t>(window.states);
  if (window.displacement_m.size() != samples || window.section.size() != numbers ||
      window.contact.size() != turns) {
    throw SolverError(fmt::format(
        "a window of {} turns takes {} samples, {} section numbers and the contact facts of every "
        "turn, got {}, {} and {}",
        window.turns, samples, numbers, window.displacement_m.size(), window.section.size(),
        window.contact.size()));
  }
}

// A rotor that slides without a break has no hits; therefore hits and contact share must both be zero.
bool never_touches(const ContactFacts& contact) { return contact.hits == 0 && contact.contact_fraction == 0; }

double largest_line_m(const spectrum::FullSpectrum& spectrum) {
  return spectrum.amplitude(spectrum::dominant_line(spectrum));
}

struct OffOrder {
  double energy_fraction = 0;
  bool agrees = true;
};

// Energy and largest line off the multiples of 1/order; spectrum.turns must be a multiple of order.
OffOrder off_order(const spectrum::FullSpectrum& spectrum, int order, double clearance_m) {
  const int spacing = spectrum.turns / order;
  const double floor_m = significant_share_of_clearance * clearance_m;
  const double significant_m = std::max(significant_share_of_largest * largest_line_m(spectrum), floor_m);
  double off_energy = 0;
  double largest_off_m = 0;
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    if (k % spacing == 0) continue;
    const double amplitude_m = spectrum.amplitude(k);
    off_energy += amplitude_m * amplitude_m;
    largest_off_m = std::max(largest_off_m, amplitude_m);
  }
  const double energy = spectrum.energy_without_mean();
  const bool energy_agrees = off_energy < off_order_energy_limit * energy || off_energy <= floor_m * floor_m;
  return {.energy_fraction = energy > 0 ? off_energy / energy : 0,
          .agrees = energy_agrees && largest_off_m <= significant_m};
}

Measures measure(const Window& window, std::span<const std::complex<double>> displacement_m,
                 const spectrum::FullSpectrum& spectrum) {
  Measures measures{.turns = spectrum.turns,
                    .contact = together(window.contact.last(static_cast<std::size_t>(spectrum.turns))),
                    .dominant = {},
                    .orbit = {},
                    .whirl = {},
                    .comb_spacing = {}};
  for (const MeasuredLine& line : measured_lines)
    measures.*line.amplitude_m = spectrum.amplitude(line.order * spectrum.turns);
  const int k = spectrum::dominant_line(spectrum);
  if (spectrum.amplitude(k) > significant_share_of_clearance * window.clearance_m) {
    measures.dominant =
        spectrum::SpectralLine{.order = spectrum.order(k), .amplitude_m = spectrum.amplitude(k)};
    measures.orbit = spectrum::orbit_kind(displacement_m, spectrum);
    measures.whirl = spectrum::whirl_kind(spectrum);
  }
  return measures;
}

}  // namespace

WindowVerdict classify_window(const Window& window, const ResponseOptions& options,
                              spectrum::SpectrumWorkspace& workspace) {
  require_shape(window);
  WindowVerdict verdict;
  const bool quiet = never_touches(together(window.contact));
  if (!quiet) verdict.period = period_of_section(window.section, window.states, options.max_order);

  const int turns = verdict.period ? window_turns(window.turns, verdict.period->order) : window.turns;
  const auto displacement_m = window.displacement_m.last(
      static_cast<std::size_t>(turns) * static_cast<std::size_t>(window.samples_per_revolution));
  const spectrum::FullSpectrum spectrum = spectrum::full_spectrum(displacement_m, turns, workspace);
  verdict.measures = measure(window, displacement_m, spectrum);

  if (quiet) verdict.motion_class = MotionClass::non_contact;
  if (verdict.period) {
    const int n = verdict.period->order;
    const OffOrder off = off_order(spectrum, n, window.clearance_m);
    verdict.off_order_energy_fraction = off.energy_fraction;
    verdict.spectrum_agrees = off.agrees;
    if (off.agrees) {
      verdict.motion_class = class_of_period(n, verdict.measures);
      verdict.order = n;
    }
  }
  return verdict;
}

MotionClass class_of_period(int order, const Measures& measures) {
  if (order > 1) return MotionClass::subharmonic;
  return measures.dominant ? MotionClass::synchronous : MotionClass::resting_contact;
}

Measures measure_window(const Window& window, spectrum::SpectrumWorkspace& workspace) {
  require_shape(window);
  return measure(window, window.displacement_m,
                 spectrum::full_spectrum(window.displacement_m, window.turns, workspace));
}

Motion settle_verdict(const WindowVerdict& previous, const WindowVerdict& last) {
  Motion motion{.motion_class = MotionClass::unsettled,
                .order = {},
                .status = MotionStatus::ok,
                .measures = last.measures,
                .exponent = {}};
  if (previous.motion_class == last.motion_class && previous.order == last.order) {
    motion.motion_class = last.motion_class;
    motion.order = last.order;
  }
  if (!previous.spectrum_agrees || !last.spectrum_agrees) motion.status = MotionStatus::spectrum_disagrees;
  return motion;
}

}  // namespace rubsweep::response::motion
