#pragma once

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace rubsweep::machine_search {

/// Parameters that the search varies. Fixed values: a rotor of 0.8 kg at 30 Hz, a shaft of 10 mm diameter and
/// a clearance of 1 mm.
struct Candidate {
  double rotor_damping_ratio = 0;
  double contact_stiffness_n_per_m = 0;  ///< stiffness of the flat stops
  double restitution_delivered = 0;
  double casing_mass_kg = 0;
  double casing_frequency_hz = 0;
  double casing_damping_ratio = 0;
  double friction_coefficient = 0;
  double kick_force_n = 0;
  double kick_duration_s = 0;
};

/// A varied parameter: its name, its member and the range from which it is drawn logarithmically.
struct Parameter {
  std::string_view name;
  double Candidate::*field;
  double low;
  double high;
};

inline constexpr std::array<Parameter, 9> parameters{{
    {"rotor_damping_ratio", &Candidate::rotor_damping_ratio, 0.002, 0.06},
    {"contact_stiffness_n_per_m", &Candidate::contact_stiffness_n_per_m, 1e6, 1e8},
    {"restitution_delivered", &Candidate::restitution_delivered, 0.27, 0.95},
    {"casing_mass_kg", &Candidate::casing_mass_kg, 0.005, 2},
    {"casing_frequency_hz", &Candidate::casing_frequency_hz, 40, 3000},
    {"casing_damping_ratio", &Candidate::casing_damping_ratio, 0.002, 1},
    {"friction_coefficient", &Candidate::friction_coefficient, 0.005, 0.3},
    {"kick_force_n", &Candidate::kick_force_n, 10, 400},
    {"kick_duration_s", &Candidate::kick_duration_s, 0.001, 0.02},
}};

/// Start of the search: machines from a wider search with another model (a heavy casing of 350 Hz, one of 150
/// Hz, a light screw, and one with ordinary restitution), each with a contact that brass survives.
inline constexpr std::array<Candidate, 5> starting_points{{
    {0.003, 1e7, 0.30, 2, 350, 0.5, 0.04, 60, 0.006},
    {0.004, 1e7, 0.35, 1.5, 150, 0.25, 0.04, 60, 0.006},
    {0.004, 1e7, 0.28, 0.1, 400, 0.6, 0.03, 90, 0.005},
    {0.00427, 1e7, 0.685, 2, 162, 0.93, 0.0375, 75, 0.00505},
    {0.005, 3e6, 0.35, 1, 250, 0.4, 0.04, 60, 0.006},
}};

/// A candidate with all parameters drawn at random.
Candidate random_candidate(std::mt19937_64& random);

/// A similar candidate: about half of its parameters are changed by factors of about 1 + `spread`.
Candidate perturbed(const Candidate& candidate, double spread, std::mt19937_64& random);

/// The five arrangements in the paper's figures.
enum class Arrangement { one_side, both_sides, unequal_casings, annulus, annulus_with_offset };

/// Configuration of a machine without `sweep`, `response` and `output`. With unequal casings the lower one is
/// farther away by half a clearance, because a rotor touches one side only if the distances differ. In a hole
/// of 6 mm diameter the contact of a 5 mm shaft is 1.18 times stiffer than on a flat screw, by Hertz' line
/// contact.
std::string machine_text(const Candidate& candidate, Arrangement arrangement);

}  // namespace rubsweep::machine_search
