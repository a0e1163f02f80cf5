#include "rubsweep/measurement/recording/turn_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

/// Largest step from mark to mark, in marks; all marks passed over in a step are surplus.
constexpr std::size_t most_ahead = 10;
/// Relative change of the interval, from one turn to the next, that costs 1; and the largest cost of any
/// change.
constexpr double usual_change = 0.08, most_of_a_change = 25;
constexpr double cost_of_a_mark = 10, cost_of_a_missing_turn = 8;
/// Cost of each unused mark before the first used one or after the last one. It exceeds the cost of a change
/// of interval, so that a shaft that starts to turn keeps its first marks.
constexpr double cost_at_an_end = 20;

/// A step from one used mark to the next, with the cost of all steps up to it.
struct Step {
  double cost = INFINITY;
  double turn_s = 0;       ///< duration of one turn
  int turns = 1;           ///< number of turns from mark to mark
  std::size_t before = 0;  ///< length of the step before, in marks; 0: this is the first step
};

/// Number of turns in an interval, and its cost, after turns of duration `turn_s`. The number exceeds one
/// only where it is unambiguous.
Step step_of(double interval_s, double turn_s, double resolution_s) {
  const auto change = [&](double turns) {
    const double logarithm = std::log(interval_s / (turns * turn_s)), rounding = resolution_s / turn_s;
    return std::min(logarithm * logarithm / (usual_change * usual_change + rounding * rounding),
                    most_of_a_change);
  };
  Step step{.cost = change(1), .turn_s = interval_s};
  const double turns = interval_s / turn_s, whole = std::round(turns);
  if (!(whole >= 2 && whole < 1e6 && std::abs(turns - whole) < 0.1)) return step;
  const double cost = change(whole) + cost_of_a_missing_turn * std::min(whole - 1, 2.0);
  if (cost < step.cost) step = {.cost = cost, .turn_s = interval_s / whole, .turns = static_cast<int>(whole)};
  return step;
}

double cost_of_passing(std::size_t marks, double each) { return each * static_cast<double>(marks); }

/// Steps that end at each mark, indexed by their length in marks minus one.
using Steps = std::vector<std::vector<Step>>;

/// Cheapest steps (dynamic programming): for each mark and length, the step with the best step before it.
Steps cheapest_steps(std::span<const double> marks_s, double resolution_s) {
  Steps steps(marks_s.size(), std::vector<Step>(most_ahead));
  for (std::size_t end = 1; end < marks_s.size(); ++end) {
    for (std::size_t length = 1; length <= std::min(most_ahead, end); ++length) {
      const std::size_t begin = end - length;
      const double interval_s = marks_s[end] - marks_s[begin];
      Step& best = steps[end][length - 1];
      // The first step, too, may contain turns without a mark.
      constexpr int most_at_first = 4;
      for (std::size_t before = 0; before <= std::min(most_ahead, begin); ++before) {
        for (int turns = 1; turns <= (before == 0 ? most_at_first : 1); ++turns) {
          Step step{.cost = cost_of_passing(begin, cost_at_an_end) + cost_of_a_missing_turn * (turns - 1),
                    .turn_s = interval_s / turns,
                    .turns = turns};
          if (before > 0) {
            const Step& last = steps[begin][before - 1];
            if (!(last.cost < best.cost)) continue;
            step = step_of(interval_s, last.turn_s, resolution_s);
            step.cost += last.cost;
            step.before = before;
          }
          step.cost += cost_of_passing(length - 1, cost_of_a_mark);
          if (step.cost < best.cost) best = step;
        }
      }
    }
  }
  return steps;
}

/// Used marks, with the numbers of their turns.
struct Chain {
  std::vector<double> t_s, turns;
};

Chain cheapest_chain(std::span<const double> marks_s, double resolution_s) {
  const Steps steps = cheapest_steps(marks_s, resolution_s);
  double cheapest = INFINITY;
  std::size_t end = 0, length = 0;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    for (std::size_t i = 0; i < most_ahead; ++i) {
      const double cost = steps[k][i].cost + cost_of_passing(steps.size() - 1 - k, cost_at_an_end);
      if (!(cost < cheapest)) continue;
      cheapest = cost;
      end = k;
      length = i + 1;
    }
  }
  Chain chain;
  for (double turn = 0; length > 0;) {
    const Step& step = steps[end][length - 1];
    chain.t_s.push_back(marks_s[end]);
    chain.turns.push_back(turn);
    turn -= step.turns;
    end -= length;
    length = step.before;
    if (length > 0) continue;
    chain.t_s.push_back(marks_s[end]);
    chain.turns.push_back(turn);
  }
  std::ranges::reverse(chain.t_s);
  std::ranges::reverse(chain.turns);
  return chain;
}

/// Polynomial through the marks next to mark i, at `place` in turns.
double between_marks(const Chain& chain, std::size_t i, double place) {
  const std::size_t size = chain.t_s.size();
  const std::size_t begin = std::min(i - std::min(i, std::size_t{2}), size - std::min<std::size_t>(size, 4));
  const std::size_t end = std::min(begin + 4, size);
  double sum = 0;
  for (std::size_t a = begin; a < end; ++a) {
    double weight = 1;
    for (std::size_t b = begin; b < end; ++b)
      if (b != a) weight *= (place - chain.turns[b]) / (chain.turns[a] - chain.turns[b]);
    sum += weight * chain.t_s[a];
  }
  return sum;
}

}  // namespace

double middle_threshold(std::span<const double> signal) {
  std::vector<double> sorted;
  std::ranges::copy_if(signal, std::back_inserter(sorted), [](double value) { return std::isfinite(value); });
  std::ranges::sort(sorted);
  const std::size_t outside = sorted.size() / 1000;
  if (sorted.empty() || !(sorted[outside] < sorted[sorted.size() - 1 - outside]))
    throw ConfigError("the keyphasor's signal does not change, allowed: one that a mark changes every turn");
  return (sorted[outside] + sorted[sorted.size() - 1 - outside]) / 2;
}

std::vector<double> mark_times_s(std::span<const double> t_s, std::span<const double> signal, Mark mark,
                                 double threshold, double hysteresis) {
  // Positive while the mark passes the probe.
  const auto height = [&](std::size_t k) {
    return mark == Mark::bright ? signal[k] - threshold : threshold - signal[k];
  };
  std::vector<double> marks_s;
  bool armed = false, gap = true;
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    const double now = height(k);
    if (!std::isfinite(now)) {
      gap = true;
      continue;
    }
    if (armed && now > 0) {
      armed = false;
      if (!gap) {
        const double before = height(k - 1);
        marks_s.push_back(t_s[k - 1] + (t_s[k] - t_s[k - 1]) * before / (before - now));
      }
    } else if (now <= 0 && now <= -hysteresis) {
      armed = true;
    }
    gap = false;
  }
  return marks_s;
}

TurnMarks numbered_marks(std::span<const double> marks_s, double resolution_s) {
  if (marks_s.size() < 3) return {.t_s = {marks_s.begin(), marks_s.end()}};
  const Chain chain = cheapest_chain(marks_s, resolution_s);
  TurnMarks numbered{.t_s = {}, .dropped = static_cast<int>(marks_s.size() - chain.t_s.size())};
  for (std::size_t i = 0; i < chain.t_s.size(); ++i) {
    for (double turn = i > 0 ? chain.turns[i - 1] + 1 : chain.turns[i]; turn < chain.turns[i]; ++turn) {
      numbered.t_s.push_back(between_marks(chain, i, turn));
      ++numbered.filled;
    }
    numbered.t_s.push_back(chain.t_s[i]);
  }
  return numbered;
}

}  // namespace rubsweep::recording
