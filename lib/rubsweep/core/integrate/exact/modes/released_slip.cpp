#include "rubsweep/core/integrate/exact/modes/released_slip.hpp"

#include <cmath>

namespace rubsweep::integrate::exact::modes {

std::optional<ReleasedSlip> released_slip(const CommonToModes& common,
                                          const std::vector<contact::Mode>& modes, std::size_t i,
                                          double longest_step_s) {
  const auto& [system, friction, form] = common;
  if (!form) return std::nullopt;
  const Eigen::Index n = system.coordinates();
  const Eigen::RowVectorXd& slides = system.contacts[i].second_row;
  const Eigen::RowVectorXd by_time = numerics::rate_of_row(*form, slides * form->basis.bottomRows(n));
  ReleasedSlip slip{numerics::bound_of_row(*form, by_time, longest_step_s), {}, {}};
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const auto& other = system.contacts[k];
    const bool open = modes[k] == contact::Mode::open;
    const double force = open ? 0 : std::abs(friction[k].coefficient) * other.stiffness;
    const Eigen::VectorXd moved = form->inverse.rightCols(n) * other.second_push;
    double swing = 0;
    for (Eigen::Index j = 0; j < n; ++j)
      swing += slip.sliding_rate_bound(j) * std::hypot(moved(j), moved(n + j));
    slip.friction_rate.push_back(force * std::abs(slides * other.second_push));
    slip.friction_swing.push_back(force * swing);
  }
  return slip;
}

}  // namespace rubsweep::integrate::exact::modes
