#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

/// A kit of solid segments, discs and supports, assembled here into full matrices. Coordinates per node of
/// the mesh: x, slope dx/dz, y, slope dy/dz.
class WrittenRotor {
 public:
  WrittenRotor(const model::RotorKit& kit, const BeamShaft& shaft) : WrittenRotor(kit, shaft, kit) {}

  /// `middle`: the kit whose modes define the damping ratios.
  WrittenRotor(const model::RotorKit& kit, const BeamShaft& shaft, const model::RotorKit& middle)
      : places_m_(shaft.node_position_m) {
    const auto n = static_cast<Eigen::Index>(4 * places_m_.size());
    mass_ = stiffness_ = damping_ = gyroscopic_ = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i + 1 < places_m_.size(); ++i) add_element(kit, i);
    for (const model::Disc& disc : kit.discs) {
      const Eigen::Index x = at(disc.position_m);
      for (const Eigen::Index w : {x, x + 2}) {
        mass_(w, w) += disc.mass_kg;
        mass_(w + 1, w + 1) += disc.diametral_inertia_kg_m2;
      }
      gyroscopic_(x + 1, x + 3) += disc.polar_inertia_kg_m2;
      gyroscopic_(x + 3, x + 1) -= disc.polar_inertia_kg_m2;
    }
    Eigen::MatrixXd conservative = stiffness_;
    for (const model::Support& s : kit.supports) {
      const Eigen::Index x = at(s.position_m), y = x + 2;
      hold(stiffness_, s);
      stiffness_(x, y) += s.stiffness_xy_n_per_m, stiffness_(y, x) += s.stiffness_yx_n_per_m;
      damping_(x, x) += s.damping_x_ns_per_m, damping_(y, y) += s.damping_y_ns_per_m;
      damping_(x, y) += s.damping_xy_ns_per_m, damping_(y, x) += s.damping_yx_ns_per_m;
      mass_(x, x) += s.mass_x_kg, mass_(y, y) += s.mass_y_kg;
    }
    for (const model::Support& s : middle.supports) hold(conservative, s);
    damping_ += of_all_modes(conservative, mass_, kit.damping_ratio.front());
    // Rotating damping uses the modes of the x plane, in both planes.
    circulatory_ = Eigen::MatrixXd::Zero(n, n);
    const std::vector<Eigen::Index> x = plane(0), y = plane(2);
    const Eigen::MatrixXd turning =
        of_all_modes(conservative(x, x), mass_(x, x), kit.rotating_damping_ratio.front());
    damping_(x, x) += turning, damping_(y, y) += turning;
    circulatory_(x, y) += turning, circulatory_(y, x) -= turning;
  }

  /// Matrices of mass q'' + (damping + speed gyroscopic) q' + stiffness q = forces.
  const Eigen::MatrixXd& mass() const { return mass_; }
  const Eigen::MatrixXd& stiffness() const { return stiffness_; }
  const Eigen::MatrixXd& damping() const { return damping_; }
  const Eigen::MatrixXd& gyroscopic() const { return gyroscopic_; }
  /// Index of the x displacement at a position; the index of y is larger by 2.
  Eigen::Index at(double place_m) const {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < places_m_.size(); ++i) {
      if (std::abs(places_m_[i] - place_m) < std::abs(places_m_[nearest] - place_m)) nearest = i;
    }
    return static_cast<Eigen::Index>(4 * nearest);
  }

  /// Displacements in x and y at some positions due to unit forces in x and y at others.
  Eigen::MatrixXcd receptance(double rad_per_s, double speed_rad_per_s,
                              const std::vector<double>& responses_m,
                              const std::vector<double>& forces_m) const {
    const std::complex<double> i(0, 1);
    Eigen::MatrixXcd dynamic = (stiffness_ + speed_rad_per_s * circulatory_ - rad_per_s * rad_per_s * mass_)
                                   .cast<std::complex<double>>();
    dynamic += i * rad_per_s * (damping_ + speed_rad_per_s * gyroscopic_);
    const Eigen::MatrixXcd found = numerics::dense::solve(dynamic, Eigen::MatrixXcd(unit(forces_m)));
    return unit(responses_m).transpose() * found;
  }

  /// Eigenvalues of free vibrations at a speed.
  Eigen::VectorXcd rates(double speed_rad_per_s) const {
    const Eigen::Index n = mass_.rows();
    const numerics::dense::LuFactors mass(mass_);
    constexpr double unit_rad_per_s = 1000;  // scales displacements to the size of velocities
    Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    generator.topRightCorner(n, n).diagonal().setConstant(unit_rad_per_s);
    generator.bottomLeftCorner(n, n) =
        -mass.solve(Eigen::MatrixXd(stiffness_ + speed_rad_per_s * circulatory_)) / unit_rad_per_s;
    generator.bottomRightCorner(n, n) =
        -mass.solve(Eigen::MatrixXd(damping_ + speed_rad_per_s * gyroscopic_));
    return numerics::dense::eigenvalues(generator);
  }

 private:
  void hold(Eigen::MatrixXd& matrix, const model::Support& s) const {
    const Eigen::Index x = at(s.position_m), y = x + 2;
    matrix(x, x) += s.stiffness_x_n_per_m, matrix(y, y) += s.stiffness_y_n_per_m;
    matrix(x + 1, x + 1) += s.angular_stiffness_nm_per_rad;
    matrix(y + 1, y + 1) += s.angular_stiffness_nm_per_rad;
  }

  /// 2 ratio (K M^-1)^(1/2) M: damping with the same ratio for all modes.
  static Eigen::MatrixXd of_all_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass,
                                      double ratio) {
    if (ratio == 0) return Eigen::MatrixXd::Zero(mass.rows(), mass.cols());
    const numerics::dense::CholeskyFactors factor(mass);
    const Eigen::MatrixXd half = factor.solve_lower(stiffness), lower = factor.upper().transpose();
    const Eigen::MatrixXd normal = factor.solve_lower(Eigen::MatrixXd(half.transpose()));
    const auto modes =
        numerics::dense::self_adjoint_modes(Eigen::MatrixXd((normal + normal.transpose()) / 2));
    const Eigen::MatrixXd turned = lower * modes.vectors;
    return 2 * ratio * turned * modes.values.cwiseAbs().cwiseSqrt().asDiagonal() * turned.transpose();
  }

  /// Indices of the coordinates of one plane: `first` is 0 for x, 2 for y.
  std::vector<Eigen::Index> plane(Eigen::Index first) const {
    std::vector<Eigen::Index> all;
    for (Eigen::Index i = first; i < mass_.rows(); i += 4) all.insert(all.end(), {i, i + 1});
    return all;
  }

  Eigen::MatrixXcd unit(const std::vector<double>& places_m) const {
    Eigen::MatrixXcd all =
        Eigen::MatrixXcd::Zero(mass_.rows(), static_cast<Eigen::Index>(2 * places_m.size()));
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      all(at(places_m[i]), static_cast<Eigen::Index>(2 * i)) = 1;
      all(at(places_m[i]) + 2, static_cast<Eigen::Index>(2 * i + 1)) = 1;
    }
    return all;
  }

  static Eigen::Matrix4d symmetric(double a, double b, double c, double d, double e, double f) {
    return Eigen::Matrix4d{{a, b, c, d}, {b, e, -d, f}, {c, -d, a, -b}, {d, f, -b, e}};
  }

  void add_element(const model::RotorKit& kit, std::size_t i) {
    const double l = places_m_[i + 1] - places_m_[i], middle = places_m_[i] + l / 2;
    double end = 0;
    const model::ShaftSegment* s = nullptr;
    for (const model::ShaftSegment& one : kit.shaft) {
      s = &one;
      if (middle < (end += one.length_m)) break;
    }
    const double d = s->outer_diameter_m, area = std::numbers::pi / 4 * d * d, moment = area * d * d / 16;
    const double nu = s->youngs_modulus_pa / (2 * s->shear_modulus_pa) - 1,
                 kappa = 6 * (1 + nu) / (7 + 6 * nu);
    const double ei = s->youngs_modulus_pa * moment,
                 p = 12 * ei / (kappa * s->shear_modulus_pa * area * l * l);
    const Eigen::Matrix4d k =
        ei / (l * l * l * (1 + p)) * symmetric(12, 6 * l, -12, 6 * l, (4 + p) * l * l, (2 - p) * l * l);
    const Eigen::Matrix4d translation =
        s->density_kg_per_m3 * area * l / (840 * (1 + p) * (1 + p)) *
        symmetric(312 + p * (588 + 280 * p), (44 + p * (77 + 35 * p)) * l, 108 + p * (252 + 140 * p),
                  -(26 + p * (63 + 35 * p)) * l, (8 + p * (14 + 7 * p)) * l * l,
                  -(6 + p * (14 + 7 * p)) * l * l);
    const Eigen::Matrix4d rotary = s->density_kg_per_m3 * moment / (30 * (1 + p) * (1 + p) * l) *
                                   symmetric(36, (3 - 15 * p) * l, -36, (3 - 15 * p) * l,
                                             (4 + p * (5 + 10 * p)) * l * l, (-1 + p * (-5 + 5 * p)) * l * l);
    const auto first = static_cast<Eigen::Index>(4 * i);
    const std::array<Eigen::Index, 4> x{first, first + 1, first + 4, first + 5},
        y{first + 2, first + 3, first + 6, first + 7};
    for (const auto& plane : {x, y}) {
      stiffness_(plane, plane) += k;
      mass_(plane, plane) += translation + rotary;
    }
    gyroscopic_(x, y) += 2 * rotary;
    gyroscopic_(y, x) -= 2 * rotary;
  }

  std::vector<double> places_m_;
  Eigen::MatrixXd mass_, stiffness_, damping_, gyroscopic_, circulatory_;
};

}  // namespace rubsweep::structure
