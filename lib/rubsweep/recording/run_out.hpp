#pragma once

#include <complex>
#include <span>
#include <vector>

namespace rubsweep::recording {

/// Run-out of a shaft: the mean turn of a slow stretch, whose `displacement_m` has samples_per_revolution of
/// every whole turn. Its own mean, the gap, is left out. `vector`: its component that turns with the shaft
/// alone, in both directions, as instruments with a slow-roll vector do. Turns with a gap (NaN) are left out.
/// Throws ConfigError where no turn is without one.
std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_revolution, bool vector);

/// Subtracts a run-out from every turn.
void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m);

}  // namespace rubsweep::recording
