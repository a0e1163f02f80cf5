#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using State = ExactTypes<4>::State;

State some_vibration() {
  State z;
  z << 0.3, -0.2, 0.01, 0.04, -0.5, 0.1, 0.02, -0.03;
  return z;
}

/// Tests in each of the four modes of one stop: three consist of pairs, `released` uses full matrices.
class ModeFlowEvery : public testing::TestWithParam<std::size_t> {
 protected:
  MachineModes<4> plan_{test::cell_of({}).scene};
  const LinearMode<4>& mode_ = *plan_.mode(GetParam());

  /// Moves a state in physical coordinates by the matrix exponential of the generator.
  State moved(const State& z, double duration_s) const {
    return mode_.inverse * (numerics::matrix_flow(mode_.generator, duration_s) * (mode_.basis * z));
  }
};

TEST_P(ModeFlowEvery, SeriesIsTheFlow) {
  for (const double size : {1e-5, 0.01, 0.1, 0.5, 1.0}) {
    const double duration_s = size * numerics::longest_series / mode_.fastest_rad_per_s;
    State z = some_vibration();
    move_by_series(mode_, duration_s, z);
    const State expected = moved(some_vibration(), duration_s);
    // The change of basis for the reference and back costs two digits.
    EXPECT_LT((z - expected).cwiseAbs().maxCoeff(), 5e-14 * expected.cwiseAbs().maxCoeff()) << size;
  }
}

TEST_P(ModeFlowEvery, PairsFlowAnyDistance) {
  EXPECT_EQ(mode_.paired, GetParam() != 3);
  if (!mode_.paired) return;
  for (const double duration_s : {1e-6, 3e-4, 0.02}) {
    State z = some_vibration();
    move_pairs(flow_of_pairs(mode_, duration_s), z);
    EXPECT_LT((z - moved(some_vibration(), duration_s)).cwiseAbs().maxCoeff(), 1e-12) << duration_s;
  }
}

TEST_P(ModeFlowEvery, TermsOfAGuardSumToItsValueAhead) {
  const double duration_s = 0.4 / mode_.fastest_rad_per_s;
  std::array<double, 18> terms{};
  for (const auto& guard : mode_.guards) {
    expand_guard(guard, some_vibration(), terms);
    numerics::scale_terms(duration_s * mode_.fastest_rad_per_s, terms);
    for (const double fraction : {0.0, 0.3, 1.0}) {
      double sum = 0;
      for (std::size_t k = terms.size(); k-- > 0;) sum = sum * fraction + terms[k];
      const State ahead = moved(some_vibration(), fraction * duration_s);
      EXPECT_NEAR(sum, guard.constant + guard.physical * mode_.basis * ahead, 1e-12) << fraction;
    }
  }
}

TEST_P(ModeFlowEvery, KnowsTheStepsOfItsTable) {
  for (int k = 0; k < numerics::exact_step_count; ++k) {
    const double duration_s = mode_.longest_step_s * numerics::exact_step_size(k);
    EXPECT_EQ(table_step_of(mode_, duration_s), k);
    for (const double other_s :
         {std::nextafter(duration_s, 0.0), std::nextafter(duration_s, 1.0), -duration_s})
      EXPECT_EQ(table_step_of(mode_, other_s), numerics::exact_step_count) << k;
  }
  EXPECT_EQ(table_step_of(mode_, 0), numerics::exact_step_count);
}

INSTANTIATE_TEST_SUITE_P(OfOneStop, ModeFlowEvery, testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
