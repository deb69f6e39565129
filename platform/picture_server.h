#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "platform/file_descriptor.h"

namespace eod {

/// Shows streams of JPEG pictures to browsers: HTTP/1.1, a page at "/", each text NAME at
/// "/NAME.txt", and each stream NAME at "/NAME.mjpeg" as multipart/x-mixed-replace (RFC 2046),
/// which an <img> shows as it comes. Single-threaded, never blocks. A slow viewer misses pictures;
/// it delays nobody.
class PictureServer {
 public:
  static constexpr size_t kMostViewers = 32;

  /// Listens on `address` (IPv4) and `port` (0: any free one). Throws std::runtime_error with one
  /// line if that cannot be.
  PictureServer(const std::string& address, int port, std::string page);

  /// What "/NAME.txt" says from now on.
  void Tell(const std::string& name, std::string text);

  /// The newest picture of a stream; the one before is forgotten.
  void Offer(const std::string& stream, std::span<const uint8_t> jpeg);

  /// Takes new viewers, reads what they ask for and sends what they have room for. To be called
  /// often.
  void Serve();

  int port() const { return port_; }
  size_t viewers() const { return viewers_.size(); }

 private:
  struct Picture {
    std::vector<uint8_t> jpeg;
    uint64_t number = 0;  ///< counts from 1
  };
  struct Viewer {
    FileDescriptor socket;
    std::string request;
    std::string stream;   ///< empty: the answer is the page or a refusal
    uint64_t number = 0;  ///< of the last picture sent
    std::string outgoing;
    size_t sent = 0;
    bool has_asked = false;
    bool has_left = false;
  };

  void Accept();
  void Read(Viewer& viewer);
  void Answer(Viewer& viewer);
  void Send(Viewer& viewer);
  bool TakeNextPicture(Viewer& viewer) const;

  std::string page_;
  FileDescriptor listener_;
  int port_ = 0;
  std::map<std::string, Picture> streams_;
  std::map<std::string, std::string> texts_;
  std::list<Viewer> viewers_;
};

}  // namespace eod
