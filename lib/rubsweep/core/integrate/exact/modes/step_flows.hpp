#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/numerics/exponential_series.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::integrate::exact::modes {

/// Flows e^{A h} of a contact mode without pairs over the steps h of its table, as matrices. Each is made
/// when first needed: computed in long double, these matrices are the most expensive part of a mode, and most
/// of a table is never used. Only one thread may use them at a time.
template <class Factor>
class StepFlows {
 public:
  StepFlows() = default;
  StepFlows(Eigen::MatrixXd generator, double longest_step_s)
      : generator_(std::move(generator)),
        longest_step_s_(longest_step_s),
        flows_(numerics::exact_step_count) {}

  const Factor& of(int k) {
    const std::optional<Factor>& flow = flows_[static_cast<std::size_t>(k)];
    if (!flow) make(k);
    return *flow;
  }

  /// Number of steps in the table.
  std::size_t size() const { return flows_.size(); }

 private:
  void make(int k) {
    numerics::make_matrix_flows(generator_, longest_step_s_, k, [&](int i, const Eigen::MatrixXd& flow) {
      flows_[static_cast<std::size_t>(i)] = Factor(flow);
    });
  }

  Eigen::MatrixXd generator_;
  double longest_step_s_ = 0;
  std::vector<std::optional<Factor>> flows_;
};

}  // namespace rubsweep::integrate::exact::modes
