#pragma once

#include <vector>

#include "rubsweep/fit/ramp.hpp"

namespace rubsweep::fit {

/// Ramp of a shaft with these speeds at ascending instants, 4 or more. Where rows are whole turns apart, as
/// those of rubscope are, their instants tell it, which are better known than speeds. A polynomial goes
/// through them, of a degree that the data ask for: where it is a straight line of speeds to
/// two ten-thousandths, the ramp is even, else its speeds at the rows are knots. Speeds that are off the
/// polynomial by more than 2 % of their change are followed from row to row.
Ramp measured_ramp(const std::vector<double>& t_s, const std::vector<double>& speed_hz);

}  // namespace rubsweep::fit
