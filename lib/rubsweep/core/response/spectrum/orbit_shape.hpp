#pragma once

#include <complex>
#include <span>
#include <string_view>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::response::spectrum {

/// Shape of the orbit z = x + iy about its mean.
enum class OrbitKind {
  circle,  ///< the distance from the mean varies by less than 5 %
  /// An ellipse: the two largest spectral lines are +k and -k and hold 95 % of the energy. A motion along a
  /// straight segment counts, too.
  oval,
  complex,  ///< any other shape
};

/// Whirl direction: the side of the full spectrum that holds 80 % of the energy.
enum class WhirlKind { forward, backward, mixed };

inline constexpr double circle_ratio = 1.05;        ///< upper bound of max |z - mean| / min |z - mean|
inline constexpr double oval_energy_share = 0.95;   ///< share of the energy without 0X
inline constexpr double whirl_energy_share = 0.80;  ///< share of the energy without 0X

/// Shape of the motion in `displacement_m`, the samples (in any unit) from which `spectrum` was computed. A
/// motion without any line except 0X gives `complex`. A point has no shape, so call the function only for
/// motions.
OrbitKind orbit_kind(std::span<const std::complex<double>> displacement_m, const FullSpectrum& spectrum);

/// Whether a motion is a `circle` about a known centre; false without samples.
bool is_circle(std::span<const std::complex<double>> displacement_m, std::complex<double> centre_m);

/// Whirl direction of a motion with the given energies (squared amplitudes) of its forward and backward
/// lines; `mixed` when both are zero.
WhirlKind whirl_kind(double forward, double backward);

/// Whirl direction; `mixed` when there is no line except 0X.
WhirlKind whirl_kind(const FullSpectrum& spectrum);

/// Names as in the tables.
constexpr std::string_view to_string(OrbitKind kind) { return enumerator_word(kind); }
constexpr std::string_view to_string(WhirlKind kind) { return enumerator_word(kind); }

}  // namespace rubsweep::response::spectrum
