#include "rubsweep/measurement/fit/ramp_phasor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::fit {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Places in a window, from -1 to 1, through which a polynomial of fourth degree is laid.
constexpr std::array<double, 5> places{-1, -0.5, 0, 0.5, 1};
constexpr auto degrees = static_cast<Eigen::Index>(places.size());

/// Weights that turn values at `places` into two means over a window of some turns: the mean of the values,
/// and the mean of the values times e^{-2i phi}. phi = 0 in the middle of the window.
struct WindowWeights {
  Eigen::RowVectorXd mean;
  Eigen::RowVectorXcd mirrored;
};

WindowWeights window_weights(double turns) {
  // Means of u^p and u^p e^{-i k u} over -1 < u < 1 by partial integration; e^{ik} = 1.
  const double k = 2 * pi * turns;
  Eigen::MatrixXd powers(degrees, degrees);
  Eigen::RowVectorXd mean(degrees);
  Eigen::RowVectorXcd mirrored(degrees);
  Complex before = 0;
  for (Eigen::Index p = 0; p < degrees; ++p) {
    for (Eigen::Index j = 0; j < degrees; ++j)
      powers(p, j) = std::pow(places[static_cast<std::size_t>(j)], p);
    const auto power = static_cast<double>(p);
    const bool odd = p % 2 == 1;
    mean(p) = odd ? 0 : 1 / (power + 1);
    before = (odd ? Complex(0, 1 / k) : 0) - Complex(0, power / k) * before;
    mirrored(p) = before;
  }
  const Eigen::MatrixXd inverse = powers.inverse();
  return {(inverse * mean.transpose()).transpose(),
          (inverse.cast<Complex>() * mirrored.transpose()).transpose()};
}

/// Limit of |rate of the shaft| / |distance from resonance|^2, below which a mode follows the speed
/// quasi-statically to second order. The error is about the square of this limit.
constexpr double far_from_resonance = 1e-4;
/// Width of the stretches with constant modes, and the largest number of stretches.
constexpr double stretch_hz = 0.25, most_stretches = 64, most_stretches_of_tables = 128;
constexpr double longest_step_rad = 2;

struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 5> gauss{{{0.046910077030668, 0.118463442528095},
                                           {0.230765344947158, 0.239314335249683},
                                           {0.5, 0.284444444444444},
                                           {0.769234655052842, 0.239314335249683},
                                           {0.953089922969332, 0.118463442528095}}};

/// Modal integration of the motion in the frame that turns with the shaft. The first column is the motion due
/// to an unbalance of 1 m eccentricity, the second that due to the bow.
class Ramped {
 public:
  Ramped(const scene::PreparedMachine& prepared, const Ramp& ramp, double begin_s, double end_s)
      : prepared_(prepared), turning_(ramp), unbalance_kg_(prepared.assembly.system.unbalance_kg) {
    const auto& assembly = prepared.assembly;
    bow_n_ = assembly.bow_n.size() > 0 ? assembly.bow_n : Eigen::VectorXcd::Zero(unbalance_kg_.size());
    const bool changing =
        assembly.gyroscopic.size() > 0 || assembly.circulatory.size() > 0 || !assembly.tables.empty();
    const double most = assembly.tables.empty() ? most_stretches : most_stretches_of_tables;
    const double stretches =
        std::clamp(turning_.most_gain() / (2 * pi) * (end_s - begin_s) / stretch_hz, 1.0, most);
    stretch_s_ = changing ? std::max((end_s - begin_s) / stretches, 1e-9) : INFINITY;
    start(begin_s);
  }

  /// Displacements at `to_s` in the frame that turns with the shaft.
  Eigen::MatrixX2cd advance(double to_s) {
    while (now_s_ < to_s) {
      const double stretch_end_s = stretch_begin_s_ + stretch_s_;
      integrate(std::min(to_s, stretch_end_s));
      if (now_s_ >= stretch_end_s) restart();
    }
    return modes_->vectors.topRows(unbalance_kg_.size()) * amplitudes();
  }

 private:
  using Both = Eigen::RowVector2cd;

  double speed(double t) const { return turning_.speed(t); }
  double gain(double t) const { return turning_.gain(t); }
  double angle(double t) const { return turning_.angle(t); }

  /// Forces on mode k in the turning frame: unbalance_ (W^2 - i W') and bow_, with the shaft speed W in
  /// rad/s.
  Both push(Eigen::Index k, double t) const {
    const double w = speed(t);
    return {unbalance_(k) * Complex(w * w, -gain(t)), bow_(k)};
  }

  /// Response of a mode that follows the speed quasi-statically: a = -c / m - (c / m)' / m, with the force c
  /// and m = value - i W.
  Both following(Eigen::Index k, double t) const {
    const Complex m = modes_->values(k) - Complex(0, speed(t)), m_rate(0, -gain(t));
    const Both c = push(k, t), c_rate(unbalance_(k) * 2.0 * speed(t) * gain(t), 0);
    return -c / m - (c_rate / m - c * m_rate / (m * m)) / m;
  }

  void use_modes(double t) {
    modes_ = modes_at(prepared_, speed(t + (std::isfinite(stretch_s_) ? stretch_s_ / 2 : 0)));
    unbalance_ = modes_->force(unbalance_kg_);
    bow_ = modes_->force(bow_n_);
    follows_.assign(static_cast<std::size_t>(modes_->values.size()), true);
    for (Eigen::Index k = 0; k < modes_->values.size(); ++k) {
      // Smallest distance between the mode's eigenvalue and i W over the stretch; without stretches, over all
      // speeds.
      const Complex value = modes_->values(k);
      double nearest = std::abs(value.real());
      if (std::isfinite(stretch_s_)) {
        const auto [low, high] = turning_.speeds_between(t, t + stretch_s_);
        nearest = std::abs(value - Complex(0, std::clamp(value.imag(), low, high)));
      }
      follows_[static_cast<std::size_t>(k)] = turning_.most_gain() < far_from_resonance * nearest * nearest;
    }
  }

  void start(double t) {
    now_s_ = stretch_begin_s_ = t;
    use_modes(t);
    state_.resize(modes_->values.size(), 2);
    for (Eigen::Index k = 0; k < state_.rows(); ++k) state_.row(k) = following(k, t);
  }

  /// Expresses the motion by the modes of the next stretch.
  void restart() {
    const Eigen::MatrixX2cd motion = modes_->vectors * amplitudes();
    stretch_begin_s_ = now_s_;
    use_modes(now_s_);
    state_ = modes_->factor.solve(motion);
  }

  Eigen::MatrixX2cd amplitudes() const {
    Eigen::MatrixX2cd all = state_;
    for (Eigen::Index k = 0; k < all.rows(); ++k)
      if (follows_[static_cast<std::size_t>(k)]) all.row(k) = following(k, now_s_);
    return all;
  }

  void integrate(double to_s) {
    for (Eigen::Index k = 0; k < state_.rows(); ++k) {
      if (follows_[static_cast<std::size_t>(k)]) continue;
      const Complex value = modes_->values(k);
      double t = now_s_;
      while (t < to_s) {
        const double distance = std::abs(value - Complex(0, speed(t)));
        const double step = std::min(to_s - t, longest_step_rad / std::max(distance, 1e-3));
        const double end = t + step >= to_s ? to_s : t + step;
        Both sum = state_.row(k) * std::exp(value * (end - t) - Complex(0, angle(end) - angle(t)));
        for (const GaussPoint& point : gauss) {
          const double at = t + point.place * (end - t);
          const Complex share =
              point.weight * (end - t) * std::exp(value * (end - at) - Complex(0, angle(end) - angle(at)));
          sum += share * push(k, at);
        }
        state_.row(k) = sum;
        t = end;
      }
    }
    now_s_ = to_s;
  }

  const scene::PreparedMachine& prepared_;
  RampTurning turning_;
  Eigen::VectorXcd unbalance_kg_, bow_n_;
  double stretch_s_ = 0, stretch_begin_s_ = 0, now_s_ = 0;
  std::optional<ModeSet> modes_;
  Eigen::VectorXcd unbalance_, bow_;
  Eigen::MatrixX2cd state_;
  std::vector<bool> follows_;
};

}  // namespace

ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s) {
  const structure::LinearSystem system = structure::system_at(prepared.assembly, speed_rad_per_s);
  const Eigen::Index n = system.coordinates();
  const Eigen::PartialPivLU<Eigen::MatrixXd> mass(system.mass);
  // Rates are in units of a typical frequency, so that the displacements and rates of a state have similar
  // size.
  const double typical = std::sqrt(mass.solve(system.stiffness).norm());
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = typical * Eigen::MatrixXd::Identity(n, n);
  generator.bottomLeftCorner(n, n) = -mass.solve(system.stiffness) / typical;
  generator.bottomRightCorner(n, n) = -mass.solve(system.damping);
  numerics::dense::GeneralModes found = numerics::dense::general_modes(generator, true);
  if (!found.converged) throw SolverError("modes: the eigenvalue iteration does not converge");
  ModeSet modes{std::move(found.values), std::move(found.vectors), {}, mass.inverse()};
  modes.vectors.bottomRows(n) *= typical;
  modes.factor.compute(modes.vectors);
  if (!modes.factor.matrixLU().allFinite() || !(modes.factor.matrixLU().diagonal().cwiseAbs().minCoeff() > 0))
    throw SolverError("modes: they do not span the motion");
  return modes;
}

Eigen::VectorXcd ModeSet::force(const Eigen::VectorXcd& newtons) const {
  Eigen::VectorXcd rate = Eigen::VectorXcd::Zero(values.size());
  rate.tail(newtons.size()) = inverse_mass.cast<std::complex<double>>() * newtons;
  return factor.solve(rate);
}

RampParts ramp_parts(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows, const Ramp& ramp,
                     const std::vector<double>& t_s, double window_turns) {
  const std::vector<WindowNode> nodes = window_nodes(ramp, t_s, window_turns);
  RampParts parts;
  parts.per_eccentricity = parts.bow_m = parts.per_eccentricity_mirrored = parts.bow_mirrored_m =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(t_s.size()), rows.rows());
  if (nodes.empty()) return parts;
  double low_hz = INFINITY, high_hz = 0;
  for (const WindowNode& node : nodes) {
    low_hz = std::min(low_hz, speed_hz(ramp, node.t_s));
    high_hz = std::max(high_hz, speed_hz(ramp, node.t_s));
  }
  structure::refuse_beyond_tables(prepared.machine, low_hz, high_hz);
  structure::refuse_changing_mass(prepared.machine, "a ramp");
  Ramped run(prepared, ramp, nodes.front().t_s, nodes.back().t_s);
  const Eigen::MatrixXcd seen = rows.cast<Complex>();
  for (const WindowNode& node : nodes) {
    const Eigen::MatrixX2cd both = seen * run.advance(node.t_s);
    parts.per_eccentricity.row(node.point) += node.weight * both.col(0).transpose();
    parts.bow_m.row(node.point) += node.weight * both.col(1).transpose();
    parts.per_eccentricity_mirrored.row(node.point) += node.mirrored * both.col(0).adjoint();
    parts.bow_mirrored_m.row(node.point) += node.mirrored * both.col(1).adjoint();
  }
  return parts;
}

Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns) {
  const RampParts parts = ramp_parts(prepared, rows, ramp, t_s, window_turns);
  return eccentricity_m * parts.per_eccentricity + parts.bow_m;
}

Eigen::RowVectorXcd steady_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                                   double eccentricity_m, double speed_hz) {
  structure::refuse_beyond_tables(prepared.machine, speed_hz, speed_hz);
  const auto& assembly = prepared.assembly;
  const double w = 2 * pi * speed_hz;
  const structure::LinearSystem system = structure::system_at(assembly, w);
  Eigen::VectorXcd force = eccentricity_m * w * w * system.unbalance_kg;
  if (assembly.bow_n.size() > 0) force += assembly.bow_n;
  const scene::QuietMotion quiet =
      scene::quiet_motion(system, w, force, Eigen::VectorXd::Zero(system.coordinates()));
  return (rows.cast<Complex>() * quiet.amplitude).transpose();
}

std::vector<WindowNode> window_nodes(const Ramp& ramp, const std::vector<double>& t_s, double window_turns) {
  std::vector<WindowNode> nodes;
  const WindowWeights weights = window_weights(std::max(window_turns, 1.0));
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    const auto point = static_cast<Eigen::Index>(k);
    const double now_hz = speed_hz(ramp, t_s[k]);
    if (!(now_hz > 0)) throw ConfigError("a ramp reaches speed 0, allowed: speeds above it");
    const double half_s = window_turns / now_hz / 2;
    if (!(half_s > 0)) {
      nodes.push_back({t_s[k], 1, 0, point});
      continue;
    }
    const double change = (speed_hz(ramp, t_s[k] + half_s) - speed_hz(ramp, t_s[k] - half_s)) / now_hz;
    for (Eigen::Index j = 0; j < degrees; ++j) {
      const double u = places[static_cast<std::size_t>(j)];
      nodes.push_back(
          {t_s[k] + half_s * (u - change * u * u / 4), weights.mean(j), weights.mirrored(j), point});
    }
  }
  std::ranges::sort(nodes, {}, &WindowNode::t_s);
  return nodes;
}

}  // namespace rubsweep::fit
