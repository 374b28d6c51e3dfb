#include "data/vtk/half_slabs.h"

#include <gtest/gtest.h>

#include <cstring>

#include "data/scene.h"
#include "data/vtk/sample_files.h"

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
        description.field.precision = "half";
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

}  // namespace
}  // namespace aeolic
