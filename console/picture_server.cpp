#include "console/picture_server.h"

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fmt/format.h>

namespace eod::console {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using beast::error_code;

constexpr uint32_t kLongestRequest = 8192;
constexpr std::chrono::seconds kPatience{30};  // with a browser that says or takes nothing

/// NAME of "/NAME" + suffix; empty if the path is none such.
std::string NameOf(std::string_view path, std::string_view suffix) {
  if (!path.starts_with('/') || !path.ends_with(suffix)) return {};
  return std::string(path.substr(1, path.size() - 1 - suffix.size()));
}

struct Picture {
  std::string part;     ///< of a multipart body: head, JPEG and end
  uint64_t number = 0;  ///< counts from 1
};

/// What there is to be seen.
struct Exhibits {
  std::string page;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::shared_ptr<const Picture>> streams;
};

/// One browser's connection: a request, and its answer.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  Viewer(tcp::socket socket, const Exhibits& exhibits)
      : stream_(std::move(socket)), exhibits_(exhibits) {
    request_.header_limit(kLongestRequest);
    request_.body_limit(kLongestRequest);
  }

  void Start() {
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, request_,
                     [self = shared_from_this()](error_code error, size_t) {
                       if (error) return self->Leave();
                       self->Answer();
                     });
  }

  void Leave() {
    has_left_ = true;
    stream_.close();
  }

  /// Sends the newest picture, unless one is on its way or this one is known.
  void SendPicture() {
    if (!watches_ || picture_in_flight_) return;
    const auto stream = exhibits_.streams.find(name_);
    if (stream == exhibits_.streams.end() || stream->second->number == last_number_) return;
    picture_in_flight_ = stream->second;
    last_number_ = picture_in_flight_->number;
    stream_.expires_after(kPatience);
    asio::async_write(stream_, asio::buffer(picture_in_flight_->part),
                      [self = shared_from_this()](error_code error, size_t) {
                        self->picture_in_flight_.reset();
                        if (error) return self->Leave();
                        self->SendPicture();
                      });
  }

  bool has_left() const { return has_left_; }

 private:
  void Answer() {
    const auto& request = request_.get();
    const std::string_view target(request.target().data(), request.target().size());
    const std::string_view path = target.substr(0, target.find('?'));
    const bool is_get = request.method() == http::verb::get;
    const auto text = exhibits_.texts.find(NameOf(path, ".txt"));
    name_ = NameOf(path, ".mjpeg");
    if (is_get && path == "/") return Reply(http::status::ok, "text/html", exhibits_.page);
    if (is_get && !name_.empty()) return BeginStream();
    if (is_get && text != exhibits_.texts.end()) {
      return Reply(http::status::ok, "text/plain", text->second);
    }
    Reply(http::status::not_found, "text/plain", "nothing here; see /\n");
  }

  void SetHead(std::string_view type) {
    response_.set(http::field::content_type, {type.data(), type.size()});
    response_.set(http::field::cache_control, "no-store");
    response_.keep_alive(false);
  }

  void Reply(http::status status, std::string_view type, const std::string& body) {
    response_.result(status);
    SetHead(fmt::format("{}; charset=utf-8", type));
    response_.body() = body;
    response_.prepare_payload();
    http::async_write(stream_, response_, [self = shared_from_this()](error_code, size_t) {
      error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
      self->Leave();
    });
  }

  void BeginStream() {
    SetHead("multipart/x-mixed-replace; boundary=picture");
    serializer_.emplace(response_);
    http::async_write_header(stream_, *serializer_,
                             [self = shared_from_this()](error_code error, size_t) {
                               if (error) return self->Leave();
                               self->stream_.expires_never();
                               self->NoticeEnd();
                               self->watches_ = true;
                               self->SendPicture();
                             });
  }

  /// A browser that watches says nothing more: what can still be read is its end.
  void NoticeEnd() {
    stream_.async_read_some(asio::buffer(scratch_),
                            [self = shared_from_this()](error_code error, size_t) {
                              if (error) return self->Leave();
                              self->NoticeEnd();
                            });
  }

  beast::tcp_stream stream_;
  const Exhibits& exhibits_;
  beast::flat_buffer buffer_;
  http::request_parser<http::string_body> request_;
  http::response<http::string_body> response_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
  std::string name_;  ///< of the stream that is watched
  std::shared_ptr<const Picture> picture_in_flight_;
  uint64_t last_number_ = 0;
  std::array<char, 512> scratch_{};
  bool watches_ = false;
  bool has_left_ = false;
};

tcp::endpoint EndpointOf(const std::string& address, int port) {
  error_code error;
  const auto ipv4 = asio::ip::make_address_v4(address, error);
  if (error || port < 0 || port > 65535) {
    throw std::runtime_error(fmt::format(
        "http://{}:{}: an IPv4 address and a port of 0..65535 are allowed", address, port));
  }
  return {ipv4, static_cast<uint16_t>(port)};
}

}  // namespace

/// The port, and all that came to it.
class PictureServer::Listener {
 public:
  explicit Listener(const tcp::endpoint& endpoint) : acceptor_(context_, endpoint) { Accept(); }
  ~Listener() {
    for (const auto& viewer : viewers_) viewer->Leave();
    error_code ignored;
    acceptor_.close(ignored);
    context_.poll();
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  void Poll() {
    for (const auto& viewer : viewers_) viewer->SendPicture();
    context_.poll();
    std::erase_if(viewers_, [](const auto& viewer) { return viewer->has_left(); });
    if (!accepts_ && viewers_.size() < kMostViewers) Accept();
  }

  int port() const { return acceptor_.local_endpoint().port(); }
  size_t viewers() const { return viewers_.size(); }

  Exhibits exhibits;

 private:
  void Accept() {
    accepts_ = true;
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      accepts_ = false;
      if (error == asio::error::operation_aborted) return;
      if (!error) {
        viewers_.push_back(std::make_shared<Viewer>(std::move(socket), exhibits));
        viewers_.back()->Start();
      }
      if (viewers_.size() < kMostViewers) Accept();
    });
  }

  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  std::vector<std::shared_ptr<Viewer>> viewers_;
  bool accepts_ = false;
};

PictureServer::PictureServer(const std::string& address, int port, std::string page) {
  const tcp::endpoint endpoint = EndpointOf(address, port);
  try {
    listener_ = std::make_unique<Listener>(endpoint);
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(fmt::format("http://{}:{}: {}: choose another port", address, port,
                                         error.code().message()));
  }
  listener_->exhibits.page = std::move(page);
}

PictureServer::~PictureServer() = default;

void PictureServer::Tell(const std::string& name, std::string text) {
  listener_->exhibits.texts[name] = std::move(text);
}

void PictureServer::Offer(const std::string& stream, std::span<const uint8_t> jpeg) {
  std::shared_ptr<const Picture>& newest = listener_->exhibits.streams[stream];
  auto picture = std::make_shared<Picture>();
  picture->part = fmt::format("--picture\r\nContent-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n",
                              jpeg.size());
  picture->part.append(jpeg.begin(), jpeg.end());
  picture->part += "\r\n";
  picture->number = newest ? newest->number + 1 : 1;
  newest = std::move(picture);
}

void PictureServer::Serve() { listener_->Poll(); }

int PictureServer::port() const { return listener_->port(); }

size_t PictureServer::viewers() const { return listener_->viewers(); }

}  // namespace eod::console
