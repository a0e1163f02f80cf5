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

/// Motion x + iy in metres of a rotor without a rub over `turns` turns, samples_of_a_turn values per turn.
/// `speed_ratio`: shaft speed / natural frequency.
std::vector<std::complex<double>> foreign_motion(Foreign cause, double speed_ratio, double damping_ratio,
                                                 int turns, int samples_of_a_turn, std::mt19937_64& random);
