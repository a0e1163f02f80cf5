#include "rubsweep/core/model/kick.hpp"
#include "rubsweep/core/model/start.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"

namespace rubsweep::config::keys {
namespace {

std::vector<Key> body_state() {
  return newer(
      fields_of<model::BodyState>({{"x_m", "displacement in x from the unloaded position", "(quiet whirl)"},
                                   {"y_m", "displacement in y from the unloaded position", "(quiet whirl)"},
                                   {"vx_m_per_s", "velocity in x", "(quiet whirl)"},
                                   {"vy_m_per_s", "velocity in y", "(quiet whirl)"}}));
}

}  // namespace

Form kick_form() {
  return map_of(joined({fields_of<model::Kick>({{"force_n", "largest force of the half-sine pulse"},
                                                {"duration_s", "length of the pulse"}}),
                        {may("angle_deg", number(model::any_finite), "direction, from +x towards +y",
                             "(wall of the first stop)"),
                         may("phase_deg", number(model::any_finite),
                             "how far the shaft has turned on from the smallest gap when it comes", "0"),
                         may("position_m", number(model::not_negative),
                             "place along the shaft, of a rotor kit only", "(first stop)")}}));
}

Form start_form() {
  return any_of(
      {word({"rest"}),
       map_of(joined({body_state(),
                      newer({may("casings", numbered(map_of(body_state()), machine::max_stops),
                                 "states of moving casings, by the number of their stop", "(none)")})}))});
}

}  // namespace rubsweep::config::keys
