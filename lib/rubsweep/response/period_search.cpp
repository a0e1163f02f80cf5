#include "rubsweep/response/period_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubsweep::response {
namespace {

constexpr double close_enough =
    1e-2;  ///< return error, in (clearance, clearance omega), from which a proof is tried
constexpr double much_closer = 0.1;  ///< than after any fewer turns, and than when last refused
constexpr double much_later = 1.3;   ///< turns, in proportion

}  // namespace

PeriodSearch::PeriodSearch(std::size_t states, int largest_order)
    : states_(states),
      largest_(largest_order),
      kept_(2 * largest_order + 1),
      rows_(states * static_cast<std::size_t>(kept_)),
      tried_(static_cast<std::size_t>(largest_order) + 1, Tried{close_enough, 0}) {}

std::span<const double> PeriodSearch::row(long turn) const {
  const auto slot = static_cast<std::size_t>(turn % kept_);
  return std::span(rows_).subspan(slot * states_, states_);
}

void PeriodSearch::add(std::span<const double> section, bool touched) {
  const auto slot = static_cast<std::size_t>(turns_ % kept_);
  std::copy(section.begin(), section.end(), rows_.begin() + static_cast<std::ptrdiff_t>(slot * states_));
  if (touched) last_touch_ = turns_;
  ++turns_;
}

/// Return error after `order` turns that end `ago` turns ago. Errors above `worst` are not told apart.
double PeriodSearch::return_error(int order, double worst, int ago) const {
  const auto now = row(turns_ - 1 - ago), then = row(turns_ - 1 - ago - order);
  double largest = 0;
  for (std::size_t i = 0; i < states_ && largest <= worst; ++i)
    largest = std::max(largest, std::abs(now[i] - then[i]));
  return largest;
}

std::optional<int> PeriodSearch::candidate() const {
  double least = std::numeric_limits<double>::infinity();
  const long known = std::min<long>(largest_, turns_ - 1);
  for (int n = 1; n <= known; ++n) {
    const double error = return_error(n, close_enough / much_closer);
    const Tried& tried = tried_[static_cast<std::size_t>(n)];
    const bool touched = last_touch_ >= turns_ - n;
    const bool due =
        error < tried.below || (tried.again > 0 && turns_ >= tried.again && error < close_enough);
    if (touched && due && error < much_closer * least && contracts(n, error)) return n;
    least = std::min(least, error);
  }
  return std::nullopt;
}

/// The return before this one was farther: a transient that passes an unstable orbit comes back less and less
/// close.
bool PeriodSearch::contracts(int order, double error) const {
  return turns_ > 2 * order && return_error(order, error, order) > error;
}

void PeriodSearch::refuse(int order) {
  Tried& tried = tried_[static_cast<std::size_t>(order)];
  tried.below = much_closer * return_error(order, std::numeric_limits<double>::infinity());
  tried.again = turns_ + std::max(8L, static_cast<long>((much_later - 1) * static_cast<double>(turns_)));
}

}  // namespace rubsweep::response
