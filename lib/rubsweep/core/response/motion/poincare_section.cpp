#include "rubsweep/core/response/motion/poincare_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/error.hpp"

namespace rubsweep::response::motion {
namespace {

// Largest return error at the distance `lag`; empty as soon as an error exceeds the tolerance or is NaN.
std::optional<double> return_error(std::span<const double> rows, std::size_t lag) {
  double largest = 0;
  for (std::size_t i = 0; i + lag < rows.size(); ++i) {
    const double error = std::abs(rows[i + lag] - rows[i]);
    if (!(error <= section_tolerance)) return std::nullopt;
    largest = std::max(largest, error);
  }
  return largest;
}

/// Limit to which the return error after a number of turns tends: apart (above zero), nothing (zero) or
/// undecided.
enum class ReturnLimit { apart, nothing, undecided };

/// Root mean square of the return error at the distance `lag` (in numbers) in three successive parts at the
/// end of the rows. Each part has the same number of whole periods of `period` numbers, so that variations
/// within a period do not affect the comparison. Zeros where not even one period fits.
std::array<double, 3> returns_by_thirds(std::span<const double> rows, std::size_t lag, std::size_t period) {
  std::array<double, 3> means{};
  const std::size_t third = (rows.size() - lag) / period / 3 * period;
  if (third == 0) return means;
  for (std::size_t part = 0; part < 3; ++part) {
    const auto kept = rows.last(lag + (3 - part) * third).first(lag + third);
    double square = 0;
    for (std::size_t i = 0; i < third; ++i) square += (kept[i + lag] - kept[i]) * (kept[i + lag] - kept[i]);
    means[part] = std::sqrt(square / static_cast<double>(third));
  }
  return means;
}

/// Limit of the returns if the decaying part shrinks by one factor per turn (Aitken's extrapolation).
ReturnLimit return_limit(std::span<const double> rows, std::size_t lag, std::size_t period) {
  constexpr double shrinks = 0.999;  ///< largest ratio of the last mean to the first mean that is a decay
  constexpr double enough = 0.95;    ///< largest such ratio if the limit may be zero
  constexpr double of_last = 0.5;    ///< a limit above this share of the last part is non-zero
  constexpr double nothing = 0.05;   ///< a limit below this share of the last part counts as zero
  const auto [first, middle, last] = returns_by_thirds(rows, lag, period);
  if (!(last < shrinks * first)) return ReturnLimit::apart;
  const double slowing = (first - middle) - (middle - last);
  const double limit = slowing > 0 ? last - (middle - last) * (middle - last) / slowing : 0;
  if (limit > of_last * last) return ReturnLimit::apart;
  if (last < enough * first && std::abs(limit) < nothing * last) return ReturnLimit::nothing;
  return ReturnLimit::undecided;
}

/// Largest return error at the distance `lag` over the last `lag` numbers.
double last_return_error(std::span<const double> rows, std::size_t lag) {
  double largest = 0;
  for (std::size_t i = rows.size() - lag; i < rows.size(); ++i)
    largest = std::max(largest, std::abs(rows[i] - rows[i - lag]));
  return largest;
}

}  // namespace

std::optional<SectionPeriod> period_of_section(std::span<const double> rows, int states, int max_order) {
  if (states < 1 || rows.empty() || rows.size() % static_cast<std::size_t>(states) != 0) {
    throw SolverError(fmt::format("a section of {} numbers has no rows of {} states", rows.size(), states));
  }
  const auto width = static_cast<std::size_t>(states);
  const int turns = static_cast<int>(rows.size() / width) - 1;
  const auto lag = [width](int order) { return static_cast<std::size_t>(order) * width; };

  for (int n = 1; n <= std::min(max_order, turns / 2); ++n) {
    const auto window = rows.last(lag(window_turns(turns, n) + 1));
    const std::optional<double> residual = return_error(window, lag(n));
    if (!residual) continue;
    for (int smaller = 1; smaller < n; ++smaller) {
      if (return_error(window, lag(smaller))) return std::nullopt;
    }
    for (int part = 1; part < n; ++part) {
      if (n % part != 0) continue;
      const ReturnLimit limit = return_limit(window, lag(part), lag(n));
      if (limit == ReturnLimit::undecided) return std::nullopt;
      if (limit == ReturnLimit::nothing)
        return SectionPeriod{.order = part, .residual = last_return_error(window, lag(part))};
    }
    return SectionPeriod{.order = n, .residual = *residual};
  }
  return std::nullopt;
}

bool SectionReturns::returned(const std::vector<double>& section) {
  sections_.push_back(section);
  if (sections_.size() <= order_) return false;
  double error = 0;
  for (std::size_t i = 0; i < section.size(); ++i)
    error = std::max(error, std::abs(section[i] - sections_.front()[i]));
  sections_.pop_front();
  return error <= section_tolerance;
}

}  // namespace rubsweep::response::motion
