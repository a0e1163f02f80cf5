#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/numerics/matrix_vector.hpp"
#include "rubsweep/core/numerics/side_by_side.hpp"

namespace rubsweep::integrate::exact {

/// The same as TangentsOneByOne, with identical results, for many vectors: several of them are processed at
/// once.
template <int N>
class TangentsSideBySide {
 public:
  using Types = modes::ExactTypes<N>;
  using State = typename Types::State;
  using Linear = modes::LinearMode<N>;

  std::size_t size() const { return count_; }
  void clear() { count_ = 0; }
  void resize(Eigen::Index numbers, std::size_t count);
  void set(std::size_t i, const State& z);
  State get(std::size_t i) const;

  void move(const typename Types::Pairs& flow);
  void move(const typename Types::Factor& flow);
  void move_by_series(const Linear& mode, double duration_s);
  void change(const Linear& from, const Linear& to);
  void see(const modes::ModalTerms& terms, bool paired, double unit, modes::ModalSums& sums) const;

 private:
  numerics::SideBySide view(numerics::AlignedMatrix& of) const;
  void change_by(const typename Types::Factor& matrix, bool diagonal);

  std::size_t count_ = 0;
  numerics::AlignedMatrix list_;            ///< number j of vector i at (i, j)
  numerics::AlignedMatrix moved_, forces_;  ///< scratch matrices of the same size
};

}  // namespace rubsweep::integrate::exact
