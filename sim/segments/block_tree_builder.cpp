#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "sim/segments/block_packer.h"
#include "sim/segments/block_tree.h"
#include "sim/segments/split.h"

namespace eod::sim {
namespace {

constexpr int kDeepest = 24;  // levels; below, ranges are halved by count

struct Range {
  size_t first = 0, count = 0;
  Box4 box, centres;

  double Cost() const { return HalfArea(box) * static_cast<double>(count); }
};

class Builder {
 public:
  explicit Builder(std::span<const CollisionTriangle> triangles)
      : triangles_(triangles), packer_(triangles, tree_) {
    items_.reserve(triangles.size());
    for (size_t i = 0; i < triangles.size(); ++i) items_.push_back(ItemOf(triangles[i], i));
  }

  BlockTree Build() && {
    if (!items_.empty()) {
      Reserve();
      const std::vector<Range> classes = PartByClass();
      BuildForest(classes);
    }
    packer_.Finish();
    return std::move(tree_);
  }

 private:
  static Item ItemOf(const CollisionTriangle& triangle, size_t index);
  Range RangeOf(size_t first, size_t count) const;
  void Split(const Range& range, bool halve, Range& left, Range& right);
  std::vector<Range> PartByClass();
  int32_t BuildForest(std::span<const Range> ranges);
  int32_t BuildNode(std::span<const Range> ranges, int depth);
  int SplitToChildren(std::span<const Range> ranges, int depth,
                      std::array<Range, kFanOut>& children);
  void AddChild(int32_t node, int place, const Box4& box, int32_t child);
  void Reserve();

  std::span<const CollisionTriangle> triangles_;
  std::vector<Item> items_;
  BlockTree tree_;
  BlockPacker packer_;
};

Item Builder::ItemOf(const CollisionTriangle& triangle, size_t index) {
  Item item;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = triangle.corner[0][axis], b = triangle.corner[1][axis],
                 c = triangle.corner[2][axis];
    if (!(std::abs(a) <= 1e6 && std::abs(b) <= 1e6 && std::abs(c) <= 1e6)) {
      throw std::invalid_argument("a triangle's corner is not finite or beyond 1e6 m");
    }
    item.low[axis] = static_cast<float>(std::min({a, b, c}));
    item.high[axis] = static_cast<float>(std::max({a, b, c}));
  }
  item.low[3] = 0;
  item.high[3] = std::bit_cast<float>(static_cast<uint32_t>(index));
  return item;
}

Range Builder::RangeOf(size_t first, size_t count) const {
  Range range{.first = first, .count = count, .box = {}, .centres = {}};
  for (size_t i = first; i < first + count; ++i) Grow(items_[i], range.box, range.centres);
  return range;
}

void Builder::Split(const Range& range, bool halve, Range& left, Range& right) {
  const std::span items(&items_[range.first], range.count);
  left = {.first = range.first, .count = 0, .box = {}, .centres = {}};
  right = left;
  if (const Cut cut = halve ? Cut{} : BestCut(items, range.centres); cut.axis >= 0) {
    size_t end = items.size();
    while (left.count < end) {
      if (Item& item = items[left.count]; cut.IsLeft(item)) {
        Grow(item, left.box, left.centres);
        ++left.count;
      } else {
        Grow(item, right.box, right.centres);
        std::swap(item, items[--end]);
      }
    }
    right.first += left.count;
    right.count = range.count - left.count;
    return;
  }
  const int axis = WidestAxis(range.centres);
  const size_t half = range.count / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const Item& one, const Item& other) {
                     const float a = CentreOf(one, axis), b = CentreOf(other, axis);
                     return a != b ? a < b : one.index() < other.index();
                   });
  left = RangeOf(range.first, half);
  right = RangeOf(range.first + half, range.count - half);
}

/// One range for each class mask, so that a mask passes over whole branches and blocks.
std::vector<Range> Builder::PartByClass() {
  const auto class_of = [this](const Item& item) { return triangles_[item.index()].class_mask; };
  const auto by_class = [&](const Item& one, const Item& other) {
    return class_of(one) < class_of(other);
  };
  // Most worlds come in few runs of one class each: the sort is for those that do not.
  if (!std::is_sorted(items_.begin(), items_.end(), by_class)) {
    std::stable_sort(items_.begin(), items_.end(), by_class);
  }
  std::vector<Range> ranges;
  for (size_t first = 0; first < items_.size();) {
    size_t end = first + 1;
    while (end < items_.size() && class_of(items_[end]) == class_of(items_[first])) ++end;
    ranges.push_back(RangeOf(first, end - first));
    first = end;
  }
  return ranges;
}

/// A node above any number of ranges: eight at once, or eight forests.
int32_t Builder::BuildForest(std::span<const Range> ranges) {
  if (ranges.size() <= kFanOut) return BuildNode(ranges, 0);
  const auto index = static_cast<int32_t>(tree_.nodes.size());
  tree_.nodes.push_back(EmptyNode());
  const size_t each = (ranges.size() + kFanOut - 1) / kFanOut;
  int place = 0;
  for (size_t first = 0; first < ranges.size(); first += each) {
    const auto part = ranges.subspan(first, std::min(each, ranges.size() - first));
    Box4 box;
    for (const Range& range : part) Include(range.box, box);
    AddChild(index, place++, box, BuildForest(part));
  }
  return index;
}

/// Cuts the largest range again and again until there are eight, or only blocks.
int Builder::SplitToChildren(std::span<const Range> ranges, int depth,
                             std::array<Range, kFanOut>& children) {
  auto count = static_cast<int>(ranges.size());
  std::copy(ranges.begin(), ranges.end(), children.begin());
  while (count < kFanOut) {
    int largest = -1;
    for (int i = 0; i < count; ++i) {
      const Range& child = children[static_cast<size_t>(i)];
      if (child.count <= kBlockSize) continue;
      if (largest < 0 || child.Cost() > children[static_cast<size_t>(largest)].Cost()) largest = i;
    }
    if (largest < 0) break;
    Range left, right;
    Split(children[static_cast<size_t>(largest)], depth >= kDeepest, left, right);
    children[static_cast<size_t>(largest)] = left;
    children[static_cast<size_t>(count++)] = right;
  }
  return count;
}

int32_t Builder::BuildNode(std::span<const Range> ranges, int depth) {
  std::array<Range, kFanOut> children;
  const int count = SplitToChildren(ranges, depth, children);
  const auto index = static_cast<int32_t>(tree_.nodes.size());
  tree_.nodes.push_back(EmptyNode());
  for (int i = 0; i < count; ++i) {
    const Range& child = children[static_cast<size_t>(i)];
    const int32_t entry = child.count <= kBlockSize
                              ? ~packer_.Pack({&items_[child.first], child.count})
                              : BuildNode({&child, 1}, depth + 1);
    AddChild(index, i, child.box, entry);
  }
  return index;
}

void Builder::AddChild(int32_t node, int place, const Box4& box, int32_t child) {
  constexpr float kFar = Box4::kFar;
  Node& parent = tree_.nodes[static_cast<size_t>(node)];
  for (int axis = 0; axis < 3; ++axis) {
    parent.low[axis][place] = std::nextafter(box.low[axis], -kFar);
    parent.high[axis][place] = std::nextafter(box.high[axis], kFar);
  }
  parent.child[place] = child;
  const int32_t block = ~child;
  parent.classes[place] = child < 0 ? tree_.places[static_cast<size_t>(block)].classes
                                    : ClassesBelow(tree_.nodes[static_cast<size_t>(child)]);
}

void Builder::Reserve() {
  const size_t blocks = items_.size() / 12 + 1;
  tree_.nodes.reserve(blocks / 3 + 1);
  packer_.Reserve(blocks);
}

}  // namespace

BlockTree BuildBlockTree(std::span<const CollisionTriangle> triangles) {
  return Builder(triangles).Build();
}

}  // namespace eod::sim
