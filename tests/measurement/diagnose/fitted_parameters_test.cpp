#include "rubsweep/measurement/diagnose/fitted_parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose {
namespace {

class FittedParametersTest : public testing::Test {
 protected:
  void write(const char* name, const char* text) const { std::ofstream(directory_.path() / name) << text; }

  TemporaryDirectory directory_;
};

constexpr const char* table =
    "# rubfit\nparameter,value,standard_error,low_95,high_95,start,at_bound\n"
    "rotor.supports.0.stiffness_x_n_per_m,3e4,500,2.9e4,3.1e4,2e4,0\n"
    "eccentricity_m,2e-5,1e-6,1.8e-5,2.2e-5,1e-5,0\n";

TEST_F(FittedParametersTest, AreReadWithTheirIntervals) {
  EXPECT_FALSE(read_fitted_parameters(directory_.path()));
  write("parameters.csv", table);
  const auto fitted = read_fitted_parameters(directory_.path());
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->value(0), 3e4);
  EXPECT_EQ(interval_of(*fitted, "eccentricity_m")->high, 2.2e-5);
  EXPECT_FALSE(interval_of(*fitted, "mark_deg"));
  EXPECT_TRUE((fitted->error_root * fitted->error_root.transpose()).isIdentity(1e-15));
}

TEST_F(FittedParametersTest, AreDrawnAsTheirErrorsAreCorrelated) {
  write("parameters.csv", table);
  write("correlation.csv",
        "parameter,rotor.supports.0.stiffness_x_n_per_m,eccentricity_m\n"
        "rotor.supports.0.stiffness_x_n_per_m,1,-0.9\neccentricity_m,-0.9,1\n");
  const auto fitted = read_fitted_parameters(directory_.path());
  RandomStream random(7, 0, 0);
  constexpr int draws = 20'000;
  double inside = 0, product = 0;
  for (int k = 0; k < draws; ++k) {
    const Eigen::VectorXd value = draw_parameters(*fitted, random);
    inside += value(0) >= 2.9e4 && value(0) <= 3.1e4 ? 1.0 / draws : 0;
    product += (value(0) - 3e4) / (1e3 / 1.96) * (value(1) - 2e-5) / (2e-6 / 1.96) / draws;
  }
  EXPECT_NEAR(inside, 0.95, 0.006);
  EXPECT_NEAR(product, -0.9, 0.02);
}

TEST_F(FittedParametersTest, ThatNoFitFindsAreRefused) {
  const std::string header = "parameter,value,standard_error,low_95,high_95,start,at_bound\n";
  const auto problem = [&](const std::string& rows) {
    write("parameters.csv", (header + rows).c_str());
    return message_of<IoError>([&] { read_fitted_parameters(directory_.path()); });
  };
  const auto expect = [&](const std::string& rows, std::string_view text) {
    EXPECT_NE(problem(rows).find(text), std::string::npos) << problem(rows);
  };
  expect(
      "rotor.damping_ratio,0.0385,1e-4,0.9,0.0387,0.02,0\n",
      "parameters.csv:2: rotor.damping_ratio: value: is 0.0385, allowed: from low_95 0.9 to high_95 0.0387");
  expect("a,1,,1,2,1,0\nrotor.damping_ratio,-5,1e-4,0.0384,0.0387,0.02,0\n", "parameters.csv:3: ");
  expect("a,,1,1,2,1,0\n", "a: value: is no number");
  expect("a,inf,1,1,inf,1,0\n", "a: value: is no number");
  expect("a,1.5,1,,2,1,0\n", "allowed: from low_95 nan to high_95 2");
  expect("a,1.5,1,1,2,1,0\na,1.5,1,1,2,1,0\n", "a: is there twice");
}

TEST_F(FittedParametersTest, CorrelationsThatNoErrorsHaveAreRefused) {
  write("parameters.csv", "parameter,value,low_95,high_95\na,1,0,2\nb,1,0,2\nc,1,0,2\n");
  const auto problem = [&](const std::string& rows) {
    write("correlation.csv", ("parameter,a,b,c\n" + rows).c_str());
    return message_of<IoError>([&] { read_fitted_parameters(directory_.path()); });
  };
  const std::string none = "correlation.csv: holds no correlations";
  for (const char* rows :
       {"a,1,7,0\nb,7,1,0\nc,0,0,1\n", "a,1,0.5,0\nb,-0.5,1,0\nc,0,0,1\n", "a,2,0,0\nb,0,1,0\nc,0,0,1\n",
        // each pair is possible, all three together are not
        "a,1,0.9,0.9\nb,0.9,1,-0.9\nc,0.9,-0.9,1\n"})
    EXPECT_NE(problem(rows).find(none), std::string::npos) << problem(rows);
  EXPECT_NE(problem("b,1,0,0\na,0,1,0\nc,0,0,1\n")
                .find("correlation.csv:2: is the row of 'b', allowed: that of 'a'"),
            std::string::npos);
  EXPECT_NE(problem("a,1,0,nan\nb,0,1,0\nc,0,0,1\n").find("correlation.csv"), std::string::npos);
}

TEST_F(FittedParametersTest, StayAsTheyWereFoundWithoutAnInterval) {
  write("parameters.csv",
        "parameter,value,standard_error,low_95,high_95,start,at_bound\n"
        "rotor.damping_ratio,0.02,,,,0.02,1\nmark_deg,7,,-inf,inf,0,0\n");
  const auto fitted = read_fitted_parameters(directory_.path());
  RandomStream random(7, 0, 0);
  EXPECT_EQ(draw_parameters(*fitted, random), Eigen::Vector2d(0.02, 7));
}

TEST_F(FittedParametersTest, DamagedFilesAreNamed) {
  write("parameters.csv", table);
  write("correlation.csv", "parameter,rotor.supports.0.stiffness_x_n_per_m,eccentricity_m\n");
  EXPECT_THROW(read_fitted_parameters(directory_.path()), IoError);
  write("parameters.csv", "parameter,value\n");
  EXPECT_THROW(read_fitted_parameters(directory_.path()), IoError);
}

}  // namespace
}  // namespace rubsweep::diagnose
