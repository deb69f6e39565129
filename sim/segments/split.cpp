#include "sim/segments/split.h"

#include <algorithm>
#include <array>

namespace eod::sim {
namespace {

constexpr int kBins = 16;
constexpr int kFewBins = 8;  // where sweeping the bins would cost more than filling them
constexpr size_t kFewItems = 64;
constexpr size_t kSample = 1 << 14;  // of more items, every n-th shows where the best cut is

using Float4 [[gnu::vector_size(16)]] = float;

Float4 Load(const float* from) { return *reinterpret_cast<const Float4*>(from); }
void Store(Float4 value, float* to) { *reinterpret_cast<Float4*>(to) = value; }
Float4 Least(Float4 a, Float4 b) { return a < b ? a : b; }
Float4 Largest(Float4 a, Float4 b) { return a > b ? a : b; }

void Include(Float4 low, Float4 high, Box4& box) {
  Store(Least(Load(box.low), low), box.low);
  Store(Largest(Load(box.high), high), box.high);
}

struct Bin {
  Box4 box;
  int count = 0;
};

float BlocksOf(int triangles) {
  const int blocks = (triangles + kBlockSize - 1) / kBlockSize;
  return static_cast<float>(blocks);
}

float Area(const Box4& box) {
  const float x = box.high[0] - box.low[0], y = box.high[1] - box.low[1],
              z = box.high[2] - box.low[2];
  return x >= 0 ? x * y + y * z + z * x : 0;
}

int BinOf(float centre, float low, float scale) { return static_cast<int>((centre - low) * scale); }

using Bins = std::array<std::array<Bin, kBins>, 3>;

void Fill(std::span<const Item> items, const Box4& centres, const float* scale, Bins& bins) {
  const size_t stride = items.size() / kSample + 1;
  for (size_t i = 0; i < items.size(); i += stride) {
    const Item& item = items[i];
    const Float4 low = Load(item.low), high = Load(item.high);
    for (size_t axis = 0; axis < 3; ++axis) {
      const int bin = BinOf(CentreOf(item, static_cast<int>(axis)), centres.low[axis], scale[axis]);
      Bin& chosen = bins[axis][static_cast<size_t>(bin)];
      Include(low, high, chosen.box);
      ++chosen.count;
    }
  }
}

/// Sweeps from both sides; returns the least cost and where.
std::pair<float, int> Cheapest(const std::array<Bin, kBins>& bins, size_t count) {
  std::array<float, kBins> right_cost;
  Box4 right;
  int right_count = 0;
  for (size_t i = count - 1; i > 0; --i) {
    Include(Load(bins[i].box.low), Load(bins[i].box.high), right);
    right_count += bins[i].count;
    right_cost[i] = Area(right) * BlocksOf(right_count);
  }
  std::pair<float, int> best{Box4::kFar, 0};
  const int total = right_count + bins[0].count;
  Box4 left;
  int left_count = 0;
  for (size_t i = 1; i < count; ++i) {
    Include(Load(bins[i - 1].box.low), Load(bins[i - 1].box.high), left);
    left_count += bins[i - 1].count;
    if (left_count == 0 || left_count == total) continue;
    const float cost = Area(left) * BlocksOf(left_count) + right_cost[i];
    if (cost < best.first) best = {cost, static_cast<int>(i)};
  }
  return best;
}

}  // namespace

double HalfArea(const Box4& box) { return static_cast<double>(Area(box)); }

void Grow(const Item& item, Box4& box, Box4& centres) {
  const Float4 low = Load(item.low), high = Load(item.high);
  Include(low, high, box);
  Include(low + high, low + high, centres);
}

void Include(const Box4& other, Box4& box) { Include(Load(other.low), Load(other.high), box); }

int WidestAxis(const Box4& centres) {
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (centres.high[axis] - centres.low[axis] > centres.high[widest] - centres.low[widest]) {
      widest = axis;
    }
  }
  return widest;
}

bool Cut::IsLeft(const Item& item) const { return BinOf(CentreOf(item, axis), low, scale) < bin; }

Cut BestCut(std::span<const Item> items, const Box4& centres) {
  const int count = items.size() > kFewItems ? kBins : kFewBins;
  std::array<float, 3> scale{};
  for (size_t axis = 0; axis < 3; ++axis) {
    const float width = centres.high[axis] - centres.low[axis];
    // A hair below the full number of bins; a width of 0 puts everything into the first.
    scale[axis] = width > 0 ? static_cast<float>(count) * 0.99999F / width : 0;
    if (!(scale[axis] < std::numeric_limits<float>::max())) scale[axis] = 0;
  }
  Bins bins;
  Fill(items, centres, scale.data(), bins);
  Cut best;
  float least = Box4::kFar;
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto [cost, bin] = Cheapest(bins[axis], static_cast<size_t>(count));
    if (cost >= least) continue;
    least = cost;
    best = {static_cast<int>(axis), bin, centres.low[axis], scale[axis]};
  }
  return best;
}

Node EmptyNode() {
  Node node{};
  for (auto& axis : node.low) std::fill(std::begin(axis), std::end(axis), Box4::kFar);
  for (auto& axis : node.high) std::fill(std::begin(axis), std::end(axis), Box4::kFar);
  return node;
}

uint32_t ClassesBelow(const Node& node) {
  uint32_t classes = 0;
  for (const uint32_t mask : node.classes) classes |= mask;
  return classes;
}

}  // namespace eod::sim
