#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubsweep/page/boundaries.hpp"
#include "rubsweep/page/map_table.hpp"
#include "rubsweep/page/orbits.hpp"
#include "rubsweep/page/thinned_grid.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::page {

/// A wall as it is drawn with an orbit, in metres from the rotor's rest position.
struct Wall {
  bool around = false;                   ///< around the rotor, else flat
  std::array<double, 2> normal{0, 1};    ///< of a flat wall: from the rest position towards it
  std::array<double, 2> centre_m{0, 0};  ///< of one around the rotor
  double clearance_m = 0;
  bool at_orbit = true;  ///< it stands at the point of the shaft whose orbit is drawn
};

/// All that a page shows.
struct PageContents {
  std::string version;                    ///< of the program that makes the page
  std::vector<std::string> findings;      ///< sentences
  std::string model;                      ///< what is simulated, in words
  std::string configuration;              ///< YAML
  std::array<sweep::SweptAxis, 2> plane;  ///< what the map is drawn over: across, up
  std::vector<std::string> keys;          ///< columns of the axes over keys of the configuration
  MapTable map;
  std::vector<Wall> walls;
  std::vector<Boundary> boundaries;
  Orbits orbits;
  ThinnedGrid kept;      ///< of which the orbits are
  bool refined = false;  ///< the orbits are of some of the computed cells of a refined map instead
};

/// The page as one file of HTML without any other: style, script and data are in it, and its content security
/// policy allows nothing else to be loaded or run. Equal contents give equal bytes. Characters of the
/// contents that mean something in HTML are shown as they are.
std::string page_text(const PageContents& contents);

}  // namespace rubsweep::page
