#include "map_options.hpp"

#include <boost/program_options.hpp>

#include "shared/figure.hpp"

namespace rubsweep::apps {

void add_map_files(po::options_description& options) {
  add_output(options, "write there instead of output.directory");
  add_figure(options, "also draw the map as FILE.png, .svg or .pdf");
  options.add_options()("fade",
                        "of --figure: cells fade by robust_share, of response.robustness probability");
}

void add_fresh(po::options_description& options) {
  options.add_options()("fresh",
                        "forget what earlier runs finished, a finished map included, and start over");
}

void add_report(po::options_description& options) {
  options.add_options()(
      "report",
      "also write DIR/report.html, a page that shows the map and the motion of each cell at a click");
}

}  // namespace rubsweep::apps
