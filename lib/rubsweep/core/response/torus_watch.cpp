#include "rubsweep/core/response/torus_watch.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/response/aperiodic.hpp"
#include "rubsweep/core/response/growth.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"
#include "rubsweep/core/scene/observed.hpp"

namespace rubsweep::response {
namespace {

constexpr long first_watch = 200;  ///< turns after the first that is watched
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
      observed_(scene::observed(scene)),
      motion_{.states = 2 * static_cast<std::size_t>(scene.structure.coordinates()),
              .rows = {},
              .contributions = {}},
      direction_(first_disturbance(motion_.states).normalized()),
      look_(settled_after + std::max(first_watch, 2L * options.window_revolutions)),
      record_begin_(last_windows()) {
  if (!wanted || !worth_a_look()) end();
}

void TorusWatch::ask(long revolutions, integrate::run::TurnRequest& request) const {
  const bool carrying = look_ < options_.max_revolutions || chaotic_;
  if (carrying && revolutions >= settled_after) {
    request.tangent_vectors = direction_;
    request.tangent_accuracy = growth_accuracy;
  } else {
    request.tangent_vectors.resize(0, 0);
  }
}

void TorusWatch::add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn) {
  if (request.tangent_vectors.cols() == 0) return;
  const Eigen::MatrixXd* moved = turn.tangent_vectors.get();
  if (!moved) return refuse();
  direction_ = *moved;
  motion_.add(turn.section, take_growth(direction_), turn.touched);
}

/// With contact, without a period in the last window, and returning as a torus does.
bool TorusWatch::shows_a_torus(spectrum::SpectrumWorkspace& workspace) const {
  const int window = options_.window_revolutions;
  if (motion_.turns_without_contact >= window) return false;
  const auto rows = motion_.last_rows(static_cast<std::size_t>(window) + 1);
  return !motion::period_of_section(rows, static_cast<int>(motion_.states), options_.max_order) &&
         returns_like_a_torus(motion_, observed_, window, return_rate_known_to, workspace);
}

void TorusWatch::look(spectrum::SpectrumWorkspace& workspace) {
  const auto [all, first, last] = bump_means(motion_.contributions);
  const bool zero = std::abs(all) < torus_exponent && std::abs(first) < torus_half_exponent &&
                    std::abs(last) < torus_half_exponent;
  if (zero && shows_a_torus(workspace)) {
    torus_ = exponent_of(motion_.contributions);
    record_begin_ = look_;
    return end();
  }
  look_ += (look_ - settled_after) / 4;
  chaotic_ = std::min(first, last) > chaotic_half_exponent;
  if (chaotic_ || !worth_a_look()) end();
}

void TorusWatch::refuse() {
  torus_.reset();
  chaotic_ = false;
  record_begin_ = last_windows();
  end();
}

std::optional<motion::Exponent> TorusWatch::chaos() const {
  return chaotic_ ? lasting_chaos(motion_) : std::nullopt;
}

}  // namespace rubsweep::response
