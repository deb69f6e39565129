#include "platform/can_datagram.h"

#include <chrono>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <msgpack.hpp>

namespace eod {
namespace {

using namespace std::string_literals;

constexpr TimePoint kNow{std::chrono::milliseconds{1500}};

/// Frame 0x123#1122 as python3-can 4.1 packs it (Message(timestamp=1.5, arbitration_id=0x123,
/// is_extended_id=False, data=[0x11, 0x22]) through udp_multicast.utils.pack_message).
const std::string kFromPython =
    "\x8b\xa9timestamp\xcb\x3f\xf8\x00\x00\x00\x00\x00\x00\xae"
    "arbitration_id\xcd\x01\x23\xaeis_extended_id\xc2\xafis_remote_frame\xc2\xae"
    "is_error_frame\xc2\xa7"
    "channel\xc0\xa3"
    "dlc\x02\xa4"
    "data\xc4\x02\x11\x22\xa5is_fd\xc2\xae"
    "bitrate_switch\xc2\xb5"
    "error_state_indicator\xc2"s;

std::span<const uint8_t> AsBytes(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string AsText(std::span<const uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

/// The fields of a datagram, to be changed one at a time.
std::map<std::string, std::string> Fields() {
  const auto packed = [](const auto& value) {
    msgpack::sbuffer buffer;
    msgpack::pack(buffer, value);
    return std::string(buffer.data(), buffer.size());
  };
  return {{"timestamp", packed(0.25)},
          {"arbitration_id", packed(0x123)},
          {"is_extended_id", packed(false)},
          {"is_remote_frame", packed(false)},
          {"is_error_frame", packed(false)},
          {"channel", "\xc0"},
          {"dlc", packed(2)},
          {"data", "\xc4\x02\x11\x22"},
          {"is_fd", packed(false)},
          {"bitrate_switch", packed(false)},
          {"error_state_indicator", packed(false)}};
}

std::string Pack(const std::map<std::string, std::string>& fields) {
  std::string packed(1, static_cast<char>(0x80 + fields.size()));
  for (const auto& [key, value] : fields) {
    packed += static_cast<char>(0xa0 + key.size());
    packed += key;
    packed += value;
  }
  return packed;
}

std::optional<CanFrame> DecodeWith(const std::string& key, const std::string& value) {
  auto fields = Fields();
  fields[key] = value;
  return DecodeCanDatagram(AsBytes(Pack(fields)));
}

TEST(CanDatagram, IsByteForByteWhatPythonCanSends) {
  const CanDatagram dut({.id = 0x123, .length = 2, .data = {0x11, 0x22}}, kNow);
  EXPECT_EQ(AsText(dut.bytes()), kFromPython);
}

TEST(CanDatagram, DecodesWhatPythonCanSends) {
  const auto dut = DecodeCanDatagram(AsBytes(kFromPython));
  ASSERT_TRUE(dut.has_value());
  EXPECT_TRUE(SameOnWire(*dut, {.id = 0x123, .length = 2, .data = {0x11, 0x22}}));
}

TEST(CanDatagram, CarriesEveryKindOfFrame) {
  CanFrame full_fd{.id = 0x1FFFFFFF,
                   .extended = true,
                   .fd = true,
                   .bit_rate_switch = true,
                   .error_state_indicator = true,
                   .length = 64};
  full_fd.data.fill(0xA5);
  for (const CanFrame& frame : {CanFrame{.id = 0x7FF}, CanFrame{.id = 0x7FF, .extended = true},
                                CanFrame{.id = 0x100, .remote = true, .length = 8},
                                CanFrame{.id = 0x44, .error = true, .length = 8}, full_fd}) {
    const auto dut = DecodeCanDatagram(CanDatagram(frame, kNow).bytes());
    ASSERT_TRUE(dut.has_value()) << frame.id;
    EXPECT_TRUE(SameOnWire(*dut, frame)) << frame.id;
  }
}

TEST(CanDatagram, KeepsAWholeNumberOfSecondsAFloat) {
  // Byte 10 follows the map header and the ten bytes of the key "timestamp": 0xcb marks a float64.
  const CanDatagram dut({.id = 1}, TimePoint{std::chrono::seconds{2}});
  EXPECT_EQ(dut.bytes()[11], 0xcb);
}

TEST(CanDatagram, TakesAnyOrderOfKeys) {
  // std::map sorts the keys by name, which is not python-can's order.
  EXPECT_TRUE(DecodeCanDatagram(AsBytes(Pack(Fields()))).has_value());
}

TEST(CanDatagram, TakesAnyWidthOfIntegers) {
  const std::string in_8_bytes("\xcf\0\0\0\0\0\0\x01\x23", 9);
  const std::string in_4_bytes("\xce\0\0\x01\x23", 5);
  const std::string in_4_signed_bytes("\xd2\0\0\x01\x23", 5);
  for (const std::string& id : {in_8_bytes, in_4_bytes, in_4_signed_bytes}) {
    const auto dut = DecodeWith("arbitration_id", id);
    ASSERT_TRUE(dut.has_value());
    EXPECT_EQ(dut->id, 0x123U);
  }
  EXPECT_TRUE(DecodeWith("timestamp", "\x05").has_value());
}

TEST(CanDatagram, TakesAChannelName) {
  EXPECT_TRUE(DecodeWith("channel", "\xa5vcan0").has_value());
}

TEST(CanDatagram, RefusesWhatIsNoFrame) {
  EXPECT_FALSE(DecodeWith("arbitration_id", std::string("\xcd\x08\x00", 3)));  // over 11 bits
  EXPECT_FALSE(DecodeWith("arbitration_id", "\xff"));                          // -1
  EXPECT_FALSE(DecodeWith("arbitration_id", "\xc3"));                          // true
  EXPECT_FALSE(DecodeWith("arbitration_id", "\xcf\1\0\0\0\0\0\0\1"));
  EXPECT_FALSE(DecodeWith("dlc", "\x03"));              // two bytes of data
  EXPECT_FALSE(DecodeWith("is_remote_frame", "\xc3"));  // with data
  EXPECT_FALSE(DecodeWith("is_fd", "\x01"));            // a number for a bool
  EXPECT_FALSE(DecodeWith("bitrate_switch", "\xc3"));   // in a classic frame
  EXPECT_FALSE(DecodeWith("data", "\xa2\x11\x22"));     // text
  EXPECT_FALSE(DecodeWith("data", "\x92\x11\x22"));     // a list
  EXPECT_FALSE(DecodeWith("timestamp", "\xa1x"));
}

TEST(CanDatagram, RefusesOtherKeysThanTheEleven) {
  auto fields = Fields();
  fields.emplace("is_rx", "\xc3");
  EXPECT_FALSE(DecodeCanDatagram(AsBytes(Pack(fields)))) << "twelve";
  fields.erase("is_fd");
  EXPECT_FALSE(DecodeCanDatagram(AsBytes(Pack(fields)))) << "one unknown";
  fields.erase("is_rx");
  EXPECT_FALSE(DecodeCanDatagram(AsBytes(Pack(fields)))) << "ten";
}

TEST(CanDatagram, RefusesAKeyThatComesTwice) {
  auto fields = Fields();
  fields.erase("is_fd");
  std::string packed = Pack(fields) +
                       "\xa3"
                       "dlc\x02";
  packed[0] = '\x8b';
  EXPECT_FALSE(DecodeCanDatagram(AsBytes(packed)));
}

TEST(CanDatagram, RefusesEveryTruncationAndATail) {
  for (size_t size = 0; size < kFromPython.size(); ++size) {
    EXPECT_FALSE(DecodeCanDatagram(AsBytes(kFromPython.substr(0, size)))) << size;
  }
  EXPECT_FALSE(DecodeCanDatagram(AsBytes(kFromPython + '\xc0')));
}

TEST(CanDatagram, SurvivesEveryChangeOfOneByte) {
  for (size_t i = 0; i < kFromPython.size(); ++i) {
    for (int value = 0; value < 256; ++value) {
      std::string changed = kFromPython;
      changed[i] = static_cast<char>(value);
      const auto dut = DecodeCanDatagram(AsBytes(changed));
      EXPECT_TRUE(!dut || IsWellFormed(*dut));
    }
  }
}

}  // namespace
}  // namespace eod
