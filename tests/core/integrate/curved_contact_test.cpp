// Contacts with nonlinear laws, compared with closed forms of an impact and with a second implementation of
// the equations in long double. The latter shares only the numbers of a scene with the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using model::ForceCurve;
using model::ImpactDamping;
using Real = long double;

model::Stop stop_of(ForceCurve kind) {
  model::Stop stop;
  stop.clearance_m = 1e-3;
  stop.law.kind = kind;
  return stop;
}

model::Stop power_stop(double stiffness, double exponent, ImpactDamping damping = ImpactDamping::none,
                       double restitution = 1) {
  model::Stop stop = stop_of(ForceCurve::power);
  stop.law.stiffness_n_per_m_n = stiffness;
  stop.law.exponent = exponent;
  stop.law.damping = damping;
  stop.law.restitution = restitution;
  return stop;
}

void give_law(const model::Stop& stop, scene::Contact& contact) {
  contact.law = std::make_shared<contact::CurvedLaw>(stop);
  contact.stiffness_n_per_m = contact::secant_n_per_m(stop);
  contact.damping_ns_per_m = 0;
}

run::SolverOptions tight() {
  run::SolverOptions options;
  options.relative_tolerance = 1e-13;
  return options;
}

/// A mass of 2 kg that moves at `speed` mm/s towards a wall 1 mm away; one revolution per second.
scene::Scene flight(const model::Stop& stop, double speed) {
  scene::Scene scene = test::one_mass_scene(2, 0, 0, 2 * std::numbers::pi, 1e-3);
  scene.contacts.push_back(test::wall_across_x(1, 1e-3, 1, 0));
  give_law(stop, scene.contacts[0]);
  scene.velocity_m_per_s << 1e-3 * speed, 0;
  return scene;
}

struct Impact {
  double duration_s = 0, peak_n = 0, restitution = 0;
};

Impact impact(const scene::Scene& scene) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, tight(), modes);
  run::TurnRequest asked;
  asked.peaks = asked.switches = true;
  run::TurnReport turn;
  double touched = 0;
  Impact seen;
  for (int k = 0; k < 5000; ++k) {
    EXPECT_EQ(run.advance(asked, turn), run::Outcome::ok);
    seen.peak_n = std::max(seen.peak_n, turn.peak_contact_force_n);
    for (const auto& change : turn.switches) {
      const double time_s = k * 2 * std::numbers::pi + change.phase_rad;
      if (change.from == contact::Mode::open) touched = time_s;
      if (change.to == contact::Mode::open) seen.duration_s = time_s - touched;
    }
    if (seen.duration_s == 0) continue;
    seen.restitution = -turn.section[2] * 1e-3 / scene.velocity_m_per_s(0);
    return seen;
  }
  ADD_FAILURE() << "no impact";
  return seen;
}

TEST(CurvedContact, HertzImpactLastsAsLongAsHertzSays) {
  const double K = 1e4, m = 2;
  for (const double speed : {1.0, 0.03}) {
    const double v = 1e-3 * speed;
    const Impact seen = impact(flight(power_stop(K, 1.5), speed));
    const double peak_m = std::pow(5 * m * v * v / (4 * K), 0.4);
    const double constant =
        2 * std::pow(1.25, 0.4) * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
    EXPECT_NEAR(constant / std::pow(1.25, 0.4), 2.9432, 1e-4);
    EXPECT_NEAR(seen.duration_s / (2.9432 * peak_m / v), 1, 3e-5);
    EXPECT_NEAR(seen.duration_s / (constant * std::pow(m * m / (K * K * v), 0.2)), 1, 1e-9);
    EXPECT_NEAR(seen.peak_n / (K * std::pow(peak_m, 1.5)), 1, 1e-6);
    EXPECT_NEAR(seen.restitution, 1, 1e-10);
  }
}

/// Root of the first integral by bisection: (1 + e) x = ln((1 + x) / (1 - e x)).
double restitution_by_halving(double x) {
  Real low = 0, high = std::min<Real>(1, 1 / Real(x) * (1 - 1e-18L));
  for (int k = 0; k < 200; ++k) {
    const Real e = (low + high) / 2;
    ((1 + e) * x - std::log((1 + x) / (1 - e * x)) > 0 ? low : high) = e;
  }
  return double(low);
}

TEST(CurvedContact, EachDampingReturnsItsClosedFormOverThreeDecadesOfSpeed) {
  for (const double e : {0.3, 0.8}) {
    const std::pair<ImpactDamping, double> expected[] = {
        {ImpactDamping::none, 1},
        {ImpactDamping::hunt_crossley, restitution_by_halving(1.5 * (1 - e))},
        {ImpactDamping::lankarani_nikravesh, restitution_by_halving(0.75 * (1 - e * e))},
        {ImpactDamping::flores, restitution_by_halving(1.6 * (1 - e) / e)},
        {ImpactDamping::delivered, e}};
    for (const auto& [damping, returned] : expected) {
      for (const double speed : {1.0, 0.03, 0.0011})
        EXPECT_NEAR(impact(flight(power_stop(1e4, 1.5, damping, e), speed)).restitution, returned,
                    1e-10 / std::max(speed, 1e-2))
            << int(damping) << " " << e << " " << speed;
      model::Stop felt = stop_of(ForceCurve::table);
      felt.law.penetration_m = {0, 1e-5, 5e-5};
      felt.law.force_n = {0, 1e-3, 1};
      felt.law.damping = damping;
      felt.law.restitution = e;
      EXPECT_NEAR(impact(flight(felt, 1)).restitution, returned, 1e-8);
    }
  }
}

TEST(CurvedContact, AFixedSpeedOfApproachDeliversAtThatSpeedAlone) {
  model::Stop stop = power_stop(1e4, 1.5, ImpactDamping::delivered, 0.5);
  stop.law.approach_speed_m_per_s = 1e-3;
  EXPECT_NEAR(impact(flight(stop, 1)).restitution, 0.5, 1e-9);
  EXPECT_GT(impact(flight(stop, 0.1)).restitution, 0.85);
}

/// A rotor of 1 kg on springs, with weight and a rotating force, and a casing of 0.3 kg behind the first
/// stop.
scene::Scene rotor_and_casing(const std::vector<scene::Contact>& contacts, double force_n) {
  scene::Scene scene = test::one_mass_scene(1, 0, 0, 0.02, 1e-3);
  auto& system = scene.structure;
  Eigen::Vector4d mass(1, 1, 0.3, 0.3), stiffness(4e4, 5e4, 6e4, 6e4), damping(20, 25, 15, 15);
  system.mass = mass.asDiagonal();
  system.stiffness = stiffness.asDiagonal();
  system.damping = damping.asDiagonal();
  system.unbalance_kg = Eigen::VectorXcd::Zero(4);
  system.weight_kg = Eigen::Vector4d(0, -1, 0, 0);
  system.points.clear();
  Eigen::Matrix<double, 2, Eigen::Dynamic> rotor(2, 4), casing(2, 4);
  rotor << 1, 0, 0, 0, 0, 1, 0, 0;
  casing << 0, 0, 1, 0, 0, 0, 0, 1;
  system.points = {{rotor}, {casing}};
  scene.harmonic_n = Eigen::VectorXcd::Zero(4);
  scene.harmonic_n(0) = force_n;
  scene.harmonic_n(1) = {0, -force_n};
  scene.constant_n = Eigen::Vector4d(0, -9.81, 0, 0);
  scene.displacement_m = scene.velocity_m_per_s = Eigen::VectorXd::Zero(4);
  scene.velocity_m_per_s(1) = 0.3;
  scene.contacts = contacts;
  return scene;
}

TEST(CurvedContact, ExponentOneIsALinearContact) {
  for (const contact::Wall& wall :
       {contact::Wall(contact::FlatWall{{0, 1}}), contact::Wall(contact::AnnularWall{})}) {
    scene::Contact linear;
    linear.wall = wall;
    linear.casing_point = 1;
    linear.clearance_m = 1e-3;
    linear.stiffness_n_per_m = 2e6;
    linear.friction = model::ConstantFriction{0.1};
    linear.surface_speed_m_per_s = 8;
    scene::Contact curved = linear;
    give_law(power_stop(2e6, 1), curved);
    exact::modes::ModeCache modes;
    run::SolverOptions options = tight();
    options.method = run::Method::adaptive;
    const run::Run one = start(rotor_and_casing({linear}, 40), options, modes),
                   other = start(rotor_and_casing({curved}, 40), options, modes);
    run::TurnReport a, b;
    int hits = 0;
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(one.advance({}, a), run::Outcome::ok);
      ASSERT_EQ(other.advance({}, b), run::Outcome::ok);
      hits += a.hits;
      for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-10);
    }
    EXPECT_GT(hits, 0);
  }
}

TEST(CurvedContact, OnlyTheSteppersKnowIt) {
  const scene::Scene scene = flight(power_stop(1e4, 1.5), 1);
  run::SolverOptions options;
  EXPECT_EQ(solver_of(scene, options), Solver::adaptive);
  exact::modes::ModeCache modes;
  options.method = run::Method::exact;
  EXPECT_THROW(start(scene, options, modes), ConfigError);
  options.method = run::Method::adaptive;
  options.contact = run::ContactHandling::smoothed;
  EXPECT_THROW(start(scene, options, modes), ConfigError);
}

/// Elastic force of a stop, implemented independently.
Real spring(const model::Stop& stop, Real p) {
  const model::NormalLaw& law = stop.law;
  if (p <= 0) return 0;
  if (law.kind == ForceCurve::power) return law.stiffness_n_per_m_n * std::pow(p, Real(law.exponent));
  if (law.kind == ForceCurve::hertz_line) {
    const model::HertzLine& h = *stop.hertz;
    const auto soft = [](const model::HertzBody& body) {
      return (1 - Real(body.poisson_ratio) * body.poisson_ratio) / body.youngs_modulus_pa;
    };
    const Real both = soft(h.rotor) + soft(h.casing), pi = std::numbers::pi_v<Real>, L = h.length_m;
    Real force = p / both;
    for (int k = 0; k < 40; ++k) {
      const Real b = std::sqrt(4 * force * both * h.rotor.radius_m / (pi * L));
      force = p * pi * L / (2 * both * (2 * std::log(2.0L) + 0.5L + std::log(L / (2 * b))));
    }
    return force;
  }
  // Cubic Hermite polynomials through three points, with slopes by Fritsch and Butland.
  const auto& x = law.penetration_m;
  const auto& y = law.force_n;
  const Real h0 = Real(x[1]) - x[0], h1 = Real(x[2]) - x[1], d0 = (Real(y[1]) - y[0]) / h0,
             d1 = (Real(y[2]) - y[1]) / h1;
  const Real w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  const auto end = [](Real h, Real next, Real d, Real other) {
    const Real slope = ((2 * h + next) * d - h * other) / (h + next);
    return slope <= 0 ? 0 : slope;
  };
  const Real slopes[] = {end(h0, h1, d0, d1), (w0 + w1) / (w0 / d0 + w1 / d1), end(h1, h0, d1, d0)};
  if (p >= x[2]) return y[2] + slopes[2] * (p - x[2]);
  const int k = p < x[1] ? 0 : 1;
  const Real h = k == 0 ? h0 : h1, t = (p - x[std::size_t(k)]) / h, u = 1 - t;
  return u * u * (1 + 2 * t) * y[std::size_t(k)] + t * t * (3 - 2 * t) * y[std::size_t(k) + 1] +
         h * t * u * (u * slopes[k] - t * slopes[k + 1]);
}

using Numbers = std::array<Real, 8>;

/// The scene of `rotor_and_casing` in SI units and long double, integrated by the classical Runge-Kutta
/// method. Steps are shortened where a contact begins or ends.
struct Reference {
  const scene::Scene& scene;
  std::vector<model::Stop> stops;
  std::vector<Real> x{};      ///< damping factor c of each stop times approach speed v0
  std::vector<Real> speed{};  ///< speed of the present approach, per stop
  Numbers state{};
  Real longest = 1;

  struct Seen {
    Real p, v, s, nx, ny;
  };
  Seen seen(std::size_t i, const Numbers& z) const {
    const scene::Contact& c = scene.contacts[i];
    const Real moves = c.casing_point ? 1 : 0;
    const Real dx = z[0] - moves * z[2], dy = z[1] - moves * z[3], vx = z[4] - moves * z[6],
               vy = z[5] - moves * z[7];
    Real nx = 0, ny = 0;
    if (const auto* flat = std::get_if<contact::FlatWall>(&c.wall)) {
      nx = flat->normal.x(), ny = flat->normal.y();
    } else {
      const Real r = std::hypot(dx, dy);
      nx = r > 0 ? dx / r : 1, ny = r > 0 ? dy / r : 0;
    }
    return {dx * nx + dy * ny - c.clearance_m, vx * nx + vy * ny, vy * nx - vx * ny, nx, ny};
  }

  Numbers rate(const Numbers& z, Real t) const {
    const Real w = scene.speed_rad_per_s;
    std::array<Real, 4> force{};
    for (int i = 0; i < 4; ++i)
      force[std::size_t(i)] = Real(scene.constant_n(i)) + Real(scene.harmonic_n(i).real()) * std::cos(w * t) -
                              Real(scene.harmonic_n(i).imag()) * std::sin(w * t) -
                              Real(scene.structure.stiffness(i, i)) * z[std::size_t(i)] -
                              Real(scene.structure.damping(i, i)) * z[std::size_t(i) + 4];
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const Seen m = seen(i, z);
      const Real elastic = spring(stops[i], m.p);
      const Real normal = elastic * std::max<Real>(0, 1 + x[i] * m.v / speed[i]);
      Real mu = 0;
      const Real slip = m.s + scene.contacts[i].surface_speed_m_per_s;
      if (const auto* dry = std::get_if<model::ConstantFriction>(&scene.contacts[i].friction))
        mu = dry->coefficient * (slip > 0 ? 1 : -1);
      if (const auto* curve = std::get_if<model::StribeckFriction>(&scene.contacts[i].friction))
        mu = curve->gamma[3] * std::tanh(curve->gamma[4] * slip);
      const Real fx = normal * m.nx - mu * elastic * m.ny, fy = normal * m.ny + mu * elastic * m.nx;
      force[0] -= fx, force[1] -= fy;
      if (scene.contacts[i].casing_point) force[2] += fx, force[3] += fy;
    }
    Numbers out{};
    for (std::size_t i = 0; i < 4; ++i) {
      out[i] = z[i + 4];
      out[i + 4] = force[i] / Real(scene.structure.mass(Eigen::Index(i), Eigen::Index(i)));
    }
    return out;
  }

  Numbers step(Real t, Real h) const {
    const auto at = [&](const Numbers& k, Real f) {
      Numbers z = state;
      for (std::size_t i = 0; i < 8; ++i) z[i] += f * k[i];
      return z;
    };
    const auto a = rate(state, t), b = rate(at(a, h / 2), t + h / 2), c = rate(at(b, h / 2), t + h / 2),
               d = rate(at(c, h), t + h);
    Numbers z = state;
    for (std::size_t i = 0; i < 8; ++i) z[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return z;
  }

  /// One step, at most up to the first instant at which a contact begins, ends or loses its force.
  Real advance(Real t, Real most) {
    const Real w = scene.speed_rad_per_s;
    Real h = most;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const Seen m = seen(i, state);
      if (m.p <= 0) continue;
      h = std::min(h, std::clamp(m.p / (100 * std::abs(m.v)), 1e-7L / w, longest / (4 * w)));
      // A damper whose factor was set by a grazing approach is stiff.
      h = std::min(h, speed[i] * Real(0.03L) / (20 * x[i] * spring(stops[i], m.p) + 1e-9L));
    }
    h = std::min(h, longest / w);
    Numbers next = step(t, h);
    const auto region = [&](std::size_t i, const Numbers& z) {
      const Seen m = seen(i, z);
      return m.p <= 0 ? 0 : 1 + x[i] * m.v / speed[i] > 0 ? 1 : 2;
    };
    const auto changed = [&](const Numbers& z) {
      for (std::size_t i = 0; i < stops.size(); ++i)
        if (region(i, z) != region(i, state)) return true;
      return false;
    };
    if (changed(next)) {
      Real low = 0, high = h;
      for (int k = 0; k < 70; ++k) {
        const Real middle = (low + high) / 2;
        (changed(step(t, middle)) ? high : low) = middle;
      }
      h = high;
      next = step(t, h);
      for (std::size_t i = 0; i < stops.size(); ++i)
        if (seen(i, state).p <= 0 && seen(i, next).p > 0 && !stops[i].law.approach_speed_m_per_s)
          speed[i] = std::max(seen(i, next).v, Real(1e-3) * scene.contacts[i].clearance_m * w);
    }
    state = next;
    return t + h;
  }

  std::vector<double> after_turns(int turns) {
    const Real period = 2 * std::numbers::pi_v<Real> / scene.speed_rad_per_s, end = turns * period;
    for (Real t = 0; t < end;) t = advance(t, end - t);
    std::vector<double> section(8);
    for (std::size_t i = 0; i < 8; ++i)
      section[i] = double(state[i] / (1e-3L * (i < 4 ? 1 : Real(scene.speed_rad_per_s))));
    return section;
  }
};

double damping_of(ImpactDamping damping, double e) {
  switch (damping) {
    case ImpactDamping::none:
      return 0;
    case ImpactDamping::hunt_crossley:
      return 1.5 * (1 - e);
    case ImpactDamping::lankarani_nikravesh:
      return 0.75 * (1 - e * e);
    case ImpactDamping::flores:
      return 1.6 * (1 - e) / e;
    case ImpactDamping::delivered: {
      double low = 0, high = 1 / e;
      for (int k = 0; k < 100; ++k) {
        const double x = (low + high) / 2;
        (restitution_by_halving(x) > e ? low : high) = x;
      }
      return low;
    }
  }
  return 0;
}

class RandomMachine {
 public:
  explicit RandomMachine(unsigned seed) : random_(seed) {
    const int count = 1 + int(seed % 3);
    std::vector<scene::Contact> contacts;
    for (int i = 0; i < count; ++i) contacts.push_back(contact(i == 0 && seed % 2 == 0, seed + unsigned(i)));
    scene = rotor_and_casing(contacts, between(10, 60));
  }

  scene::Scene scene;
  std::vector<model::Stop> stops;

  Reference reference() const {
    Reference reference{.scene = scene, .stops = stops};
    for (const model::Stop& stop : stops) {
      reference.x.push_back(damping_of(stop.law.damping, stop.law.restitution));
      reference.speed.push_back(stop.law.approach_speed_m_per_s.value_or(1));
    }
    for (Eigen::Index i = 0; i < 4; ++i) {
      reference.state[std::size_t(i)] = scene.displacement_m(i);
      reference.state[std::size_t(i) + 4] = scene.velocity_m_per_s(i);
    }
    return reference;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  scene::Contact contact(bool moving, unsigned seed) {
    constexpr ForceCurve kinds[] = {ForceCurve::power, ForceCurve::power, ForceCurve::hertz_line,
                                    ForceCurve::table};
    model::Stop stop = stop_of(kinds[seed % 4]);
    model::NormalLaw& law = stop.law;
    law.exponent = std::array{1.5, between(1, 3), 1.2, 2.0}[seed / 4 % 4];
    law.stiffness_n_per_m_n = between(1e5, 1e6) / std::pow(5e-5, law.exponent - 1);
    law.penetration_m = {0, 3e-5, 1e-4};
    law.force_n = {0, between(1, 3), between(10, 60)};
    stop.hertz = model::HertzLine{.length_m = 0.02,
                                  .rotor = {0.02, between(2e8, 2e9), 0.3},
                                  .casing = {model::required, 1e9, 0.3},
                                  .casing_shape = model::HertzShape::flat,
                                  .design_force_n = 1};
    law.damping = model::impact_dampings.values[seed % 5];
    law.restitution = between(0.4, 1);
    if (seed % 7 == 0) law.approach_speed_m_per_s = between(0.05, 0.3);
    scene::Contact contact;
    contact.clearance_m = stop.clearance_m = between(3e-4, 6e-4);
    if (moving) contact.casing_point = 1;
    const double angle = between(0, 2 * std::numbers::pi);
    contact.wall = seed % 3 == 0 ? contact::Wall(contact::AnnularWall{})
                                 : contact::Wall(contact::FlatWall{{std::cos(angle), std::sin(angle)}});
    contact.surface_speed_m_per_s = 12;
    if (seed % 4 == 1) contact.friction = model::ConstantFriction{between(0, 0.3)};
    if (seed % 4 == 2) contact.friction = model::StribeckFriction{{0, 0, 0, between(0, 0.3), 0.1, 0}};
    give_law(stop, contact);
    stops.push_back(stop);
    return contact;
  }

  std::mt19937 random_;
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Largest difference after `turns` turns, divided by the growth of a small disturbance.
double error_of(unsigned seed, int turns, int& hits) {
  const RandomMachine machine(seed);
  exact::modes::ModeCache modes;
  const run::Run run = start(machine.scene, tight(), modes);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) {
    EXPECT_EQ(run.advance({}, turn), run::Outcome::ok);
    hits += turn.hits;
  }
  Reference reference = machine.reference(), disturbed = machine.reference();
  reference.longest = disturbed.longest = 2e-3L;
  constexpr Real disturbance = 1e-12L;
  disturbed.state[1] += disturbance;
  const std::vector<double> expected = reference.after_turns(turns);
  const double growth = distance(expected, disturbed.after_turns(turns)) / double(disturbance / 1e-3L);
  return distance(turn.section, expected) / std::max(1.0, growth);
}

/// RUBSWEEP_CURVED_MACHINES=N tests N machines over three turns: half a minute each.
TEST(CurvedContact, RandomMachinesMoveAsTheirEquationsSay) {
  const char* wanted = std::getenv("RUBSWEEP_CURVED_MACHINES");
  const unsigned machines = wanted != nullptr ? unsigned(std::atoi(wanted)) : 2;
  int hits = 0;
  for (unsigned seed = 1; seed <= machines; ++seed)
    EXPECT_LT(error_of(seed, wanted ? 3 : 1, hits), 1e-10) << seed;
  EXPECT_GT(hits, int(machines));
}

}  // namespace
}  // namespace rubsweep::integrate
