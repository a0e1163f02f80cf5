#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rubsweep::batch {

/// Number of steps of the size `step` that lead from `from` to `to`, in either direction, counted in
/// decimals: from 30 to 31 there are ten of 0.1, although the doubles of these numbers say otherwise. `step`
/// > 0. Empty where no whole number of them meets `to`, and where the three numbers span more than 15 digits.
std::optional<std::int64_t> whole_steps(double from, double to, double step);

/// Values of these steps from `from` on between which `to` lies, the nearer one to `from` first: for somebody
/// whose steps miss it. Empty where the three numbers span more than 15 digits.
std::optional<std::pair<double, double>> steps_beside(double from, double to, double step);

/// Values from `from` to `to`, both included, by these steps: each the double nearest to its decimal, 30.3
/// and not 30.299999999999997. Throws std::invalid_argument where whole_steps is empty.
std::vector<double> decimal_steps(double from, double to, double step);

}  // namespace rubsweep::batch
