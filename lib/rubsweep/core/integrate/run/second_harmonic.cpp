#include "rubsweep/core/integrate/run/second_harmonic.hpp"

namespace rubsweep::integrate::run {

std::vector<HarmonicPart> second_harmonic(const scene::Scene& scene) {
  if (scene.second_harmonic_n.size() == 0) return {};
  // cos(x) = sin(x + pi / 2): an eighth of a turn ahead, because the angle is twice that of the shaft.
  return {{scene.second_harmonic_n.real(), 0.125}, {-scene.second_harmonic_n.imag(), 0}};
}

}  // namespace rubsweep::integrate::run
