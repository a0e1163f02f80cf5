#pragma once

#include <optional>
#include <span>
#include <vector>

namespace rubsweep::response::proof {

/// Watches the section of a transient for signs of a period worth a proof. Cheap: a few comparisons a turn.
class PeriodSearch {
 public:
  /// `states` numbers per section, periods up to `largest_order` turns.
  PeriodSearch(std::size_t states, int largest_order);

  /// Section after one more turn; `touched`: there was contact in it.
  void add(std::span<const double> section, bool touched);

  /// A number of turns after which the section lately came back closer than after any fewer and than the last
  /// time, with contact in between; empty most of the time.
  std::optional<int> candidate() const;

  /// `order` could not be proven: asks again when the return is much closer, or much later.
  void refuse(int order);

 private:
  double return_error(int order, double worst, int ago = 0) const;
  bool is_due(int order, double error) const;
  bool closest(int order, double error) const;
  bool contracts(int order, double error) const;
  const double* row(int ago) const;
  const double* before(const double* row) const;

  struct Tried {
    double below = 0;
    long again = 0;
  };

  std::size_t states_;
  int largest_, kept_;
  int newest_ = -1;  ///< slot of the last section
  long turns_ = 0, last_touch_ = -1;
  std::vector<double> rows_;  ///< the last kept_ sections, as a circular buffer
  std::vector<Tried> tried_;  ///< by order
};

}  // namespace rubsweep::response::proof
