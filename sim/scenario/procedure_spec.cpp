#include "sim/scenario/procedure_spec.h"

#include <array>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 4> kProcedureKeys = {"kind", "text", "before_step",
                                                            "distance_m"};
struct KindName {
  std::string_view name;
  std::string_view text;
};
constexpr std::array kKinds = {  // as the enum
    KindName{"estop_test", "Test the e-stop"},
    KindName{"lamp_test", "Test the lamps"},
    KindName{"camera_tour", "Look through all four cameras"},
    KindName{"two_camera_recon", "Look at the charge through two cameras before grasping it"},
    KindName{"horn_before_fire", "Sound the horn before firing"},
    KindName{"retreat_before_fire", "Keep the distance before firing"},
    KindName{"low_speed_while_carrying", "Carry at low speed"},
    KindName{"travel_pose_before_driving", "Draw the charge in before driving"},
    KindName{"arm_key_safe_until_still", "Arm only while the robot stands still"}};

const KindName& Entry(ProcedureSpec::Kind kind) { return kKinds[static_cast<size_t>(kind)]; }

}  // namespace

std::string_view NameOf(ProcedureSpec::Kind kind) { return Entry(kind).name; }
std::string_view TextOf(ProcedureSpec::Kind kind) { return Entry(kind).text; }
bool IsKeptAllTheTime(ProcedureSpec::Kind kind) {
  return kind >= ProcedureSpec::Kind::kLowSpeedWhileCarrying;
}

ProcedureSpec ReadProcedureSpec(const TomlTable& table) {
  table.RejectUnknownKeys(kProcedureKeys);
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) names[i] = kKinds[i].name;
  ProcedureSpec spec;
  spec.kind = static_cast<ProcedureSpec::Kind>(table.Choice("kind", names));
  spec.text = table.Text("text", "");
  spec.before_step = static_cast<int>(table.Integer("before_step", 1, 100, 0));
  const bool needs_distance = spec.kind == ProcedureSpec::Kind::kRetreatBeforeFire;
  spec.distance = needs_distance ? table.Number("distance_m", 0, 3000) : 0;
  return spec;
}

}  // namespace eod::sim
