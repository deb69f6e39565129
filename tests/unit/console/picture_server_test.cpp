// Pictures to browsers over a real socket of the loopback.
#include "console/picture_server.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "platform/file_descriptor.h"
#include "platform/multicast.h"

namespace eod::console {
namespace {

class Browser {
 public:
  explicit Browser(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const auto place = ParseIpv4("127.0.0.1", port);
    EXPECT_EQ(::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&*place), sizeof *place),
              0);
  }
  void Ask(const std::string& text) {
    EXPECT_EQ(::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  void Get(const std::string& path) { Ask("GET " + path + " HTTP/1.1\r\nHost: x\r\n\r\n"); }

  // All that has come so far.
  const std::string& Heard() {
    char bytes[65536];
    ssize_t count = 0;
    while ((count = ::recv(socket_.get(), bytes, sizeof bytes, MSG_DONTWAIT)) > 0) {
      heard_.append(bytes, static_cast<size_t>(count));
    }
    return heard_;
  }

 private:
  FileDescriptor socket_;
  std::string heard_;
};

std::vector<uint8_t> Jpeg(const std::string& text) { return {text.begin(), text.end()}; }

TEST(PictureServer, GivesThePageAndRefusesOtherPaths) {
  PictureServer dut("127.0.0.1", 0, "<p>cameras</p>");
  Browser page(dut.port()), other(dut.port()), post(dut.port());
  page.Get("/");
  other.Get("/../etc/passwd");
  post.Ask("POST / HTTP/1.1\r\n\r\n");
  dut.Serve();
  EXPECT_TRUE(page.Heard().starts_with("HTTP/1.1 200 OK\r\n")) << page.Heard();
  EXPECT_NE(page.Heard().find("Content-Length: 14\r\n"), std::string::npos);
  EXPECT_TRUE(page.Heard().ends_with("\r\n\r\n<p>cameras</p>"));
  EXPECT_TRUE(other.Heard().starts_with("HTTP/1.1 404"));
  EXPECT_TRUE(post.Heard().starts_with("HTTP/1.1 404"));
  EXPECT_EQ(dut.viewers(), 0u) << "all are answered";
}

TEST(PictureServer, SendsEachNewPictureOfTheStreamAskedFor) {
  PictureServer dut("127.0.0.1", 0, "");
  Browser mast(dut.port());
  mast.Get("/mast.mjpeg?again");
  dut.Serve();
  EXPECT_NE(mast.Heard().find("multipart/x-mixed-replace; boundary=picture\r\n"),
            std::string::npos);
  dut.Offer("mast", Jpeg("FIRST"));
  dut.Offer("rear", Jpeg("OTHER"));
  dut.Serve();
  dut.Serve();
  dut.Offer("mast", Jpeg("SECOND"));
  dut.Serve();
  const std::string heard = mast.Heard();
  EXPECT_TRUE(heard.ends_with(
      "--picture\r\nContent-Type: image/jpeg\r\nContent-Length: 5\r\n\r\nFIRST\r\n"
      "--picture\r\nContent-Type: image/jpeg\r\nContent-Length: 6\r\n\r\nSECOND\r\n"))
      << heard;
}

TEST(PictureServer, GivesTheTextAsItIsNow) {
  PictureServer dut("127.0.0.1", 0, "");
  dut.Tell("step", "one");
  dut.Tell("step", "two");
  Browser reader(dut.port());
  reader.Get("/step.txt");
  dut.Serve();
  EXPECT_TRUE(reader.Heard().ends_with("\r\n\r\ntwo")) << reader.Heard();
}

TEST(PictureServer, ARequestMayComeInPieces) {
  PictureServer dut("127.0.0.1", 0, "page");
  Browser slow(dut.port());
  slow.Ask("GET / HT");
  dut.Serve();
  EXPECT_EQ(slow.Heard(), "");
  slow.Ask("TP/1.1\r\n\r\n");
  dut.Serve();
  EXPECT_TRUE(slow.Heard().ends_with("page"));
}

TEST(PictureServer, AViewerThatDoesNotReadMissesPicturesAndDelaysNobody) {
  PictureServer dut("127.0.0.1", 0, "");
  Browser asleep(dut.port()), awake(dut.port());
  asleep.Get("/mast.mjpeg");
  awake.Get("/mast.mjpeg");
  const std::string body(100'000, 'x');
  size_t asked = 0;
  for (int picture = 0; picture < 200; ++picture) {
    dut.Offer("mast", Jpeg(body + "END"));
    asked += body.size();
    while (awake.Heard().size() < asked) dut.Serve();
  }
  dut.Offer("mast", Jpeg("NEWEST"));
  while (!asleep.Heard().ends_with("NEWEST\r\n")) dut.Serve();
  EXPECT_LT(asleep.Heard().size(), awake.Heard().size() - 10 * body.size());
}

TEST(PictureServer, ForgetsViewersThatLeaveOrTalkTooMuch) {
  PictureServer dut("127.0.0.1", 0, "");
  {
    Browser leaver(dut.port());
    leaver.Get("/mast.mjpeg");
    dut.Serve();
    EXPECT_EQ(dut.viewers(), 1u);
  }
  dut.Serve();
  EXPECT_EQ(dut.viewers(), 0u);
  Browser talker(dut.port());
  talker.Ask("GET /" + std::string(20'000, 'a'));
  dut.Serve();
  EXPECT_EQ(dut.viewers(), 0u);
}

TEST(PictureServer, SaysInOneLineWhyItCannotListen) {
  const PictureServer first("127.0.0.1", 0, "");
  for (const auto& [address, port] :
       {std::pair<std::string, int>{"127.0.0.1", first.port()}, {"localhost", 0}}) {
    try {
      const PictureServer dut(address, port, "");
      FAIL() << address;
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      EXPECT_NE(text.find("http://" + address), std::string::npos) << text;
    }
  }
}

}  // namespace
}  // namespace eod::console
