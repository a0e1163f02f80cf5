#pragma once

namespace rubsweep::numerics {

/// A real 2 x 2 matrix: an oscillator (0, 1; -stiffness, -damping), a pair of complex eigenvalues (s, w; -w,
/// s), two real ones on the diagonal, or the flow of one of these.
struct Pair {
  double uu = 0, uv = 0, vu = 0, vv = 0;
};

/// e^{generator duration}, closed form for every kind of eigenvalues and regular where they meet:
/// e^{m t} (C I + S (G - m I)) with m = trace / 2, q = det - m^2, C = cos(sqrt(q) t), S = sin(sqrt(q) t) /
/// sqrt(q), or their hyperbolic partners for q < 0.
Pair pair_flow(const Pair& generator, double duration);

}  // namespace rubsweep::numerics
