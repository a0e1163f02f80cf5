#include "rubsweep/measurement/diagnose/lasting_motion.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::diagnose {
namespace {

using integrate::run::Outcome;

constexpr int samples_of_a_turn = 32;

/// A kit that says how many modes it keeps is not asked again whether they are enough: that takes most of the
/// time of a short run.
scene::Cell cell_of(const model::Machine& machine, double speed_hz, const scene::Unbalance& unbalance) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (!kit || !kit->modes) return scene::build_cell(machine, speed_hz, unbalance);
  return scene::build_cell(scene::prepare_with_modes(structure::machine_at(machine, speed_hz), *kit->modes),
                           speed_hz, unbalance);
}

/// Whether the run still touches something after so many turns.
bool lasts(const integrate::run::Run& run, int turns, integrate::run::TurnReport& turn) {
  int untouched = 0;
  for (int k = 0; k < turns; ++k) {
    if (run.advance({}, turn) != Outcome::ok) return false;
    untouched = turn.touched ? 0 : untouched + 1;
    if (untouched > turns_in_flight) return false;
  }
  return true;
}

std::optional<LastingMotion> record(const scene::Cell& cell, const integrate::run::Run& run, int turns,
                                    response::spectrum::SpectrumWorkspace& workspace) {
  integrate::run::TurnRequest request;
  request.samples_per_revolution = samples_of_a_turn;
  request.peaks = true;
  integrate::run::TurnReport turn;
  std::vector<std::complex<double>> displacement_m;
  std::vector<response::motion::ContactFacts> facts;
  for (int k = 0; k < turns; ++k) {
    if (run.advance(request, turn) != Outcome::ok) return std::nullopt;
    add_samples(cell.scene, turn, displacement_m);
    facts.push_back(response::motion::facts_of(turn));
  }
  return LastingMotion{lines_of(displacement_m, turns, most_order, workspace),
                       response::motion::together(facts), cell.eccentricity_m};
}

}  // namespace

void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m) {
  const auto& map = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  const auto coordinates = static_cast<std::size_t>(scene.structure.coordinates());
  for (std::size_t k = 0; k < static_cast<std::size_t>(turn.sample_count); ++k) {
    const Eigen::Map<const Eigen::VectorXd> q(turn.samples.data() + k * 2 * coordinates,
                                              scene.structure.coordinates());
    const Eigen::Vector2d z = scene.length_scale_m * (map * q);
    displacement_m.emplace_back(z.x(), z.y());
  }
}

int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left) {
  constexpr double most = 1e6;
  const double turns =
      -std::log(left) * speed_hz / (2 * std::numbers::pi * damping_ratio * natural_frequency_hz);
  return static_cast<int>(std::ceil(std::min(turns, most)));
}

int turns_before_recording(const model::Machine& machine, double speed_hz) {
  const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor);
  if (!rotor) return kit_turns_before_recording;
  constexpr double left = 5e-3;
  return std::clamp(turns_to_decay(rotor->natural_frequency_hz, rotor->damping_ratio, speed_hz, left),
                    fewest_turns_before_recording, most_turns_before_recording);
}

std::optional<LastingMotion> rubbing_motion(const model::Machine& machine, double speed_hz,
                                            const scene::Unbalance& unbalance, int turns,
                                            response::spectrum::SpectrumWorkspace& workspace) {
  const scene::Cell cell = cell_of(machine, speed_hz, unbalance);
  if (!scene::can_run(cell.start)) return std::nullopt;
  // Every machine is another one: a cache for all of them would only grow.
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(cell.scene, {}, modes);
  integrate::run::TurnReport turn;
  if (!lasts(run, turns_before_recording(machine, speed_hz), turn)) return std::nullopt;
  auto motion = record(cell, run, turns, workspace);
  if (motion && motion->contact.contact_fraction == 0) return std::nullopt;
  return motion;
}

std::optional<LastingMotion> motion_without_contact(const model::Machine& machine, double speed_hz,
                                                    const scene::Unbalance& unbalance, int turns,
                                                    response::spectrum::SpectrumWorkspace& workspace) {
  const scene::Cell cell = cell_of(machine, speed_hz, unbalance);
  if (cell.start != scene::Start::quiet) return std::nullopt;
  integrate::exact::modes::ModeCache modes;
  return record(cell, integrate::start(cell.scene, {}, modes), turns, workspace);
}

}  // namespace rubsweep::diagnose
