#include "rubsweep/page/page.hpp"

#include <fmt/format.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <map>
#include <string_view>

#include "rubsweep/page/assets.hpp"
#include "rubsweep/page/compressed.hpp"
#include "rubsweep/page/encode_column.hpp"
#include "rubsweep/page/json_text.hpp"

namespace rubsweep::page {
namespace {

namespace json = boost::json;

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// "sha256-..." as a content security policy names what may run.
std::string policy_hash(const Asset& asset) {
  std::string bytes;
  for (std::size_t i = 0; i < asset.sha256.size(); i += 2)
    bytes.push_back(static_cast<char>(std::stoi(std::string(asset.sha256.substr(i, 2)), nullptr, 16)));
  return fmt::format("'sha256-{}'", base64(bytes));
}

/// Pictures are drawn by way of data: and blob: addresses, which stay inside the page.
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

/// What the script must know to read the data that follow.
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
          {"across", contents.plane[0].name},
          {"speed_hz", numbers(contents.plane[0].values)},
          {"measure", contents.plane[1].name},
          {"unbalance", numbers(contents.plane[1].values)},
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

/// The document with each {{name}} replaced by its value. What the values hold is not looked at again.
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

std::string page_text(const PageContents& contents) {
  return filled(document.text, {{"policy", policy()},
                                {"style", std::string(style.text)},
                                {"library", std::string(library.text)},
                                {"script", std::string(script.text)},
                                {"data", data(contents)},
                                {"findings", list(contents.findings)},
                                {"model", html_text(contents.model)},
                                {"configuration", html_text(contents.configuration)},
                                {"version", html_text(contents.version)},
                                {"digest", html_text(contents.map.digest)},
                                {"licence", html_text(library_licence.text)}});
}

}  // namespace rubsweep::page
