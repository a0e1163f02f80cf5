#include "rubsweep/core/response/rotating/apex_return_search.hpp"

#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {
namespace {

constexpr int most_maxima = 32;
/// Smallest radial speed, as a share of |z| |z'|. A distance from the centre that changes more slowly counts
/// as constant, as on a circle, where maxima are only rounding.
constexpr double constant_rate = 1e-12;

}  // namespace

ApexReturnSearch::ApexReturnSearch(const scene::Scene& scene)
    : map_(scene::observed(scene)),
      states_(2 * scene.structure.coordinates()),
      returns_(static_cast<std::size_t>(states_), most_maxima) {}

void ApexReturnSearch::add(const integrate::run::TurnReport& turn) {
  const double spacing = numerics::full_turn / turn.sample_count;
  const Eigen::Index n = states_ / 2;
  // Half the rate of |z|^2; exactly zero where |z| is constant.
  const auto rate = [&](const double* state) {
    const Eigen::Vector2d z = map_ * Eigen::Map<const Eigen::VectorXd>(state, n),
                          v = map_ * Eigen::Map<const Eigen::VectorXd>(state + n, n);
    const double half = z.dot(v);
    return half * half > constant_rate * constant_rate * z.squaredNorm() * v.squaredNorm() ? half : 0;
  };
  in_turn_ = 0;
  const double* before = last_.empty() ? nullptr : last_.data();
  double rate_before = before ? rate(before) : 0;
  for (int k = 0; k < turn.sample_count; ++k) {
    const double* here = turn.samples.data() + k * states_;
    const double rate_here = rate(here);
    if (before && rate_before > 0 && rate_here <= 0)
      add_maximum(before, here, rate_before / (rate_before - rate_here), (k - 1) * spacing, spacing,
                  turn.touched);
    before = here;
    rate_before = rate_here;
  }
  last_.assign(before, before + states_);
  ++turns_;
}

void ApexReturnSearch::add_maximum(const double* before, const double* here, double share,
                                   double phase_before_rad, double spacing_rad, bool touched) {
  const Eigen::Map<const Eigen::VectorXd> a(before, states_), b(here, states_);
  const Eigen::VectorXd state =
      (1 - share) * turned(a, -phase_before_rad) + share * turned(b, -phase_before_rad - spacing_rad);
  returns_.add({state.data(), static_cast<std::size_t>(states_)}, touched);
  maxima_.push_back(
      {numerics::full_turn * static_cast<double>(turns_) + phase_before_rad + share * spacing_rad, state});
  ++in_turn_;
}

std::optional<ApexReturnSearch::Return> ApexReturnSearch::candidate() const {
  if (in_turn_ == 0) return std::nullopt;
  const auto maxima = returns_.candidate();
  if (!maxima) return std::nullopt;
  Return found{*maxima, {}};
  const double period = maximum(0).phase_rad - maximum(*maxima).phase_rad;
  for (int m = 1; m <= *maxima; ++m) {
    if (*maxima % m != 0) continue;
    const double error = (maximum(0).state - maximum(m).state).cwiseAbs().maxCoeff();
    if (error < proof::farthest_orbit) found.periods_rad.push_back(period * m / *maxima);
  }
  return found;
}

void ApexReturnSearch::refuse(const Return& candidate) { returns_.refuse(candidate.maxima); }

}  // namespace rubsweep::response::rotating
