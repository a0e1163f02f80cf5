#include "rubsweep/measurement/diagnose/features/feature.hpp"

#include <utility>

namespace rubsweep::diagnose::features {

void add(Features& features, std::string name, double value) { features.push_back({std::move(name), value}); }

}  // namespace rubsweep::diagnose::features
