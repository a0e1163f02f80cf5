#include "rubsweep/core/integrate/taylor/tangent_expansion.hpp"

namespace rubsweep::integrate::taylor {

template <int N>
bool TangentExpansion<N>::pass(Expansion<N>& motion, double duration_rad, double accuracy) {
  if (count() == 0) return true;
  if (motion.any_creeps()) return pass_creeping(motion, duration_rad, accuracy);
  Eigen::Index i = 0;
  for (; i + tangents_together <= count(); i += tangents_together)
    together_.pass(motion, duration_rad, accuracy, tangents_, i);
  for (; i < count(); ++i) alone_.pass(motion, duration_rad, accuracy, tangents_, i);
  return true;
}

template <int N>
bool TangentExpansion<N>::pass_creeping(Expansion<N>& motion, double duration_rad, double accuracy) {
  before_ = tangents_;
  for (Eigen::Index i = 0; i < count(); ++i) {
    if (alone_.pass_creeping(motion, duration_rad, accuracy, tangents_, i)) continue;
    tangents_ = before_;
    return false;
  }
  return true;
}

template class TangentExpansion<2>;
template class TangentExpansion<4>;
template class TangentExpansion<6>;
template class TangentExpansion<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::taylor
