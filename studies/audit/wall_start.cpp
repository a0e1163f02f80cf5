#include "audit/wall_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "audit/fixed_step_turn.hpp"
#include "audit/random_machine.hpp"
#include "audit/section_distance.hpp"
#include "audit/time_stepping_turn.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::audit {
namespace {

constexpr double clearly = 4;      ///< least error that counts / uncertainty of the fixed steps
constexpr double rounding = 1e-6;  ///< errors of the section too small for any fixed steps
constexpr double undecided = 1e-2;
constexpr std::array refinements{1, 8, 40};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double even(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double log(double low, double high) { return std::exp(even(std::log(low), std::log(high))); }
  bool chance(double share) { return even(0, 1) < share; }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  std::mt19937_64& generator() { return random_; }

 private:
  std::mt19937_64 random_;
};

bool dry(const scene::Contact& contact) { return contact::dry_coefficient(contact.friction) != 0; }

bool any_dry(const scene::Scene& scene) { return std::ranges::any_of(scene.contacts, dry); }

/// One reference uses friction as a function of slip, the other one dry friction, so only one kind is kept.
void keep_one_friction(model::Machine& machine) {
  const auto is_dry = [](const model::Stop& stop) { return contact::dry_coefficient(stop.friction) != 0; };
  if (std::ranges::none_of(machine.stops, is_dry)) return;
  for (model::Stop& stop : machine.stops) {
    if (!is_dry(stop)) stop.friction = model::NoFriction{};
  }
}

std::optional<scene::Scene> random_scene(StopKind kind, Draw& draw) {
  RandomCell cell = random_cell(kind, draw.generator());
  cell.machine.kick.reset();
  keep_one_friction(cell.machine);
  const auto& rotor = std::get<model::JeffcottRotor>(cell.machine.rotor);
  scene::Unbalance unbalance = scene::WhirlRatio{cell.whirl_ratio};
  if (cell.eccentricity_m) unbalance = scene::Eccentricity{*cell.eccentricity_m};
  // Turns are short: a wrong start shows at once, and chaos has no time to separate correct results.
  const double speed_hz = std::max(cell.speed_hz, 2 * rotor.natural_frequency_hz);
  const scene::Cell built = scene::build_cell(cell.machine, speed_hz, unbalance);
  if (!scene::can_run(built.start)) return std::nullopt;
  return built.scene;
}

/// Places rotor and casing of contact `i` at the wall; returns the normal there.
Eigen::Vector2d place(scene::Scene& scene, std::size_t i, Draw& draw) {
  const scene::Contact& c = scene.contacts[i];
  const auto& points = scene.structure.points;
  const double around = draw.even(0, 2 * std::numbers::pi);
  Eigen::Vector2d normal(std::cos(around), std::sin(around)), along = Eigen::Vector2d::Zero();
  if (contact::linear(c.wall)) {
    normal = contact::normal_at(c.wall, {0, 0});
    if (draw.chance(0.5)) along = Eigen::Vector2d(-normal.y(), normal.x()) * draw.even(-1, 1) * c.clearance_m;
  }
  Eigen::Vector2d casing = Eigen::Vector2d::Zero();
  scene.displacement_m.setZero();
  if (c.casing_point && draw.chance(0.5)) {
    casing = c.clearance_m * Eigen::Vector2d(draw.even(-0.3, 0.3), draw.even(-0.3, 0.3));
    scene.displacement_m += points[static_cast<std::size_t>(*c.casing_point)].map.transpose() * casing;
  }
  Eigen::Vector2d rotor = casing + c.clearance_m * normal + along - contact::offset(c.wall);
  for (double* x : {&rotor.x(), &rotor.y()}) {
    const int ulp = draw.whole(-1, 1);
    if (ulp != 0) *x = std::nextafter(*x, ulp * std::numeric_limits<double>::infinity());
  }
  scene.displacement_m += points[static_cast<std::size_t>(c.rotor_point)].map.transpose() * rotor;
  return normal;
}

std::string_view set_velocities(scene::Scene& scene, std::size_t i, const Eigen::Vector2d& normal,
                                Draw& draw) {
  const scene::Contact& c = scene.contacts[i];
  const auto& points = scene.structure.points;
  const double unit = c.clearance_m * scene.speed_rad_per_s;
  scene.velocity_m_per_s.setZero();
  const int way = draw.whole(0, 3);
  if (way == 0) return "at rest";
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  if (c.casing_point) {
    velocity = unit * Eigen::Vector2d(draw.even(-1, 1), draw.even(-1, 1));
    scene.velocity_m_per_s += points[static_cast<std::size_t>(*c.casing_point)].map.transpose() * velocity;
  }
  const Eigen::Vector2d tangent(-normal.y(), normal.x());
  if (way == 2) velocity += tangent * unit * draw.even(-2, 2);
  if (way == 3) velocity -= tangent * c.surface_speed_m_per_s;
  scene.velocity_m_per_s += points[static_cast<std::size_t>(c.rotor_point)].map.transpose() * velocity;
  constexpr std::array<std::string_view, 4> names{"", "with its casing", "along the wall", "without slip"};
  return names[static_cast<std::size_t>(way)];
}

/// Radial acceleration of the rotor relative to the casing at the start, including the rotation of the
/// normal.
double radial_acceleration(const scene::Scene& scene, std::size_t i, const Eigen::Vector2d& normal) {
  const scene::Contact& c = scene.contacts[i];
  const Eigen::MatrixXd map = scene::relative_map(scene.structure, c);
  Eigen::VectorXd force = scene.constant_n + scene.harmonic_n.real() -
                          scene.structure.stiffness * scene.displacement_m -
                          scene.structure.damping * scene.velocity_m_per_s;
  if (scene.second_harmonic_n.size() > 0) force += scene.second_harmonic_n.real();
  const Eigen::VectorXd acceleration = force.cwiseQuotient(scene.structure.mass.diagonal());
  double radial = normal.dot(map * acceleration);
  if (!contact::linear(c.wall)) {
    const double along = Eigen::Vector2d(-normal.y(), normal.x()).dot(map * scene.velocity_m_per_s);
    radial += along * along / c.clearance_m;
  }
  return radial;
}

std::string_view push(scene::Scene& scene, std::size_t i, const Eigen::Vector2d& normal, Draw& draw) {
  const scene::Contact& c = scene.contacts[i];
  const auto& rotor = scene.structure.points[static_cast<std::size_t>(c.rotor_point)].map;
  const double kg = (rotor * scene.structure.mass * rotor.transpose())(0, 0);
  const int way = draw.whole(0, 3);
  const double unit = c.clearance_m * scene.speed_rad_per_s * scene.speed_rad_per_s;
  const double wanted = way == 0 ? 0 : (way == 3 ? -1 : 1) * draw.log(0.003, 1) * unit;
  scene.constant_n += rotor.transpose() * normal * kg * (wanted - radial_acceleration(scene, i, normal));
  return way == 0 ? "no radial acceleration" : way == 3 ? "pulled off" : "pressed on";
}

/// Whether no other wall is penetrated by more than rounding.
bool clear_of_others(const scene::Scene& scene, std::size_t i) {
  for (std::size_t j = 0; j < scene.contacts.size(); ++j) {
    const scene::Contact& c = scene.contacts[j];
    const Eigen::Vector2d d =
        scene::relative_map(scene.structure, c) * scene.displacement_m + contact::offset(c.wall);
    if (j != i && d.dot(contact::normal_at(c.wall, d)) > (1 + 1e-9) * c.clearance_m) return false;
  }
  return true;
}

/// Number of steps per turn in which the phase of the stiffest contact changes only little.
int steps_of_turn(const scene::Scene& scene) {
  constexpr double little_rad = 0.1;
  double stiffest = 0;
  for (const scene::Contact& contact : scene.contacts)
    stiffest = std::max(stiffest, contact.stiffness_n_per_m / scene.structure.mass.diagonal().minCoeff());
  return static_cast<int>(std::clamp(std::sqrt(stiffest) * scene.period_s() / little_rad, 2000.0, 60000.0));
}

std::vector<double> fixed_steps(const scene::Scene& scene, const std::vector<double>& section, int steps) {
  return any_dry(scene) ? time_stepping_turn(scene, section, steps).section
                        : fixed_step_turn(scene, section, steps);
}

std::array<std::vector<double>, wall_start_solvers.size()> solved(const scene::Scene& scene) {
  std::array<std::vector<double>, wall_start_solvers.size()> sections;
  integrate::run::TurnReport turn;
  integrate::exact::modes::ModeCache modes;
  integrate::run::SolverOptions options;
  options.method = integrate::run::Method::exact;
  const auto take = [&](integrate::run::Outcome outcome, std::size_t k) {
    if (outcome == integrate::run::Outcome::ok) sections[k] = turn.section;
  };
  take(integrate::start(scene, options, modes).advance({}, turn), 0);
  integrate::taylor::TaylorRun<Eigen::Dynamic> series(scene, options);
  take(series.advance({}, turn), 1);
  options.method = integrate::run::Method::adaptive;
  options.relative_tolerance = 1e-10;
  take(integrate::start(scene, options, modes).advance({}, turn), 2);
  return sections;
}

double size_of(const std::vector<double>& section) {
  double largest = 1;
  for (const double value : section) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

WallStart random_wall_start(std::uint64_t seed, std::size_t index) {
  Draw draw(seed * 1'000'003 + index);
  const StopKind kind = named_stop_kinds[index % named_stop_kinds.size()];
  for (;;) {
    auto scene = random_scene(kind, draw);
    if (!scene) continue;
    scene->pulses.clear();
    const auto i = static_cast<std::size_t>(draw.whole(0, static_cast<int>(scene->contacts.size()) - 1));
    const Eigen::Vector2d normal = place(*scene, i, draw);
    if (!clear_of_others(*scene, i)) continue;
    const std::string_view moves = set_velocities(*scene, i, normal, draw);
    const std::string_view pushed = push(*scene, i, normal, draw);
    return {std::move(*scene), fmt::format("{}, {}, {}", to_string(kind), moves, pushed)};
  }
}

WallStartAudit audit_wall_start(const WallStart& start) {
  WallStartAudit audit;
  const std::vector<double> section = integrate::run::scaled_initial_state(start.scene);
  const auto sections = solved(start.scene);
  for (const int finer : refinements) {
    const int steps = finer * steps_of_turn(start.scene);
    // The ratio of the step numbers is not simple: otherwise an event half a step late in each would look
    // like agreement.
    const auto fine = fixed_steps(start.scene, section, 31 * steps / 10);
    audit.spread = std::max(section_distance(fixed_steps(start.scene, section, steps), fine),
                            section_distance(fixed_steps(start.scene, section, 17 * steps / 10), fine));
    audit.decides = audit.spread < undecided;
    audit.wrong = false;
    for (std::size_t k = 0; k < sections.size(); ++k) {
      audit.errors[k] =
          sections[k].empty() ? std::numeric_limits<double>::infinity() : section_distance(sections[k], fine);
      audit.wrong = audit.wrong || !(audit.errors[k] <= clearly * audit.spread + rounding * size_of(fine));
    }
    if (!audit.wrong) break;
  }
  return audit;
}

}  // namespace rubsweep::audit
