#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::diagnose {

/// A rotor kit with its uncertainty: a set of equally likely kits.
struct KnownKit {
  std::vector<model::RotorKit> likely;  ///< equally likely kits, sorted by ascending natural frequency
  double natural_frequency_hz = 0;      ///< lowest bending frequency at rest of the middle kit
  double rotor_mass_kg = 0;
  double probe_position_m = 0;    ///< place of the first sensor
  double from_m = 0, to_m = 0;    ///< first and last support on the shaft; the stops stand between them
  double length_m = 0;            ///< length of the shaft
  bool same_all_around = false;   ///< isotropic: the kit behaves alike in all directions across the shaft
  std::vector<double> nodes_m{};  ///< nodes of a kit of matrices, where its stops stand
  std::string digest{};           ///< digest of everything that decided the kits, for tables of cases
};

/// Throws ConfigError, beginning with `name`, where a kit has a length or a force that is not proportional to
/// the unbalance (bow, misaligned couplings, static loads, a faulty bearing, clearances from the sag),
/// torsion, or no sensor.
void refuse_unscalable(const model::RotorKit& kit, const std::string& name);

/// Makes a known kit from kits whose unknown numbers were drawn. Each keeps the modes up to most_order times
/// the speed and one more, unless the kit itself gives the number of modes. Throws ConfigError, beginning
/// with `name`, like refuse_unscalable, and where a kit has no damping or cannot be computed at this speed.
KnownKit known_kit(std::vector<model::RotorKit> drawn, double speed_hz, const std::string& name);

/// The kit with all natural frequencies multiplied by one factor (through its stiffnesses), and all damping
/// by another. Bearings given by tables and matrices stay unchanged.
model::RotorKit varied_kit(const model::RotorKit& kit, double frequency_factor, double damping_factor);

/// Kits whose frequencies and damping are uniformly distributed within these shares about those of `kit`.
std::vector<model::RotorKit> varied_kits(const model::RotorKit& kit, double frequency_share,
                                         double damping_share, std::size_t count, std::uint64_t seed);

/// The kit at a share in [0, 1] of the list of likely kits.
const model::RotorKit& likely_kit(const KnownKit& kit, double share);

/// Position of a stop that was drawn at `position_m`: unchanged, or the nearest node in a kit of matrices.
double place_of_stop(const KnownKit& kit, double position_m);

}  // namespace rubsweep::diagnose
