#include "sim/disposal/grasp.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/disposal/charge.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

// Durations are sums of steps: rounding must not make a step of difference.
constexpr double kRounding = 1e-6;  // [s]

constexpr std::array<int, 5> kGraspingLines = {kL1, kL2, kL3, kL5, kL9};

/// l1 and l2 leave the charge on either side of the pad; their mean is what the pad presses on.
double ProductOfNormals(const HandLines& lines) {
  const Vector3d left = lines[kL1].normal + lines[kL2].normal;
  constexpr double kNoSide = 1e-6;
  return left.norm() < kNoSide ? 0 : left.normalized().dot(lines[kL5].normal);
}

}  // namespace

int GraspCandidate(const HandLines& lines) {
  const int charge = lines[kL1].charge;
  const bool all = std::all_of(kGraspingLines.begin(), kGraspingLines.end(),
                               [&](int line) { return lines[line].charge == charge; });
  return all ? charge : -1;
}

bool IsHeldWell(const Grip& grip, const GraspRules& rules) {
  const double along = std::abs(grip.X_MO.linear().col(2).dot(grip.closing_M));
  return grip.lines[kL4].charge < 0 && ProductOfNormals(grip.lines) < rules.opposed_below &&
         along < std::sin(rules.across) &&
         std::abs(grip.gap - 2 * grip.charge.radius) <= 2 * rules.pad;
}

bool GuardsHold(const Grip& grip, const GraspRules& rules) {
  const bool on_surface = std::all_of(kGraspingLines.begin(), kGraspingLines.end(), [&](int line) {
    return IsOnCharge(grip.charge, grip.X_MO, grip.lines[line].point, rules.surface_tolerance);
  });
  return on_surface && IsHeldWell(grip, rules) &&
         grip.closing_age <= rules.close_memory + kRounding &&
         grip.relative_speed < rules.relative_speed && grip.tilt < rules.tilt &&
         grip.mass <= grip.payload;
}

bool Grasp::Close(int candidate, const Grip* grip) {
  steps_ = candidate >= 0 && candidate == candidate_ ? steps_ + 1 : candidate >= 0 ? 1 : 0;
  candidate_ = candidate;
  if (candidate < 0 || steps_ < rules_.steps) return false;
  return mode_ == GraspMode::kPaper || GuardsHold(*grip, rules_);
}

void Grasp::Hold(int charge, const Eigen::Isometry3d& X_GO, double left, double right, bool well) {
  Reset();
  charge_ = charge;
  X_GO_ = X_GO;
  left_ = left;
  right_ = right;
  well_ = well;
}

bool Grasp::IsLetGo(bool opening_commanded, double left, double right) const {
  // J7 is the mean of both hands. A nanometre: rounding must not cost a step.
  const double grown = (left + right) / 2 - (left_ + right_) / 2;
  return is_held() && opening_commanded && grown >= rules_.release - 1e-9;
}

bool Grasp::Slip(bool too_heavy, const Eigen::Vector3d& down_G, double dt_s) {
  is_slipping_ = is_held() && (too_heavy || !well_);
  if (!is_slipping_) return false;
  slipped_s_ += dt_s;
  X_GO_.translation() += rules_.slip_speed * dt_s * down_G;
  return slipped_s_ >= rules_.slip - kRounding;
}

void Grasp::Release() { Reset(); }

bool Grasp::Squeeze(bool pressed, double dt_s) {
  squeezed_s_ = pressed && !is_held() ? squeezed_s_ + dt_s : 0;
  return squeezed_s_ > rules_.squeeze + kRounding;
}

}  // namespace eod::sim
