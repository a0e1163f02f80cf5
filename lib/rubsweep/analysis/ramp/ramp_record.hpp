#pragma once

#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "rubsweep/analysis/ramp/ramp_run.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::ramp {

/// Extremes of the displacement of a rotor over a short part of a ramp.
struct EnvelopePoint {
  double t_s = 0, speed_hz = 0;  ///< time and speed in the middle of this part
  double lowest_x_m = std::numeric_limits<double>::infinity(), highest_x_m = -lowest_x_m;
  double lowest_y_m = lowest_x_m, highest_y_m = -lowest_x_m;
  double peak_displacement_m = 0, peak_contact_force_n = 0;
  int hits = 0;
  double touching_s = 0, duration_s = 0;
};

/// Orbit of a few turns of a ramp.
struct RampOrbit {
  double speed_hz = 0;  ///< speed at the begin of the orbit
  std::vector<RampSample> samples;
};

/// Full spectrum over orders. With samples at equal shaft angles an order is a single line even while the
/// speed changes. A Hann window keeps a resonance near its orders.
struct OrderSpectrum {
  double t_s = 0, speed_hz = 0;  ///< time and speed in the middle of the turns
  response::spectrum::FullSpectrum spectrum;
};

/// Range of speeds in which the rotor was never free of contact for `most_free_turns` turns or longer.
struct RubbingSpan {
  double from_hz = 0, to_hz = 0;  ///< ends of the range in the order of the ramp
};
inline constexpr int most_free_turns = 24;

inline constexpr std::size_t most_envelope_points = 500, most_spectra = 240;
inline constexpr int orbits_of_a_ramp = 8, turns_of_an_orbit = 4;
/// Turns of a spectrum, a multiple of the usual periods, and samples per turn, which suffice up to order 8.
inline constexpr int spectrum_turns = 60, spectrum_samples = 64;

/// Record of a ramp for figures, filled one stretch at a time.
class RampRecord {
 public:
  explicit RampRecord(const SpeedRamp& ramp);

  void add(const RampStretch& stretch);

  const std::vector<EnvelopePoint>& envelope() const { return envelope_; }
  const std::vector<RampOrbit>& orbits() const { return orbits_; }
  const std::vector<OrderSpectrum>& spectra() const { return spectra_; }
  /// Rubbing spans up to the last stretch that was added.
  std::vector<RubbingSpan> rubbing_spans() const { return spans_; }

 private:
  void add_to_envelope(const RampStretch& stretch);
  void add_to_orbits(const RampSample& sample);
  void add_to_spectra(const RampSample& sample);
  void add_to_spans(const RampStretch& stretch);
  void take_spectrum();

  SpeedRamp ramp_;
  std::size_t points_;       ///< number of points of the envelope
  long window_ = 0, every_;  ///< number of the present spectrum; `every_`: one of so many spectra is kept
  long next_angle_sample_ = 0;
  std::optional<RampSample> last_;
  std::optional<double> last_contact_s_;
  std::vector<EnvelopePoint> envelope_;
  std::vector<RampOrbit> orbits_;
  std::vector<OrderSpectrum> spectra_;
  std::vector<RubbingSpan> spans_;
  std::vector<std::complex<double>> turns_;  ///< samples of the present spectrum, in metres
  response::spectrum::SpectrumWorkspace workspace_;
};

}  // namespace rubsweep::ramp
