#include "rubsweep/diagnose/feature.hpp"

#include <utility>

namespace rubsweep::diagnose {

void add(Features& features, std::string name, double value) { features.push_back({std::move(name), value}); }

}  // namespace rubsweep::diagnose
