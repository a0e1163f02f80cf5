#pragma once

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace rubsweep::machine_search {

/// Parameters that the search may choose. The rest is fixed: a rotor of 0.8 kg at 30 Hz, a steel shaft of 10
/// mm, a clearance of 1 mm, brass, and the stiffness that Hertz' line contact gives for them.
struct Candidate {
  double rotor_damping_ratio = 0;
  double contact_length_m = 0;  ///< of the line contact, so the width of screw and annular stop
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
    {"rotor_damping_ratio", &Candidate::rotor_damping_ratio, 0.004, 0.04},
    {"contact_length_m", &Candidate::contact_length_m, 0.0015, 0.01},
    {"restitution_delivered", &Candidate::restitution_delivered, 0.5, 0.95},
    {"casing_mass_kg", &Candidate::casing_mass_kg, 0.01, 0.3},
    {"casing_frequency_hz", &Candidate::casing_frequency_hz, 200, 1500},
    {"casing_damping_ratio", &Candidate::casing_damping_ratio, 0.02, 1},
    {"friction_coefficient", &Candidate::friction_coefficient, 0.005, 0.2},
    {"kick_force_n", &Candidate::kick_force_n, 40, 400},
    {"kick_duration_s", &Candidate::kick_duration_s, 0.002, 0.005},
}};

/// Where the search starts: the reference machine before it, the one good machine of an earlier sample of 400 against
/// one stop and the same with less friction, the best random one of a first run, and two with softer casings,
/// which let the annulus have its oval.
inline constexpr std::array<Candidate, 6> starting_points{{
    {0.01, 0.006, 0.736, 0.05, 600, 0.05, 0.05, 120, 0.005},
    {0.01, 0.006, 0.736, 0.05, 700, 0.1, 0.2, 120, 0.005},
    {0.01, 0.006, 0.736, 0.05, 700, 0.1, 0.05, 120, 0.005},
    {0.009, 0.0055, 0.766, 0.0958, 372, 0.048, 0.03, 220, 0.0023},
    {0.01, 0.006, 0.736, 0.05, 500, 0.05, 0.05, 160, 0.005},
    {0.01, 0.006, 0.736, 0.0958, 500, 0.1, 0.05, 160, 0.005},
}};

/// Every parameter drawn anew.
Candidate random_candidate(std::mt19937_64& random);

/// A candidate nearby: about half of the parameters are changed by factors of the order of 1 + `spread`.
Candidate perturbed(const Candidate& candidate, double spread, std::mt19937_64& random);

/// The five arrangements of the figures.
enum class Arrangement { one_side, both_sides, unequal_casings, annulus, annulus_with_offset };

/// Configuration of a machine without `sweep`, `response` and `output`. Between unequal casings the lower one
/// is twice as stiff.
std::string machine_text(const Candidate& candidate, Arrangement arrangement);

}  // namespace rubsweep::machine_search
