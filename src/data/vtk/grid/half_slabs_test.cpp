#include "data/vtk/grid/half_slabs.h"

#include <gtest/gtest.h>

#include <cstring>

#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

using namespace test;

/// Whatever the slabs: the halves of the field read at once.
TEST(HalfSlabs, AreTheHalvesOfTheWhole)
{
    const TempFolder folder;
    for (const auto& [name, encoding] :
         {std::pair("a.vti", Encoding::raw), std::pair("b.vti", Encoding::zlib), std::pair("c.pvti", Encoding::raw)}) {
        GridSample sample;
        sample.encoding = encoding;
        sample.nanPoints = {5, 400};
        sample.maskedPoints = {60};
        sample.doubles = true;
        writeGridFile(folder.file(name), sample);
        SceneDescription description;
        description.surface.spec = "boundary";
        description.field.spec = folder.file(name);
        description.field.precision = FieldPrecision::float16;
        const Scene whole = loadScene(description);

        for (const std::int64_t slabBytes : {1, 2000, 1 << 20}) {
            FileReader reader(folder.file(name), FileReader::Use::field);
            const auto arrays = reader.announcedArrays();
            const auto vectors =
                std::find_if(arrays.begin(), arrays.end(), [](const ArrayInfo& a) { return a.name == "U"; });
            ASSERT_NE(vectors, arrays.end());
            const HalfVectors halves =
                readHalves(reader, *reader.wholeImage(), *vectors, folder.file(name), {}, slabBytes);
            EXPECT_EQ(std::memcmp(halves.samples.get(), whole.field->samples.get(), whole.field->bytes()), 0)
                << name << ", slabs of " << slabBytes;
            EXPECT_EQ(halves.masked.maxMagnitude, whole.field->maxMagnitude);
            EXPECT_EQ(halves.masked.masked + halves.masked.nonFinite, 3);
            EXPECT_EQ(halves.structure->GetNumberOfPoints(), 9 * 8 * 7);
        }
    }
}

/// Bricks, whose ghosts are in two or more of them, slab by slab.
TEST(HalfSlabs, OfBricksCountEverySampleOnce)
{
    const TempFolder folder;
    GridSample sample;
    for (int i = 0; i < 9 * 8 * 7; i += 5) sample.nanPoints.push_back(i);
    sample.maskedPoints = {60, 61, 62};
    sample.scale = 30000;
    writeGridFile(folder.file("a.vti"), sample);
    MaskResult whole, parts;
    std::int64_t wholeClamped = 0, clamped = 0;
    for (const int ranks : {1, 5}) {
        parts = {};
        clamped = 0;
        for (int rank = 0; rank < ranks; ++rank) {
            FileReader reader(folder.file("a.vti"), FileReader::Use::field);
            const auto arrays = reader.announcedArrays();
            const ImagePiece piece = ranks == 1 ? *reader.wholeImage() : reader.keepBrick({rank, ranks}, rank == 2);
            const HalfVectors halves =
                readHalves(reader, piece, chooseVectors(arrays, "U", "a.vti"), folder.file("a.vti"), {}, 700);
            parts.add(halves.masked);
            clamped += halves.clamped;
        }
        if (ranks == 1) whole = parts, wholeClamped = clamped;
    }
    EXPECT_EQ(whole.masked, 3);
    EXPECT_EQ(whole.masked + whole.nonFinite, std::int64_t(sample.nanPoints.size()) + 2) << "60 is both";
    EXPECT_GT(wholeClamped, 0);
    EXPECT_EQ(parts.masked, whole.masked);
    EXPECT_EQ(parts.nonFinite, whole.nonFinite);
    EXPECT_EQ(parts.all, whole.all);
    EXPECT_EQ(parts.maxMagnitude, whole.maxMagnitude);
    EXPECT_EQ(clamped, wholeClamped);
}

}  // namespace
}  // namespace aeolic
