#pragma once

/// \file
/// Configurations as files in YAML, JSON or TOML, as the programs read them. Every key is checked.
/// ConfigError lists all problems, one a line: `file:line:column: path.to.key: what is wrong, allowed: what
/// is allowed`. IoError means that the file cannot be read. Overrides are `path.to.key=value`, as for
/// `--set`.
///
/// config::RunConfig has `study` (machine, grid, solver, classification) and the places for results.
/// print_config gives the complete YAML with all defaults; reading it back gives an equal configuration.
/// read_cell_config reads the configuration of a single cell.
///
/// ```cpp
/// using namespace rubsweep;
/// const config::RunConfig config =
///     config::read_run_config("configs/minimal.yaml", {"rotor.damping_ratio=0.03", "kick.force_n=250"});
/// std::printf("%zu cells\n", sweep::cell_count(config.study.grid));
/// std::puts(config::print_config(config).c_str());
/// ```

#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
