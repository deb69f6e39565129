#pragma once

#include <cstdint>
#include <span>

namespace eod::dbc {

/// AUTOSAR E2E profile 1, variant with both bytes of the data id in the CRC: CRC-8 polynomial 0x1D,
/// start 0x00, final XOR 0x00, over data id low byte, high byte, then all bytes but the CRC byte.
uint8_t E2eCrc(uint16_t data_id, std::span<const uint8_t> payload, int crc_byte);

inline constexpr int kE2eCounterCount = 15;  ///< counter runs 0..14; 15 is never sent

/// Outcome of one received frame, names as in AUTOSAR.
enum class E2eStatus : uint8_t {
  kInitial,        ///< first good frame
  kOk,             ///< counter advanced by 1
  kOkSomeLost,     ///< advanced by 2 or 3
  kRepeated,       ///< counter did not advance: dropped
  kWrongSequence,  ///< advanced by more than 3, or is 15: dropped
  kWrongCrc,       ///< dropped
  kSync,           ///< good, but still counting frames after a wrong sequence: dropped
};

constexpr bool IsAccepted(E2eStatus status) {
  return status == E2eStatus::kInitial || status == E2eStatus::kOk ||
         status == E2eStatus::kOkSomeLost;
}

/// Watches the counter and the CRC verdict of one message. After a wrong sequence it takes three
/// good frames in a row to trust the message again: two are kSync, the third is accepted.
class E2eChecker {
 public:
  E2eStatus Check(bool crc_ok, int counter);
  /// Frames that were lost in the gaps of kOkSomeLost and kWrongSequence.
  uint64_t lost() const { return lost_; }
  /// Forgets the sequence, as after a time-out.
  void Reset();

 private:
  int last_counter_ = -1;
  int sync_needed_ = 0;
  uint64_t lost_ = 0;
};

}  // namespace eod::dbc
