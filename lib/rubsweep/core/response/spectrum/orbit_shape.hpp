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
  oval,    ///< the two largest lines are an ellipse, +k and -k, with 95 % of the energy; also a straight line
  complex,  ///< anything else
};

/// Side of the full spectrum that holds 80 % of the energy.
enum class WhirlKind { forward, backward, mixed };

inline constexpr double circle_ratio = 1.05;        ///< max |z - mean| / min |z - mean| stays below this
inline constexpr double oval_energy_share = 0.95;   ///< share of the energy without 0X
inline constexpr double whirl_energy_share = 0.80;  ///< share of the energy without 0X

/// Shape of the motion in `displacement_m`, the samples (metres, any unit serves) that `spectrum` was taken
/// of. A motion without any line but 0X is `complex`: a point has no shape, ask only about motions.
OrbitKind orbit_kind(std::span<const std::complex<double>> displacement_m, const FullSpectrum& spectrum);

/// The rule of `circle` alone, about a centre that is known: false for no samples.
bool is_circle(std::span<const std::complex<double>> displacement_m, std::complex<double> centre_m);

/// Whirl direction of a motion whose lines hold so much energy (squared amplitudes) on either side of 0X;
/// `mixed` when there is none.
WhirlKind whirl_kind(double forward, double backward);

/// Whirl direction; `mixed` when no line but 0X exists.
WhirlKind whirl_kind(const FullSpectrum& spectrum);

/// Names as the tables write them.
constexpr std::string_view to_string(OrbitKind kind) { return enumerator_word(kind); }
constexpr std::string_view to_string(WhirlKind kind) { return enumerator_word(kind); }

}  // namespace rubsweep::response::spectrum
