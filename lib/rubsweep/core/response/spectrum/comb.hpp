#pragma once

#include <complex>
#include <optional>
#include <span>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// Largest return error in the rotating frame: root mean square divided by the orbit's size in that frame. A
/// line off the comb with a thousandth of this size makes the error 2e-3.
inline constexpr double comb_tolerance = 2e-3;

/// Lines at the orders 1 + k spacing, k = 0, +-1, ...: z = w e^{i phase} with w periodic. A closed orbit in
/// the rotating frame of a rotationally symmetric scene has this spectrum in the fixed frame.
struct Comb {
  double spacing = 0;   ///< > 0, in multiples of the shaft speed; 1 / spacing is the period of w in turns
  bool closed = false;  ///< w returns within comb_tolerance after one period and after as many as fit: the
                        ///< comb then holds all energy except comb_tolerance squared
  double energy_share = 0;  ///< share of z's energy within a line's width of the comb; 0 where lines overlap
};

/// Fewest turns in which a comb can be identified.
inline constexpr int fewest_comb_turns = 32;

/// Comb of the motion in `displacement_m`, samples of z (any unit serves) over whole turns, 32 turns or more.
///
/// The largest line off 1X is k spacings away from it. Its order, interpolated between the bins of a
/// Hann-windowed spectrum and divided by k = 1, 2, ..., 16, gives the candidates. Each is refined until w(t +
/// P T) - w(t) is smallest for P = 1, 2, 4, ... periods, up to half the samples. The first one that closes is
/// the comb (so that a doubled period is found as such); when none does, it is that of k = 1. Periods above a
/// quarter of the samples are skipped. Empty when w does not move. SolverError when the samples do not fill
/// 32 turns.
std::optional<Comb> find_comb(std::span<const std::complex<double>> displacement_m,
                              int samples_per_revolution, SpectrumWorkspace& workspace);

/// Largest line of a comb 1 + k spacing, |k| <= 16, except 0X, at its exact order instead of the nearest bin.
/// Its amplitude has no error from lying between two bins: |sum w_j z_j e^{-2 pi i order t_j}| / sum w_j over
/// all samples under a Hann window w, t in turns. Lines 4 bins or more away leak less than 1 % of themselves
/// into it. Empty when all amplitudes are zero. `displacement_m`: samples of z, in any unit.
std::optional<SpectralLine> largest_comb_line(std::span<const std::complex<double>> displacement_m,
                                              int samples_per_revolution, double spacing);

}  // namespace rubsweep::response::spectrum
