#pragma once

#include <array>

#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

inline constexpr int most_creep_sweeps = 24;

/// Slip of a contact with friction so steep that the slip's own transient has decayed: the contact creeps at
/// the slip for which friction balances the other forces. The power series of the slip is found by
/// fixed-point sweeps. A sweep takes the slip as given, like the constraint of a sticking contact, and
/// computes the friction that maintains it. From this friction follows the slip for the next sweep. Each
/// sweep reduces the error by the ratio of the motion's rate to the rate at which friction changes the slip.
class Creep {
 public:
  /// Starts with a constant slip, its value at the start of the expansion.
  void begin(const ContactLaw& law, double slip_m_per_s);

  /// Finds the friction that keeps `contact` at its present slip, and sets the slip to the value at which the
  /// law gives this friction, up to `order`. False where no nearby slip has this friction.
  bool sweep(const ContactSeries& contact, int order);

  double slip_m_per_s() const { return slip_[0]; }
  /// Series of the sliding speed d' . t.
  const numerics::Series& sliding() const { return sliding_; }
  /// Change of coefficient k < order of the sliding speed by the latest sweep.
  double change(int k) const { return change_[static_cast<std::size_t>(k)]; }

  // Results of a sweep: spring force, friction over spring force, and its derivative by the sliding speed.
  const numerics::Series& load() const { return load_; }
  const numerics::Series& coefficient() const { return coefficient_; }
  const numerics::Series& slope() const { return slope_; }

 private:
  bool find_start(double coefficient);
  void set_slip(int k, double slip_m_per_s);

  const ContactLaw* law_ = nullptr;
  numerics::Series slip_, sliding_, load_, coefficient_, slope_;
  std::array<numerics::TanhSeries, 3> tanh_;
  std::array<double, numerics::most_taylor_order + 1> change_{};
};

}  // namespace rubsweep::integrate::taylor
