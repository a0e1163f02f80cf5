#include "rubsweep/ring/assembly.hpp"

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::ring {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector2d;

/// Cosine that is exact at multiples of 90 degrees.
double cos_deg(double angle_deg) { return boost::math::cos_pi(angle_deg / 180); }
double sin_deg(double angle_deg) { return boost::math::sin_pi(angle_deg / 180); }

void add_ring(Matrices& matrices, const Ring& ring) {
  const double n = ring.nodal_diameters, a = amplitude_mass_kg(ring), critical = critical_speed(ring);
  matrices.mass.topLeftCorner<2, 2>() += a * Matrix2d::Identity();
  matrices.rotation(0, 1) -= 2 * a * n;
  matrices.rotation(1, 0) += 2 * a * n;
  matrices.stiffness.topLeftCorner<2, 2>() += a * n * n * critical * critical * Matrix2d::Identity();
  matrices.softening.topLeftCorner<2, 2>() += a * n * n * Matrix2d::Identity();
}

/// Maps of one load: the motion of its tip due to X, and the force of its friction on X.
struct LoadMaps {
  Eigen::MatrixXd tip;        ///< 2 x N: X to the tip's motion (u along the load, v across it)
  Eigen::RowVector2d inward;  ///< (u, v) to the tip's displacement along the inward normal
  Eigen::VectorXd friction;   ///< N: generalised force for a unit friction force on the ring
};

/// Maps of a load. The friction column includes the reaction on the load. `coordinate`: index of q in X; < 0:
/// none.
LoadMaps load_maps(const Ring& ring, const Load& load, Index coordinate, Index size) {
  const double n = ring.nodal_diameters, eta = surface_ratio(ring);
  const double cos_n = cos_deg(n * load.angle_deg), sin_n = sin_deg(n * load.angle_deg);
  const double c = cos_deg(load.inclination_deg), s = sin_deg(load.inclination_deg);
  LoadMaps maps{Eigen::MatrixXd::Zero(2, size), {-c, s}, Eigen::VectorXd::Zero(size)};
  if (load.motion != Motion::tangential) {
    const Eigen::RowVector2d inward(-n * sin_n, n * cos_n);
    maps.tip.topLeftCorner<1, 2>() = -c * inward;
    maps.tip.bottomLeftCorner<1, 2>() = s * inward;
  }
  maps.friction.head<2>() << eta * cos_n, eta * sin_n;
  if (coordinate >= 0) {
    maps.tip.col(coordinate) << s, c;
    maps.friction(coordinate) = -1;
  }
  return maps;
}

/// Index in X of every load's coordinate; -1 for a load without one.
std::vector<Index> load_coordinates(const System& system) {
  std::vector<Index> coordinates;
  Index next = 2;
  for (const Load& load : system.loads) coordinates.push_back(load.motion == Motion::radial ? -1 : next++);
  return coordinates;
}

void add_load(Matrices& matrices, const System& system, const Load& load, Index coordinate) {
  const LoadMaps maps = load_maps(system.ring, load, coordinate, matrices.coordinates());
  // The forces of the load act on X through its tip. Their normal component also causes friction.
  const Eigen::MatrixXd reach =
      maps.tip.transpose() - system.friction_coefficient * maps.friction * maps.inward;
  const auto add = [&](Eigen::MatrixXd& target, const Matrix2d& own) { target += reach * own * maps.tip; };
  Matrix2d own = Matrix2d::Zero();
  own.diagonal() << load.radial_mass_kg, load.flexural_mass_kg;
  add(matrices.mass, own);
  own.diagonal() << load.radial_stiffness_n_per_m, load.tangential_stiffness_n_per_m;
  add(matrices.stiffness, own);
  own.diagonal() << load.radial_mass_kg, load.flexural_mass_kg - load.rotary_mass_kg;
  add(matrices.softening, own);
  own << 0, -2 * load.gyroscopic_mass_kg, 2 * load.gyroscopic_mass_kg, 0;
  add(matrices.rotation, own);
  matrices.force += reach * (-system.preload_n * maps.inward.transpose());
  matrices.centrifugal += reach * Vector2d(load.centrifugal_mass_kg * system.ring.radius_m.value_or(0), 0);
}

/// Limit on iterations per row. Eigen's own may be too low where several roots merge at once.
constexpr Index iterations_per_row = 4000;

numerics::dense::GeneralModes solve(const MatrixXd& matrix, bool with_vectors) {
  numerics::dense::GeneralModes modes =
      numerics::dense::general_modes(matrix, with_vectors, iterations_per_row);
  if (!modes.converged) throw SolverError("the eigenvalue iteration did not converge");
  return modes;
}

/// Matrix of the first-order form d/dt (Y, Y') = state_matrix (Y, Y') in scaled time.
MatrixXd state_matrix(const NormalForm& form, double speed_rad_per_s) {
  const double speed = speed_rad_per_s / form.reference_rad_per_s;
  const Eigen::Index size = form.coordinates();
  MatrixXd state(2 * size, 2 * size);
  state.topLeftCorner(size, size).setZero();
  state.topRightCorner(size, size).setIdentity();
  state.bottomLeftCorner(size, size) = speed * speed * form.softening - form.stiffness;
  state.bottomRightCorner(size, size) = -speed * form.rotation;
  return state;
}

/// Derivative of the state matrix by the scaled speed O.
MatrixXd state_matrix_slope(const NormalForm& form, double speed_rad_per_s) {
  const double speed = speed_rad_per_s / form.reference_rad_per_s;
  const Eigen::Index size = form.coordinates();
  MatrixXd slope = MatrixXd::Zero(2 * size, 2 * size);
  slope.bottomLeftCorner(size, size) = 2 * speed * form.softening;
  slope.bottomRightCorner(size, size) = -form.rotation;
  return slope;
}

}  // namespace

NormalForm normal_form(const System& system) {
  const Matrices matrices = assemble(system);
  const Eigen::ArrayXd diagonal = matrices.mass.diagonal().array().abs();
  if (!(diagonal > 0).all()) throw ConfigError("the mass matrix is singular: a load that moves needs a mass");
  const Eigen::VectorXd scale = diagonal.rsqrt();
  const auto scaled = [&](const MatrixXd& matrix) -> MatrixXd {
    return scale.asDiagonal() * matrix * scale.asDiagonal();
  };
  const numerics::dense::LuFactors mass(scaled(matrices.mass));
  if (!(mass.reciprocal_condition() > 1e-12)) {
    throw ConfigError("the mass matrix is singular: friction cancels the inertia of a load");
  }
  const MatrixXd stiffness = mass.solve(scaled(matrices.stiffness));
  NormalForm form;
  form.reference_rad_per_s = std::sqrt(stiffness.diagonal().cwiseAbs().maxCoeff());
  form.has_friction = system.friction_coefficient != 0;
  form.stiffness = stiffness / (form.reference_rad_per_s * form.reference_rad_per_s);
  form.rotation = mass.solve(scaled(matrices.rotation));
  form.softening = mass.solve(scaled(matrices.softening));
  return form;
}

Matrices assemble(const System& system) {
  const std::vector<Index> coordinates = load_coordinates(system);
  Index size = 2;
  for (const Index coordinate : coordinates) size += coordinate >= 0 ? 1 : 0;
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(size, size);
  Matrices matrices{zero, zero, zero, zero, Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  add_ring(matrices, system.ring);
  for (std::size_t j = 0; j < system.loads.size(); ++j) {
    add_load(matrices, system, system.loads[j], coordinates[j]);
  }
  return matrices;
}

bool StaticLoad::valid() const {
  for (std::size_t j = 0; j < normal_n.size(); ++j) {
    if (!(std::isfinite(normal_n[j]) && normal_n[j] > 0 && slip_m_per_s[j] > 0)) return false;
  }
  return true;
}

StaticLoad static_load(const System& system, double speed_rad_per_s) {
  const double speed2 = speed_rad_per_s * speed_rad_per_s, radius = system.ring.radius_m.value();
  const Matrices matrices = assemble(system);
  const Eigen::VectorXd rest =
      numerics::dense::solve_full_pivot(matrices.stiffness - speed2 * matrices.softening,
                                        Eigen::VectorXd(matrices.force + speed2 * matrices.centrifugal));
  const auto coordinates = load_coordinates(system);
  StaticLoad result;
  for (std::size_t j = 0; j < system.loads.size(); ++j) {
    const Load& load = system.loads[j];
    const LoadMaps maps = load_maps(system.ring, load, coordinates[j], matrices.coordinates());
    const Eigen::Vector2d stiffness(
        load.radial_stiffness_n_per_m - speed2 * load.radial_mass_kg,
        load.tangential_stiffness_n_per_m - speed2 * (load.flexural_mass_kg - load.rotary_mass_kg));
    const Eigen::Vector2d tip = maps.tip * rest;
    const Eigen::Vector2d carried(stiffness(0) * tip(0) - speed2 * load.centrifugal_mass_kg * radius,
                                  stiffness(1) * tip(1));
    result.normal_n.push_back(maps.inward * carried + system.preload_n);
    // The tip moves at Omega (R - u). The surface moves at Omega eta u, because the wave stands still while
    // the ring rotates through it.
    const double inward = maps.inward * tip;
    result.slip_m_per_s.push_back(speed_rad_per_s * (radius + (surface_ratio(system.ring) - 1) * inward));
  }
  return result;
}

Eigen::VectorXcd eigenvalues(const NormalForm& form, double speed_rad_per_s) {
  return form.reference_rad_per_s * solve(state_matrix(form, speed_rad_per_s), false).values;
}

Spectrum spectrum(const NormalForm& form, double speed_rad_per_s) {
  numerics::dense::GeneralModes all = solve(state_matrix(form, speed_rad_per_s), true);
  Spectrum result;
  result.vectors = std::move(all.vectors);
  result.values = form.reference_rad_per_s * all.values;
  // Rows of the inverse are the left eigenvectors, scaled so that y^H x = 1.
  const MatrixXcd left = numerics::dense::inverse(result.vectors);
  const MatrixXcd moved = state_matrix_slope(form, speed_rad_per_s) * result.vectors;
  result.slopes.resize(result.values.size());
  for (Index i = 0; i < result.values.size(); ++i) {
    const std::complex<double> slope = left.row(i) * moved.col(i);
    result.slopes(i) = std::isfinite(std::abs(slope)) ? slope : 0;
  }
  return result;
}

double size_of(const Eigen::VectorXcd& values) { return values.cwiseAbs().maxCoeff(); }

Index nearest_to(std::complex<double> place, const Eigen::VectorXcd& values) {
  Index nearest = 0;
  (values.array() - place).abs().minCoeff(&nearest);
  return nearest;
}

double zero_tolerance(const NormalForm& form) { return form.has_friction ? 1e-11 : 1e-7; }

Signature signature(const NormalForm& form, const Eigen::VectorXcd& values) {
  const double size = size_of(values), zero = zero_tolerance(form) * size;
  // For uncoupled loads, two equal real roots may be computed as a pair that lies this close to the real
  // axis.
  const double equal = 1e-7 * size;
  Signature counts;
  for (const std::complex<double>& value : values) {
    const bool grows = value.real() > zero;
    if (std::abs(value.imag()) <= equal) {
      ++(grows ? counts.growing_real : counts.decaying_real);
    } else if (value.imag() > 0 && grows) {
      ++counts.growing_pairs;
    }
  }
  return counts;
}

Signature signature(const NormalForm& form, double speed_rad_per_s) {
  return signature(form, eigenvalues(form, speed_rad_per_s));
}

}  // namespace rubsweep::ring
