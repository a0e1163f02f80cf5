#include "maps/config/support.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"

namespace rubsweep::config {
namespace {

TEST(SlipOf, IsTheSameForCommandLines) {
  const model::Machine machine =
      read_run_config_text(test_file("minimal.yaml"), "test.yaml", {}).study.machine;
  const auto slip = slip_of(Quantity::speed_hz, 12000, &machine);
  ASSERT_TRUE(slip);
  EXPECT_TRUE(slip->certain);
  EXPECT_FALSE(slip_of(Quantity::speed_hz, 200, &machine));
  EXPECT_FALSE(slip_of(Quantity::clearance_m, 1, nullptr)) << "what it is compared with is not known";
}

}  // namespace
}  // namespace rubsweep::config
