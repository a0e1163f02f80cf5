#include "rubsweep/integrate/exact/tangent_vectors.hpp"

#include <algorithm>
#include <utility>

#include "rubsweep/integrate/exact/mode_flow.hpp"

namespace rubsweep::integrate::exact {

template <int N>
void TangentVectors<N>::begin(const LinearMode<N>& mode, const run::StateScale& scale,
                              const Eigen::MatrixXd& vectors) {
  lag_s_ = 0;
  count_ = static_cast<std::size_t>(vectors.cols());
  if (list_.size() < count_) list_.resize(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    State physical = vectors.col(static_cast<Eigen::Index>(i));
    scale.to_seconds(physical);
    list_[i] = mode.to_free(physical);
  }
}

template <int N>
void TangentVectors<N>::change(const LinearMode<N>& from, const LinearMode<N>& to) {
  catch_up(from);
  for (std::size_t i = 0; i < count_; ++i) {
    from.put_from_free(list_[i], moved_);
    to.put_to_free(moved_, list_[i]);
  }
}

template <int N>
void TangentVectors<N>::add(const LinearMode<N>& mode, const State& physical) {
  catch_up(mode);
  if (list_.size() == count_) list_.emplace_back();
  list_[count_++] = mode.to_free(physical);
}

template <int N>
void TangentVectors<N>::put(const LinearMode<N>& mode, const run::StateScale& scale,
                            Eigen::MatrixXd& vectors) {
  catch_up(mode);
  for (std::size_t i = 0; i < std::min(count_, static_cast<std::size_t>(vectors.cols())); ++i) {
    State physical = mode.from_free(list_[i]);
    scale.from_seconds(physical);
    vectors.col(static_cast<Eigen::Index>(i)) = physical;
  }
}

template <int N>
void TangentVectors<N>::catch_up(const LinearMode<N>& mode) {
  const double duration_s = std::exchange(lag_s_, 0);
  if (count_ == 0 || duration_s == 0) return;
  if (mode.paired) {
    const auto move = [&](const typename ExactTypes<N>::Pairs& flow) {
      for (std::size_t i = 0; i < count_; ++i) move_pairs(flow, list_[i]);
    };
    const int k = table_step_of(mode, duration_s);
    return k < numerics::exact_step_count ? move(mode.pair_steps[static_cast<std::size_t>(k)])
                                          : move(flow_of_pairs(mode, duration_s));
  }
  const double rest_s = table_steps(mode, mode.fastest_rad_per_s, duration_s, [&](int k) {
    for (std::size_t i = 0; i < count_; ++i) {
      numerics::put_product(mode.steps[static_cast<std::size_t>(k)], list_[i], moved_);
      list_[i] = moved_;
    }
  });
  if (rest_s == 0) return;  // a step of the table
  for (std::size_t i = 0; i < count_; ++i) move_by_series(mode, rest_s, list_[i]);
}

template class TangentVectors<2>;
template class TangentVectors<4>;
template class TangentVectors<6>;
template class TangentVectors<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
