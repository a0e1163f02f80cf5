#include "rubsweep/core/integrate/exact/tangent_vectors.hpp"

#include <algorithm>
#include <utility>

#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// Smallest number of vectors that are stored side by side. Fewer vectors do not fill a register; products
/// with full matrices then compute several rows at once.
constexpr std::size_t fewest_side_by_side = 4;

}  // namespace

template <int N>
void TangentVectors<N>::clear() {
  std::visit([](auto& vectors) { vectors.clear(); }, vectors_);
}

template <int N>
void TangentVectors<N>::begin(const modes::LinearMode<N>& mode, const run::StateScale& scale,
                              const Eigen::MatrixXd& vectors) {
  lag_s_ = 0;
  const auto count = static_cast<std::size_t>(vectors.cols());
  const bool side_by_side = count >= fewest_side_by_side;
  if (count > 0 && side_by_side != std::holds_alternative<TangentsSideBySide<N>>(vectors_)) {
    if (side_by_side)
      vectors_.template emplace<TangentsSideBySide<N>>();
    else
      vectors_.template emplace<TangentsOneByOne<N>>();
  }
  std::visit(
      [&](auto& list) {
        list.resize(vectors.rows(), count);
        for (std::size_t i = 0; i < count; ++i) {
          State physical = vectors.col(static_cast<Eigen::Index>(i));
          scale.to_seconds(physical);
          list.set(i, mode.to_free(physical));
        }
      },
      vectors_);
}

template <int N>
void TangentVectors<N>::change(const modes::LinearMode<N>& from, const modes::LinearMode<N>& to) {
  catch_up(from);
  std::visit([&](auto& list) { list.change(from, to); }, vectors_);
}

template <int N>
void TangentVectors<N>::change(const modes::LinearMode<N>& from,
                               const typename modes::ExactTypes<N>::Factor& by) {
  catch_up(from);
  std::visit([&](auto& list) { list.move(by); }, vectors_);
}

template <int N>
void TangentVectors<N>::add(const modes::LinearMode<N>& mode, const State& physical) {
  catch_up(mode);
  std::visit(
      [&](auto& list) {
        list.resize(physical.size(), list.size() + 1);
        list.set(list.size() - 1, mode.to_free(physical));
      },
      vectors_);
}

template <int N>
std::vector<typename modes::ExactTypes<N>::State> TangentVectors<N>::now(const modes::LinearMode<N>& mode) {
  catch_up(mode);
  std::vector<State> all;
  std::visit(
      [&](const auto& list) {
        for (std::size_t i = 0; i < list.size(); ++i) all.push_back(list.get(i));
      },
      vectors_);
  return all;
}

template <int N>
void TangentVectors<N>::put(const modes::LinearMode<N>& mode, const run::StateScale& scale,
                            Eigen::MatrixXd& vectors) {
  catch_up(mode);
  std::visit(
      [&](const auto& list) {
        for (std::size_t i = 0; i < std::min(list.size(), static_cast<std::size_t>(vectors.cols())); ++i) {
          State physical = mode.from_free(list.get(i));
          scale.from_seconds(physical);
          vectors.col(static_cast<Eigen::Index>(i)) = physical;
        }
      },
      vectors_);
}

template <int N>
void TangentVectors<N>::put_sums(const modes::LinearMode<N>& mode, const modes::ModalTerms& terms,
                                 double unit, modes::ModalSums& sums) {
  catch_up(mode);
  std::visit([&](const auto& list) { list.see(terms, mode.paired, unit, sums); }, vectors_);
}

template <int N>
void TangentVectors<N>::catch_up(const modes::LinearMode<N>& mode) {
  const double duration_s = std::exchange(lag_s_, 0);
  if (duration_s == 0) return;
  std::visit(
      [&](auto& list) {
        if (list.size() == 0) return;
        if (mode.paired) {
          const int k = modes::table_step_of(mode, duration_s);
          return k < numerics::exact_step_count ? list.move(mode.pair_steps[static_cast<std::size_t>(k)])
                                                : list.move(modes::flow_of_pairs(mode, duration_s));
        }
        const double rest_s = modes::table_steps(mode, mode.fastest_rad_per_s, duration_s,
                                                 [&](int k) { list.move(mode.steps.of(k)); });
        if (rest_s != 0) list.move_by_series(mode, rest_s);  // the state moves by a table step
      },
      vectors_);
}

template class TangentVectors<2>;
template class TangentVectors<4>;
template class TangentVectors<6>;
template class TangentVectors<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
