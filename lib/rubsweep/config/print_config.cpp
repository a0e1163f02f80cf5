#include "rubsweep/config/print_config.hpp"

#include "rubsweep/config/captions.hpp"
#include "rubsweep/config/kick.hpp"
#include "rubsweep/config/output.hpp"
#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/response.hpp"
#include "rubsweep/config/rotor.hpp"
#include "rubsweep/config/solver.hpp"
#include "rubsweep/config/start.hpp"
#include "rubsweep/config/stop.hpp"
#include "rubsweep/config/study_kind.hpp"
#include "rubsweep/config/sweep.hpp"

namespace rubsweep::config {
namespace {

void print(Printer& printer, const sweep::Study& study, AxisPrint how) {
  print_rotor(printer, study.machine);
  print_stops(printer, study.machine.stops);
  if (study.machine.kick) print_kick(printer, *study.machine.kick);
  if (study.machine.start) print_start(printer, *study.machine.start);
  printer.number("gravity_m_per_s2", study.machine.gravity_m_per_s2);
  print_sweep(printer, study.grid, how);
  print_study_kind(printer, study, how);
  print_solver(printer, study.solver);
  print_response(printer, study);
}

}  // namespace

std::string print_config(const RunConfig& config) {
  Printer printer;
  print_captions(printer, config.captions);
  print(printer, config.study, AxisPrint::as_written);
  print_run_output(printer, config);
  return printer.yaml();
}

std::string print_study(const sweep::Study& study) {
  Printer printer;
  print(printer, study, AxisPrint::by_value);
  return printer.yaml();
}

}  // namespace rubsweep::config
