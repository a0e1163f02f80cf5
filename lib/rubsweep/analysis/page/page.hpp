#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/analysis/page/orbits.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// A file that the build put into the program.
struct Asset {
  std::string_view text;
  std::string_view sha256;  ///< digest of the text, 64 hexadecimal digits
};

/// The page's document with its places to fill in, its style sheet and its script.
extern const Asset document, style, script;

/// The chart library D3 and its licence, from the package that the build found.
extern const Asset library, library_licence;

/// A column of a map as the page reads it.
struct EncodedColumn {
  std::vector<std::string> words;  ///< the different words in the order of their first row; empty: numbers
  std::string data;  ///< compressed byte planes: 8 bytes a number (IEEE 754, NaN where empty), or
                     ///< 4 bytes a word, its place in `words`
};

EncodedColumn encode_column(const MapColumn& column);

/// All that a page shows.
struct PageContents {
  std::string version;                          ///< version of the program that makes the page
  std::vector<std::string> findings;            ///< sentences
  std::string model;                            ///< the simulation, in words
  std::string configuration;                    ///< YAML
  std::array<sweep::SweptAxis, 2> plane;        ///< axes of the drawn map: across, up
  std::array<sweep::WrittenAxis, 2> written{};  ///< how a person wrote these two axes
  batch::Captions captions{};
  std::string unbalance_measure;  ///< the column that says the unbalance of a cell to rubtrace
  std::vector<std::string> keys;  ///< columns of the axes over keys of the configuration
  MapTable map;
  Walls walls;
  std::vector<Boundary> boundaries;
  Orbits orbits;
  ThinnedGrid kept;      ///< grid of the orbits
  bool refined = false;  ///< the orbits are of some of the computed cells of a refined map instead
};

/// The page as one file of HTML without any other: style, script and data are in it, and its content security
/// policy allows nothing else to be loaded or run. Equal contents give equal bytes. Characters of the
/// contents that mean something in HTML are shown as they are.
std::string page_text(const PageContents& contents);

}  // namespace rubsweep::page
