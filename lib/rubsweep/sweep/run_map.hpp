#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/sweep/row.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::sweep {

/// Evaluates every cell of the study on `threads` threads (0: all processors). Rows come in the order of the
/// cells, with the same content for any number of threads. `on_row` sees each row as it is finished, one at a
/// time, in any order. Once `stop` is true no new cell starts; cells that did not run stay empty.
std::vector<std::optional<Row>> run_map(const Study& study, int threads,
                                        const std::function<void(const Row&)>& on_row,
                                        const std::atomic<bool>& stop);

}  // namespace rubsweep::sweep
