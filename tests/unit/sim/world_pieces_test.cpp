#include "sim/sdf/world_pieces.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr size_t kOneByOne = 1;

const std::string kWorld =
    "<?xml version=\"1.0\"?>\n<sdf><world name=\"w\">\n<!-- <model name=\"no\"/> -->\n"
    "<frame name=\"f\"/>\n<model name=\"a\">\n<link name=\"a > b\"/>\n</model>\n"
    "<model name=\"b\"><model name=\"inner\"/><link name='x'/></model>\n"
    "<light name=\"sun\"><model/></light>\n<include name=\"c\"/>\n</world></sdf>\n";

/// Line (from 1) of `word` in each piece that has it.
std::vector<ptrdiff_t> LinesOf(const std::string& word, const std::vector<std::string>& pieces) {
  std::vector<ptrdiff_t> lines;
  for (const std::string& piece : pieces) {
    const size_t at = piece.find(word);
    if (at == std::string::npos) continue;
    lines.push_back(1 +
                    std::count(piece.begin(), piece.begin() + static_cast<ptrdiff_t>(at), '\n'));
  }
  return lines;
}

TEST(WorldPieces, EachModelStandsInOnePieceAndInItsLine) {
  const auto pieces = WorldPieces(kWorld, kOneByOne);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_THAT(LinesOf("model name=\"a\"", pieces), ElementsAre(5));
  EXPECT_THAT(LinesOf("a > b", pieces), ElementsAre(6));
  EXPECT_THAT(LinesOf("model name=\"b\"", pieces), ElementsAre(8));
  EXPECT_THAT(LinesOf("inner", pieces), ElementsAre(8));
  EXPECT_THAT(LinesOf("include", pieces), ElementsAre(10));
}

TEST(WorldPieces, AllElseStandsInEveryPiece) {
  const auto pieces = WorldPieces(kWorld, kOneByOne);
  EXPECT_THAT(LinesOf("<frame", pieces), ElementsAre(4, 4, 4));
  EXPECT_THAT(LinesOf("<light name=\"sun\"><model/>", pieces), ElementsAre(9));  // in the first
  EXPECT_THAT(LinesOf("<model name=\"no\"/> -->", pieces), ElementsAre(3, 3, 3));
  EXPECT_THAT(LinesOf("</world></sdf>", pieces), ElementsAre(11, 11, 11));
}

TEST(WorldPieces, PieceTakesAsManyModelsAsItMayHold) {
  const size_t a = std::string("<model name=\"a\">\n<link name=\"a > b\"/>\n</model>").size();
  const size_t b =
      std::string("<model name=\"b\"><model name=\"inner\"/><link name='x'/></model>").size();
  EXPECT_EQ(WorldPieces(kWorld, a + b - 1).size(), 2u);  // a; b and c
  const auto pieces = WorldPieces(kWorld, a + b);        // a and b; c
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_THAT(pieces[0], HasSubstr("name=\"b\""));
  EXPECT_THAT(pieces[1], Not(HasSubstr("name=\"b\"")));
  EXPECT_EQ(WorldPieces(kWorld, kWorld.size()), std::vector{kWorld});
}

TEST(WorldPieces, WorldWithoutModelsIsOnePiece) {
  const std::string empty = "<sdf><world name=\"w\"/></sdf>";
  EXPECT_EQ(WorldPieces(empty, kOneByOne), std::vector{empty});
}

}  // namespace
}  // namespace eod::sim
