#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"

namespace rubsweep::integrate::adaptive {

template class AdaptiveRun<law::Dynamics<4, false>>;
template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, false>>;
template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, true>>;

}  // namespace rubsweep::integrate::adaptive
