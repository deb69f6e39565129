#include "tests/reference/double_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eod::reference {

using Eigen::Vector3d;
using sim::Accepts;
using sim::CollisionTriangle;
using sim::FaceRule;
using sim::kEndTolerance;
using sim::SegmentQuery;
using sim::Triangle;

namespace {

constexpr int kLeafSize = 4;
constexpr int kBins = 16;
constexpr int kMaxDepth = 48;        // beyond this a branch becomes one leaf, whatever its size
constexpr double kBoxMargin = 1e-6;  // [m] more than any rounding of the exact test

void Improve(Nearest& nearest, double range, int triangle) {
  const bool better = nearest.triangle < 0 || range < nearest.range ||
                      (range == nearest.range && triangle < nearest.triangle);
  if (better) nearest = {range, triangle};
}

}  // namespace

PreparedSegment::PreparedSegment(const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                                 double length, FaceRule face_rule)
    : start_(start), length_(length), front_only_(face_rule == FaceRule::kFrontOnly) {
  direction.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  // Keeps the winding of triangles when the segment runs towards the negative axis.
  if (direction[z_] < 0) std::swap(x_, y_);
  shear_x_ = direction[x_] / direction[z_];
  shear_y_ = direction[y_] / direction[z_];
  scale_z_ = 1 / direction[z_];
}

std::optional<double> PreparedSegment::Meet(const Triangle& triangle) const {
  const Eigen::Vector3d a = triangle[0] - start_;
  const Eigen::Vector3d b = triangle[1] - start_;
  const Eigen::Vector3d c = triangle[2] - start_;
  const double ax = a[x_] - shear_x_ * a[z_], ay = a[y_] - shear_y_ * a[z_];
  const double bx = b[x_] - shear_x_ * b[z_], by = b[y_] - shear_y_ * b[z_];
  const double cx = c[x_] - shear_x_ * c[z_], cy = c[y_] - shear_y_ * c[z_];
  // Signed areas against the three edges; the two triangles of an edge see exactly opposite values.
  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  const bool any_negative = u < 0 || v < 0 || w < 0;
  const bool any_positive = u > 0 || v > 0 || w > 0;
  if (any_negative && (any_positive || front_only_)) return std::nullopt;
  const double area = u + v + w;
  if (area == 0) return std::nullopt;
  const double range = (u * a[z_] + v * b[z_] + w * c[z_]) * scale_z_ / area;
  if (!(range >= -kEndTolerance && range <= length_ + kEndTolerance)) return std::nullopt;
  return std::clamp(range, 0.0, length_);
}

Nearest TryEveryTriangle(std::span<const CollisionTriangle> triangles, const SegmentQuery& query) {
  const PreparedSegment segment(query.start, query.direction, query.length, query.face_rule);
  Nearest nearest;
  for (size_t i = 0; i < triangles.size(); ++i) {
    if (!Accepts(query.class_mask, triangles[i].class_mask)) continue;
    const std::optional<double> range = segment.Meet(triangles[i].corner);
    if (range) Improve(nearest, *range, static_cast<int>(i));
  }
  return nearest;
}

struct DoubleTree::Item {
  Box box;
  Vector3d centre;
  uint32_t class_mask;
  int triangle;
};

struct DoubleTree::Split {
  int axis;
  double position;
};

/// Inverse direction for slab tests; a component of 0 becomes a huge number, never infinite, so
/// that no NaN arises on a box's face.
struct DoubleTree::Ray {
  Vector3d start, inverse;

  Ray(const Vector3d& start_in, const Vector3d& direction) : start(start_in) {
    for (int axis = 0; axis < 3; ++axis) {
      const double d = direction[axis];
      inverse[axis] = 1 / (std::abs(d) > 1e-30 ? d : std::copysign(1e-30, d));
    }
  }

  /// Range at which the box is entered, infinity if it is missed within `length`.
  double Enter(const Box& box, double length) const {
    double enter = 0, leave = length;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.low[axis] - start[axis]) * inverse[axis];
      const double b = (box.high[axis] - start[axis]) * inverse[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
  }
};

namespace {

/// Bounds of a growing set, and its surface.
struct Bounds {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  int count = 0;

  void Add(const Vector3d& other_low, const Vector3d& other_high, int items) {
    low = low.cwiseMin(other_low);
    high = high.cwiseMax(other_high);
    count += items;
  }
  double Cost() const {
    if (count == 0) return 0;
    const Vector3d d = high - low;
    return count * (d.x() * d.y() + d.y() * d.z() + d.z() * d.x());
  }
};

}  // namespace

DoubleTree::DoubleTree(std::span<const CollisionTriangle> triangles) {
  std::vector<Item> items;
  items.reserve(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& corner = triangles[i].corner;
    Box box{corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
            corner[0].cwiseMax(corner[1]).cwiseMax(corner[2])};
    const Vector3d centre = (box.low + box.high) / 2;
    box.low.array() -= kBoxMargin;
    box.high.array() += kBoxMargin;
    items.push_back({box, centre, triangles[i].class_mask, static_cast<int>(i)});
  }
  nodes_.emplace_back();
  if (!items.empty()) Build(0, items, 0, 0);
  entries_.reserve(items.size());
  for (const Item& item : items) {
    entries_.push_back(
        {triangles[static_cast<size_t>(item.triangle)].corner, item.class_mask, item.triangle});
  }
}

std::optional<DoubleTree::Split> DoubleTree::BestSplit(std::span<const Item> items) {
  Bounds centres;
  for (const Item& item : items) centres.Add(item.centre, item.centre, 1);
  double best_cost = std::numeric_limits<double>::infinity();
  std::optional<Split> best;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = centres.low[axis], width = centres.high[axis] - low;
    if (!(width > 0)) continue;
    std::array<Bounds, kBins> bins;
    for (const Item& item : items) {
      const int bin = static_cast<int>((item.centre[axis] - low) / width * kBins);
      bins[static_cast<size_t>(std::min(bin, kBins - 1))].Add(item.box.low, item.box.high, 1);
    }
    // Cost of everything right of each cut, then sweep from the left.
    std::array<double, kBins> right_cost{};
    Bounds right;
    for (size_t i = kBins - 1; i > 0; --i) {
      right.Add(bins[i].low, bins[i].high, bins[i].count);
      right_cost[i] = right.Cost();
    }
    Bounds left;
    for (size_t i = 1; i < kBins; ++i) {
      left.Add(bins[i - 1].low, bins[i - 1].high, bins[i - 1].count);
      const double cost = left.Cost() + right_cost[i];
      if (cost < best_cost) {
        best_cost = cost;
        best = Split{axis, low + width * static_cast<double>(i) / kBins};
      }
    }
  }
  return best;
}

void DoubleTree::Build(int node, std::span<Item> items, int offset, int depth) {
  Bounds bounds;
  uint32_t classes = 0;
  for (const Item& item : items) {
    bounds.Add(item.box.low, item.box.high, 1);
    classes |= item.class_mask;
  }
  nodes_[static_cast<size_t>(node)] = {
      {bounds.low, bounds.high}, classes, offset, static_cast<int>(items.size())};
  if (items.size() <= kLeafSize || depth >= kMaxDepth) return;
  const std::optional<Split> split = BestSplit(items);
  if (!split) return;
  const auto middle = std::stable_partition(items.begin(), items.end(), [&](const Item& item) {
    return item.centre[split->axis] < split->position;
  });
  const auto left_count = static_cast<size_t>(middle - items.begin());
  if (left_count == 0 || left_count == items.size()) return;
  const int first = static_cast<int>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[static_cast<size_t>(node)].first = first;
  nodes_[static_cast<size_t>(node)].count = 0;
  Build(first, items.first(left_count), offset, depth + 1);
  Build(first + 1, items.subspan(left_count), offset + static_cast<int>(left_count), depth + 1);
}

void DoubleTree::TestLeaf(const Node& node, const PreparedSegment& segment, uint32_t class_mask,
                          Nearest& nearest) const {
  for (int i = node.first; i < node.first + node.count; ++i) {
    const Entry& entry = entries_[static_cast<size_t>(i)];
    if (!Accepts(class_mask, entry.class_mask)) continue;
    const std::optional<double> range = segment.Meet(entry.corner);
    if (!range) continue;
    Improve(nearest, *range, entry.triangle);
  }
}

Nearest DoubleTree::Cast(const SegmentQuery& query) const {
  const Ray ray(query.start, query.direction);
  const PreparedSegment segment(query.start, query.direction, query.length, query.face_rule);
  struct Waiting {
    int node;
    double enter;
  };
  std::array<Waiting, kMaxDepth + 2> stack;
  size_t waiting = 0;
  Nearest nearest;
  double reach = query.length;
  const auto enter = [&](int index) {
    const Node& node = nodes_[static_cast<size_t>(index)];
    return Accepts(query.class_mask, node.classes) ? ray.Enter(node.box, reach)
                                                   : std::numeric_limits<double>::infinity();
  };
  if (!entries_.empty() && std::isfinite(enter(0))) stack[waiting++] = {0, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.enter > reach) continue;
    const Node& node = nodes_[static_cast<size_t>(next.node)];
    if (node.count > 0) {
      TestLeaf(node, segment, query.class_mask, nearest);
      if (nearest.triangle >= 0) reach = nearest.range;
      continue;
    }
    // The nearer child is looked into first, so it goes on the stack last.
    Waiting near{node.first, enter(node.first)}, far{node.first + 1, enter(node.first + 1)};
    if (far.enter < near.enter) std::swap(near, far);
    if (std::isfinite(far.enter)) stack[waiting++] = far;
    if (std::isfinite(near.enter)) stack[waiting++] = near;
  }
  return nearest;
}

}  // namespace eod::reference
