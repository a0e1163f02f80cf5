#include "rubsweep/maps/config/print_config.hpp"

#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/output.hpp"
#include "rubsweep/maps/config/study/captions.hpp"
#include "rubsweep/maps/config/study/response.hpp"
#include "rubsweep/maps/config/study/start.hpp"
#include "rubsweep/maps/config/study/study_kind.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"

namespace rubsweep::config {
namespace {

void print(yaml::Printer& printer, const sweep::Study& study, study::AxisPrint how,
           machine::MatrixPrint matrices = machine::MatrixPrint::inside) {
  machine::print_rotor(printer, study.machine, matrices);
  machine::print_stops(printer, study.machine.stops);
  if (study.machine.kick) study::print_kick(printer, *study.machine.kick);
  if (study.machine.start) study::print_start(printer, *study.machine.start);
  printer.number("gravity_m_per_s2", study.machine.gravity_m_per_s2);
  study::print_sweep(printer, study.grid, how);
  study::print_study_kind(printer, study, how);
  study::print_solver(printer, study.solver);
  study::print_response(printer, study);
}

}  // namespace

std::string print_config(const RunConfig& config, machine::MatrixPrint matrices) {
  yaml::Printer printer;
  study::print_captions(printer, config.captions);
  print(printer, config.study, study::AxisPrint::as_written, matrices);
  print_run_output(printer, config);
  return printer.yaml();
}

std::string print_study(const sweep::Study& study) {
  yaml::Printer printer;
  print(printer, study, study::AxisPrint::by_value);
  return printer.yaml();
}

}  // namespace rubsweep::config
