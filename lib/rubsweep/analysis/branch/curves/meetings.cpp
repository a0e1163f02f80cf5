#include "rubsweep/analysis/branch/curves/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "rubsweep/analysis/branch/continuation/segment.hpp"
#include "rubsweep/analysis/branch/orbits/contact_sequence.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::curves {
namespace {

/// Largest number of changes of the contact sequence to be found between two neighbouring points of a curve.
constexpr std::size_t most_sequences = 16;

using Multipliers = Eigen::VectorXcd;
using Complex = std::complex<double>;

using Test = std::function<double(const CurvePoint&)>;
using Some = std::function<Multipliers(const CurvePoint&)>;

struct MeetingTest : continuation::EventTest<MeetingKind, CurvePoint> {
  MeetingTest(MeetingKind meeting, Test test, Some complex_pair = {}, bool differences = false)
      : continuation::EventTest<MeetingKind, CurvePoint>{meeting, std::move(test)},
        with_a_complex_pair(std::move(complex_pair)),
        of_differences(differences) {}

  /// Where set, a root counts only if the pair of these multipliers whose product is nearest to 1 is complex.
  Some with_a_complex_pair;
  /// Whether the test is computed by differences. Near a graze differences that cross it are wrong, so that
  /// smaller steps must confirm the root.
  bool of_differences;
};

/// Multipliers without the `count` ones nearest to `critical`.
Multipliers others(const Multipliers& all, Complex critical, Eigen::Index count = 1) {
  Multipliers rest = all;
  std::stable_sort(rest.begin(), rest.end(),
                   [&](Complex a, Complex b) { return std::abs(a - critical) > std::abs(b - critical); });
  return rest.head(std::max<Eigen::Index>(rest.size() - count, 0));
}

/// Multipliers without the pair on the unit circle.
Multipliers without_pair(const CurvePoint& point) {
  const double half = point.critical.pair_sum / 2;
  const Complex root = std::sqrt(Complex(half * half - 1, 0));
  const Multipliers without_one = others(point.multipliers, half + root);
  return others(without_one, half - root);
}

double turned(const Eigen::VectorXd& vector, const Eigen::VectorXd& reference) {
  return vector.dot(reference) < 0 ? -1 : 1;
}

std::vector<MeetingTest> tests_of_one_multiplier(double sign, const Critical& reference) {
  const Some rest = [sign](const CurvePoint& point) { return others(point.multipliers, sign); };
  const Test flip = [rest](const CurvePoint& point) { return orbits::doubling_test(rest(point)); };
  const Test fold = [rest](const CurvePoint& point) { return orbits::unit_test(rest(point)); };
  const Test torus = [rest](const CurvePoint& point) { return orbits::torus_test(rest(point)); };
  const Test cubic = [reference](const CurvePoint& point) {
    const Critical& c = point.critical;
    return c.cubic * turned(c.left, reference.left) * turned(c.right, reference.right);
  };
  if (sign < 0) {
    // The coefficient `cubic` has a pole where another multiplier is 1; the factor `fold` cancels it.
    const Test without_pole = [cubic, fold](const CurvePoint& point) { return cubic(point) * fold(point); };
    return {{MeetingKind::generalised_flip, without_pole, {}, true},
            {MeetingKind::fold_flip, fold},
            {MeetingKind::resonance_1_2, flip},
            {MeetingKind::flip_torus, torus, rest}};
  }
  return {{MeetingKind::fold_flip, flip},
          {MeetingKind::resonance_1_1, fold},
          {MeetingKind::fold_torus, torus, rest},
          {MeetingKind::degenerate_branching, cubic, {}, true}};
}

std::vector<MeetingTest> tests_of_a_fold(const Critical& reference) {
  auto tests = tests_of_one_multiplier(1, reference);
  tests.pop_back();
  tests.push_back({MeetingKind::cusp,
                   [reference](const CurvePoint& point) {
                     return point.critical.quadratic * turned(point.critical.left, reference.left);
                   },
                   {},
                   true});
  return tests;
}

std::vector<MeetingTest> tests_of_a_torus() {
  const auto sum_less = [](double sum) -> Test {
    return [sum](const CurvePoint& point) { return point.critical.pair_sum - sum; };
  };
  return {{MeetingKind::resonance_1_1, sum_less(2)},
          {MeetingKind::resonance_1_2, sum_less(-2)},
          {MeetingKind::resonance_1_3, sum_less(-1)},
          {MeetingKind::resonance_1_4, sum_less(0)},
          {MeetingKind::fold_torus,
           [](const CurvePoint& point) { return orbits::unit_test(without_pair(point)); }},
          {MeetingKind::flip_torus,
           [](const CurvePoint& point) { return orbits::doubling_test(without_pair(point)); }},
          {MeetingKind::double_torus,
           [](const CurvePoint& point) { return orbits::torus_test(without_pair(point)); }, without_pair}};
}

std::vector<MeetingTest> tests_of_a_graze(bool even) {
  std::vector<MeetingTest> tests{
      {MeetingKind::graze_fold, [](const CurvePoint& point) { return orbits::unit_test(point.multipliers); }},
      {MeetingKind::graze_flip,
       [](const CurvePoint& point) { return orbits::doubling_test(point.multipliers); }},
      {MeetingKind::graze_torus,
       [](const CurvePoint& point) { return orbits::torus_test(point.multipliers); },
       [](const CurvePoint& point) { return point.multipliers; }},
      {MeetingKind::degenerate_graze, [](const CurvePoint& point) { return point.critical.curvature; }}};
  // an even contact touches along the whole orbit, so that its guard cannot turn back
  if (even) tests.pop_back();
  return tests;
}

std::vector<MeetingTest> tests_of(const ExtendedSystem& system, const Critical& reference) {
  switch (system.kind) {
    case continuation::EventKind::fold: return tests_of_a_fold(reference);
    case continuation::EventKind::branch_point: return tests_of_one_multiplier(1, reference);
    case continuation::EventKind::period_doubling: return tests_of_one_multiplier(-1, reference);
    case continuation::EventKind::neimark_sacker: return tests_of_a_torus();
    case continuation::EventKind::graze: return tests_of_a_graze(system.even);
    case continuation::EventKind::period_halving:
    case continuation::EventKind::sequence:
    case continuation::EventKind::stability: break;  // no curve follows these
  }
  return {};
}

/// Kind of the meeting of a graze with a curve of `kind`.
MeetingKind graze_on(continuation::EventKind kind) {
  switch (kind) {
    case continuation::EventKind::graze: return MeetingKind::double_graze;
    case continuation::EventKind::period_doubling: return MeetingKind::graze_flip;
    case continuation::EventKind::neimark_sacker: return MeetingKind::graze_torus;
    case continuation::EventKind::fold:
    case continuation::EventKind::branch_point:
    case continuation::EventKind::period_halving:
    case continuation::EventKind::sequence:
    case continuation::EventKind::stability: break;
  }
  return MeetingKind::graze_fold;
}

class MeetingFinder {
 public:
  MeetingFinder(const ExtendedSystem& system, const CurvePoint& from, const CurvePoint& to)
      : system_(system), from_(from), to_(to), segment_(system, from, to) {}

  std::vector<Meeting> all() {
    if (!(segment_.length() > 0)) throw continuation::NotContinuous{};
    for (const MeetingTest& test : tests_of(system_, from_.critical)) find(test);
    if (system_.orbits->facts) find_grazes();
    std::ranges::stable_sort(meetings_, {}, [](const Meeting& meeting) { return meeting.point.arclength; });
    return std::move(meetings_);
  }

 private:
  void find(const MeetingTest& test) {
    const auto root = continuation::root_on(segment_, test.value);
    if (!root) return;
    CurvePoint point = segment_.required_at((root->low + root->high) / 2);
    if (test.with_a_complex_pair && !orbits::nearest_pair_is_complex(test.with_a_complex_pair(point))) return;
    if (test.of_differences &&
        !holds_by_finer_differences(test, point, std::abs(test.value(from_)) + std::abs(test.value(to_))))
      return;
    meetings_.push_back({test.kind, std::move(point), (root->high - root->low) / 2});
  }

  bool holds_by_finer_differences(const MeetingTest& test, CurvePoint point, double size) const {
    constexpr double finer = 0.3, still_zero = 0.1;
    const Extended again = extend(system_, point.at, finer);
    if (again.evaluation != orbits::Evaluation::ok) return false;
    point.critical = again.critical;
    return std::abs(test.value(point)) < still_zero * size;
  }

  /// Finds every change of the sequence of contact modes between both ends, one after the other.
  void find_grazes() {
    double begin = 0;
    CurvePoint here = from_;
    for (std::size_t i = 0; i < most_sequences && !orbits::same_contact(here.facts, to_.facts); ++i) {
      const orbits::OrbitFacts facts = here.facts;
      auto change = continuation::change_on(segment_, begin, std::move(here), [&](const CurvePoint& point) {
        return !orbits::same_contact(point.facts, facts);
      });
      begin = change.at.high;
      here = change.behind;
      meetings_.push_back(
          {graze_on(system_.kind), std::move(change.behind), (change.at.high - change.at.low) / 2});
    }
  }

  const ExtendedSystem& system_;
  const CurvePoint &from_, &to_;
  continuation::Segment<ExtendedSystem, CurvePoint> segment_;
  std::vector<Meeting> meetings_;
};

}  // namespace

std::optional<std::vector<Meeting>> meetings_between(const ExtendedSystem& system, const CurvePoint& from,
                                                     const CurvePoint& to) {
  try {
    return MeetingFinder(system, from, to).all();
  } catch (const continuation::NotContinuous&) {
    return std::nullopt;
  }
}

}  // namespace rubsweep::branch::curves
