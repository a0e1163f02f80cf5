#pragma once

#include <array>

#include "rubsweep/core/integrate/taylor/regular_contact.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Derivatives of the force of a RegularContact in its two fixed directions, as power series along an
/// expanded motion. A small change w of the relative displacement changes the force by by[0] w1 + by[1] w1' +
/// by[2] w2 + by[3] w2'; a change of the impact's damping c by `by_damping` times that change. The force is
/// N(p, p') n + T(p, s) t with N = S (1 + c p'), T = mu(s) S, and the sliding speed s = t . d'.
struct RegularSlopes {
  using Twin = numerics::Twin;
  using PlaneSeries = numerics::PlaneSeries;

  std::array<PlaneSeries, 4> by;
  PlaneSeries by_damping;
  bool only_first = false;  ///< true: by[2] and by[3] are zero

  /// Makes `order` coefficients along the present expansion of `contact`.
  void make(RegularContact& contact, int order) {
    using numerics::both;
    using numerics::product_term;
    const bool annular = contact.law().annular, varies = contact.friction_varies(),
               presses = contact.mode() == contact::Mode::sprung;
    const double damping = presses ? contact.impact_damping() : 0;
    only_first = !annular && !varies;
    if (annular) contact.make_sliding(order);
    for (int k = 0; k < order; ++k) {
      elastic_.set(k, contact.elastic_term(k));  // S' and S
      closing_.set(k, contact.closing_term(k));
      const Twin moved = damping > 0 ? product_term(closing_, elastic_, k) : Twin{};
      const Twin pushes =
          presses ? elastic_[k] + both(damping) * moved : Twin{};      // derivative by p of N, and N
      Twin rubs = both(contact.constant_coefficient()) * elastic_[k];  // the same of T
      double by_sliding = 0;
      if (varies) {
        rubs = product_term(contact.coefficient(), elastic_, k);
        friction_slope_.set(k, contact.friction_slope_term(k));
        by_sliding = product_term(friction_slope_, elastic_, k)[1];
      }
      const double damper = damping * elastic_[k][1];
      if (!annular) {
        by[0].set(k, Twin{pushes[0], rubs[0]});
        by[1].set(k, Twin{damper, 0});
        by[2].set(k, Twin{});
        by[3].set(k, Twin{0, by_sliding});
        by_damping.set(k, Twin{moved[1], 0});
        continue;
      }
      by_closing_.set(k, moved[1]);
      by_damping.set(k, product_term(by_closing_, contact.normal(), k));
      // When the normal turns by t . w / r, so do both forces and the directions of p' and s.
      dampers_.set(k, Twin{damper, by_sliding});
      speeds_.set(k, Twin{contact.sliding()[k], closing_.number(k)});
      const Twin turned = product_term(dampers_, speeds_, k);
      across_.set(k, Twin{turned[0] - rubs[1], pushes[1] - turned[1]});
      const Twin rest = k == 0 ? both(1) : -numerics::sum_of_products(contact.length(), inverse_, k, 1, k);
      inverse_.set(k, rest * both(contact.inverse_length()));
      const Twin across = product_term(inverse_, across_, k);
      turn(contact.normal(), k, Twin{pushes[0], rubs[0]}, across);
    }
  }

 private:
  /// Coefficient k of the product of two plane vectors, taken as complex numbers.
  static Twin complex_product(const PlaneSeries& a, const PlaneSeries& b, int k) {
    Twin sum{};
    for (int j = 0; j <= k; ++j)
      sum += numerics::first_twice(a[j]) * b[k - j] +
             numerics::second_twice(a[j]) * numerics::quarter_turned(b[k - j]);
    return sum;
  }

  /// Writes coefficient k of `by` from matrices in the directions n and t: the columns `along` and `across`
  /// by w, and diag(dampers_) by w'. As a complex number, M w = a w + b conj(w), and turning by n turns b
  /// twice.
  void turn(const PlaneSeries& normal, int k, Twin along, Twin across) {
    const Twin half = numerics::both(0.5), damper = half * dampers_[k];
    twice_.set(k, complex_product(normal, normal, k));
    stretch_.set(k, half * Twin{along[0] - across[1], along[1] + across[0]});
    damper_stretch_.set(k, numerics::both(damper[0] - damper[1]));
    const Twin same = half * Twin{along[0] + across[1], along[1] - across[0]},
               turned = complex_product(twice_, stretch_, k),
               rate = numerics::product_term(damper_stretch_, twice_, k);
    const Twin rate_same{damper[0] + damper[1], 0};
    by[0].set(k, same + turned);
    by[1].set(k, rate_same + rate);
    by[2].set(k, numerics::quarter_turned(same - turned));
    by[3].set(k, numerics::quarter_turned(rate_same - rate));
  }

  PlaneSeries elastic_, closing_, friction_slope_, dampers_, speeds_, inverse_, across_, twice_;
  PlaneSeries stretch_, damper_stretch_, by_closing_;
};

}  // namespace rubsweep::integrate::taylor
