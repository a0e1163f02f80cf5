#include "rubsweep/dataset/machine_draw.hpp"

#include "rubsweep/diagnose/random_stream.hpp"

namespace rubsweep::dataset {

std::size_t candidate_of(const DataStudy& study, std::size_t machine) {
  return machine % study.candidates.size();
}

MachineDraw draw_machine(const DataStudy& study, std::size_t machine) {
  diagnose::RandomStream random(study.seed, machine, Purpose::of_machine);
  MachineDraw drawn;
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (!row.of_kit) drawn.unit[static_cast<std::size_t>(row.unknown)] = random.uniform();
  drawn.clearance_m = value_at(study.candidates[candidate_of(study, machine)].clearance_m, random.uniform());
  drawn.stop_angle_deg = 360 * random.uniform();
  drawn.mark_turns = random.uniform();
  const double place = random.uniform();
  drawn.part = place < study.split.training                            ? "training"
               : place < study.split.training + study.split.validation ? "validation"
                                                                       : "test";
  for (int probe = 0; probe < study.measurement.probes; ++probe)
    drawn.gain.push_back(1 + study.measurement.gain_error * random.normal());
  return drawn;
}

}  // namespace rubsweep::dataset
