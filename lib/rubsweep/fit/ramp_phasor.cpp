#include "rubsweep/fit/ramp_phasor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "rubsweep/error.hpp"
#include "rubsweep/fit/mode_set.hpp"
#include "rubsweep/scene/quiet_motion.hpp"
#include "rubsweep/structure/system_at.hpp"
#include "rubsweep/structure/tabled_support.hpp"

namespace rubsweep::fit {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A mode follows the speed where |rate of the shaft| / |distance from resonance|^2 is below this: what is
/// left out is the square of it.
constexpr double far_from_resonance = 1e-4;
constexpr int stretches = 64, stretches_of_tables = 128;
constexpr double longest_step_rad = 2;

struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 5> gauss{{{0.046910077030668, 0.118463442528095},
                                           {0.230765344947158, 0.239314335249683},
                                           {0.5, 0.284444444444444},
                                           {0.769234655052842, 0.239314335249683},
                                           {0.953089922969332, 0.118463442528095}}};

/// Forces that turn with the shaft, and modes, at the speed of the moment.
class Ramped {
 public:
  Ramped(const scene::PreparedMachine& prepared, double eccentricity_m, const Ramp& ramp, double begin_s,
         double end_s)
      : prepared_(prepared),
        ramp_(ramp),
        unbalance_n_(eccentricity_m * prepared.assembly.system.unbalance_kg) {
    const auto& assembly = prepared.assembly;
    bow_n_ = assembly.bow_n.size() > 0 ? assembly.bow_n : Eigen::VectorXcd::Zero(unbalance_n_.size());
    const bool changing =
        assembly.gyroscopic.size() > 0 || assembly.circulatory.size() > 0 || !assembly.tables.empty();
    const int count = assembly.tables.empty() ? stretches : stretches_of_tables;
    stretch_s_ = changing ? std::max((end_s - begin_s) / count, 1e-9) : INFINITY;
    start(begin_s);
  }

  /// Displacements in the frame that turns with the shaft.
  Eigen::VectorXcd advance(double to_s) {
    while (now_s_ < to_s) {
      const double stretch_end_s = stretch_begin_s_ + stretch_s_;
      integrate(std::min(to_s, stretch_end_s));
      if (now_s_ >= stretch_end_s) restart();
    }
    return modes_->vectors.topRows(unbalance_n_.size()) * amplitudes();
  }

 private:
  double speed(double t) const { return 2 * pi * (ramp_.from_hz + ramp_.rate_hz_per_s * t); }
  double gain() const { return 2 * pi * ramp_.rate_hz_per_s; }
  double angle(double t) const { return 2 * pi * (ramp_.from_hz * t + ramp_.rate_hz_per_s * t * t / 2); }

  /// Modal force of mode k in the turning frame: unbalance_ (W^2 - i W') + bow_.
  Complex push(Eigen::Index k, double t) const {
    const double w = speed(t);
    return unbalance_(k) * Complex(w * w, -gain()) + bow_(k);
  }

  /// Answer of a mode that follows the speed: a = -c / m - (c / m)' / m with m = value - i W.
  Complex following(Eigen::Index k, double t) const {
    const Complex m = modes_->values(k) - Complex(0, speed(t)), c = push(k, t);
    const Complex c_rate = unbalance_(k) * 2.0 * speed(t) * gain(), m_rate(0, -gain());
    return -c / m - (c_rate / m - c * m_rate / (m * m)) / m;
  }

  void use_modes(double t) {
    modes_ = modes_at(prepared_, speed(t + (std::isfinite(stretch_s_) ? stretch_s_ / 2 : 0)));
    unbalance_ = modes_->force * unbalance_n_;
    bow_ = modes_->force * bow_n_;
    follows_.assign(static_cast<std::size_t>(modes_->values.size()), true);
    for (Eigen::Index k = 0; k < modes_->values.size(); ++k) {
      // The nearest that the stretch, or without stretches any speed, comes to the mode.
      const Complex value = modes_->values(k);
      double nearest = std::abs(value.real());
      if (std::isfinite(stretch_s_)) {
        const auto [low, high] = std::minmax({speed(t), speed(t + stretch_s_)});
        nearest = std::abs(value - Complex(0, std::clamp(value.imag(), low, high)));
      }
      follows_[static_cast<std::size_t>(k)] = std::abs(gain()) < far_from_resonance * nearest * nearest;
    }
  }

  void start(double t) {
    now_s_ = stretch_begin_s_ = t;
    use_modes(t);
    state_.resize(modes_->values.size());
    for (Eigen::Index k = 0; k < state_.size(); ++k) state_(k) = following(k, t);
  }

  /// The modes of the next stretch take over the motion.
  void restart() {
    const Eigen::VectorXcd motion = modes_->vectors * amplitudes();
    stretch_begin_s_ = now_s_;
    use_modes(now_s_);
    state_ = modes_->inverse * motion;
  }

  Eigen::VectorXcd amplitudes() const {
    Eigen::VectorXcd all = state_;
    for (Eigen::Index k = 0; k < all.size(); ++k)
      if (follows_[static_cast<std::size_t>(k)]) all(k) = following(k, now_s_);
    return all;
  }

  void integrate(double to_s) {
    for (Eigen::Index k = 0; k < state_.size(); ++k) {
      if (follows_[static_cast<std::size_t>(k)]) continue;
      const Complex value = modes_->values(k);
      double t = now_s_;
      while (t < to_s) {
        const double distance = std::abs(value - Complex(0, speed(t)));
        const double step = std::min(to_s - t, longest_step_rad / std::max(distance, 1e-3));
        const double end = t + step >= to_s ? to_s : t + step;
        Complex sum = state_(k) * std::exp(value * (end - t) - Complex(0, angle(end) - angle(t)));
        for (const GaussPoint& point : gauss) {
          const double at = t + point.place * (end - t);
          sum += point.weight * (end - t) * push(k, at) *
                 std::exp(value * (end - at) - Complex(0, angle(end) - angle(at)));
        }
        state_(k) = sum;
        t = end;
      }
    }
    now_s_ = to_s;
  }

  const scene::PreparedMachine& prepared_;
  Ramp ramp_;
  Eigen::VectorXcd unbalance_n_, bow_n_;
  double stretch_s_ = 0, stretch_begin_s_ = 0, now_s_ = 0;
  std::optional<ModeSet> modes_;
  Eigen::VectorXcd unbalance_, bow_, state_;
  std::vector<bool> follows_;
};

/// Instants of a window and their weights in its mean, by Simpson's rule.
struct Node {
  double t_s = 0, weight = 0;
  Eigen::Index point = 0;
};

}  // namespace

Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns) {
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    const auto point = static_cast<Eigen::Index>(k);
    const double speed_hz = ramp.from_hz + ramp.rate_hz_per_s * t_s[k];
    if (!(speed_hz > 0)) throw ConfigError("a ramp reaches speed 0, allowed: speeds above it");
    const double half_s = window_turns / speed_hz / 2;
    if (half_s > 0) {
      nodes.push_back({t_s[k] - half_s, 1.0 / 6, point});
      nodes.push_back({t_s[k] + half_s, 1.0 / 6, point});
    }
    nodes.push_back({t_s[k], half_s > 0 ? 4.0 / 6 : 1, point});
  }
  std::ranges::sort(nodes, {}, &Node::t_s);
  Eigen::MatrixXcd phasors = Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(t_s.size()), rows.rows());
  if (nodes.empty()) return phasors;
  const auto [low_hz, high_hz] = std::minmax({ramp.from_hz + ramp.rate_hz_per_s * nodes.front().t_s,
                                              ramp.from_hz + ramp.rate_hz_per_s * nodes.back().t_s});
  structure::refuse_beyond_tables(prepared.machine, low_hz, high_hz);
  structure::refuse_changing_mass(prepared.machine, "a ramp");
  Ramped run(prepared, eccentricity_m, ramp, nodes.front().t_s, nodes.back().t_s);
  for (const Node& node : nodes)
    phasors.row(node.point) += node.weight * (rows.cast<Complex>() * run.advance(node.t_s)).transpose();
  return phasors;
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

}  // namespace rubsweep::fit
