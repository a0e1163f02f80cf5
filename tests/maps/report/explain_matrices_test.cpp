#include "rubsweep/maps/report/explain_matrices.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/structure/hand_matrices.hpp"

namespace rubsweep::report {
namespace {

std::string explained(const model::ShaftMatrices& matrices) {
  model::RotorKit kit;
  kit.matrices = std::make_shared<model::ShaftMatrices>(matrices);
  return explain_matrices(kit);
}

TEST(ExplainMatrices, SaysWhatIsSymmetricAndWhatIsNot) {
  EXPECT_EQ(explained(structure::disc_and_bracket()),
            "rotor: matrices of 4 degrees of freedom at 1 nodes along 0.5 m and 1 bodies, 2 kg; 0 supports "
            "beside them\n"
            "  stiffness: not symmetric, most between y of node disc and x of node disc, by 7000; such a "
            "rotor can whirl "
            "up by itself\n"
            "  damping: symmetric\n"
            "  gyroscopic: none\n");
  model::ShaftMatrices book = structure::book_rotor();
  book.stiffness(0, 4) *= 1 + 1e-13;
  const std::string text = explained(book);
  EXPECT_NE(
      text.find("  stiffness: symmetric\n  damping: none\n  gyroscopic: skew-symmetric, times the speed\n"),
      std::string::npos)
      << text;
  book.mass.setZero();
  EXPECT_NE(explained(book).find("but for 28 degrees of freedom without any"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::report
