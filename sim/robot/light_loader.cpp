#include <fmt/format.h>

#include "sim/robot/robot_parts.h"
#include "sim/robot/vocabulary.h"

namespace eod::sim {

SpotLightSpec ReadLight(const SdfLight& light, int link, const std::filesystem::path& file) {
  AllowElements(light.customs, {"lamp"}, "light " + light.name);
  const CustomElement* lamp = FindElement(light.customs, "lamp");
  if (!light.is_spot || lamp == nullptr) {
    FailAt(file, light.line,
           fmt::format("light {}: of a robot, only type=\"spot\" with <eod:lamp> is supported",
                       light.name));
  }
  lamp->AllowAttributes({"switch"});
  SpotLightSpec spec;
  spec.name = light.name;
  spec.link = link;
  spec.on_by = SwitchOf(*lamp, "switch");
  spec.X_LS = light.X_FS;
  spec.X_LS.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), light.direction));
  spec.light = light.light;
  spec.inner_angle = light.inner_angle / 2;
  spec.outer_angle = light.outer_angle / 2;
  return spec;
}

}  // namespace eod::sim
