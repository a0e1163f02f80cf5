#pragma once

#include <complex>
#include <span>
#include <vector>

namespace rubsweep::recording {

/// Run-out of a shaft: the mean turn of a slow stretch, minus the mean of that turn (the gap).
/// `displacement_m` has samples_per_turn values per whole turn. `vector`: only the components at +1X and -1X,
/// like instruments with a slow-roll vector. Turns with a gap in the data (NaN) are left out. Throws
/// ConfigError where every turn has a gap.
std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_turn, bool vector);

/// Subtracts a run-out from every turn.
void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m);

}  // namespace rubsweep::recording
