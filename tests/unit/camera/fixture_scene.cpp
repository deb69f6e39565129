#include "tests/unit/camera/fixture_scene.h"

#include <utility>

namespace eod::sim {
namespace {

using Eigen::Translation3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

LinkVisual LinkBox(int link, const Vector3d& size, const Vector3d& at, const Vector3f& colour) {
  Visual visual;
  visual.size = size;
  visual.X_OV = Translation3d(at);
  visual.material = {
      .diffuse = colour, .texture = "metal", .texture_scale_m = 0.8F, .specular = 0.2F};
  return {link, visual};
}

}  // namespace

RobotModel FixtureRobot() {
  RobotModel robot;
  robot.file = "fixture_robot.sdf";
  robot.name = "fixture";
  LinkSpec chassis;
  chassis.name = "chassis";
  LinkSpec pan;
  pan.name = "camera_pan";
  pan.parent = 0;
  pan.X_PL = Translation3d(-0.2, -0.25, 1.2);
  pan.kind = LinkSpec::Kind::kRevolute;
  pan.axis = Vector3d::UnitZ();
  pan.joint = kCameraPan;
  LinkSpec tilt;
  tilt.name = "camera_tilt";
  tilt.parent = 1;
  tilt.kind = LinkSpec::Kind::kRevolute;
  tilt.axis = Vector3d::UnitX();
  tilt.joint = kCameraTilt;
  robot.links = {chassis, pan, tilt};
  const Vector3f olive(0.19F, 0.22F, 0.12F);
  robot.visuals = {LinkBox(0, {0.7, 0.95, 0.35}, {0, 0, 0.275}, olive),
                   LinkBox(0, {0.05, 0.05, 0.7}, {-0.2, -0.25, 0.8}, olive),
                   LinkBox(0, {0.04, 0.5, 0.04}, {0.2, 0.7, 0.3}, {0.85F, 0.3F, 0.03F}),
                   LinkBox(2, {0.1, 0.1, 0.08}, {0, 0, 0}, olive)};
  CameraSpec drive;
  drive.name = "drive";
  drive.X_LC = Translation3d(0, 0.48, 0.4);
  CameraSpec mast;
  mast.name = "mast";
  mast.link = 2;
  mast.X_LC = Translation3d(0, 0.06, 0);
  mast.horizontal_fov = 1.05;
  robot.cameras = {drive, mast};
  return robot;
}

WorldObject GroundBox(const std::string& name, double x, double y, const Vector3d& size,
                      const Material& material) {
  WorldObject object;
  object.name = name;
  object.X_MO = Translation3d(x, y, size.z() / 2);
  Visual visual;
  visual.size = size;
  visual.material = material;
  object.visuals = {visual};
  return object;
}

WorldModel FixtureWorld() {
  const Vector3f white = Vector3f::Ones();
  const Material grass{white, "grass", 2.0F, 0.0F};
  const Material concrete{white, "concrete", 2.0F, 0.02F};
  const Material brick{white, "brick", 1.0F, 0.02F};
  ModuleModel module;
  module.id = 1;
  module.name = "flat";
  module.half_size = {20, 20};
  WorldObject ground = GroundBox("ground", 0, 0, {40, 40, 0.2}, grass);
  ground.X_MO = Translation3d(0, 0, -0.1);
  WorldObject yard = GroundBox("yard", 0, 0, {8, 8, 0.2}, concrete);
  yard.X_MO = Translation3d(0, 0, -0.095);
  module.objects = {ground, yard, GroundBox("wall", 0, 6.15, {6, 0.3, 2.5}, brick)};
  WorldModel world;
  world.file = "fixture_world.sdf";
  world.modules = {std::move(module)};
  return world;
}

RobotState StandingAt(double x, double y, double heading) {
  RobotState state;
  state.position = {x, y, 0};
  state.attitude.heading = heading;
  return state;
}

}  // namespace eod::sim
