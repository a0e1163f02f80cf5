#include "rubsweep/identify/whirl_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/numerics/spectral/hermitian.hpp"

namespace rubsweep::identify {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double same_root = 1e-7;  ///< of its size: rounding of a double root, and far below any split

/// lower^-1 matrix lower^-T.
Eigen::MatrixXd normalised(const numerics::dense::CholeskyFactors& mass, const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd half = mass.solve_lower(matrix);
  return mass.solve_lower(half.transpose()).transpose();
}

}  // namespace

double WhirlMode::frequency_hz() const { return root_per_s.imag() / (2 * pi); }

double WhirlMode::damping_ratio() const { return -root_per_s.real() / std::abs(root_per_s); }

double assurance(const WhirlMode& a, const WhirlMode& b) { return std::norm(a.state.dot(b.state)); }

WhirlProblem::WhirlProblem(const FreeRotor& rotor) : mass_(rotor.system.mass) {
  stiffness_ = normalised(mass_, rotor.system.stiffness);
  damping_ = normalised(mass_, rotor.system.damping);
  gyroscopic_ = normalised(mass_, rotor.system.gyroscopic);
  circulatory_ = rotor.circulatory.size() > 0 ? normalised(mass_, rotor.circulatory)
                                              : Eigen::MatrixXd::Zero(stiffness_.rows(), stiffness_.cols());
  if (!(stiffness_.diagonal().minCoeff() > 0))
    throw ConfigError("rotor.supports: they do not hold the shaft at some speed of their tables");
  rad_per_s_ = stiffness_.diagonal().cwiseSqrt();
  const auto slowness = rad_per_s_.cwiseInverse().asDiagonal();
  if (!rotor.tables.empty()) tabled_ = rotor;
  spin_ = Complex(0, 1) * (slowness * normalised(mass_, rotor.spin) * slowness).cast<Complex>();
}

std::vector<WhirlMode> WhirlProblem::at(double speed_hz) const {
  if (!tabled_.tables.empty()) return WhirlProblem(rotor_at(tabled_, speed_hz)).at(speed_hz);
  const Eigen::Index n = rad_per_s_.size();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = rad_per_s_.asDiagonal();
  const Eigen::MatrixXd stiffness = stiffness_ + 2 * pi * speed_hz * circulatory_;
  generator.bottomLeftCorner(n, n) = -stiffness * rad_per_s_.cwiseInverse().asDiagonal();
  generator.bottomRightCorner(n, n) = -damping_ - 2 * pi * speed_hz * gyroscopic_;
  const numerics::dense::GeneralModes all = numerics::dense::general_modes(generator, true);
  if (!all.converged) throw SolverError("whirl modes: the iteration does not converge");
  std::vector<WhirlMode> modes;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    const Complex root = all.values(k);
    if (root.imag() > 0) modes.push_back(mode_of(root, all.vectors.col(k)));
  }
  std::stable_sort(modes.begin(), modes.end(), [](const WhirlMode& a, const WhirlMode& b) {
    return a.root_per_s.imag() < b.root_per_s.imag();
  });
  part_by_direction(modes);
  return modes;
}

WhirlMode WhirlProblem::mode_of(Complex root, const Eigen::VectorXcd& state) const {
  WhirlMode mode;
  mode.root_per_s = root;
  mode.state = state.normalized();
  const Eigen::VectorXcd place = mode.state.head(rad_per_s_.size());
  const Eigen::VectorXcd normal = rad_per_s_.cwiseInverse().cast<Complex>().asDiagonal() * place;
  mode.shape = mass_.solve_upper(normal.real()).cast<Complex>() +
               Complex(0, 1) * mass_.solve_upper(normal.imag()).cast<Complex>();
  mode.forward_share =
      std::clamp(0.5 * (1 + place.dot(spin_ * place).real() / normal.squaredNorm()), 0.0, 1.0);
  return mode;
}

void WhirlProblem::part_by_direction(std::vector<WhirlMode>& modes) const {
  const Eigen::Index n = rad_per_s_.size();
  for (std::size_t begin = 0, end = 0; begin < modes.size(); begin = end) {
    const Complex root = modes[begin].root_per_s;
    while (end < modes.size() && std::abs(modes[end].root_per_s - root) <= same_root * std::abs(root)) ++end;
    const auto count = static_cast<Eigen::Index>(end - begin);
    if (count < 2) continue;
    Eigen::MatrixXcd states(2 * n, count);
    for (Eigen::Index k = 0; k < count; ++k) states.col(k) = modes[begin + static_cast<std::size_t>(k)].state;
    const Eigen::MatrixXcd base = numerics::spectral::unitary_columns(states, count);
    const Eigen::MatrixXcd places = base.topRows(n);
    // Most backward first.
    const auto directions =
        numerics::spectral::hermitian_modes(Eigen::MatrixXcd(places.adjoint() * spin_ * places));
    const Eigen::MatrixXcd parted = base * directions.vectors;
    for (Eigen::Index k = 0; k < count; ++k) {
      WhirlMode& mode = modes[begin + static_cast<std::size_t>(k)];
      mode = mode_of(mode.root_per_s, parted.col(k));
    }
  }
}

}  // namespace rubsweep::identify
