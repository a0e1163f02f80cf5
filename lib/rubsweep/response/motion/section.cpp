#include "rubsweep/response/motion/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rubsweep/error.hpp"

namespace rubsweep::response::motion {
namespace {

// Largest return error after `lag` numbers; empty as soon as one is beyond the tolerance or not a number.
std::optional<double> return_error(std::span<const double> rows, std::size_t lag) {
  double largest = 0;
  for (std::size_t i = 0; i + lag < rows.size(); ++i) {
    const double error = std::abs(rows[i + lag] - rows[i]);
    if (!(error <= section_tolerance)) return std::nullopt;
    largest = std::max(largest, error);
  }
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
