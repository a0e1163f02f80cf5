// libFuzzer target for everything between a configuration and the row of one cell. The input determines the
// configuration, see random_config; with the environment variable RUBSWEEP_FUZZ_PRINT=1 it is printed.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/random_config.hpp"
#include "fuzz/whole_path.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rubsweep::fuzz;
  static const bool print = std::getenv("RUBSWEEP_FUZZ_PRINT") != nullptr;
  ByteSource bytes({data, size});
  const std::string text = random_config(bytes);
  if (print) std::fputs(text.c_str(), stderr);
  check_whole_path(text);  // an exception ends the program like a crash
  return 0;
}
