#include "rubsweep/response/aperiodic.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>

#include "rubsweep/response/closest_return.hpp"
#include "rubsweep/response/motion/section.hpp"
#include "rubsweep/response/spectrum/discrete_lines.hpp"

namespace rubsweep::response {
namespace {

using Complex = std::complex<double>;

/// Of the undecided cells of the one-side, two-sides and annular maps the first look decides five of six, all
/// three together nineteen of twenty. A transient that outlasts them may last for ever.
constexpr std::size_t looks[] = {640, 1280, 2560};
constexpr std::size_t shortest_chaos = 1280;

/// The base motion, turn by turn, and how a disturbance of it grows.
struct Followed {
  std::size_t states = 0;
  std::vector<double> rows;           ///< sections after turns 1, 2, ...
  std::vector<double> contributions;  ///< to the exponent
  int turns_without_contact = 0;

  std::size_t turns() const { return contributions.size(); }

  std::span<const double> last_rows(std::size_t count) const { return std::span(rows).last(count * states); }
};

/// Displacements of the observed point at `count` successive rows.
std::vector<Complex> displacements(std::span<const double> rows, std::size_t states,
                                   const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed) {
  std::vector<Complex> z;
  for (std::size_t first = 0; first < rows.size(); first += states) {
    const Eigen::Map<const Eigen::VectorXd> q(rows.data() + first, observed.cols());
    z.emplace_back(observed.row(0).dot(q), observed.row(1).dot(q));
  }
  return z;
}

bool stays_away(const ClosestReturn& nearest) {
  return nearest.distance >= significant_return && nearest.rate_error_bar <= known_rate &&
         std::abs(nearest.rate) <= std::max(nearest.rate_error_bar, zero_rate);
}

bool is_torus(const Followed& motion, const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
              spectrum::SpectrumWorkspace& workspace) {
  const std::size_t half = 2 * motion.turns() / 5;
  const auto rows = motion.last_rows(2 * half);
  if (!stays_away(closest_return(rows, static_cast<int>(motion.states), window / 2))) return false;
  const std::vector<Complex> z = displacements(rows, motion.states, observed);
  return spectrum::same_discrete_lines(std::span(z).first(half), std::span(z).last(half), workspace);
}

/// Fills class and evidence; false when the turns so far do not decide.
bool decide(const Followed& motion, const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
            spectrum::SpectrumWorkspace& workspace, Aperiodic& result) {
  result.exponent = exponent_of(motion.contributions);
  const std::size_t half = 2 * motion.turns() / 5;
  const auto period = motion::period_of_section(motion.last_rows(half), static_cast<int>(motion.states),
                                                static_cast<int>(half) / 2);
  if (period) {
    result.returns_after = period->order;
    return true;
  }
  const auto [exponent, bar] = *result.exponent;
  if (exponent < -std::max(bar, chaos_floor)) return true;
  if (exponent > std::max(bar, chaos_floor) && motion.turns() >= shortest_chaos) {
    result.motion_class = motion::MotionClass::chaotic;
    return true;
  }
  const bool zero =
      std::abs(exponent) <= std::max(bar, zero_exponent) && std::abs(exponent) + bar <= chaos_floor;
  if (!zero || !is_torus(motion, observed, window, workspace)) return false;
  result.motion_class = motion::MotionClass::quasi_periodic;
  return true;
}

}  // namespace

Aperiodic classify_aperiodic(const Growth& turn, const std::function<bool()>& touched,
                             std::vector<double> section,
                             const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
                             spectrum::SpectrumWorkspace& workspace) {
  Followed motion{.states = section.size(), .rows = {}, .contributions = {}};
  Aperiodic result;
  for (const std::size_t look : looks) {
    while (motion.turns() < look) {
      const auto growth = turn(section);
      if (!growth) return {};
      motion.turns_without_contact = touched() ? 0 : motion.turns_without_contact + 1;
      if (motion.turns_without_contact >= window) return {};
      motion.rows.insert(motion.rows.end(), section.begin(), section.end());
      motion.contributions.push_back(*growth);
    }
    if (decide(motion, observed, window, workspace, result)) return result;
  }
  return result;
}

}  // namespace rubsweep::response
