#include "batch/fingerprint.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/unit/batch/scratch_folder.h"

namespace eod::batch {
namespace {

TEST(Fingerprint, IsFnv1aOf64Bits) {
  // Test vectors of draft-eastlake-fnv.
  EXPECT_EQ(FingerprintOf(""), "cbf29ce484222325");
  EXPECT_EQ(FingerprintOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(FingerprintOf("foobar"), "85944171f73967e8");
}

TEST(Fingerprint, OfAnSdfChangesWithTheMeshesItNames) {
  const ScratchFolder folder;
  const auto world = folder.Put("world.sdf", "<sdf><uri>meshes/hill.obj</uri></sdf>");
  folder.Put("meshes/hill.obj", "v 0 0 0\n");
  folder.Put("meshes/other.obj", "v 0 0 0\n");
  const std::string before = FingerprintOfSdf(world);
  EXPECT_EQ(FingerprintOfSdf(world), before);
  folder.Put("meshes/other.obj", "v 0 0 1\n");
  EXPECT_EQ(FingerprintOfSdf(world), before);
  folder.Put("meshes/hill.obj", "v 0 0 1\n");
  EXPECT_NE(FingerprintOfSdf(world), before);
}

TEST(Fingerprint, OfAFileThatIsNotThereIsAnError) {
  EXPECT_THROW(FingerprintOfFile("/nowhere/at/all"), std::runtime_error);
}

}  // namespace
}  // namespace eod::batch
