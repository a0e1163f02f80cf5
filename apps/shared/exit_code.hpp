#pragma once

namespace rubsweep::apps {

/// Exit codes shared by the programs; 128 + signal when interrupted.
enum ExitCode : int {
  done = 0,
  usage = 1,
  bad_configuration = 2,
  input_output = 3,
  some_cells_failed = 4,
  maps_differ = 5,
  directory_in_use = 6,
  not_whole = 7,        ///< results are damaged, unfinished, or inconsistent
  unfinished = 75,      ///< other processes still have work to do (sysexits: EX_TEMPFAIL)
  software_fault = 70,  ///< out of memory, or a fault of the program itself (sysexits: EX_SOFTWARE)
};

}  // namespace rubsweep::apps
