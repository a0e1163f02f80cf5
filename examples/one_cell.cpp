// One cell of a map, from the numbers of a machine to the motion that it settles on.
//
//     one_cell [SPEED_HZ [WHIRL_RATIO]]      (70 and 0.2 without arguments)
//
// A rotor whirls quietly under a stop, is kicked against it, and either comes to rest again or goes on
// rubbing. The machine is that of configs/minimal.yaml, so that
//
//     rubtrace configs/minimal.yaml --speed-hz 70 --whirl-ratio 0.2
//
// must say the same. A program that would rather read a file takes config::read_run_config of
// rubsweep/configuration.hpp (target rubsweep::maps).

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include "rubsweep/cell.hpp"
#include "rubsweep/machine.hpp"
#include "rubsweep/settle.hpp"

namespace {

using namespace rubsweep;

// Units are part of the names. A member that is not set has a default or, where there can be none, is
// `model::required`: then model::validate, which build_cell calls, throws a ConfigError that names it.
model::Machine machine() {
  model::Stop stop;
  stop.geometry =
      model::OneSideGeometry{.angle_deg = 90};  // a flat wall above the rotor; +x points right, +y up
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 2e6;                            // contact alone, without its support
  stop.damping = model::NominalRestitution{.value = 0.7};  // defines the damper of the contact
  stop.contact_radius_m = 0.0375;                          // surface speed = radius x angular speed
  stop.friction = model::StribeckFriction{.gamma = {0, 0, 0, 0.1, 100, 0}};  // mu = 0.1 tanh(100 s/m * slip)
  stop.casing = model::Casing{.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1};

  model::Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
  machine.stops = {stop};
  machine.kick = model::Kick{.force_n = 200, .duration_s = 0.005, .angle_deg = {}};  // no angle: to the wall
  return machine;
}

// Text for the motion that the rotor settled on: its class and, for a periodic motion, its order, the number
// of revolutions after which it repeats.
std::string in_words(const response::motion::Motion& motion) {
  switch (motion.motion_class) {
    case response::motion::MotionClass::non_contact: return "it does not touch the stop any more";
    case response::motion::MotionClass::synchronous: return "it rubs in every revolution in the same way";
    case response::motion::MotionClass::resting_contact: return "it rests on the stop and does not move";
    case response::motion::MotionClass::subharmonic:
      return "it rubs in a rhythm of " + std::to_string(motion.order.value()) + " revolutions";
    case response::motion::MotionClass::quasi_periodic:
      return "it rubs with two frequencies that have no common period";
    case response::motion::MotionClass::chaotic: return "it rubs chaotically";
    case response::motion::MotionClass::unsettled:
      return "it rubs, and the run was too short to tell in which way";
    case response::motion::MotionClass::initial_contact:
    case response::motion::MotionClass::failed: break;
  }
  return "nothing can be said";
}

// Text for the evidence that proves the motion.
std::string_view in_words(response::motion::Proof proof) {
  switch (proof) {
    case response::motion::Proof::rest:
      return "a bound on the free vibration: it can never reach the stop again";
    case response::motion::Proof::floquet: return "a periodic orbit that is proven to attract the motion";
    case response::motion::Proof::floquet_observed:
      return "a stable periodic orbit that the motion was seen to approach";
    case response::motion::Proof::observed: return "what the end of the run shows";
  }
  return "";
}

void print_motion(double speed_hz, double whirl_ratio) {
  // Build one run: structure, contacts and forces at one speed, starting on the quiet whirl with this share
  // of the clearance.
  const scene::Cell cell = scene::build_cell(machine(), speed_hz, scene::WhirlRatio{whirl_ratio});
  if (!scene::can_run(cell.start)) {
    std::puts("no unbalance gives this whirl ratio at this speed");
    return;
  }

  // The defaults are those of a sweep. The workspace caches data for the next run; use one per thread.
  response::motion::Workspace workspace;
  const response::SettledRun run =
      response::settle(cell, integrate::run::SolverOptions{}, response::motion::ResponseOptions{}, workspace);
  if (run.outcome != integrate::run::Outcome::ok) {  // a failed run is a result, not an exception
    std::printf("the run failed: %s\n", std::string(integrate::run::to_string(run.outcome)).c_str());
    return;
  }

  std::printf("The rotor at %g Hz, eccentricity %.3g mm: after %ld revolutions %s.\n", speed_hz,
              1e3 * cell.eccentricity_m, run.revolutions, in_words(run.motion).c_str());
  std::printf("class %s", std::string(response::motion::to_string(run.motion.motion_class)).c_str());
  if (run.motion.order) std::printf(", order %d", *run.motion.order);
  if (run.proof) {
    std::printf(", proof %s: %s", std::string(response::motion::to_string(*run.proof)).c_str(),
                std::string(in_words(*run.proof)).c_str());
  }
  std::printf("\nlargest displacement %.3g mm, in contact %.3g %% of the time\n",
              1e3 * run.motion.measures.contact.peak_displacement_m,
              100 * run.motion.measures.contact.contact_fraction);
}

}  // namespace

int main(int count, char** arguments) {
  const double speed_hz = count > 1 ? std::atof(arguments[1]) : 70;
  const double whirl_ratio = count > 2 ? std::atof(arguments[2]) : 0.2;
  if (!(speed_hz > 0 && whirl_ratio >= 0)) {
    std::fputs("usage: one_cell [SPEED_HZ [WHIRL_RATIO]], a speed > 0 and a ratio >= 0\n", stderr);
    return 2;
  }
  try {
    print_motion(speed_hz, whirl_ratio);
  } catch (const std::exception& error) {  // ConfigError: a number of the machine is not allowed
    std::fprintf(stderr, "one_cell: %s\n", error.what());
    return 2;
  }
  return 0;
}
