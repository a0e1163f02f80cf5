#include "rubsweep/core/scene/two_orders.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::scene {
namespace {

/// Samples per revolution. The functions below have no order above 4, so at most four maxima. Maxima less
/// than two samples apart differ by at most 1e-5 of the motion, and each maximum of the samples is refined.
constexpr int samples = 256;

/// Value of a function of the phase with its first two derivatives.
struct Local {
  double value = 0, slope = 0, curvature = 0;
};

/// Newton's iteration from a bracketed maximum, whose position follows from values alone to only half the
/// digits.
template <class Function>
double polished(const Function& at, double phase_rad) {
  for (int step = 0; step < 3; ++step) {
    const Local here = at(phase_rad);
    if (!(here.curvature < 0)) break;
    const double next = phase_rad - here.slope / here.curvature;
    if (std::abs(at(next).slope) >= std::abs(here.slope)) break;
    phase_rad = next;
  }
  return phase_rad;
}

/// Largest value of `at`, which has no order above 4.
template <class Function>
TopOfMotion top_of(const Function& at) {
  std::vector<double> values;
  for (int k = 0; k < samples; ++k) values.push_back(at(numerics::full_turn * k / samples).value);
  const auto sampled = [&](int k) { return values[static_cast<std::size_t>((k + samples) % samples)]; };
  TopOfMotion top{-std::numeric_limits<double>::infinity(), 0};
  for (int k = 0; k < samples; ++k) {
    if (sampled(k) < sampled(k - 1) || sampled(k) <= sampled(k + 1)) continue;
    const auto below = [&](double phase_rad) { return -at(phase_rad).value; };
    const double found = boost::math::tools::brent_find_minima(below, numerics::full_turn * (k - 1) / samples,
                                                               numerics::full_turn * (k + 1) / samples, 26)
                             .first;
    const double phase_rad = polished(at, found), value = at(phase_rad).value;
    if (value > top.value) top = {value, phase_rad < 0 ? phase_rad + numerics::full_turn : phase_rad};
  }
  return std::isfinite(top.value) ? top : TopOfMotion{values.front(), 0};
}

constexpr TopOfMotion unbounded{std::numeric_limits<double>::infinity(), 0};

}  // namespace

TopOfMotion largest_value(std::complex<double> first, std::complex<double> second) {
  if (!std::isfinite(std::norm(first) + std::norm(second))) return unbounded;
  return top_of([&](double phase_rad) -> Local {
    const std::complex<double> i(0, 1), one = first * std::polar(1.0, phase_rad),
                                        two = second * std::polar(1.0, 2 * phase_rad);
    return {(one + two).real(), (i * (one + 2.0 * two)).real(), -(one + 4.0 * two).real()};
  });
}

TopOfMotion largest_distance(const Eigen::Vector2cd& first, const Eigen::Vector2cd& second) {
  const double size = std::sqrt(first.squaredNorm() + second.squaredNorm());
  if (!std::isfinite(size)) return unbounded;
  if (size == 0) return {};
  TopOfMotion top = top_of([&](double phase_rad) -> Local {
    const std::complex<double> i(0, 1);
    const Eigen::Vector2cd one = first / size * std::polar(1.0, phase_rad),
                           two = second / size * std::polar(1.0, 2 * phase_rad);
    const Eigen::Vector2d place = (one + two).real(), rate = (i * (one + 2.0 * two)).real(),
                          bend = -(one + 4.0 * two).real();
    return {place.squaredNorm() / 2, place.dot(rate), rate.squaredNorm() + place.dot(bend)};
  });
  top.value = size * std::sqrt(2 * top.value);
  return top;
}

}  // namespace rubsweep::scene
