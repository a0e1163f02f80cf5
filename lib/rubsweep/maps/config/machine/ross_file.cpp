#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/ross_elements.hpp"
#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/other_documents.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view allowed_ross_file = "a TOML or JSON file of ROSS, named relative to this one";

class KitOfElements {
 public:
  /// `file`: place of problems that concern the file as a whole.
  KitOfElements(yaml::Value file, RossSettings settings) : file_(std::move(file)), settings_(settings) {}

  /// Builds the kit. `sound`: no problem was found in the file yet. Relations between elements are checked
  /// only if each element is valid: an invalid element would otherwise cause misleading problems.
  model::RotorKit build(const RossSections& elements, bool sound) {
    const std::size_t problems = file_.diagnostics.count();
    std::vector<AtNode<model::ShaftSegment>> shaft;
    std::vector<AtNode<model::Disc>> discs;
    std::vector<AtNode<RossMass>> masses;
    std::vector<AtNode<RossSupport>> supports;
    for (const RossElement& element : elements.shaft) shaft.push_back(read_ross_shaft(element));
    for (const RossElement& element : elements.discs) discs.push_back(read_ross_disc(element));
    for (const RossElement& element : elements.masses) masses.push_back(read_ross_mass(element));
    for (const RossElement& element : elements.supports)
      supports.push_back(read_ross_support(element, settings_.whirl_tables));
    if (!sound || file_.diagnostics.count() > problems) return {};
    add_shaft(std::move(shaft));
    if (file_.diagnostics.count() > problems) return {};
    for (const auto& disc : discs) add_disc(disc);
    for (const auto& mass : masses) add_mass(mass);
    for (auto& support : supports) add_support(std::move(support));
    if (file_.diagnostics.count() > problems) return {};
    if (kit_.supports.empty()) refuse(file_, "has no bearing", "supports that hold the shaft");
    refuse_useless_housings();
    add_damping();
    return kit_;
  }

 private:
  int last_node() const { return static_cast<int>(node_m_.size()) - 1; }

  /// Elements at one node are layers of one segment, sorted by E D^4 (Young's modulus, outer diameter), the
  /// largest first.
  void add_shaft(std::vector<AtNode<model::ShaftSegment>> elements) {
    std::map<int, std::vector<AtNode<model::ShaftSegment>>> by_node;
    for (auto& shaft : elements) by_node[shaft.node].push_back(std::move(shaft));
    if (elements.empty()) refuse(file_, "has no shaft element", "at least one ShaftElement");
    node_m_.push_back(0);
    for (auto& [node, layers] : by_node) {
      if (node != last_node()) {
        refuse(layers.front().element->value,
               fmt::format("stands on node {}, and no shaft element on node {}", node, last_node()),
               "nodes from 0 on without a gap");
        return;
      }
      std::ranges::stable_sort(layers, std::ranges::greater{}, [](const auto& layer) {
        return layer.part.youngs_modulus_pa * std::pow(layer.part.outer_diameter_m, 4);
      });
      kit_.shaft.push_back(joined(layers));
      node_m_.push_back(node_m_.back() + kit_.shaft.back().length_m);
    }
  }

  static model::ShaftSegment joined(const std::vector<AtNode<model::ShaftSegment>>& layers) {
    constexpr double rounding = 1e-9;
    model::ShaftSegment segment = layers.front().part;
    for (std::size_t i = 1; i < layers.size(); ++i) {
      if (std::abs(layers[i].part.length_m - segment.length_m) > rounding * segment.length_m) {
        refuse(layers[i].element->value,
               fmt::format("is {} m long, and '{}' on the same node {} m", layers[i].part.length_m,
                           layers.front().element->tag, segment.length_m),
               "layers of one length");
      }
      segment.layers.push_back(layers[i].part);
    }
    return segment;
  }

  /// Adds damping to the whole rotor: in proportion to all masses, and to the stiffness of all shaft
  /// elements.
  void add_damping() {
    kit_.mass_damping_per_s = settings_.mass_damping_per_s;
    for (model::ShaftSegment& segment : kit_.shaft) {
      segment.stiffness_damping_s += settings_.stiffness_damping_s;
      for (model::ShaftLayer& layer : segment.layers)
        layer.stiffness_damping_s += settings_.stiffness_damping_s;
    }
  }

  bool is_on_shaft(int node) const { return node <= last_node(); }

  void add_disc(AtNode<model::Disc> disc) {
    if (!is_on_shaft(disc.node)) {
      refuse_node(*disc.element, disc.node);
      return;
    }
    disc.part.position_m = node_m_[static_cast<std::size_t>(disc.node)];
    disc.part.name = disc.element->tag;
    kit_.discs.push_back(disc.part);
  }

  void refuse_node(const RossElement& element, int node) const {
    refuse(element.value, fmt::format("stands on node {}, which is not of the shaft", node),
           fmt::format("a node from 0 to {}", last_node()));
  }

  void add_mass(const AtNode<RossMass>& mass) {
    const auto& [x_kg, y_kg] = mass.part;
    const std::optional<double> other = y_kg == x_kg ? std::nullopt : std::optional(y_kg);
    if (is_on_shaft(mass.node)) {
      kit_.point_masses.push_back(
          {node_m_[static_cast<std::size_t>(mass.node)], x_kg, other, mass.element->tag});
      return;
    }
    const auto [found, is_new] =
        housing_of_node_.try_emplace(mass.node, static_cast<int>(kit_.housings.size()));
    if (is_new) {
      kit_.housings.push_back({x_kg, other, mass.element->tag});
      housing_elements_.push_back(&mass.element->value);
      return;
    }
    model::Housing& housing = kit_.housings[static_cast<std::size_t>(found->second)];
    const double sum_y = housing.mass_y_kg.value_or(housing.mass_kg) + y_kg;
    housing.mass_kg += x_kg;
    housing.mass_y_kg = sum_y == housing.mass_kg ? std::nullopt : std::optional(sum_y);
  }

  std::optional<int> housing_at(const RossElement& element, int node) const {
    const auto found = housing_of_node_.find(node);
    if (found != housing_of_node_.end()) return found->second;
    return refuse(element.value,
                  fmt::format("names node {}, where neither the shaft nor a PointMass stands", node),
                  fmt::format("a node of the shaft, 0 to {}, or one with a PointMass", last_node()));
  }

  void add_support(AtNode<RossSupport> read) {
    model::Support& support = read.part.support;
    support.name = read.element->name;
    if (is_on_shaft(read.node)) {
      support.position_m = node_m_[static_cast<std::size_t>(read.node)];
    } else {
      support.at_housing = housing_at(*read.element, read.node);
      if (!support.at_housing) return;
    }
    if (const auto link = read.part.linked_node) {
      if (is_on_shaft(*link)) {
        refuse(read.element->value, fmt::format("is linked to node {} of the shaft", *link),
               "an n_link beyond the shaft");
        return;
      }
      support.on_housing = housing_at(*read.element, *link);
    }
    if (const auto problem = model::housing_problem(support))
      refuse(read.element->value, problem->wrong, problem->allowed);
    kit_.supports.push_back(std::move(support));
  }

  /// Refuses a housing that no support touches: it would have no effect.
  void refuse_useless_housings() const {
    for (const auto& [node, housing] : housing_of_node_) {
      const int number = housing;
      const bool used = std::ranges::any_of(kit_.supports, [&](const model::Support& support) {
        return support.at_housing == number || support.on_housing == number;
      });
      if (used) continue;
      refuse(*housing_elements_[static_cast<std::size_t>(number)],
             fmt::format("stands on node {}, which no bearing reaches", node),
             fmt::format("a node of the shaft, 0 to {}, or one that a bearing is linked to", last_node()));
    }
  }

  yaml::Value file_;
  RossSettings settings_;
  model::RotorKit kit_;
  std::vector<double> node_m_;
  std::map<int, int> housing_of_node_;
  std::vector<const yaml::Value*> housing_elements_;
};

/// Keys of a disc's unbalance, without the tag.
void visit_unbalance(auto& disc, auto&& visit) {
  using model::key, model::any_finite, model::physical::per_eccentricity;
  visit("eccentricity_ratio", disc.eccentricity_ratio,
        key(per_eccentricity,
            "distance of the centre of mass from the axis, per metre of the cell's eccentricity"));
  visit("eccentricity_phase_deg", disc.eccentricity_phase_deg, key(any_finite, "angle of that distance"));
  visit("skew_rad_per_m", disc.skew_rad_per_m, key(per_eccentricity, "lean of the axis of inertia"));
  visit("skew_phase_deg", disc.skew_phase_deg, key(any_finite, "angle of that lean"));
}

/// Reads the unbalance of discs, named by their tags. Discs that are not named become balanced.
void read_unbalance(const yaml::Value& list, const RossSections& elements, model::RotorKit& kit) {
  const auto items = read_list(list, model::RotorKit::most_parts);
  if (items.empty() || kit.discs.size() != elements.discs.size()) return;
  std::vector<std::string_view> tags;
  for (const RossElement& disc : elements.discs) tags.push_back(disc.tag);
  for (model::Disc& disc : kit.discs) disc.eccentricity_ratio = 0;
  for (const yaml::Value& item : items) {
    yaml::Section section(item);
    const auto tag = section.require("disc", yaml::describe(tags));
    model::Disc unbalance;
    visit_unbalance(unbalance, model::fields_into(section));
    section.refuse_unknown_keys();
    const auto index = tag ? yaml::read_word(*tag, tags) : std::nullopt;
    if (!index) continue;
    model::Disc& disc = kit.discs[*index];
    disc.eccentricity_ratio = unbalance.eccentricity_ratio;
    disc.eccentricity_phase_deg = unbalance.eccentricity_phase_deg;
    disc.skew_rad_per_m = unbalance.skew_rad_per_m;
    disc.skew_phase_deg = unbalance.skew_phase_deg;
  }
}

std::optional<yaml::Node> parse(const yaml::Value& name, const std::filesystem::path& file) {
  const yaml::FileBytes bytes = yaml::read_bytes(file);
  if (!bytes.problem.empty())
    return refuse(name, fmt::format("'{}' cannot be read: {}", yaml::shown(name.node.text), bytes.problem),
                  allowed_ross_file);
  const bool json = file.extension() == ".json";
  if (!json && file.extension() != ".toml")
    return refuse(name, fmt::format("'{}' ends neither in .toml nor in .json", yaml::shown(name.node.text)),
                  allowed_ross_file);
  const int index = name.diagnostics.add_file(yaml::shown(file.string(), yaml::max_text_bytes));
  auto root = json ? yaml::parse_json(bytes.text, name.path, name.diagnostics, index)
                   : yaml::parse_toml(bytes.text, name.path, name.diagnostics, index);
  if (!root || root->kind == yaml::Node::Kind::map) return root;
  return yaml::refuse({*root, name.path, name.diagnostics}, yaml::describe(*root) + " and no rotor",
                      "a map of elements");
}

}  // namespace

model::RotorKit read_ross_rotor(yaml::Section& section) {
  model::RotorKit kit;
  const auto name = section.require("file", allowed_ross_file);
  const auto unbalance = section.find("unbalance");
  const auto text = name ? read_text(*name) : std::nullopt;
  if (text) {
    const std::filesystem::path beside = name->diagnostics.file_of(name->node.place);
    if (const auto root = parse(*name, beside.parent_path() / *text)) {
      const std::size_t problems = name->diagnostics.count();
      const yaml::Value file{*root, "", name->diagnostics};
      const RossSections elements = read_ross_sections(file);
      const RossSettings settings = read_ross_settings(file);
      kit = KitOfElements({*root, name->path, name->diagnostics}, settings)
                .build(elements, name->diagnostics.count() == problems);
      if (unbalance) read_unbalance(*unbalance, elements, kit);
    }
  }
  // Elements of the file are not divided, except by a stop or a sensor between two nodes.
  kit.elements = 1;
  kit.from_file = true;
  read_kit_rest(section, kit);
  if (name && section.is_sound()) refuse_loose_shaft(*name, kit);
  return kit;
}

std::vector<keys::Key> ross_keys() {
  using namespace keys;
  const auto of_disc = [](Table& table) {
    const model::Disc disc;
    visit_unbalance(disc, model::fields_into(table));
  };
  std::vector<Key> keys =
      newer({must("file", text(), "file of ROSS, TOML or JSON, its name relative to this one"),
             may("unbalance",
                 list_of(map_of(joined({{must("disc", text(), "tag of the disc")}, keys_by(of_disc)})), 1,
                         model::RotorKit::most_parts),
                 "discs that stand off the axis; those that are not named are balanced",
                 "(all, with a ratio of 1)")});
  for (Key& key : kit_rest_keys()) {
    if (key.name == "elements") key.fallback = "1";
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::machine
