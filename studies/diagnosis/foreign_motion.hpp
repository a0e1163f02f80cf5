#pragma once

#include <array>
#include <complex>
#include <random>
#include <string_view>
#include <vector>

/// Causes of vibration that are not among the candidates of a diagnosis.
enum class Foreign {
  misaligned_coupling,
  bearing_fault,
  loose_support,
  oil_whirl,
  electrical_run_out,
  clipped_sensor
};
inline constexpr std::array all_foreign{Foreign::misaligned_coupling, Foreign::bearing_fault,
                                        Foreign::loose_support,       Foreign::oil_whirl,
                                        Foreign::electrical_run_out,  Foreign::clipped_sensor};
std::string_view to_string(Foreign cause);

/// Motion of a rotor without rub over so many turns, m: x + iy, samples_of_a_turn of each. `speed_ratio`:
/// speed over natural frequency.
std::vector<std::complex<double>> foreign_motion(Foreign cause, double speed_ratio, double damping_ratio,
                                                 int turns, int samples_of_a_turn, std::mt19937_64& random);
