#include "rubsweep/config/friction.hpp"

#include <fmt/format.h>

#include <variant>

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view none = "none";
constexpr std::string_view forms = "none, or a map with stribeck or coefficient";

model::StribeckFriction read_stribeck(const Value& value) {
  model::StribeckFriction friction;
  const std::size_t count = friction.gamma.size();
  const Node& node = value.node;
  if (node.kind != Node::Kind::list || node.items.size() != count) {
    const std::string wrong = node.kind == Node::Kind::list
                                  ? fmt::format("holds {} values", node.items.size())
                              : node.kind == Node::Kind::scalar ? describe(node) + " is not a list"
                                                                : describe(node);
    refuse(value, wrong, fmt::format("a list of {} numbers", count));
    return friction;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Value item{node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics};
    friction.gamma[i] = read_number(item, model::any_finite).value_or(0);
  }
  return friction;
}

}  // namespace

model::Friction read_friction(const Value& value) {
  if (value.node.kind == Node::Kind::scalar) {
    read_word(value, {&none, 1}, forms);
    return model::NoFriction{};
  }
  Section section(value, forms);
  model::Friction friction;
  section.require_exactly_one({"stribeck", "coefficient"});
  if (const auto stribeck = section.find("stribeck")) friction = read_stribeck(*stribeck);
  if (const auto coefficient = section.find("coefficient")) {
    const auto number = read_number(*coefficient, model::ConstantFriction::coefficient_range);
    friction = model::ConstantFriction{number.value_or(0)};
  }
  section.refuse_unknown_keys();
  return friction;
}

void print_friction(Printer& printer, const model::Friction& friction) {
  if (std::holds_alternative<model::NoFriction>(friction)) {
    printer.word("friction", none);
    return;
  }
  printer.open("friction");
  if (const auto* stribeck = std::get_if<model::StribeckFriction>(&friction)) {
    printer.numbers("stribeck", stribeck->gamma);
  } else {
    printer.number("coefficient", std::get<model::ConstantFriction>(friction).coefficient);
  }
  printer.close();
}

}  // namespace rubsweep::config
