// audit events|proofs|wall_starts ...: runs one of the audits; each is described in its source.

#include <fmt/format.h>

#include <string_view>

#include "audit/audit_programs.hpp"

int main(int argc, char** argv) {
  using namespace rubsweep;
  const std::string_view name = argc > 1 ? argv[1] : "";
  if (name == "events") return audit::events(argc - 1, argv + 1);
  if (name == "proofs") return audit::proofs(argc - 1, argv + 1);
  if (name == "wall_starts") return audit::wall_starts(argc - 1, argv + 1);
  fmt::print(stderr, "usage: audit events|proofs|wall_starts ...\n");
  return 1;
}
