#pragma once

#include <complex>
#include <optional>
#include <span>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// A motion that returns in the frame turning with the shaft must come back within this, root mean square
/// over the orbit's size there. A line off the comb of a thousandth of that size makes it 2e-3.
inline constexpr double comb_tolerance = 2e-3;

/// Lines at the orders 1 + k spacing, k = 0, +-1, ...: z = w e^{i phase} with w periodic. In a rotationally
/// symmetric scene that is what a closed orbit in the rotating frame looks like from outside.
struct Comb {
  double spacing = 0;   ///< > 0, in multiples of the shaft speed; 1 / spacing is the period of w in turns
  bool closed = false;  ///< w returns within comb_tolerance, after one period and after as many as fit: then
                        ///< the comb holds all the energy but comb_tolerance squared
  double energy_share = 0;  ///< share of z within a line's width of the comb; 0 where its lines overlap
};

/// Fewest turns in which a comb can be told.
inline constexpr int fewest_comb_turns = 32;

/// Comb of the motion in `displacement_m`, samples of z (any unit serves) over whole turns, 32 turns or more.
///
/// The largest line off 1X stands k spacings from it: its order, read between the bins of a Hann-windowed
/// spectrum, over k = 1, 2, ..., 16 gives the candidates, each refined until w(t + P T) - w(t) is least for P
/// = 1, 2, 4, ... periods up to half the samples. The first that closes is the comb (so that a doubled period
/// is found as such); when none does, the comb is that of k = 1. Periods above a quarter of the samples are
/// not looked for. Empty when w does not move. SolverError when the samples do not fill 32 turns.
std::optional<Comb> find_comb(std::span<const std::complex<double>> displacement_m,
                              int samples_per_revolution, SpectrumWorkspace& workspace);

/// Largest line of a comb 1 + k spacing, |k| <= 16, but 0X; its order is exact, not that of the nearest bin,
/// and its amplitude does not suffer from standing between two bins: |sum w_j z_j e^{-2 pi i order t_j}| /
/// sum w_j over all samples under a Hann window w, t in turns. Neighbours 4 bins or more away leak less than
/// 1 % of themselves. Empty when all amplitudes are zero. `displacement_m`: samples of z, any unit serves.
std::optional<SpectralLine> largest_comb_line(std::span<const std::complex<double>> displacement_m,
                                              int samples_per_revolution, double spacing);

}  // namespace rubsweep::response::spectrum
