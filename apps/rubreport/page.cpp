#include "rubreport/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/src.hpp>  // compiles the library's code, in this file only
#include <boost/json/value.hpp>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "rubreport/compressed.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"

namespace rubsweep::page {
namespace {

/// `value` as JSON that is safe inside an HTML script element: no character of it opens a tag.
std::string json_text(const boost::json::value& value) {
  // JSON has '<' only inside strings.
  return boost::algorithm::replace_all_copy(boost::json::serialize(value), "<", "\\u003c");
}

namespace json = boost::json;

std::string html_text(std::string text) {
  for (const auto& [letter, entity] :
       {std::pair("&", "&amp;"), {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    boost::algorithm::replace_all(text, letter, entity);
  return text;
}

/// Hash "sha256-..." by which a content security policy allows a script.
std::string policy_hash(const Asset& asset) {
  std::string bytes;
  for (std::size_t i = 0; i < asset.sha256.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(std::string(asset.sha256.substr(i, 2)), nullptr, 16)));
  return fmt::format("'sha256-{}'", base64(bytes));
}

/// Content security policy. It allows the data: and blob: addresses of pictures, which stay inside the page.
std::string policy() {
  return fmt::format(
      "default-src 'none'; script-src {} {}; style-src {}; img-src data: blob:; base-uri 'none'; "
      "form-action 'none'",
      policy_hash(library), policy_hash(script), policy_hash(style));
}

json::array numbers(const auto& values) {
  json::array array;
  for (const auto value : values) array.push_back(value);
  return array;
}

json::array words(const std::vector<std::string>& values) {
  json::array array;
  for (const std::string& value : values) array.push_back(json::string(value));
  return array;
}

json::array walls(const std::vector<Wall>& list) {
  json::array array;
  for (const Wall& wall : list)
    array.push_back(json::object{{"around", wall.around},
                                 {"normal", numbers(wall.normal)},
                                 {"centre_m", numbers(wall.centre_m)},
                                 {"clearance_m", wall.clearance_m},
                                 {"at_orbit", wall.at_orbit}});
  return array;
}

json::array wall_lists(const Walls& walls) {
  json::array array;
  for (const std::vector<Wall>& list : walls.lists) array.push_back(page::walls(list));
  return array;
}

json::array boundaries(const PageContents& contents) {
  json::array array;
  for (const Boundary& boundary : contents.boundaries) {
    json::array points;
    for (const auto& point : boundary.points) points.push_back(numbers(point));
    array.push_back(json::object{{"family", boundary.family}, {"kind", boundary.kind}, {"points", points}});
  }
  return array;
}

/// Unit and scale of an axis for display; empty for a linear axis in the units of the map.
json::object shown_axis(const sweep::WrittenAxis& written, double least) {
  json::object shown;
  if (!written.is_si()) {
    shown["unit"] = written.unit;
    shown["units_per_si"] = written.units_per_si;
    if (written.key.starts_with("unbalance")) shown["name"] = "unbalance";
    if (written.key.starts_with("balance_grade")) shown["name"] = "balance grade";
  }
  // A logarithmic axis cannot show 0.
  if (written.spacing && written.spacing->logarithmic && least > 0) shown["logarithmic"] = true;
  return shown;
}

json::array shown_axes(const PageContents& contents) {
  json::array axes;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<double>& values = contents.plane[i].values;
    axes.push_back(shown_axis(contents.written[i], std::ranges::min(values)));
  }
  return axes;
}

/// Line such as "N. N.: the note", with author and note if they are given.
std::string byline(const batch::Captions& captions) {
  const bool both = !captions.author.empty() && !captions.note.empty();
  return captions.author + (both ? ": " : "") + captions.note;
}

/// Kinds of motions as in response::motion::motion_kinds.
json::array motion_kinds() {
  json::array kinds;
  const auto css = [](std::uint32_t colour) { return fmt::format("#{:06X}", colour); };
  for (const response::motion::MotionKind& kind : response::motion::motion_kinds)
    kinds.push_back(json::object{{"name", kind.name},
                                 {"label", kind.label},
                                 {"colour", css(kind.colour)},
                                 {"dark", css(kind.dark_colour)},
                                 {"hatched", kind.hatched},
                                 {"settled_rub", kind.settled_rub}});
  return kinds;
}

/// Index for the script, which describes the data that follow in the page.
json::object index(const PageContents& contents, const std::vector<EncodedColumn>& columns) {
  const ThinnedGrid& kept = contents.kept;
  json::object orbits{{"recorded", contents.orbits.recorded},
                      {"speed_stride", kept.speed_stride},
                      {"unbalance_stride", kept.unbalance_stride},
                      {"cells_per_block", cells_per_block}};
  if (contents.refined)
    orbits["cells"] = json::array(contents.orbits.cells.begin(), contents.orbits.cells.end());
  json::array names;
  for (std::size_t i = 0; i < columns.size(); ++i)
    names.push_back(json::object{{"name", contents.map.columns[i].name}, {"words", words(columns[i].words)}});
  return {{"version", contents.version},
          {"digest", contents.map.digest},
          {"motion_kinds", motion_kinds()},
          {"across", contents.plane[0].name},
          {"speed_hz", numbers(contents.plane[0].values)},
          {"measure", contents.plane[1].name},
          {"unbalance", numbers(contents.plane[1].values)},
          {"shown_axes", shown_axes(contents)},
          {"unbalance_measure", contents.unbalance_measure},
          {"keys", words(contents.keys)},
          {"columns", names},
          {"wall_lists", wall_lists(contents.walls)},
          {"wall_list_of_keys", numbers(contents.walls.list_of_keys)},
          {"boundaries", boundaries(contents)},
          {"orbits", orbits}};
}

std::string data_element(const std::string& id, const std::string& text) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, text);
}

std::string data(const PageContents& contents) {
  std::vector<EncodedColumn> columns;
  for (const MapColumn& column : contents.map.columns) columns.push_back(encode_column(column));
  std::string text = data_element("index", json_text(index(contents, columns)));
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += data_element(fmt::format("column-{}", i), columns[i].data);
  for (std::size_t i = 0; i < contents.orbits.blocks.size(); ++i)
    text += data_element(fmt::format("orbits-{}", i), contents.orbits.blocks[i]);
  return text;
}

std::string list(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += fmt::format("<li>{}</li>\n", html_text(sentence));
  return text;
}

/// Document with each {{name}} replaced by its value. Names inside values are not replaced.
std::string filled(std::string_view form, const std::map<std::string_view, std::string>& values) {
  std::string text;
  while (true) {
    const std::size_t open = form.find("{{");
    text += form.substr(0, open);
    if (open == std::string_view::npos) return text;
    const std::size_t close = form.find("}}", open);
    text += values.at(form.substr(open + 2, close - open - 2));
    form.remove_prefix(close + 2);
  }
}

}  // namespace

EncodedColumn encode_column(const MapColumn& column) {
  EncodedColumn encoded;
  std::string records, planes;
  if (!column.numbers.empty()) {
    for (const double number : column.numbers) append(records, number);
    append_planes(planes, records, 8);
  } else {
    std::unordered_map<std::string, std::uint32_t> places;
    for (const std::string& word : column.words) {
      const auto [found, is_new] = places.try_emplace(word, static_cast<std::uint32_t>(places.size()));
      if (is_new) encoded.words.push_back(word);
      append(records, found->second);
    }
    append_planes(planes, records, 4);
  }
  encoded.data = compressed(planes);
  return encoded;
}

std::string page_text(const PageContents& contents) {
  return filled(document.text,
                {{"policy", policy()},
                 {"style", std::string(style.text)},
                 {"library", std::string(library.text)},
                 {"script", std::string(script.text)},
                 {"data", data(contents)},
                 {"title", html_text(contents.captions.title.empty() ? "Rub map" : contents.captions.title)},
                 {"byline", html_text(byline(contents.captions))},
                 {"findings", list(contents.findings)},
                 {"model", html_text(contents.model)},
                 {"configuration", html_text(contents.configuration)},
                 {"version", html_text(contents.version)},
                 {"digest", html_text(contents.map.digest)},
                 {"licence", html_text(std::string(library_licence.text))}});
}

}  // namespace rubsweep::page
