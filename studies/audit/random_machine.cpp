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

/// Angles: any, multiples of 30 degrees, or a regular polygon.
void put_flats(Draw& draw, const model::JeffcottRotor& rotor, bool equal, int count,
               std::vector<model::Stop>& stops) {
  const bool regular = draw.chance(0.5);
  const double first = draw.chance(0.5) ? 30.0 * draw.whole(0, 11) : draw.even(0, 360);
  const model::Stop pattern = stop(draw, rotor);
  for (int i = 0; i < count; ++i) {
    model::Stop next = equal ? pattern : stop(draw, rotor);
    if (!equal && draw.chance(0.5)) next.clearance_m = pattern.clearance_m;
    // Contacts that begin within rounding of each other, and a little apart.
    if (equal && i > 0 && draw.chance(0.5)) next.clearance_m *= 1 + draw.log(1e-14, 1e-3);
    const double angle = regular ? first + 360.0 * i / count
                                 : (draw.chance(0.5) ? 30.0 * draw.whole(0, 11) : draw.even(0, 360));
    next.geometry = model::OneSideGeometry{std::fmod(angle, 360)};
    stops.push_back(next);
  }
}

/// At the speed of such a surface the rotor in contact goes back faster, for a while.
void make_thin(Draw& draw, model::Stop& stop) {
  stop.contact_radius_m = draw.log(1e-4, 3e-3);
  const double coefficient = draw.even(0.02, 0.4);
  if (draw.chance(0.5)) {
    stop.friction = model::ConstantFriction{coefficient};
  } else {
    stop.friction = model::StribeckFriction{{0, 0, 0, coefficient, draw.log(30, 3000), 0}};
  }
}

}  // namespace

RandomCell random_cell(StopKind kind, std::mt19937_64& random) {
  Draw draw(random);
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
  // A short pulse of this speed carries the rotor one to six clearances away.
  const double speed_m_per_s = draw.log(1, 6) * machine.stops.front().clearance_m * natural_rad_per_s;
  const double duration_s =
      draw.log(0.03, 0.4) / std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
  machine.kick = model::Kick{std::get<model::JeffcottRotor>(machine.rotor).mass_kg * speed_m_per_s *
                                 std::numbers::pi / (2 * duration_s),
                             duration_s, std::nullopt};
  return cell;
}

}  // namespace rubsweep::audit
