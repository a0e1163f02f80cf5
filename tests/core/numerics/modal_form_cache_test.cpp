#include "rubsweep/core/numerics/modal_form_cache.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/numerics/modal_form.hpp"

namespace rubsweep::numerics {
namespace {

/// Damping of a gyroscopic rotor, whose eigenvectors must be computed.
Eigen::Matrix2d damping(double speed) {
  Eigen::Matrix2d damping;
  damping << 0.1, speed, -speed, 0.1;
  return damping;
}

const Eigen::Matrix2d stiffness = Eigen::Vector2d(1, 4).asDiagonal();

void expect_form_of(const std::optional<ModalForm>& form, double speed) {
  const auto expected = modal_form(stiffness, damping(speed));
  ASSERT_TRUE(form && expected);
  EXPECT_EQ(form->basis, expected->basis);
  EXPECT_EQ(form->inverse, expected->inverse);
  EXPECT_EQ(form->growth, expected->growth);
}

TEST(ModalFormCache, AnswersAsModalForm) {
  ModalFormCache cache;
  for (const double speed : {1.0, 2.0, 1.0, 3.0, 2.0}) {
    expect_form_of(cache.form_of(stiffness, damping(speed)), speed);
  }
  EXPECT_EQ(cache.size(), 3u);
}

TEST(ModalFormCache, TellsSystemsOfDifferentSizeApart) {
  ModalFormCache cache;
  expect_form_of(cache.form_of(stiffness, damping(1)), 1);
  const auto& larger = cache.form_of(Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  ASSERT_TRUE(larger);
  EXPECT_EQ(larger->basis.rows(), 6);
}

TEST(ModalFormCache, DropsWhatWasNotUsedForLongest) {
  ModalFormCache cache(1);
  for (const double speed : {1.0, 2.0, 1.0}) {
    expect_form_of(cache.form_of(stiffness, damping(speed)), speed);
    EXPECT_EQ(cache.size(), 1u);
  }
}

}  // namespace
}  // namespace rubsweep::numerics
