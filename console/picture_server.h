#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace eod::console {

/// Shows streams of JPEG pictures to browsers: HTTP/1.1, a page at "/", each text NAME at
/// "/NAME.txt", and each stream NAME at "/NAME.mjpeg" as multipart/x-mixed-replace, which an <img>
/// shows as it comes. Single-threaded, never blocks. One picture is on its way to each viewer, and
/// then the newest: a slow viewer misses pictures and delays nobody.
class PictureServer {
 public:
  /// More wait until one leaves.
  static constexpr size_t kMostViewers = 32;

  /// Listens on `address` (IPv4) and `port` (0..65535, 0: any free one). Throws std::runtime_error
  /// with one line if that cannot be.
  PictureServer(const std::string& address, int port, std::string page);
  ~PictureServer();
  PictureServer(const PictureServer&) = delete;
  PictureServer& operator=(const PictureServer&) = delete;

  /// What "/NAME.txt" says from now on.
  void Tell(const std::string& name, std::string text);

  /// The newest picture of a stream; the one before is forgotten.
  void Offer(const std::string& stream, std::span<const uint8_t> jpeg);

  /// Takes new viewers, reads what they ask for and sends what they have room for. To be called
  /// often.
  void Serve();

  int port() const;
  size_t viewers() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace eod::console
