#include "rubsweep/core/model/support.hpp"

#include <cstddef>
#include <utility>

namespace rubsweep::model {

void set_coefficients(Support& support, const std::array<double, support_coefficients.size()>& values) {
  std::size_t next = 0;
  for (double* coefficient :
       {&support.stiffness_x_n_per_m, &support.stiffness_xy_n_per_m, &support.stiffness_yx_n_per_m,
        &support.stiffness_y_n_per_m, &support.damping_x_ns_per_m, &support.damping_xy_ns_per_m,
        &support.damping_yx_ns_per_m, &support.damping_y_ns_per_m, &support.mass_x_kg, &support.mass_y_kg})
    *coefficient = values[next++];
}

Support with_table(Support support, SupportTable table) {
  std::array<double, support_coefficients.size()> middle{};
  for (std::size_t c = 0; c < middle.size(); ++c) middle[c] = table.columns[c].at(table.speed_hz.size() / 2);
  set_coefficients(support, middle);
  support.table = std::move(table);
  return support;
}

std::optional<PartProblem> housing_problem(const Support& support) {
  if (!support.at_housing && !support.on_housing) return std::nullopt;
  const char* key = support.at_housing ? "at_housing" : "on_housing";
  if (support.pedestal) return PartProblem{key, "given beside a pedestal", "one of the two"};
  if (!support.at_housing) return std::nullopt;
  if (support.fault) return PartProblem{key, "given beside a fault", "a fault of a support of the shaft"};
  if (support.angular_stiffness_nm_per_rad != 0)
    return PartProblem{key, "given beside angular_stiffness_nm_per_rad", "no such stiffness at a housing"};
  if (support.at_housing == support.on_housing)
    return PartProblem{"on_housing", "is the housing that it holds", "another housing, or none"};
  return std::nullopt;
}

}  // namespace rubsweep::model
