#pragma once

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace rubsweep::machine_search {

/// Parameters that the search may choose. The rest is fixed: a rotor of 0.8 kg at 30 Hz, a shaft of 10 mm and
/// a clearance of 1 mm.
struct Candidate {
  double rotor_damping_ratio = 0;
  double contact_stiffness_n_per_m = 0;  ///< of the flat stops
  double restitution_delivered = 0;
  double casing_mass_kg = 0;
  double casing_frequency_hz = 0;
  double casing_damping_ratio = 0;
  double friction_coefficient = 0;
  double kick_force_n = 0;
  double kick_duration_s = 0;
};

/// One chosen number: its name, its place in the struct and the range it is drawn from, on a logarithmic
/// scale.
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

/// Where the search starts: four machines that a wider search with a model of its own came to (a heavy casing
/// of 350 Hz, one of 150 Hz, a light screw, and one with an everyday restitution), each with a contact that
/// brass survives.
inline constexpr std::array<Candidate, 5> starting_points{{
    {0.003, 1e7, 0.30, 2, 350, 0.5, 0.04, 60, 0.006},
    {0.004, 1e7, 0.35, 1.5, 150, 0.25, 0.04, 60, 0.006},
    {0.004, 1e7, 0.28, 0.1, 400, 0.6, 0.03, 90, 0.005},
    {0.00427, 1e7, 0.685, 2, 162, 0.93, 0.0375, 75, 0.00505},
    {0.005, 3e6, 0.35, 1, 250, 0.4, 0.04, 60, 0.006},
}};

/// Every parameter drawn anew.
Candidate random_candidate(std::mt19937_64& random);

/// A candidate nearby: about half of the parameters are changed by factors of the order of 1 + `spread`.
Candidate perturbed(const Candidate& candidate, double spread, std::mt19937_64& random);

/// The five arrangements of the figures.
enum class Arrangement { one_side, both_sides, unequal_casings, annulus, annulus_with_offset };

/// Configuration of a machine without `sweep`, `response` and `output`. Of unequal casings the lower one is
/// half a clearance farther away: a difference that lets the rotor touch one side only is one of distance. In
/// a hole of 6 mm the contact of a shaft of 5 mm is 1.18 times as stiff as on a flat screw, by Hertz' line
/// contact.
std::string machine_text(const Candidate& candidate, Arrangement arrangement);

}  // namespace rubsweep::machine_search
