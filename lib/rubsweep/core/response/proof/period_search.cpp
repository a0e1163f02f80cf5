#include "rubsweep/core/response/proof/period_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubsweep::response::proof {
namespace {

constexpr double close_enough =
    1e-2;  ///< return error, in (clearance, clearance omega), from which a proof is tried
constexpr double much_closer = 0.1;  ///< than after any fewer turns, and than when last refused
constexpr double much_later = 1.3;   ///< turns, in proportion

/// Largest difference of `count` numbers, or the first above `worst`.
double largest_difference(const double* a, const double* b, std::size_t count, double worst) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (difference > worst) return difference;
    largest = difference > largest ? difference : largest;
  }
  return largest;
}

}  // namespace

PeriodSearch::PeriodSearch(std::size_t states, int largest_order)
    : states_(states),
      largest_(largest_order),
      kept_(2 * largest_order + 1),
      rows_(states * static_cast<std::size_t>(kept_)),
      tried_(static_cast<std::size_t>(largest_order) + 1, Tried{close_enough, 0}) {}

/// Section `ago` < kept_ turns before the last.
const double* PeriodSearch::row(int ago) const {
  const int slot = newest_ >= ago ? newest_ - ago : newest_ - ago + kept_;
  return rows_.data() + static_cast<std::size_t>(slot) * states_;
}

const double* PeriodSearch::before(const double* row) const {
  return (row == rows_.data() ? rows_.data() + rows_.size() : row) - states_;
}

void PeriodSearch::add(std::span<const double> section, bool touched) {
  if (++newest_ == kept_) newest_ = 0;
  std::copy(section.begin(), section.end(),
            rows_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(newest_) * states_));
  if (touched) last_touch_ = turns_;
  ++turns_;
}

/// Return error after `order` turns that end `ago` turns ago. Errors above `worst` are not told apart.
double PeriodSearch::return_error(int order, double worst, int ago) const {
  return largest_difference(row(ago), row(ago + order), states_, worst);
}

std::optional<int> PeriodSearch::candidate() const {
  const int known = static_cast<int>(std::min<long>(largest_, turns_ - 1));
  if (last_touch_ < turns_ - known) return std::nullopt;  // no order is due
  const double* const last = row(0);
  const double* then = last;
  for (int n = 1; n <= known; ++n) {
    then = before(then);
    // Most orders are refused by one number.
    const double error = largest_difference(last, then, states_, close_enough);
    if (error < close_enough && is_due(n, error) && closest(n, error) && contracts(n, error)) return n;
  }
  return std::nullopt;
}

/// Much closer than after any fewer turns.
bool PeriodSearch::closest(int order, double error) const {
  for (int n = 1; n < order; ++n) {
    if (!(error < much_closer * return_error(n, error / much_closer))) return false;
  }
  return true;
}

/// With contact on the way, and closer than ever tried or not tried for long.
bool PeriodSearch::is_due(int order, double error) const {
  const Tried& tried = tried_[static_cast<std::size_t>(order)];
  return last_touch_ >= turns_ - order && (error < tried.below || (tried.again > 0 && turns_ >= tried.again));
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

}  // namespace rubsweep::response::proof
