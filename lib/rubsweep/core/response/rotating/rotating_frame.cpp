#include "rubsweep/core/response/rotating/rotating_frame.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/integrate/law/settle_slips.hpp"

namespace rubsweep::response::rotating {
namespace {

/// Compares exactly: any anisotropy destroys the symmetry, and symmetric scenes are built from equal numbers.
bool isotropic(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() % 2 != 0 || matrix.cols() % 2 != 0) return false;
  for (Eigen::Index r = 0; r < matrix.rows(); r += 2) {
    for (Eigen::Index c = 0; c < matrix.cols(); c += 2) {
      if (matrix(r, c) != matrix(r + 1, c + 1) || matrix(r, c + 1) != -matrix(r + 1, c)) return false;
    }
  }
  return true;
}

/// Re(f e^{i phase}) turns forward in every pair when f_y = -i f_x, up to rounding of the phase factor of the
/// smallest gap.
bool turns_forward(const Eigen::VectorXcd& force) {
  constexpr double rounding = 1e-14;
  const std::complex<double> i(0, 1);
  for (Eigen::Index k = 0; k + 1 < force.size(); k += 2) {
    if (std::abs(force(k + 1) + i * force(k)) > rounding * std::abs(force(k))) return false;
  }
  return true;
}

/// Slip, as a share of the surface speed, that Newton's iteration for a rolling motion may leave.
constexpr double rolls_below = 1e-6;

}  // namespace

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd turned(const MatrixXd& state, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  MatrixXd result(state.rows(), state.cols());
  for (Eigen::Index k = 0; k + 1 < state.rows(); k += 2) {
    result.row(k) = c * state.row(k) - s * state.row(k + 1);
    result.row(k + 1) = s * state.row(k) + c * state.row(k + 1);
  }
  return result;
}

RotatingField::RotatingField(const scene::Scene& scene, const integrate::run::SolverOptions& options)
    : system_(integrate::run::scale<Eigen::Dynamic>(scene)),
      smoothed_(options.contact == integrate::run::ContactHandling::smoothed),
      located_law_(system_, 0),
      smoothed_law_(system_, options.smoothing_m / scene.length_scale_m) {}

template <class Visit>
auto RotatingField::at(const VectorXd& state, const Visit& visit) const {
  if (smoothed_) return visit(smoothed_law_);
  for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
    const auto& c = system_.contacts[i];
    // Set to a touching mode, so that the penetration is the true one; its value needs no acceleration.
    located_law_.modes()[i] = contact::Mode::sprung;
    const contact::Kinematics k = located_law_.kinematics(i, state, state);
    located_law_.modes()[i] = contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    located_law_.slips()[i] =
        located_law_.slip_m_per_s(i, state) < 0 ? contact::Slip::backward : contact::Slip::forward;
  }
  return visit(located_law_);
}

VectorXd RotatingField::rate(const VectorXd& state) const {
  return at(state, [&](const auto& law) -> VectorXd {
    VectorXd rate(state.size());
    if (!smoothed_) {
      integrate::law::settle_slips(located_law_, state, rate, 0.0, [&](std::size_t i) {
        const double surface = system_.contacts[i].surface_speed_m_per_s;
        return std::abs(located_law_.slip_m_per_s(i, state)) < rolls_below * surface;
      });
    }
    law(state, rate, 0.0);
    return rate - turned(state, std::numbers::pi / 2);
  });
}

MatrixXd RotatingField::jacobian(const VectorXd& state) const {
  return at(state, [&](const auto& law) -> MatrixXd {
    const Eigen::Index n = system_.coordinates();
    MatrixXd by_u, by_v, all = MatrixXd::Zero(2 * n, 2 * n);
    law.slopes(state, {}, by_u, by_v);  // slips, if any, are in one direction
    all.topRightCorner(n, n).setIdentity();
    all.bottomLeftCorner(n, n) = by_u;
    all.bottomRightCorner(n, n) = by_v;
    return all - turned(MatrixXd::Identity(2 * n, 2 * n), std::numbers::pi / 2);
  });
}

double RotatingField::contact_force_n(const VectorXd& state) const {
  return at(state, [&](const auto& law) {
    double largest = 0;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      const contact::Kinematics k = law.kinematics(i, state, state);
      largest = std::max(largest, law.normal_force(i, k.penetration, k.closing_speed).total_n);
    }
    return largest;
  });
}

double RotatingField::casing_displacement_m(const VectorXd& state) const {
  double largest = 0;
  for (const auto& casing : system_.casings)
    largest = std::max(largest, (casing.map * state.head(system_.coordinates())).norm());
  return largest * system_.scale.length_m;
}

bool RotatingField::touches(const VectorXd& state) const {
  return at(state, [&](const auto& law) {
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      if (law.kinematics(i, state, state).penetration > 0) return true;
    }
    return false;
  });
}

bool rotationally_symmetric(const scene::Scene& scene) {
  const auto& s = scene.structure;
  // The equations of this frame cover only linear contacts.
  return std::ranges::all_of(scene.contacts,
                             [](const auto& c) { return contact::centred(c.wall) && !c.law; }) &&
         scene.constant_n.isZero(0) && scene.impulses.empty() && turns_forward(scene.harmonic_n) &&
         scene.second_harmonic_n.size() == 0 && isotropic(s.mass) && isotropic(s.damping) &&
         isotropic(s.stiffness) &&
         std::ranges::all_of(s.points, [](const auto& p) { return isotropic(p.map); });
}

}  // namespace rubsweep::response::rotating
