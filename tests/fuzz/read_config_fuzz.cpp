// libFuzzer target for the configuration reader of rubsweep.
#include "fuzz/reader_fuzz.hpp"
#include "rubsweep/maps/config/run_config.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubsweep;
  return fuzz::check_reader(data, size, config::read_run_config_text, config::print_config,
                            config::study_digest);
}
