#include "rubsweep/core/numerics/pair_flow.hpp"

#include <cmath>

namespace rubsweep::numerics {
namespace {

/// cos(sqrt(x)) and sin(sqrt(x)) / sqrt(x), continued through x <= 0 by their hyperbolic partners.
struct CosineAndSinc {
  double c, s;
};

CosineAndSinc cosine_and_sinc(double x) {
  // Here the series is exact to rounding, on both sides of zero.
  if (std::abs(x) < 1e-2) {
    return {1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90)))),
            1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72 * (1 - x / 110))))};
  }
  const double root = std::sqrt(std::abs(x));
  if (x > 0) return {std::cos(root), std::sin(root) / root};
  return {std::cosh(root), std::sinh(root) / root};
}

}  // namespace

Pair pair_flow(const Pair& g, double duration) {
  const double mean = (g.uu + g.vv) / 2, half = (g.uu - g.vv) / 2;
  // det - mean^2, without the cancellation of the diagonal's product.
  const double q = -g.uv * g.vu - half * half;
  const double square = q * duration * duration;
  double c = 0, s = 0;
  if (square < -100) {
    // cosh would overflow where its product with the decay is small.
    const double root = std::sqrt(-q);
    const double slow = std::exp((mean + root) * duration), fast = std::exp((mean - root) * duration);
    c = (slow + fast) / 2;
    s = (slow - fast) / (2 * root);
  } else {
    const auto pair = cosine_and_sinc(square);
    const double decay = std::exp(mean * duration);
    c = decay * pair.c;
    s = decay * pair.s * duration;
  }
  return {c + s * half, s * g.uv, s * g.vu, c - s * half};
}

}  // namespace rubsweep::numerics
