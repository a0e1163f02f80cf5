#include "rubsweep/contact/saturation.hpp"

#include <algorithm>
#include <limits>

namespace rubsweep::contact {
namespace {

/// 1 - tanh(14) = 1.4e-12.
constexpr double saturated_argument = 14;

}  // namespace

std::optional<SaturatedFriction> saturated_friction(const model::Friction& friction) {
  constexpr double everywhere = -std::numeric_limits<double>::infinity();
  if (std::holds_alternative<model::NoFriction>(friction)) return SaturatedFriction{0, everywhere};
  if (const auto* constant = std::get_if<model::ConstantFriction>(&friction))
    return SaturatedFriction{constant->coefficient, everywhere};
  const auto& g = std::get<model::StribeckFriction>(friction).gamma;
  if (g[5] != 0) return std::nullopt;
  double steepness = std::numeric_limits<double>::infinity();
  if (g[0] != 0) steepness = std::min(g[1], g[2]);
  if (g[3] != 0) steepness = std::min(steepness, g[4]);
  if (!(steepness > 0)) return std::nullopt;
  return SaturatedFriction{g[3], saturated_argument / steepness};
}

}  // namespace rubsweep::contact
