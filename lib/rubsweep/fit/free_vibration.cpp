#include "rubsweep/fit/free_vibration.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/fit/mode_set.hpp"
#include "rubsweep/scene/build_scene.hpp"
#include "rubsweep/structure/tabled_support.hpp"

namespace rubsweep::fit {
namespace {

using Complex = std::complex<double>;

/// Answer of a' = value a + sin(w t) for 0 < t < d, from rest.
Complex answer(Complex value, double t, double duration_s) {
  if (t <= 0) return 0;
  const double w = std::numbers::pi / duration_s;
  const Complex denominator = value * value + w * w;
  if (t < duration_s)
    return (w * std::exp(value * t) - value * std::sin(w * t) - w * std::cos(w * t)) / denominator;
  return w * (std::exp(value * t) + std::exp(value * (t - duration_s))) / denominator;
}

}  // namespace

Eigen::MatrixXd free_vibration(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                               const std::vector<double>& since_s) {
  structure::refuse_beyond_tables(prepared.machine, 0, 0);
  const auto pulses = scene::build_cell(prepared, 1, scene::Eccentricity{0}).scene.pulses;
  if (pulses.empty())
    throw ConfigError("kick: is not there, allowed with a ring-down: where and how it was struck");
  const ModeSet modes = modes_at(prepared, 0);
  const Eigen::MatrixXcd seen = rows.cast<Complex>() * modes.vectors.topRows(rows.cols());
  Eigen::MatrixXd signal = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(since_s.size()), rows.rows());
  for (const scene::Pulse& pulse : pulses) {
    const Eigen::VectorXcd push = modes.force((pulse.force_n * pulse.direction).cast<Complex>());
    Eigen::VectorXcd state(push.size());
    for (std::size_t k = 0; k < since_s.size(); ++k) {
      for (Eigen::Index i = 0; i < push.size(); ++i)
        state(i) = push(i) * answer(modes.values(i), since_s[k] + pulse.elapsed_s, pulse.duration_s);
      signal.row(static_cast<Eigen::Index>(k)) += (seen * state).real().transpose();
    }
  }
  return signal;
}

}  // namespace rubsweep::fit
