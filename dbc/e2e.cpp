#include "dbc/e2e.h"

#include <array>
#include <cstddef>

namespace eod::dbc {
namespace {

constexpr uint8_t kPolynomial = 0x1D;  // SAE J1850
constexpr int kMaxAdvance = 3;
constexpr int kSyncFrames = 3;

constexpr std::array<uint8_t, 256> MakeTable() {
  std::array<uint8_t, 256> table{};
  for (size_t byte = 0; byte < table.size(); ++byte) {
    auto crc = static_cast<uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<uint8_t>((crc << 1) ^ ((crc & 0x80) != 0 ? kPolynomial : 0));
    }
    table[byte] = crc;
  }
  return table;
}

constexpr std::array<uint8_t, 256> kTable = MakeTable();

}  // namespace

uint8_t E2eCrc(uint16_t data_id, std::span<const uint8_t> payload, int crc_byte) {
  uint8_t crc = kTable[data_id & 0xFF];
  crc = kTable[crc ^ (data_id >> 8)];
  for (size_t i = 0; i < payload.size(); ++i) {
    if (i != static_cast<size_t>(crc_byte)) crc = kTable[crc ^ payload[i]];
  }
  return crc;
}

E2eStatus E2eChecker::Check(bool crc_ok, int counter) {
  // Whatever is not a good frame starts the count of good frames in a row anew.
  if (sync_needed_ > 0 && !crc_ok) sync_needed_ = kSyncFrames;
  if (!crc_ok) return E2eStatus::kWrongCrc;
  if (counter < 0 || counter >= kE2eCounterCount) {
    sync_needed_ = kSyncFrames;
    return E2eStatus::kWrongSequence;
  }

  const bool is_first = last_counter_ < 0;
  const int advance =
      is_first ? 1 : (counter - last_counter_ + kE2eCounterCount) % kE2eCounterCount;
  last_counter_ = counter;
  if (advance == 0) {
    if (sync_needed_ > 0) sync_needed_ = kSyncFrames;
    return E2eStatus::kRepeated;
  }
  lost_ += static_cast<uint64_t>(advance - 1);
  if (advance > kMaxAdvance) {
    sync_needed_ = kSyncFrames;
    return E2eStatus::kWrongSequence;
  }
  if (sync_needed_ > 0 && --sync_needed_ > 0) return E2eStatus::kSync;
  if (is_first) return E2eStatus::kInitial;
  return advance == 1 ? E2eStatus::kOk : E2eStatus::kOkSomeLost;
}

void E2eChecker::Reset() {
  last_counter_ = -1;
  sync_needed_ = 0;
}

}  // namespace eod::dbc
