#include "rubsweep/response/torus_watch.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "rubsweep/response/exponent.hpp"
#include "rubsweep/response/growth.hpp"

namespace rubsweep::response {
namespace {

constexpr long first_look = 200;  ///< turns after the first that is watched
/// Exponent of a torus by smooth weights, of all turns and of either half. On 281 cells of an annular map
/// these told all 237 tori from 29 chaotic motions and 15 others.
constexpr double torus_exponent = 2e-4, torus_half_exponent = 8e-4;
/// The exponent is known so much better than the rate of the closest return that this has to say little.
constexpr double return_rate_known_to = 2e-3;
/// Both halves above this are chaos, for as long as it lasts.
constexpr double chaotic_half_exponent = 0.02;

}  // namespace

TorusWatch::TorusWatch(const scene::Scene& scene, const motion::ResponseOptions& options, bool wanted)
    : options_(options),
      observed_(scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map),
      motion_{.states = 2 * static_cast<std::size_t>(scene.structure.coordinates()),
              .rows = {},
              .contributions = {}},
      direction_(first_disturbance(motion_.states).normalized()),
      look_(settled_after + std::max(first_look, 2L * options.window_revolutions)) {
  if (!wanted || look_ + 2L * options_.window_revolutions > options_.max_revolutions) end();
}

void TorusWatch::ask(long revolutions, integrate::run::TurnRequest& request) const {
  if (look_ < options_.max_revolutions && revolutions >= settled_after) {
    request.tangent_vectors = direction_;
    request.tangent_accuracy = growth_accuracy;
  } else {
    request.tangent_vectors.resize(0, 0);
  }
}

void TorusWatch::add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn) {
  if (request.tangent_vectors.cols() == 0) return;
  const Eigen::MatrixXd* moved = turn.tangent_vectors.get();
  if (!moved) return end();
  direction_ = *moved;
  motion_.add(turn.section, take_growth(direction_), turn.touched);
}

std::optional<motion::Exponent> TorusWatch::look(spectrum::SpectrumWorkspace& workspace) {
  // The first fifth turns the disturbance into the direction of largest growth.
  const std::span<const double> all = motion_.contributions, kept = all.subspan(all.size() / 5);
  const double first = bump_mean(kept.first(kept.size() / 2)), last = bump_mean(kept.last(kept.size() / 2));
  const bool zero = std::abs(bump_mean(kept)) < torus_exponent && std::abs(first) < torus_half_exponent &&
                    std::abs(last) < torus_half_exponent;
  const bool torus =
      zero && motion_.turns_without_contact < options_.window_revolutions &&
      returns_like_a_torus(motion_, observed_, options_.window_revolutions, return_rate_known_to, workspace);
  if (torus) return exponent_of(motion_.contributions);
  const long known = look_ - settled_after;
  look_ = settled_after + known + std::max(known / 2, 2L * options_.window_revolutions);
  const bool chaotic = std::min(first, last) > chaotic_half_exponent;
  if (chaotic || look_ + 2L * options_.window_revolutions > options_.max_revolutions) end();
  return std::nullopt;
}

}  // namespace rubsweep::response
