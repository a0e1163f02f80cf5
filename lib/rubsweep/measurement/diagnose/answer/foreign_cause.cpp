#include "rubsweep/measurement/diagnose/answer/foreign_cause.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/features/line_features.hpp"

namespace rubsweep::diagnose::answer {
namespace {

using Complex = std::complex<double>;
using features::HannEnergy;

constexpr int line_bins = 2;             ///< bins on either side that a line fills under a Hann window
constexpr int highest_multiple = 7;      ///< highest whole order whose lines the spectrum holds
constexpr double fewest_share = 0.5;     ///< smallest share of the energy off 1X that makes a sign
constexpr double nothing_off_1x = 3e-3;  ///< energy off 1X below which there are no signs
constexpr double visible_share = 0.03;   ///< smallest share of a line that counts in a series
constexpr double one_direction = 0.9;    ///< least forward share of a whirl

class Rules {
 public:
  Rules(const MotionLines& lines, const ForeignQuestion& question)
      : lines_(lines),
        question_(question),
        plane_(question.probe_angle_deg.has_value()),
        energy_(lines, plane_),
        strongest_(features::strongest_between_multiples(energy_, {})),
        order_(strongest_ == 0 ? 0 : features::order_of_line(energy_, strongest_)),
        off_(total() - both(1)) {}

  std::vector<ForeignSign> signs() const {
    std::vector<ForeignSign> signs;
    if (off_ < nothing_off_1x) return signs;
    const auto add = [&](ForeignCause cause, double energy, double order) {
      if (energy >= fewest_share * off_) signs.push_back({cause, std::min(1.0, energy / off_), order});
    };
    add_mains(add);
    add(ForeignCause::misalignment, both(2), 2);
    const double critical = 2 * question_.speed_hz / question_.natural_frequency_hz;
    constexpr double near_half = 0.1;
    if (std::abs(critical - 1) < near_half) add(ForeignCause::cracked_shaft, both(2), 2);
    if (const double series = series_energy(1); visible_multiples() >= 3) {
      if (is_run_out()) add(ForeignCause::run_out, series, strongest_multiple());
      if (is_straight()) add(ForeignCause::looseness, series_energy(2), strongest_multiple());
    }
    add_whirls(add);
    add_bearing(add);
    if (question_.one_mode && question_.natural_frequency_hz > 0) add_second_mode(add);
    std::ranges::stable_sort(signs, std::greater{}, &ForeignSign::share);
    return signs;
  }

 private:
  double total() const {
    double sum = 0;
    for (int k = energy_.first(); k <= energy_.last(); ++k) sum += energy_[k];
    return sum;
  }
  double both(double order) const { return energy_.near(order, line_bins) + energy_.near(-order, line_bins); }
  /// Distance of an order from the multiples of 1/n, in bins.
  double bins_off(double order, int n) const {
    return std::abs(order - std::round(order * n) / n) * lines_.turns;
  }
  /// Energy at the multiples of 1/n without 1X, from 2X on if n is 1.
  double series_energy(int n) const {
    double sum = 0;
    for (int k = 1; k <= highest_multiple * n; ++k)
      if (k != n) sum += both(static_cast<double>(k) / n);
    return sum;
  }
  int visible_multiples() const {
    int count = 0;
    for (int k = 2; k <= highest_multiple; ++k) count += both(k) >= visible_share * off_;
    return count;
  }
  double strongest_multiple() const {
    int best = 2;
    for (int k = 3; k <= highest_multiple; ++k)
      if (both(k) > both(best)) best = k;
    return best;
  }

  void add_mains(const auto& add) const {
    constexpr double least_apart_bins = 1.5, largest_error = 0.01;
    for (const double mains_hz : {50.0, 60.0}) {
      const double order = mains_hz / question_.speed_hz;
      double energy = 0, found = 0;
      for (const double multiple : {order, 2 * order}) {
        const int k = static_cast<int>(std::lround(multiple * lines_.turns));
        if (bins_off(multiple, 2) < least_apart_bins || k >= energy_.last()) continue;
        const int side = energy_[k] >= energy_[-k] ? k : -k;
        const double there = std::abs(features::order_of_line(energy_, side));
        if (std::abs(there - multiple) > largest_error * multiple) continue;
        energy += both(multiple);
        if (found == 0) found = multiple;
      }
      if (found > 0) add(ForeignCause::mains_hum, energy, found);
    }
  }

  void add_whirls(const auto& add) const {
    const double order = std::abs(order_);
    if (strongest_ == 0 || order >= 1) return;
    const double forward = energy_.near(order, line_bins + 1),
                 all = forward + energy_.near(-order, line_bins + 1);
    if (plane_ && forward < one_direction * all) return;
    constexpr double slowest = 0.38, fastest = 0.495, same_frequency = 0.04, half_bins = 0.7;
    if (order >= slowest && order <= fastest && bins_off(order, 2) > half_bins)
      add(ForeignCause::oil_whirl, all, order);
    if (std::abs(order * question_.speed_hz / question_.natural_frequency_hz - 1) < same_frequency)
      add(ForeignCause::self_excited, all, order);
  }

  void add_bearing(const auto& add) const {
    constexpr double lowest = 2.2, least_apart_bins = 0.7;
    constexpr int most_fraction = 3;
    const double order = std::abs(order_);
    if (strongest_ == 0 || order < lowest) return;
    for (int n = 2; n <= most_fraction; ++n)
      if (bins_off(order, n) < least_apart_bins) return;
    double energy = 0;
    for (int multiple = 1; multiple * order - 1 <= highest_multiple; ++multiple)
      for (const int side : {-1, 0, 1})
        if (bins_off(multiple * order, 1) > line_bins) energy += both(multiple * order + side);
    add(ForeignCause::bearing_fault, energy, order_);
  }

  /// One mode, even stiffened by a contact, answers weakly so far above its natural frequency.
  void add_second_mode(const auto& add) const {
    constexpr double far_above = 2.2;
    // A bin at the edge of a visible line has a sixth of its energy; those of noise have much less.
    const double least = visible_share / 6 * off_;
    const double lowest = far_above * question_.natural_frequency_hz / question_.speed_hz * lines_.turns;
    double energy = 0;
    int best = 0;
    for (int k = energy_.first(); k <= energy_.last(); ++k) {
      if (std::abs(k) < lowest || energy_[k] < least || !features::between_multiples(energy_, k, line_bins))
        continue;
      energy += energy_[k];
      if (energy_[k] > energy_[best]) best = k;
    }
    if (best != 0) add(ForeignCause::second_mode, energy, features::order_of_line(energy_, best));
  }

  /// Component of the motion along a direction at a whole order.
  Complex along(double direction_rad, int order) const {
    const Complex turned = std::polar(1.0, -direction_rad);
    const int k = order * lines_.turns;
    return (turned * lines_.at(k) + std::conj(turned * lines_.at(-k))) / 2.0;
  }

  /// Whether the second probe reads what the first one read, later by the angle between both; one probe does
  /// not rule it out.
  bool is_run_out() const {
    constexpr double least_correlation = 0.95;
    if (!plane_) return true;
    const double first_rad = question_.probe_angle_deg->first * std::numbers::pi / 180,
                 second_rad = question_.probe_angle_deg->second * std::numbers::pi / 180;
    double together = 0, of_first = 0, of_second = 0;
    for (int order = 2; order <= highest_multiple; ++order) {
      const Complex a = along(first_rad, order) * std::polar(1.0, -order * (second_rad - first_rad)),
                    b = along(second_rad, order);
      together += (std::conj(a) * b).real();
      of_first += std::norm(a);
      of_second += std::norm(b);
    }
    return together >= least_correlation * std::sqrt(of_first * of_second);
  }

  /// Whether the multiples lie along one direction, the same for all; one probe does not rule it out.
  bool is_straight() const {
    constexpr double least_straight = 0.85;
    if (!plane_) return true;
    return features::straightness(lines_, [&](int k) {
             const int order = k / lines_.turns;
             return k == order * lines_.turns && order >= 2 && order <= highest_multiple ? 1 : 0;
           }) >= least_straight;
  }

  const MotionLines& lines_;
  const ForeignQuestion& question_;
  bool plane_;
  HannEnergy energy_;
  int strongest_;  ///< number of the strongest line between the multiples, 0: none
  double order_, off_;
};

}  // namespace

std::string_view words_for(ForeignCause cause) {
  switch (cause) {
    case ForeignCause::mains_hum: return "hum of the mains in the instrument";
    case ForeignCause::run_out: return "run-out of the surface, the same at every speed";
    case ForeignCause::misalignment: return "2X, as of a misaligned coupling or unequal stiffness";
    case ForeignCause::cracked_shaft: return "2X at half the critical speed, as of a cracked shaft";
    case ForeignCause::looseness: return "multiples along one direction, as of a loose support";
    case ForeignCause::oil_whirl: return "a forward whirl at less than half the speed, as of an oil film";
    case ForeignCause::self_excited:
      return "a forward whirl at the natural frequency, as of an oil film, a seal or internal damping";
    case ForeignCause::bearing_fault:
      return "a line and its multiples that no fraction of the speed has, as of a faulty bearing";
    case ForeignCause::second_mode:
      return "lines far above the natural frequency, as of a second bending mode: try a rotor_kit";
  }
  throw SolverError("foreign cause: no such enumerator");
}

std::vector<ForeignSign> foreign_signs(const MotionLines& lines, const ForeignQuestion& question) {
  return Rules(lines, question).signs();
}

}  // namespace rubsweep::diagnose::answer
