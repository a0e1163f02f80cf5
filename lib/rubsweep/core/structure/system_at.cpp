#include "rubsweep/core/structure/system_at.hpp"

namespace rubsweep::structure {

LinearSystem system_at(const Assembly& assembly, double speed_rad_per_s) {
  LinearSystem system = assembly.system;
  if (assembly.gyroscopic.size() > 0) system.damping += speed_rad_per_s * assembly.gyroscopic;
  if (assembly.circulatory.size() > 0) system.stiffness += speed_rad_per_s * assembly.circulatory;
  for (const TabledSupport& support : assembly.tables)
    add_lacking(support, speed_rad_per_s, system.mass, system.damping, system.stiffness);
  return system;
}

}  // namespace rubsweep::structure
