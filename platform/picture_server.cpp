#include "platform/picture_server.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>

#include "platform/multicast.h"

namespace eod {
namespace {

constexpr size_t kLongestRequest = 8192;
constexpr std::string_view kStreamSuffix = ".mjpeg";
constexpr std::string_view kTextSuffix = ".txt";
constexpr std::string_view kStreamHead =
    "HTTP/1.1 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n"
    "Cache-Control: no-store\r\nConnection: close\r\n\r\n";

std::string Whole(std::string_view status, std::string_view type, std::string_view body) {
  return fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n"
      "Connection: close\r\n\r\n{}",
      status, type, body.size(), body);
}

// NAME of "/NAME" + suffix; empty if the path is none such.
std::string NameOf(std::string_view path, std::string_view suffix) {
  if (!path.starts_with('/') || !path.ends_with(suffix)) return {};
  return std::string(path.substr(1, path.size() - 1 - suffix.size()));
}

// The path of "GET /path?query HTTP/1.1"; empty if it is no GET.
std::string_view PathOf(std::string_view request) {
  constexpr std::string_view kGet = "GET ";
  if (!request.starts_with(kGet)) return {};
  request.remove_prefix(kGet.size());
  return request.substr(0, request.find_first_of(" ?\r\n"));
}

sockaddr* AsSocketAddress(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

}  // namespace

PictureServer::PictureServer(const std::string& address, int port, std::string page)
    : page_(std::move(page)),
      listener_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  const std::string url = fmt::format("http://{}:{}", address, port);
  auto place = ParseIpv4(address, port);
  if (!place)
    throw std::runtime_error(url + ": an IPv4 address and a port of 0..65535 are allowed");
  const int on = 1;
  ::setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  socklen_t size = sizeof *place;
  if (::bind(listener_.get(), AsSocketAddress(*place), size) < 0 ||
      ::listen(listener_.get(), static_cast<int>(kMostViewers)) < 0 ||
      ::getsockname(listener_.get(), AsSocketAddress(*place), &size) < 0) {
    throw std::runtime_error(fmt::format("{}: {}: choose another port", url, std::strerror(errno)));
  }
  port_ = ntohs(place->sin_port);
}

void PictureServer::Tell(const std::string& name, std::string text) {
  texts_[name] = std::move(text);
}

void PictureServer::Offer(const std::string& stream, std::span<const uint8_t> jpeg) {
  Picture& picture = streams_[stream];
  picture.jpeg.assign(jpeg.begin(), jpeg.end());
  ++picture.number;
}

void PictureServer::Serve() {
  Accept();
  for (Viewer& viewer : viewers_) {
    if (!viewer.has_left) Read(viewer);
    if (!viewer.has_left) Send(viewer);
  }
  viewers_.remove_if([](const Viewer& viewer) { return viewer.has_left; });
}

void PictureServer::Accept() {
  while (viewers_.size() < kMostViewers) {
    FileDescriptor socket(
        ::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.is_open()) return;
    viewers_.emplace_back().socket = std::move(socket);
  }
}

void PictureServer::Read(Viewer& viewer) {
  char bytes[2048];
  ssize_t count = 0;
  while ((count = ::recv(viewer.socket.get(), bytes, sizeof bytes, 0)) > 0) {
    if (!viewer.has_asked) viewer.request.append(bytes, static_cast<size_t>(count));
    if (viewer.request.size() > kLongestRequest) viewer.has_left = true;
    if (viewer.has_left) return;
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) viewer.has_left = true;
  if (!viewer.has_asked && viewer.request.find("\r\n\r\n") != std::string::npos) Answer(viewer);
}

void PictureServer::Answer(Viewer& viewer) {
  viewer.has_asked = true;
  const std::string_view path = PathOf(viewer.request);
  viewer.stream = NameOf(path, kStreamSuffix);
  const auto text = texts_.find(NameOf(path, kTextSuffix));
  if (path == "/") {
    viewer.outgoing = Whole("200 OK", "text/html; charset=utf-8", page_);
  } else if (!viewer.stream.empty()) {
    viewer.outgoing = kStreamHead;
  } else if (text != texts_.end()) {
    viewer.outgoing = Whole("200 OK", "text/plain; charset=utf-8", text->second);
  } else {
    viewer.outgoing = Whole("404 Not Found", "text/plain", "nothing here; see /\n");
  }
}

bool PictureServer::TakeNextPicture(Viewer& viewer) const {
  const auto stream = streams_.find(viewer.stream);
  if (stream == streams_.end() || stream->second.number == viewer.number) return false;
  const Picture& picture = stream->second;
  viewer.number = picture.number;
  viewer.sent = 0;
  viewer.outgoing = fmt::format(
      "--picture\r\nContent-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n", picture.jpeg.size());
  viewer.outgoing.append(picture.jpeg.begin(), picture.jpeg.end());
  viewer.outgoing += "\r\n";
  return true;
}

void PictureServer::Send(Viewer& viewer) {
  if (!viewer.has_asked) return;
  do {
    while (viewer.sent < viewer.outgoing.size()) {
      const ssize_t count = ::send(viewer.socket.get(), viewer.outgoing.data() + viewer.sent,
                                   viewer.outgoing.size() - viewer.sent, MSG_NOSIGNAL);
      if (count < 0) {
        viewer.has_left = errno != EAGAIN && errno != EINTR;
        return;
      }
      viewer.sent += static_cast<size_t>(count);
    }
    if (viewer.stream.empty()) {
      viewer.has_left = true;
      return;
    }
  } while (TakeNextPicture(viewer));
}

}  // namespace eod
