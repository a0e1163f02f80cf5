#pragma once

#include <Eigen/Core>
#include <functional>
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
  std::vector<Tried> tried_;  ///< attempts by their order
};

/// One revolution: replaces a scaled section by the next and, where given (not null), every column of
/// `disturbances` by its image under the derivative of the new section by the old. False when the turn cannot
/// be made.
using TurnMap = std::function<bool(std::span<double> section, Eigen::MatrixXd* disturbances)>;

/// A motion that repeats after `order` turns, with every disturbance dying out.
struct StableOrbit {
  int order = 0;
  std::vector<Eigen::VectorXd> sections;     ///< scaled, where each of its turns starts
  std::vector<Eigen::MatrixXd> transitions;  ///< derivative of each section by the one before
  double floquet_modulus = 0;                ///< largest modulus of the multipliers over `order` turns, < 1
};

/// All multipliers must lie inside this.
inline constexpr double largest_floquet_modulus = 1 - 1e-6;

/// An orbit is not looked for farther from the transient than this, in (clearance, clearance omega).
inline constexpr double farthest_orbit = 0.2;

/// A transient of a run at ordinary tolerances that is this near is on the orbit: what it does next is noise.
inline constexpr double on_the_orbit = 1e-6;

/// Newton's iteration on the section, from a transient now at `section`, for an orbit of `order` turns whose
/// multipliers all lie inside `largest_floquet_modulus`. Empty where it finds none, and at once where the
/// monodromy at the transient (above 1.2) or at an iterate (above 1) has a multiplier that no stable orbit is
/// expected near. An orbit that returns after fewer turns is reported with those. That the transient is on
/// its way to the orbit is another question, see `comes_near`.
std::optional<StableOrbit> find_orbit(const TurnMap& turn, std::span<const double> section, int order);
/// The same with first steps by `roughly`, the same turn with derivatives to about 1e-6.
std::optional<StableOrbit> find_orbit(const TurnMap& turn, const TurnMap& roughly,
                                      std::span<const double> section, int order);

/// Derivative of `turn` at `section` by central differences of `step`, where the solver offers none.
bool differentiate(const std::function<bool(std::span<double>)>& turn, std::span<double> section, double step,
                   Eigen::MatrixXd& transition);

}  // namespace rubsweep::response::proof
