#include "platform/can_datagram.h"

#include <algorithm>
#include <bit>
#include <string_view>

#include <msgpack.hpp>

namespace eod {
namespace {

// The keys, in the order in which python-can writes them.
constexpr std::array<std::string_view, 11> kKeys{"timestamp",
                                                 "arbitration_id",
                                                 "is_extended_id",
                                                 "is_remote_frame",
                                                 "is_error_frame",
                                                 "channel",
                                                 "dlc",
                                                 "data",
                                                 "is_fd",
                                                 "bitrate_switch",
                                                 "error_state_indicator"};

enum Key {
  kTimestamp,
  kArbitrationId,
  kIsExtendedId,
  kIsRemoteFrame,
  kIsErrorFrame,
  kChannel,
  kDlc,
  kDataBytes,
  kIsFd,
  kBitrateSwitch,
  kErrorStateIndicator,
};

/// The output stream that msgpack::packer asks for, over a fixed buffer.
class FixedStream {
 public:
  explicit FixedStream(std::span<uint8_t> buffer) : buffer_(buffer) {}

  void write(const char* bytes, size_t count) {
    std::copy_n(bytes, count, buffer_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += count;
  }
  size_t size() const { return size_; }

 private:
  std::span<uint8_t> buffer_;
  size_t size_ = 0;
};

/// A float64 even where the number is whole; msgpack::packer would shorten that to an integer.
void PackFloat64(FixedStream& stream, double value) {
  const auto bits = std::bit_cast<uint64_t>(value);
  stream.write("\xcb", 1);
  for (int shift = 56; shift >= 0; shift -= 8) {
    const auto byte = static_cast<char>(bits >> shift);
    stream.write(&byte, 1);
  }
}

/// Takes a frame from the events of msgpack's parser; nothing is allocated. Returning false ends
/// the parse: the datagram is malformed.
class FrameVisitor : public msgpack::null_visitor {
 public:
  bool is_complete() const { return seen_ == (1U << kKeys.size()) - 1; }

  CanFrame frame() const {
    CanFrame frame = frame_;
    frame.length = static_cast<uint8_t>(dlc_);
    return frame;
  }
  bool is_consistent() const {
    return dlc_ <= frame_.data.size() && (frame_.remote ? byte_count_ == 0 : byte_count_ == dlc_);
  }

  bool start_map(uint32_t pairs) { return depth_++ == 0 && pairs == kKeys.size(); }
  bool end_map() { return --depth_ == 0; }
  bool start_array(uint32_t /*items*/) { return false; }
  bool start_map_key() { return is_key_ = true; }
  bool end_map_key() { return !(is_key_ = false); }

  bool visit_nil() { return IsValueOf(kChannel); }
  bool visit_boolean(bool value);
  bool visit_positive_integer(uint64_t value);
  bool visit_negative_integer(int64_t value) {
    // The parser reports every signed width here, whatever its sign.
    return value >= 0 ? visit_positive_integer(static_cast<uint64_t>(value))
                      : IsValueOf(kTimestamp);
  }
  bool visit_float32(float /*value*/) { return IsValueOf(kTimestamp); }
  bool visit_float64(double /*value*/) { return IsValueOf(kTimestamp); }
  bool visit_str(const char* text, uint32_t size);
  bool visit_bin(const char* bytes, uint32_t size);
  bool visit_ext(const char* /*bytes*/, uint32_t /*size*/) { return false; }

  void parse_error(size_t /*parsed*/, size_t /*error*/) {}
  void insufficient_bytes(size_t /*parsed*/, size_t /*error*/) {}

 private:
  bool IsValueOf(Key key) const { return depth_ == 1 && !is_key_ && key_ == key; }

  CanFrame frame_;
  uint64_t dlc_ = 0;
  uint64_t byte_count_ = 0;
  int depth_ = 0;
  bool is_key_ = false;
  size_t key_ = kKeys.size();
  unsigned seen_ = 0;
};

bool FrameVisitor::visit_boolean(bool value) {
  if (depth_ != 1 || is_key_) return false;
  switch (key_) {
    case kIsExtendedId:
      frame_.extended = value;
      return true;
    case kIsRemoteFrame:
      frame_.remote = value;
      return true;
    case kIsErrorFrame:
      frame_.error = value;
      return true;
    case kIsFd:
      frame_.fd = value;
      return true;
    case kBitrateSwitch:
      frame_.bit_rate_switch = value;
      return true;
    case kErrorStateIndicator:
      frame_.error_state_indicator = value;
      return true;
    default:
      return false;
  }
}

bool FrameVisitor::visit_positive_integer(uint64_t value) {
  if (IsValueOf(kArbitrationId)) {
    frame_.id = static_cast<uint32_t>(value);
    return value <= 0x1FFFFFFF;
  }
  if (IsValueOf(kDlc)) {
    dlc_ = value;
    return true;
  }
  return IsValueOf(kTimestamp) || IsValueOf(kChannel);
}

bool FrameVisitor::visit_str(const char* text, uint32_t size) {
  if (!is_key_) return IsValueOf(kChannel);
  key_ =
      static_cast<size_t>(std::ranges::find(kKeys, std::string_view(text, size)) - kKeys.begin());
  const bool is_new = key_ < kKeys.size() && (seen_ & (1U << key_)) == 0;
  if (is_new) seen_ |= 1U << key_;
  return is_new;
}

bool FrameVisitor::visit_bin(const char* bytes, uint32_t size) {
  if (!IsValueOf(kDataBytes) || size > frame_.data.size()) return false;
  std::copy_n(bytes, size, frame_.data.begin());
  byte_count_ = size;
  return true;
}

}  // namespace

CanDatagram::CanDatagram(const CanFrame& frame, TimePoint now) {
  FixedStream stream(bytes_);
  msgpack::packer<FixedStream> packer(stream);
  const auto key = [&packer](Key which) {
    const std::string_view name = kKeys[which];
    packer.pack_str(static_cast<uint32_t>(name.size()));
    packer.pack_str_body(name.data(), static_cast<uint32_t>(name.size()));
  };
  const auto flag = [&packer, &key](Key which, bool value) {
    key(which);
    packer.pack(value);
  };
  const auto payload = frame.payload();
  packer.pack_map(kKeys.size());
  key(kTimestamp);
  PackFloat64(stream, ToSeconds(now.time_since_epoch()));
  key(kArbitrationId);
  packer.pack(frame.id);
  flag(kIsExtendedId, frame.extended);
  flag(kIsRemoteFrame, frame.remote);
  flag(kIsErrorFrame, frame.error);
  key(kChannel);
  packer.pack_nil();
  key(kDlc);
  packer.pack(frame.length);
  key(kDataBytes);
  packer.pack_bin(static_cast<uint32_t>(payload.size()));
  packer.pack_bin_body(reinterpret_cast<const char*>(payload.data()),
                       static_cast<uint32_t>(payload.size()));
  flag(kIsFd, frame.fd);
  flag(kBitrateSwitch, frame.bit_rate_switch);
  flag(kErrorStateIndicator, frame.error_state_indicator);
  size_ = stream.size();
}

std::optional<CanFrame> DecodeCanDatagram(std::span<const uint8_t> bytes) {
  FrameVisitor visitor;
  size_t parsed = 0;
  const bool is_parsed =
      msgpack::parse(reinterpret_cast<const char*>(bytes.data()), bytes.size(), parsed, visitor);
  if (!is_parsed || parsed != bytes.size() || !visitor.is_complete() || !visitor.is_consistent()) {
    return {};
  }
  const CanFrame frame = visitor.frame();
  if (!IsWellFormed(frame)) return {};
  return frame;
}

}  // namespace eod
