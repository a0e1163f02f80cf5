#include "rubsweep/core/response/aperiodic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::response {
namespace {

/// Turns of the three tests. The first test decides five of six undecided cells of the one-side, two-sides
/// and annular maps; all three decide nineteen of twenty. A transient that outlasts them may last for ever.
constexpr std::size_t first_look = 640, second_look = 1280, last_look = 2560;
constexpr std::size_t shortest_chaos = 1280;

/// Period of the section in the last two fifths of the turns.
std::optional<motion::SectionPeriod> period_of(const Followed& motion) {
  const std::size_t half = 2 * motion.turns() / 5;
  return motion::period_of_section(motion.last_rows(half), static_cast<int>(motion.states),
                                   static_cast<int>(half) / 2);
}

bool chaotic(const motion::Exponent& exponent) {
  return exponent.per_revolution > std::max(exponent.error_bar, chaos_floor);
}

/// Whether a disturbance grew (`sign` 1) or shrank (-1) by more than it ever changed in the opposite
/// direction meanwhile; the first fifth is dropped. The tangent vector of a stick-slip motion swings by a
/// factor of hundreds, but neither grows nor shrinks. Near a resonance of slip and shaft these swings are so
/// slow that blocks of turns show a trend.
bool goes_beyond_its_swings(std::span<const double> contributions, double sign) {
  double sum = 0, furthest = 0, largest_return = 0;
  for (const double growth : contributions.subspan(contributions.size() / 5)) {
    sum += sign * growth;
    furthest = std::max(furthest, sum);
    largest_return = std::max(largest_return, furthest - sum);
  }
  return sum > largest_return;
}

/// Whether the motion was chaotic in the first half of the turns before its last window.
bool was_chaotic(const Followed& motion, int window) {
  constexpr std::size_t fewest = 80;
  const std::size_t turns = motion.turns() - std::min(motion.turns(), static_cast<std::size_t>(window));
  return turns / 2 >= fewest && chaotic(exponent_of(std::span(motion.contributions).first(turns / 2)));
}

/// Sets class and evidence; false when the turns so far do not decide.
bool decide(const Followed& motion, std::size_t turns_before,
            const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
            spectrum::SpectrumWorkspace& workspace, Aperiodic& result) {
  result.exponent = exponent_of(motion.contributions);
  if (const auto period = period_of(motion)) {
    result.returns_after = period->order;
    result.left_chaos = was_chaotic(motion, window);
    return true;
  }
  const auto [exponent, bar] = *result.exponent;
  if (exponent < -std::max(bar, chaos_floor) && goes_beyond_its_swings(motion.contributions, -1)) return true;
  if (chaotic(*result.exponent) && turns_before + motion.turns() >= shortest_chaos &&
      goes_beyond_its_swings(motion.contributions, 1)) {
    result.motion_class = motion::MotionClass::chaotic;
    return true;
  }
  const bool zero =
      std::abs(exponent) <= std::max(bar, zero_exponent) && std::abs(exponent) + bar <= chaos_floor;
  if (!zero || !returns_like_a_torus(motion, observed, window, known_rate, workspace)) return false;
  result.motion_class = motion::MotionClass::quasi_periodic;
  return true;
}

constexpr long first_watch = 200;  ///< turns from the start of watching to the first test
/// Largest exponent of a torus, computed with smooth weights, over all turns and over each half. On 281 cells
/// of an annular map these limits separated all 237 tori from 29 chaotic and 15 other motions.
constexpr double torus_exponent = 2e-4, torus_half_exponent = 8e-4;
/// Required accuracy of the closest return's rate; coarse, because the exponent is known much better.
constexpr double return_rate_known_to = 2e-3;
/// If the exponents of both halves exceed this limit, the motion is chaotic, at least for now.
constexpr double chaotic_half_exponent = 0.02;

/// Exponent of a motion that has been chaotic throughout. Conditions: at least 1280 turns; an exponent that
/// is positive beyond its error bar and above chaos_floor, also in either half by smooth weights; and a
/// section that does not return. Empty for any other motion.
std::optional<motion::Exponent> lasting_chaos(const Followed& motion) {
  if (motion.turns() < shortest_chaos) return std::nullopt;
  const motion::Exponent exponent = exponent_of(motion.contributions);
  const BumpMeans means = bump_means(motion.contributions);
  if (!chaotic(exponent) || std::min(means.first, means.last) <= chaos_floor || period_of(motion) ||
      !goes_beyond_its_swings(motion.contributions, 1)) {
    return std::nullopt;
  }
  return exponent;
}

}  // namespace

Aperiodic classify_aperiodic(const Growth& turn, const std::function<bool()>& touched,
                             std::vector<double> section, std::size_t turns_before,
                             const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
                             spectrum::SpectrumWorkspace& workspace) {
  Aperiodic result;
  Followed& motion = result.motion;
  motion.states = section.size();
  const std::size_t chaos_from = turns_before < shortest_chaos ? shortest_chaos - turns_before : 0;
  for (const std::size_t look : {first_look, std::max(first_look, chaos_from), second_look, last_look}) {
    if (look <= motion.turns()) continue;
    while (motion.turns() < look) {
      const auto growth = turn(section);
      if (!growth) return {};
      motion.add(section, *growth, touched());
      if (motion.turns_without_contact >= window) {
        Aperiodic lost;
        lost.left_chaos = was_chaotic(motion, window);
        return lost;
      }
    }
    if (decide(motion, turns_before, observed, window, workspace, result)) return result;
  }
  return result;
}

TorusWatch::TorusWatch(const scene::Scene& scene, const motion::ResponseOptions& options, bool wanted)
    : options_(options),
      observed_(scene::observed(scene)),
      motion_{.states = 2 * static_cast<std::size_t>(scene.structure.coordinates()),
              .rows = {},
              .contributions = {}},
      direction_(first_disturbance(motion_.states).normalized()),
      look_(settled_after + std::max(first_watch, 2L * options.window_revolutions)),
      record_begin_(last_windows()) {
  if (!wanted || !worth_a_look()) end();
}

void TorusWatch::ask(long revolutions, integrate::run::TurnRequest& request) const {
  const bool carrying = look_ < options_.max_revolutions || chaotic_;
  if (carrying && revolutions >= settled_after) {
    request.tangent_vectors = direction_;
    request.tangent_accuracy = growth_accuracy;
  } else {
    request.tangent_vectors.resize(0, 0);
  }
}

void TorusWatch::add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn) {
  if (request.tangent_vectors.cols() == 0) return;
  const Eigen::MatrixXd* moved = turn.tangent_vectors.get();
  if (!moved) return refuse();
  direction_ = *moved;
  motion_.add(turn.section, take_growth(direction_), turn.touched);
}

/// Whether the motion touches, has no period in the last window, and returns as a torus does.
bool TorusWatch::shows_a_torus(spectrum::SpectrumWorkspace& workspace) const {
  const int window = options_.window_revolutions;
  if (motion_.turns_without_contact >= window) return false;
  const auto rows = motion_.last_rows(static_cast<std::size_t>(window) + 1);
  return !motion::period_of_section(rows, static_cast<int>(motion_.states), options_.max_order) &&
         returns_like_a_torus(motion_, observed_, window, return_rate_known_to, workspace);
}

void TorusWatch::look(spectrum::SpectrumWorkspace& workspace) {
  const auto [all, first, last] = bump_means(motion_.contributions);
  const bool zero = std::abs(all) < torus_exponent && std::abs(first) < torus_half_exponent &&
                    std::abs(last) < torus_half_exponent;
  if (zero && shows_a_torus(workspace)) {
    torus_ = exponent_of(motion_.contributions);
    record_begin_ = look_;
    return end();
  }
  look_ += (look_ - settled_after) / 4;
  chaotic_ = std::min(first, last) > chaotic_half_exponent;
  if (chaotic_ || !worth_a_look()) end();
}

void TorusWatch::refuse() {
  torus_.reset();
  chaotic_ = false;
  record_begin_ = last_windows();
  end();
}

std::optional<motion::Exponent> TorusWatch::chaos() const {
  return chaotic_ ? lasting_chaos(motion_) : std::nullopt;
}

}  // namespace rubsweep::response
