#include "rubsweep/core/integrate/exact/tangents_side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "rubsweep/core/numerics/exponential_series.hpp"
#include "rubsweep/core/numerics/lanes.hpp"

namespace rubsweep::integrate::exact {

using numerics::AlignedMatrix;
using numerics::SideBySide;

namespace {

/// ModalSum for a lane of states from `z` on; contributions of z_u and of z_v are summed separately.
template <std::size_t bytes>
struct LaneSum {
  using Lane = typename numerics::Lanes<bytes>::Type;
  // NOLINTNEXTLINE(modernize-use-using): an attribute that depends on a parameter
  typedef long long Bits __attribute__((vector_size(bytes)));

  // Empty sum: -0, so that even the sign of a zero is preserved.
  Lane value_u = -Lane{}, value_v = -Lane{}, rate_u = -Lane{}, rate_v = -Lane{}, bound_u = -Lane{},
       bound_v = -Lane{};

  [[gnu::always_inline]] void add(const modes::ModalTerm& term, const double* z, std::ptrdiff_t stride,
                                  bool paired) {
    Lane u, v;
    std::memcpy(&u, z + term.u * stride, bytes);
    std::memcpy(&v, z + term.v * stride, bytes);
    value_u += term.value[0] * u;
    value_v += term.value[1] * v;
    rate_u += term.rate[0] * u;
    rate_v += term.rate[1] * v;
    const Bits all_but_sign = ~__builtin_bit_cast(Bits, -Lane{});
    Lane size_u = __builtin_bit_cast(Lane, __builtin_bit_cast(Bits, u) & all_but_sign);
    Lane size_v = __builtin_bit_cast(Lane, __builtin_bit_cast(Bits, v) & all_but_sign);
    if (paired) {  // pair_size
      const Lane larger = size_u < size_v ? size_v : size_u, smaller = size_v < size_u ? size_v : size_u;
      size_u = size_v = larger + 0.5 * smaller;
    }
    bound_u += term.bound[0] * size_u;
    bound_v += term.bound[1] * size_v;
  }
};

template <class Factor>
Eigen::Index stride_of(const Factor& matrix) {
  if constexpr (requires { matrix.stride(); }) {
    return matrix.stride();
  } else {
    return matrix.outerStride();
  }
}

}  // namespace

template <int N>
void TangentsSideBySide<N>::resize(Eigen::Index numbers, std::size_t count) {
  count_ = count;
  const auto rows = static_cast<Eigen::Index>(count);
  const bool as_long = numbers == list_.cols();
  if (count == 0 || (rows <= list_.rows() && as_long)) return;
  const Eigen::Index capacity = as_long ? std::max(rows, 2 * list_.rows()) : rows;
  AlignedMatrix larger(capacity, numbers);
  if (as_long) {
    for (Eigen::Index j = 0; j < numbers; ++j)
      std::copy_n(list_.data() + j * list_.stride(), list_.rows(), larger.data() + j * larger.stride());
  }
  list_ = std::move(larger);
  moved_ = AlignedMatrix(capacity, numbers);
  forces_ = AlignedMatrix(capacity, numbers);
}

template <int N>
SideBySide TangentsSideBySide<N>::view(AlignedMatrix& of) const {
  return {of.data(), of.stride(), static_cast<std::ptrdiff_t>(count_)};
}

template <int N>
void TangentsSideBySide<N>::set(std::size_t i, const State& z) {
  for (Eigen::Index j = 0; j < z.size(); ++j)
    list_.data()[j * list_.stride() + static_cast<Eigen::Index>(i)] = z(j);
}

template <int N>
typename TangentsSideBySide<N>::State TangentsSideBySide<N>::get(std::size_t i) const {
  State z(list_.cols());
  for (Eigen::Index j = 0; j < z.size(); ++j)
    z(j) = list_.data()[j * list_.stride() + static_cast<Eigen::Index>(i)];
  return z;
}

template <int N>
void TangentsSideBySide<N>::move(const typename Types::Pairs& flow) {
  numerics::move_pairs_of_each(flow.rows(), flow.data(), view(list_));
}

template <int N>
void TangentsSideBySide<N>::move(const typename Types::Factor& flow) {
  numerics::multiply_each(flow.rows(), flow.cols(), flow.data(), stride_of(flow), view(list_), view(moved_));
  std::swap(list_, moved_);
}

/// The same series as for one state with full matrices.
template <int N>
void TangentsSideBySide<N>::move_by_series(const Linear& mode, double duration_s) {
  const Eigen::Index n = mode.rest.size();
  const int terms = numerics::series_terms(std::abs(duration_s) * mode.fastest_rad_per_s);
  std::copy_n(list_.data(), list_.cols() * list_.stride(), moved_.data());
  const SideBySide u = view(moved_), v = u.from(n), spring = view(forces_), damper = spring.from(n);
  for (int k = 1; k <= terms; ++k) {
    numerics::multiply_each(n, n, mode.stiffness.data(), mode.stiffness.outerStride(), u, spring);
    numerics::multiply_each(n, n, mode.damping.data(), mode.damping.outerStride(), v, damper);
    numerics::add_term_to_each(n, duration_s * numerics::reciprocals[static_cast<std::size_t>(k)], spring,
                               damper, u, v, view(list_));
  }
}

template <int N>
void TangentsSideBySide<N>::change_by(const typename Types::Factor& matrix, bool diagonal) {
  if (!diagonal) return move(matrix);
  numerics::scale_each(matrix.rows(), matrix.data(), stride_of(matrix) + 1, view(list_));
}

template <int N>
void TangentsSideBySide<N>::change(const Linear& from, const Linear& to) {
  change_by(from.basis, from.diagonal_basis);
  change_by(to.inverse, to.diagonal_basis);
}

template <int N>
void TangentsSideBySide<N>::see(const modes::ModalTerms& terms, bool paired, double unit,
                                modes::ModalSums& sums) const {
  sums.resize(count_);
  const std::ptrdiff_t lanes = SideBySide::lanes(static_cast<std::ptrdiff_t>(count_));
  numerics::in_widest_lanes(
      lanes, [&]<std::size_t bytes>() __attribute__((always_inline)) {
        constexpr std::size_t width = bytes / sizeof(double);
        for (std::size_t i = 0; i < count_; i += width) {
          LaneSum<bytes> sum;
          for (const modes::ModalTerm& term : terms.list)
            sum.add(term, list_.data() + i, list_.stride(), paired);
          const std::size_t some = std::min(width, count_ - i) * sizeof(double);
          const auto value = unit * (sum.value_u + sum.value_v), rate = unit * (sum.rate_u + sum.rate_v),
                     curvature = unit * (sum.bound_u + sum.bound_v);
          std::memcpy(&sums.value[i], &value, some);
          std::memcpy(&sums.rate[i], &rate, some);
          std::memcpy(&sums.curvature[i], &curvature, some);
        }
      });
}

template class TangentsSideBySide<2>;
template class TangentsSideBySide<4>;
template class TangentsSideBySide<6>;
template class TangentsSideBySide<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
