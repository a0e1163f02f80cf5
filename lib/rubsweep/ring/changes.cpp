#include "rubsweep/ring/changes.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/ring/closed_forms.hpp"

namespace rubsweep::ring {
namespace {

using Complex = std::complex<double>;
using Values = Eigen::VectorXcd;
using Function = std::function<double(double speed)>;

struct End {
  double speed;
  Signature signature;
};

Complex nearest(const Values& values, Complex place) { return values(nearest_to(place, values)); }

std::array<Complex, 2> two_nearest(const Values& values, Complex place) {
  std::array<Complex, 2> two{};
  std::partial_sort_copy(
      values.begin(), values.end(), two.begin(), two.end(),
      [&](const Complex& a, const Complex& b) { return std::abs(a - place) < std::abs(b - place); });
  return two;
}

/// Discriminant (lambda_1 - lambda_2)^2 of the two roots nearest to `place`. It is smooth where they merge.
/// It is accurate to rounding, whereas each root is accurate only to the square root of rounding.
double discriminant(const Values& values, Complex place) {
  const auto [first, second] = two_nearest(values, place);
  const Complex difference = first - second;
  return (difference * difference).real();
}

/// Mean of the two roots nearest to `place`.
Complex middle(const Values& values, Complex place) {
  const auto [first, second] = two_nearest(values, place);
  return 0.5 * (first + second);
}

/// Complex pair nearest to the real axis, among the growing or among the decaying pairs.
Complex flattest_pair(const Values& values, bool grows, double zero) {
  Complex best(0, std::numeric_limits<double>::infinity());
  for (const Complex& value : values) {
    if (value.imag() > zero && (value.real() > zero) == grows && value.imag() < best.imag()) best = value;
  }
  return best;
}

/// First guess of a complex root that crosses the imaginary axis: of the values at both ends, the two closest
/// of which exactly one grows.
Complex crossing_pair(const Values& low, const Values& high, double zero) {
  Complex best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Complex& a : low) {
    for (const Complex& b : high) {
      const bool crosses = (a.real() > zero) != (b.real() > zero);
      if (!(a.imag() > zero && b.imag() > zero && crosses && std::abs(a - b) < least)) continue;
      least = std::abs(a - b);
      best = 0.5 * (a + b);
    }
  }
  return best;
}

enum class Kind { zero_crossing, axis_crossing, neutral_merger, growing_merger, decaying_merger, composite };

Kind kind_of(const NormalForm& form, const Signature& a, const Signature& b) {
  const int growing = std::abs(a.growing_real - b.growing_real);
  const int decaying = std::abs(a.decaying_real - b.decaying_real);
  const int pairs = std::abs(a.growing_pairs - b.growing_pairs);
  if (growing == 1 && decaying == 1 && pairs == 0) return Kind::zero_crossing;
  if (growing == 0 && decaying == 0 && pairs == 1) {
    return form.has_friction ? Kind::axis_crossing : Kind::neutral_merger;
  }
  // Without friction growing and decaying roots are mirror images and merge together.
  const bool mirrored = !form.has_friction && decaying == 2;
  if (growing == 2 && (decaying == 0 || mirrored) && pairs == 1) return Kind::growing_merger;
  if (growing == 0 && decaying == 2 && pairs == 0) return Kind::decaying_merger;
  return Kind::composite;
}

class Search {
 public:
  Search(const NormalForm& form, const ChangeOptions& options, std::vector<Change>& found)
      : form_(form), options_(options), found_(found) {}

  void between(const End& low, const End& high) {
    if (low.signature == high.signature) return;
    const double width = high.speed - low.speed;
    const double middle_speed = low.speed + 0.5 * width;
    const bool ends =
        width <= options_.tolerance_rad_per_s || middle_speed <= low.speed || middle_speed >= high.speed;
    if (starts_with_rotation(low, high)) return keep(low, high, low.speed);
    if (options_.polish && !ends && width < width_to_polish_) {
      if (const auto speed = polish(low, high)) return keep(low, high, *speed);
      // Another root was too near for a decision, so the search is repeated with a much smaller bracket.
      const double wide = std::exchange(width_to_polish_, width / 16);
      bisect(low, high, middle_speed);
      width_to_polish_ = wide;
      return;
    }
    if (ends) return keep(low, high, middle_speed);
    bisect(low, high, middle_speed);
  }

 private:
  void bisect(const End& low, const End& high, double middle_speed) {
    const End middle_end{middle_speed, signature_at(middle_speed)};
    between(low, middle_end);
    between(middle_end, high);
  }

  /// Whether the signature changes directly above speed zero. It does where friction makes a pair grow: the
  /// real part of this pair is proportional to the speed, so that the onset is at zero.
  bool starts_with_rotation(const End& low, const End& high) {
    const double probe = 1e-6 * form_.reference_rad_per_s;
    return form_.has_friction && low.speed == 0 && high.speed > probe &&
           signature_at(probe) == high.signature;
  }

  Values values_at(double speed) {
    ++evaluations_;
    return eigenvalues(form_, speed);
  }
  Signature signature_at(double speed) { return signature(form_, values_at(speed)); }

  /// Value of the root that changes, taken from the end of the bracket where it is easiest to identify.
  Complex place_of(Kind kind, const End& low, const End& high) {
    if (kind == Kind::zero_crossing) return 0;
    if (kind == Kind::axis_crossing || kind == Kind::neutral_merger) {
      const Values at_low = values_at(low.speed), at_high = values_at(high.speed);
      const Complex pair = crossing_pair(at_low, at_high, zero_tolerance(form_) * size_of(at_high));
      return kind == Kind::neutral_merger ? Complex(0, pair.imag()) : pair;
    }
    const bool more_growing_pairs = high.signature.growing_pairs > low.signature.growing_pairs;
    const bool fewer_real = high.signature.decaying_real < low.signature.decaying_real;
    const bool at_high = kind == Kind::decaying_merger ? fewer_real : more_growing_pairs;
    const Values values = values_at(at_high ? high.speed : low.speed);
    const double zero = zero_tolerance(form_) * size_of(values);
    return flattest_pair(values, kind == Kind::growing_merger, zero).real();
  }

  Function smooth_function(Kind kind, Complex place) {
    if (kind == Kind::zero_crossing) {
      return [this](double speed) {
        const double scaled = speed / form_.reference_rad_per_s;
        return numerics::dense::determinant(form_.stiffness - scaled * scaled * form_.softening);
      };
    }
    if (kind == Kind::axis_crossing) {
      return [this, place](double speed) { return nearest(values_at(speed), place).real(); };
    }
    return [this, place](double speed) { return discriminant(values_at(speed), place); };
  }

  std::optional<double> polish(const End& low, const End& high) {
    const Kind kind = kind_of(form_, low.signature, high.signature);
    if (kind == Kind::composite) return std::nullopt;
    const Function function = smooth_function(kind, place_of(kind, low, high));
    // An end may be on the wrong side of its root, within the tolerance.
    const double reach = kind == Kind::axis_crossing ? 1e-6 * form_.reference_rad_per_s : 0;
    const double first = low.speed - reach, last = high.speed + reach;
    const double at_low = function(first), at_high = function(last);
    if (!(std::isfinite(at_low) && std::isfinite(at_high)) || at_low * at_high >= 0) return std::nullopt;
    std::uintmax_t steps = 400;  // never reached: four evaluations at least halve the bracket
    const auto [from, to] = boost::math::tools::toms748_solve(
        function, first, last, at_low, at_high, boost::math::tools::eps_tolerance<double>(51), steps);
    const double speed = from + 0.5 * (to - from);
    // The bracket may contain another root of the same function, so the signatures on both sides are
    // compared.
    const double aside = distance_to_tell(kind, function, speed);
    const bool before = speed - aside <= low.speed || signature_at(speed - aside) == low.signature;
    const bool after = speed + aside >= high.speed || signature_at(speed + aside) == high.signature;
    if (!before || !after) return std::nullopt;
    return speed;
  }

  /// Distance from a root at which the signature has surely changed. If a root crosses the axis slowly, it
  /// stays within the tolerance of zero for a while.
  double distance_to_tell(Kind kind, const Function& function, double speed) {
    const double least = 1e-6 * form_.reference_rad_per_s;
    if (kind != Kind::axis_crossing) return least;
    const double slope = (function(speed + least) - function(speed - least)) / (2 * least);
    return std::max(least, 4 * zero_tolerance(form_) * size_of(values_at(speed)) / std::abs(slope));
  }

  void keep(const End& low, const End& high, double speed) {
    const Kind kind = kind_of(form_, low.signature, high.signature);
    Complex root = kind == Kind::composite ? Complex(0) : place_of(kind, low, high);
    if (kind == Kind::axis_crossing) root = nearest(values_at(speed), root);
    if (kind != Kind::axis_crossing && kind != Kind::composite) root = middle(values_at(speed), root);
    found_.push_back(
        {speed, low.signature, high.signature, {root.real(), std::abs(root.imag())}, evaluations_});
    evaluations_ = 0;
  }

  const NormalForm& form_;
  const ChangeOptions& options_;
  std::vector<Change>& found_;
  double width_to_polish_ = 1e-2 * form_.reference_rad_per_s;
  int evaluations_ = 0;
};

/// Adds speeds on both sides of every speed at which K is singular, since a short divergence between two
/// given speeds would otherwise be missed.
void add_divergence(const NormalForm& form, std::vector<End>& ends) {
  if (ends.empty()) return;
  const double aside = 1e-6 * form.reference_rad_per_s, first = ends.front().speed, last = ends.back().speed;
  for (const double singular : divergence_speeds(form)) {
    for (const double speed : {singular - aside, singular + aside}) {
      if (speed > first && speed < last) ends.push_back({speed, signature(form, speed)});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.speed < b.speed; });
}

/// Removes opposite changes at one speed: a grid point where a neutral pair crosses zero has its own
/// signature.
void drop_moments(std::vector<Change>& changes) {
  for (std::size_t i = 0; i + 1 < changes.size();) {
    const Change &first = changes[i], &second = changes[i + 1];
    const double apart = second.speed_rad_per_s - first.speed_rad_per_s;
    if (apart < 1e-6 * (1 + first.speed_rad_per_s) && first.before == second.after) {
      changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(i),
                    changes.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    } else {
      ++i;
    }
  }
}

}  // namespace

std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 std::span<const Signature> signatures, const ChangeOptions& options) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < speeds_rad_per_s.size(); ++i)
    ends.push_back({speeds_rad_per_s[i], signatures[i]});
  add_divergence(form, ends);
  std::vector<Change> changes;
  Search search(form, options, changes);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) search.between(ends[i], ends[i + 1]);
  drop_moments(changes);
  return changes;
}

std::vector<Change> find_changes(const NormalForm& form, std::span<const double> speeds_rad_per_s,
                                 const ChangeOptions& options) {
  std::vector<Signature> signatures;
  for (const double speed : speeds_rad_per_s) signatures.push_back(signature(form, speed));
  return find_changes(form, speeds_rad_per_s, signatures, options);
}

}  // namespace rubsweep::ring
