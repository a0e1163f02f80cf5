#include <utility>

#include "rubsweep/core/model/disc_geometry.hpp"
#include "rubsweep/core/model/rolling_bearing.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"

namespace rubsweep::config::machine {
namespace {

using namespace keys;

Form parts_of(std::vector<Key> keys, std::vector<Choice> choices = {}) {
  return list_of(map_of(std::move(keys), std::move(choices)), 1, model::RotorKit::most_parts);
}

/// Form of a list of parts that may have names.
template <class Part>
Form named_parts() {
  return parts_of(joined({keys_of<Part>(), {name_key()}}));
}

Form shaft() {
  Form layers = list_of(map_of(keys_of<model::ShaftLayer>()), 1, most_layers);
  return parts_of(
      joined({keys_of<model::ShaftSegment>(),
              {newer_key(may("layers", std::move(layers),
                             "further sections of the same length that share both ends, such as a "
                             "sleeve"))}}));
}

Form discs() {
  Choice ways{{{{disc_inertias.begin(), disc_inertias.end()}, {}}, {{"geometry"}, {}}}};
  return parts_of(joined({keys_of<model::Disc>(),
                          {must("geometry", map_of(keys_of<model::DiscGeometry>()),
                                "cylinder with a bore, in place of mass and inertias"),
                           name_key()}}),
                  {std::move(ways)});
}

Form fault() {
  Form bearing = map_of(joined(
      {{must("defect", one_of(bearing_defects), "part that is damaged")}, keys_of<model::RollingBearing>()}));
  return map_of(
      joined(
          {keys_of<model::BearingFault>(),
           {newer_key(must("bearing", std::move(bearing), "rolling bearing that the strikes follow from"))}}),
      {either(std::array<std::string_view, 2>{"multiple", "bearing"})});
}

Form supports() {
  std::vector<Key> numbers = keys_of<model::Support>(), coefficients = numbers;
  std::erase_if(coefficients, [](const Key& key) { return !is_coefficient(key.name); });
  const Form housing = integer(0, static_cast<long>(model::RotorKit::most_parts) - 1);
  const Key table =
      newer_key(must("table", support_table_form(), "coefficients over the speed, in place of the numbers"));
  return parts_of(
      joined(
          {std::move(numbers),
           {name_key("name in messages, tables and figures; a name with 'Seal' in it carries no weight"),
            table,
            newer_key(
                must("at_housing", housing, "number of the housing that it holds in place of the shaft")),
            newer_key(may("on_housing", housing, "number of the housing on which it stands", "(the ground)")),
            may("pedestal", map_of(keys_of<model::Pedestal>()), "housing of its own, with a mass", "(none)"),
            may("fault", fault(), "faulty bearing, which strikes the shaft", "(none)")}}),
      {either(std::array<std::string_view, 2>{"position_m", "at_housing"}),
       choice_of({{table}, coefficients})});
}

Form bow() {
  const auto numbers = [](const model::Range& range) {
    return list_of(number(range), 1, model::RotorKit::most_parts);
  };
  const std::vector<std::vector<Key>> ways{
      {must("mode", integer(1, model::RotorKit::most_modes), "mode whose shape it has, 1 the lowest"),
       must("amplitude_m", number(model::physical::amplitude_m), "largest deflection of that shape")},
      {must("position_m", numbers(model::not_negative), "places along the shaft of measured deflections"),
       must("deflection_m", numbers(model::physical::deflection_m),
            "deflections there; the least bent line through them")}};
  return map_of(joined({joined(ways),
                        {may("phase_deg", number(model::any_finite),
                             "angle of the bow from the mark on the shaft", "0")}}),
                {choice_of(ways)});
}

}  // namespace

Key name_key(std::string meaning) { return newer_key(may("name", text(), std::move(meaning), "(none)")); }

std::vector<Key> kit_rest_keys() {
  return joined(
      {{newer_key(may("static_loads", parts_of(keys_of<model::StaticLoad>()), "forces that do not change")),
        may("sensors", named_parts<model::Sensor>(), "proximity probes"),
        may("bow", bow(), "residual bow: it turns with the shaft and is not scaled by the cell", "(none)"),
        may("torsion", map_of(keys_of<model::Torsion>()),
            "twist of the rotor against a drive of constant speed", "(none)")},
       keys_of<model::RotorKit>()});
}

std::vector<Key> rotor_kit_keys() {
  return joined({{must("shaft", shaft(), "segments of the shaft, one behind the other"),
                  may("discs", discs(), "rigid discs on the shaft"),
                  must("supports", supports(), "bearings of shaft and housings"),
                  may("couplings", parts_of(keys_of<model::Coupling>()), "elastic joints of the shaft"),
                  newer_key(may("point_masses", named_parts<model::PointMass>(),
                                "masses without inertia against tilting")),
                  newer_key(may("housings", named_parts<model::Housing>(),
                                "bodies beside the shaft that move in x and y, held by supports"))},
                 kit_rest_keys()});
}

}  // namespace rubsweep::config::machine
