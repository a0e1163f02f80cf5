#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/key.hpp"

namespace rubsweep::ring {

inline double square(double x) { return x * x; }

/// Elastic ring in one in-plane, inextensible mode of n nodal diameters: w = A cos n phi + B sin n phi,
/// u = dw/dphi (inward). Source of the model: Lesaffre, Sinou, Thouverez, "Stability analysis of rotating
/// beams rubbing on an elastic circular structure", JSV 299 (2007) 1005-1032.
struct Ring {
  int nodal_diameters = 2;             ///< n >= 2
  double modal_mass_kg = 0;            ///< M_stat = rho S R pi
  double modal_stiffness_n_per_m = 0;  ///< K_stat = E I pi / R^3
  double thickness_ratio = 0;          ///< h / R_stat
  std::optional<double> radius_m;      ///< needed only for the static load
};

/// Motions of a load. Only `radial`: it slides on the ring and has no coordinate. Only `tangential`: it does
/// not follow the ring's deflection.
enum class Motion { both, radial, tangential };

enum class LoadKind { spring_mass, beam };

/// Load that rotates with the frame and rubs on the ring: a spring-mass system or an Euler-Bernoulli beam,
/// given by modal data at its tip.
struct Load {
  LoadKind kind = LoadKind::spring_mass;
  double angle_deg = 0;        ///< place on the ring, in the rotating frame
  double inclination_deg = 0;  ///< alpha, between the load and the normal of the ring; -90 to 90
  Motion motion = Motion::both;
  double radial_mass_kg = 0;                ///< m_r, for traction and compression
  double flexural_mass_kg = 0;              ///< m_t
  double rotary_mass_kg = 0;                ///< J_b: part of m_t that causes no centrifugal softening
  double gyroscopic_mass_kg = 0;            ///< couples the two motions: m, or 2 m_r / pi for a beam
  double centrifugal_mass_kg = 0;           ///< static load / (R Omega^2): m, or 8 m_r / pi^2 for a beam
  double radial_stiffness_n_per_m = 0;      ///< k_r
  double tangential_stiffness_n_per_m = 0;  ///< k_t

  bool operator==(const Load&) const = default;
};

/// Ring and loads in the frame that rotates with the loads.
struct System {
  Ring ring;
  std::vector<Load> loads;
  double friction_coefficient = 0;  ///< mu of all loads; the friction force keeps its direction
  double preload_n = 0;  ///< N_U, which presses every load on the ring in addition to the centrifugal force
};

/// Load with equal masses in both motions (Appendix B). A massless load has mass 0 and only a radial motion.
Load spring_mass(double mass_kg, double radial_stiffness_n_per_m, double tangential_stiffness_n_per_m);

/// Clamped Euler-Bernoulli beam as long as the ring's radius, given by modal data at its tip (Appendix A).
/// Its Ritz functions sin(pi x / 2R) and 1 - cos(pi x / 2R) fix J_b = m_t - 2 m_r (3/2 - 4/pi).
Load beam(double radial_mass_kg, double flexural_mass_kg, double radial_stiffness_n_per_m,
          double tangential_stiffness_n_per_m);

/// Section and material of a uniform beam.
struct BeamGeometry {
  double density_kg_per_m3 = model::required, section_area_m2 = model::required,
         second_moment_m4 = model::required, youngs_modulus_pa = model::required;

  static void visit_fields(auto& self, auto&& visit) {
    using model::key, model::positive;
    visit("density_kg_per_m3", self.density_kg_per_m3, key(positive, "density"));
    visit("section_area_m2", self.section_area_m2, key(positive, "area of the section"));
    visit("second_moment_m4", self.second_moment_m4, key(positive, "second moment of area"));
    visit("youngs_modulus_pa", self.youngs_modulus_pa, key(positive, "Young's modulus"));
  }
};
Load beam(const BeamGeometry& geometry, double length_m);

/// Ring of rectangular section; `thickness_m` is radial, `radius_m` is the radius of the centre line.
struct RingGeometry {
  double radius_m = model::required, thickness_m = model::required, width_m = model::required,
         density_kg_per_m3 = model::required, youngs_modulus_pa = model::required;

  static void visit_fields(auto& self, auto&& visit) {
    using model::key, model::positive;
    visit("radius_m", self.radius_m, key(positive, "mean radius"));
    visit("thickness_m", self.thickness_m, key(positive, "thickness"));
    visit("width_m", self.width_m, key(positive, "width"));
    visit("density_kg_per_m3", self.density_kg_per_m3, key(positive, "density"));
    visit("youngs_modulus_pa", self.youngs_modulus_pa, key(positive, "Young's modulus"));
  }
};
Ring ring(const RingGeometry& geometry, int nodal_diameters);

double amplitude_mass_kg(const Ring& ring);  ///< Modal mass of either amplitude A, B: a = M_stat (n^2 + 1).

/// Critical speed in rad/s: Omega_c = sqrt(K_stat (n^2 - 1)^2 / a), at which the forward wave stands still in
/// the rotating frame. The natural frequency of the mode is n Omega_c.
double critical_speed(const Ring& ring);

/// Stiffness K_stat of a ring whose mode has this natural frequency (rad/s).
double stiffness_of_frequency(double frequency_rad_per_s, double modal_mass_kg, int nodal_diameters);

/// Ratio of the tangential displacement of the rubbed surface to that of the centre line: eta = 1 + h (n^2 -
/// 1) / (2 R).
double surface_ratio(const Ring& ring);

}  // namespace rubsweep::ring
