/// Reads the configurations whose names are on standard input, one per line. Prints a line for each: "ok" or
/// the first problem. A line "ring FILE" is read like ringstab does, "run FILE" like rubsweep.
#include <iostream>
#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/ring/read_ring_config.hpp"

int main() {
  std::string kind, file;
  while (std::cin >> kind && std::getline(std::cin >> std::ws, file)) {
    std::string answer = "ok";
    try {
      if (kind == "ring") {
        rubsweep::config::ring::read_ring_config(file, {});
      } else {
        rubsweep::config::read_run_config(file, {});
      }
    } catch (const rubsweep::ConfigError& error) {
      answer = error.what();
      for (char& c : answer) {
        if (c == '\n') c = '\t';
      }
    }
    std::cout << answer << '\n';
  }
}
