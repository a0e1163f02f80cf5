// libFuzzer target for the configuration reader of ringstab.
#include "fuzz/reader_fuzz.hpp"
#include "rubsweep/ring/read_ring_config.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubsweep;
  return fuzz::check_reader(data, size, config::ring::read_ring_config_text, config::ring::print_ring_config,
                            config::ring::ring_study_digest);
}
