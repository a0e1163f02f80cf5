#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::response::proof {

/// Watches the section of a transient for a period worth a proof, by a few comparisons per turn.
class PeriodSearch {
 public:
  /// `states` numbers per section, periods up to `largest_order` turns.
  PeriodSearch(std::size_t states, int largest_order);

  /// Adds the section after one more turn; `touched`: there was contact in this turn.
  void add(std::span<const double> section, bool touched);

  /// A number of turns after which the section has recently returned closer than after any smaller number,
  /// with contact in between. The return must also be closer than one period earlier. Usually empty.
  std::optional<int> candidate() const;

  /// Marks `order` as not proven. It is proposed again when the return is much closer, or much later.
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
  int newest_ = -1;  ///< slot of the latest section
  long turns_ = 0, last_touch_ = -1;
  std::vector<double> rows_;  ///< the last kept_ sections, as a circular buffer
  std::vector<Tried> tried_;  ///< attempts, by order
};

/// One revolution: replaces a scaled section by the next one. If `disturbances` is not null, each of its
/// columns becomes its image under the derivative of the new section by the old one. False when the turn
/// cannot be computed.
using TurnMap = std::function<bool(std::span<double> section, Eigen::MatrixXd* disturbances)>;

/// A motion that repeats after `order` turns and whose disturbances all die out.
struct StableOrbit {
  int order = 0;
  std::vector<Eigen::VectorXd> sections;     ///< scaled section at the start of each turn
  std::vector<Eigen::MatrixXd> transitions;  ///< derivative of each section by the one before
  double floquet_modulus = 0;                ///< largest modulus of the multipliers over `order` turns, < 1
};

/// Upper bound for the moduli of all multipliers of a stable orbit.
inline constexpr double largest_floquet_modulus = 1 - 1e-6;

/// Largest distance between an orbit that is sought and the transient, in (clearance, clearance omega).
inline constexpr double farthest_orbit = 0.2;

/// Distance at which a transient at ordinary tolerances counts as on the orbit, because smaller changes are
/// noise.
inline constexpr double on_the_orbit = 1e-6;

/// Newton's iteration on the section, from a transient now at `section`, for an orbit of `order` turns whose
/// multipliers all lie inside `largest_floquet_modulus`. Empty where it finds none. It stops at once where a
/// multiplier of the monodromy matrix is too large for a stable orbit nearby: above 1.2 at the transient,
/// above 1 at an iterate. An orbit that returns after fewer turns is reported with this smaller number.
/// Whether the transient converges to the orbit is tested separately, see `comes_near`.
/// `roughly`, unless null: the same turn with derivatives accurate to about 1e-6, for the first steps.
std::optional<StableOrbit> find_orbit(const TurnMap& turn, std::span<const double> section, int order,
                                      const TurnMap* roughly = nullptr);

/// Derivative of `turn` at `section` by central differences of width `step`, for solvers without derivatives.
bool differentiate(const std::function<bool(std::span<double>)>& turn, std::span<double> section, double step,
                   Eigen::MatrixXd& transition);

}  // namespace rubsweep::response::proof
