#include "audit/random_machine.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::audit {
namespace {

class Draw {
 public:
  explicit Draw(std::mt19937_64& random) : random_(random) {}

  double even(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double log(double low, double high) { return std::exp(even(std::log(low), std::log(high))); }
  bool chance(double share) { return even(0, 1) < share; }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

 private:
  std::mt19937_64& random_;
};

model::ContactDamping damping(Draw& draw) {
  if (draw.chance(0.1)) return model::ExplicitDamping{0};
  if (draw.chance(0.1)) return model::DeliveredRestitution{draw.even(0.3, 0.95)};
  return model::NominalRestitution{draw.chance(0.35) ? 1 - draw.log(1e-5, 0.05) : draw.even(0.3, 0.95)};
}

model::Friction friction(Draw& draw) {
  if (draw.chance(0.4)) return model::NoFriction{};
  if (draw.chance(0.75)) return model::ConstantFriction{draw.even(0, 0.3)};
  return model::StribeckFriction{{0, 0, 0, draw.even(0, 0.3), draw.log(30, 300), 0}};
}

model::Stop stop(Draw& draw, const model::JeffcottRotor& rotor) {
  const double rate = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  const double shaft_n_per_m = rotor.mass_kg * rate * rate;
  model::Stop stop;
  stop.clearance_m = draw.log(2e-4, 2e-3);
  stop.stiffness_n_per_m = shaft_n_per_m * draw.log(3, 3e4);
  stop.damping = damping(draw);
  stop.contact_radius_m = draw.log(0.005, 0.08);
  stop.friction = friction(draw);
  if (draw.chance(0.6))
    stop.casing = model::Casing{rotor.mass_kg * draw.log(0.01, 1), shaft_n_per_m * draw.log(0.1, 100),
                                draw.log(0.005, 0.5)};
  return stop;
}

/// Adds flat stops at random angles, at multiples of 30 degrees, or as a regular polygon.
void put_flats(Draw& draw, const model::JeffcottRotor& rotor, bool equal, int count,
               std::vector<model::Stop>& stops) {
  const bool regular = draw.chance(0.5);
  const double first = draw.chance(0.5) ? 30.0 * draw.whole(0, 11) : draw.even(0, 360);
  const model::Stop pattern = stop(draw, rotor);
  for (int i = 0; i < count; ++i) {
    model::Stop next = equal ? pattern : stop(draw, rotor);
    if (!equal && draw.chance(0.5)) next.clearance_m = pattern.clearance_m;
    // Some clearances differ by rounding or slightly more, so that contacts begin almost together.
    if (equal && i > 0 && draw.chance(0.5)) next.clearance_m *= 1 + draw.log(1e-14, 1e-3);
    const double angle = regular ? first + 360.0 * i / count
                                 : (draw.chance(0.5) ? 30.0 * draw.whole(0, 11) : draw.even(0, 360));
    next.geometry = model::OneSideGeometry{std::fmod(angle, 360)};
    stops.push_back(next);
  }
}

/// Makes the shaft so thin that a rotor in contact can move backwards faster than its surface.
void make_thin(Draw& draw, model::Stop& stop) {
  stop.contact_radius_m = draw.log(1e-4, 3e-3);
  const double coefficient = draw.even(0.02, 0.4);
  if (draw.chance(0.5)) {
    stop.friction = model::ConstantFriction{coefficient};
  } else {
    stop.friction = model::StribeckFriction{{0, 0, 0, coefficient, draw.log(30, 3000), 0}};
  }
}

/// A value equal to `value`, or larger by a share of 1e-12 to 1e-2.
double nearly(Draw& draw, double value) {
  return draw.chance(0.4) ? value : value * (1 + draw.log(1e-12, 1e-2));
}

model::Stop dry_stop(Draw& draw, const model::JeffcottRotor& rotor) {
  model::Stop dry = stop(draw, rotor);
  const double rate = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  dry.stiffness_n_per_m = rotor.mass_kg * rate * rate * draw.log(10, 3e3);
  dry.damping = model::NominalRestitution{draw.even(0.3, 0.95)};
  dry.contact_radius_m = draw.chance(0.2) ? 0 : draw.log(1e-5, 0.02);
  dry.friction = model::ConstantFriction{draw.log(0.05, 2)};
  // On rigid stops the tangent vectors are linearly dependent.
  if (draw.chance(0.7)) dry.casing.reset();
  return dry;
}

/// A stop beside `pattern`, equal or nearly equal in everything that decides when both touch and slip.
model::Stop dry_neighbour(Draw& draw, const model::JeffcottRotor& rotor, const model::Stop& pattern) {
  model::Stop next = draw.chance(0.5) ? pattern : dry_stop(draw, rotor);
  next.clearance_m = nearly(draw, pattern.clearance_m);
  next.contact_radius_m = nearly(draw, pattern.contact_radius_m);
  if (draw.chance(0.5)) next.casing.reset();
  return next;
}

void put_dry_stops(Draw& draw, StopKind kind, const model::JeffcottRotor& rotor,
                   std::vector<model::Stop>& stops) {
  const double angle = draw.chance(0.5) ? -90 : draw.even(0, 360);
  model::Stop first = dry_stop(draw, rotor);
  const double away = draw.chance(0.5) ? 0 : draw.log(1e-10, 0.1) * first.clearance_m;
  const double way = draw.even(0, 2 * std::numbers::pi);
  if (kind == StopKind::parallel_flats) {
    first.geometry = model::OneSideGeometry{angle};
  } else {
    first.geometry = model::AnnularGeometry{{away * std::cos(way), away * std::sin(way)}};
  }
  stops.push_back(first);
  const int more = kind == StopKind::rings ? 1 : draw.whole(1, 2);
  const double apart_deg = draw.chance(0.15) ? 0 : draw.log(1e-6, 10);
  for (int i = 0; i < more; ++i) {
    model::Stop next = dry_neighbour(draw, rotor, first);
    if (kind == StopKind::rings) {
      next.geometry = model::AnnularGeometry{{0, 0}};
    } else {
      next.geometry = model::OneSideGeometry{std::fmod(angle + (i + 1) * apart_deg + 360, 360)};
    }
    stops.push_back(next);
  }
}

/// A cell with slow surfaces, and a weight or a kick that brings the rotor to its stops.
RandomCell dry_cell(StopKind kind, Draw& draw) {
  RandomCell cell;
  const model::JeffcottRotor rotor{draw.log(0.1, 7), draw.even(10, 45), draw.log(0.002, 0.1)};
  cell.machine.rotor = rotor;
  put_dry_stops(draw, kind, rotor, cell.machine.stops);
  const double clearance_m = cell.machine.stops.front().clearance_m;
  const double rate = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  cell.speed_hz = rotor.natural_frequency_hz * draw.log(0.1, 3);
  cell.eccentricity_m = clearance_m * draw.log(0.003, 0.5);
  if (draw.chance(0.6)) cell.machine.gravity_m_per_s2 = draw.log(0.3, 5) * clearance_m * rate * rate;
  const double duration_s = draw.log(0.03, 0.4) / rotor.natural_frequency_hz;
  const double speed_m_per_s = draw.log(0.5, 6) * clearance_m * rate;
  cell.machine.kick = model::Kick{rotor.mass_kg * speed_m_per_s * std::numbers::pi / (2 * duration_s),
                                  duration_s, draw.even(0, 360)};
  return cell;
}

}  // namespace

RandomCell random_cell(StopKind kind, std::mt19937_64& random) {
  Draw draw(random);
  if (several_dry(kind)) return dry_cell(kind, draw);
  RandomCell cell;
  model::Machine& machine = cell.machine;
  machine.rotor = model::JeffcottRotor{draw.log(0.1, 7), draw.even(10, 45), draw.log(0.002, 0.1)};
  if (kind == StopKind::annular || kind == StopKind::offset_annular) {
    model::Stop annular = stop(draw, std::get<model::JeffcottRotor>(machine.rotor));
    model::AnnularGeometry geometry;
    if (kind == StopKind::offset_annular) {
      const double share = draw.even(0.02, 0.6), angle = draw.even(0, 2 * std::numbers::pi);
      geometry.offset_m = {share * annular.clearance_m * std::cos(angle),
                           share * annular.clearance_m * std::sin(angle)};
    }
    annular.geometry = geometry;
    machine.stops.push_back(annular);
  } else {
    const int count = kind == StopKind::one_flat     ? 1
                      : kind == StopKind::thin_flats ? draw.whole(1, 4)
                                                     : draw.whole(2, 4);
    put_flats(draw, std::get<model::JeffcottRotor>(machine.rotor), kind == StopKind::equal_flats, count,
              machine.stops);
    if (kind == StopKind::thin_flats) {
      for (model::Stop& thin : machine.stops) make_thin(draw, thin);
    }
  }
  const double natural_rad_per_s =
      2 * std::numbers::pi * std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
  cell.speed_hz = std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz * draw.even(0.5, 7);
  cell.whirl_ratio = draw.even(0.03, 0.95);
  // A short pulse with this speed moves the rotor by one to six clearances.
  const double speed_m_per_s = draw.log(1, 6) * machine.stops.front().clearance_m * natural_rad_per_s;
  const double duration_s =
      draw.log(0.03, 0.4) / std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
  machine.kick = model::Kick{std::get<model::JeffcottRotor>(machine.rotor).mass_kg * speed_m_per_s *
                                 std::numbers::pi / (2 * duration_s),
                             duration_s, std::nullopt};
  return cell;
}

}  // namespace rubsweep::audit
