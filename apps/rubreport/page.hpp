#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "rubreport/map_table.hpp"
#include "rubreport/orbits.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::page {

/// File that the build embedded in the program.
struct Asset {
  std::string_view text;
  std::string_view sha256;  ///< digest of the text, 64 hexadecimal digits
};

/// Parts of the page: the HTML document with placeholders, its style sheet and its script.
extern const Asset document, style, script;

/// Chart library D3 and its licence, from the package that the build found.
extern const Asset library, library_licence;

/// Column of a map, encoded for the page.
struct EncodedColumn {
  std::vector<std::string> words;  ///< different words in order of occurrence; empty: numbers
  std::string data;  ///< compressed byte planes: 8 bytes a number (IEEE 754, NaN where empty), or
                     ///< 4 bytes a word, its place in `words`
};

EncodedColumn encode_column(const MapColumn& column);

/// Contents of a page.
struct PageContents {
  std::string version;                          ///< version of the program that makes the page
  std::vector<std::string> findings;            ///< findings of the map, one sentence each
  std::string model;                            ///< description of the simulation in words
  std::string configuration;                    ///< configuration as YAML
  std::array<sweep::SweptAxis, 2> plane;        ///< axes of the drawn map: across, up
  std::array<sweep::WrittenAxis, 2> written{};  ///< units and spacing in which these axes were written
  batch::Captions captions{};
  std::string unbalance_measure;  ///< column of the unbalance, by which rubtrace finds a cell
  std::vector<std::string> keys;  ///< columns of the axes over keys of the configuration
  MapTable map;
  Walls walls;
  std::vector<Boundary> boundaries;
  Orbits orbits;
  ThinnedGrid kept;      ///< grid of the orbits
  bool refined = false;  ///< true: the orbits belong to some computed cells of a refined map, not to a grid
};

/// Page as one HTML file that needs no other file. Style, script and data are inside, and its content
/// security policy forbids to load or run anything else. Equal contents give equal bytes. Characters that are
/// special in HTML are escaped.
std::string page_text(const PageContents& contents);

}  // namespace rubsweep::page
