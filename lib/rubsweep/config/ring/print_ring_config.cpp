#include "rubsweep/config/ring/print_ring_config.hpp"

#include "rubsweep/config/output.hpp"
#include "rubsweep/config/ring/ring.hpp"
#include "rubsweep/config/ring/ring_chart.hpp"
#include "rubsweep/config/ring/ring_load.hpp"
#include "rubsweep/config/study/axis.hpp"
#include "rubsweep/config/study/captions.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/config/yaml/printer.hpp"

namespace rubsweep::config::ring {
namespace {

void print(yaml::Printer& printer, const rubsweep::ring::Study& study, study::AxisPrint how) {
  print_ring(printer, study.system.ring);
  print_ring_loads(printer, study.system.loads);
  printer.number("friction_coefficient", study.system.friction_coefficient);
  printer.number("preload_n", study.system.preload_n);
  printer.open("speed_rpm");
  study::print_axis_values(printer, study.speeds_rpm,
                           how == study::AxisPrint::as_written ? study.spacing : std::nullopt);
  printer.close();
  if (study.chart) print_ring_chart(printer, *study.chart, how);
}

}  // namespace

std::string print_ring_config(const RingConfig& config) {
  yaml::Printer printer;
  study::print_captions(printer, config.captions);
  print(printer, config.study, study::AxisPrint::as_written);
  print_output(printer, config.output_directory);
  return printer.yaml();
}

std::string ring_study_digest(const rubsweep::ring::Study& study) {
  yaml::Printer printer;
  print(printer, study, study::AxisPrint::by_value);
  return digest_of(printer.yaml());
}

}  // namespace rubsweep::config::ring
