#pragma once

namespace rubsweep::ring {

inline double square(double x) { return x * x; }

}  // namespace rubsweep::ring
