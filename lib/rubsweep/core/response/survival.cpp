#include "rubsweep/core/response/survival.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/response/followed.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::response {
namespace {

constexpr double confidence = 0.95;

/// Standard deviation of every coordinate along the motion.
std::vector<double> spread_of(const Followed& motion) {
  std::vector<double> mean(motion.states, 0), square(motion.states, 0);
  const auto turns = static_cast<double>(motion.turns());
  for (std::size_t i = 0; i < motion.rows.size(); ++i) mean[i % motion.states] += motion.rows[i] / turns;
  for (std::size_t i = 0; i < motion.rows.size(); ++i) {
    const double off = motion.rows[i] - mean[i % motion.states];
    square[i % motion.states] += off * off / turns;
  }
  for (double& x : square) x = std::sqrt(x);
  return square;
}

/// Start of a companion: the last section, moved forwards or backwards by the shares of `first_disturbance`;
/// each pair of companions is farther away than the pair before.
std::vector<double> start_of(const Followed& motion, const std::vector<double>& spread, int companion,
                             double distance) {
  const auto last = motion.last_rows(1);
  const Eigen::VectorXd shares = first_disturbance(motion.states) / separation;
  const double length = (companion % 2 == 0 ? distance : -distance) * (1 + companion / 2);
  std::vector<double> start(last.begin(), last.end());
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] += length * spread[i] * shares(static_cast<Eigen::Index>(i));
  return start;
}

/// Whether the motion is periodic in its last window, during which chaos would not return all the time.
bool returns(const Followed& lived, const SurvivalOptions& options) {
  const auto window = static_cast<std::size_t>(options.window);
  return lived.turns() > window &&
         motion::period_of_section(lived.last_rows(window + 1), static_cast<int>(lived.states),
                                   options.max_order);
}

}  // namespace

double Survival::least_mean_life() const {
  if (!(turns > 0)) return 0;
  const boost::math::chi_squared_distribution<double> chi_squared(2.0 * (escapes + 1));
  return 2 * turns / boost::math::quantile(chi_squared, confidence);
}

Survival survive(const proof::SectionMap& turn, const std::function<bool()>& touched, const Followed& motion,
                 const SurvivalOptions& options) {
  const auto counted = [&options](std::size_t turns) {
    return std::max(0.0, static_cast<double>(turns) - options.window);
  };
  Survival seen{.turns = counted(motion.turns()), .escapes = 0};
  if (motion.turns() == 0) return seen;
  const std::vector<double> spread = spread_of(motion);
  for (int companion = 0; companion < options.companions; ++companion) {
    std::vector<double> section = start_of(motion, spread, companion, options.distance);
    Followed lived{.states = motion.states, .rows = {}, .contributions = {}};
    bool escaped = false;
    for (int k = 1; k <= options.turns && !escaped && turn(section); ++k) {
      lived.add(section, 0, touched());
      const bool look = k % options.window == 0 || k == options.turns;
      escaped = lived.turns_without_contact >= options.window || (look && returns(lived, options));
    }
    seen.turns += counted(lived.turns());
    if (escaped) ++seen.escapes;
  }
  return seen;
}

}  // namespace rubsweep::response
