#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "aeolic/error.h"
#include "data/load/scene_sizes.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"

/// A field read in bricks: every rank its part, with the bits of the whole.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr Split kBricks{true, false};

SceneDescription describe(const std::string& field, const std::string& surface = "sphere",
                          const std::string& colorBy = "")
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    description.shading.colorBy = colorBy;
    return description;
}

template <class T>
void expectPartOf(const GridField& whole, const GridField& part)
{
    ASSERT_TRUE(part.brick);
    EXPECT_EQ(part.dims, whole.dims);
    EXPECT_EQ(part.originWorld, whole.originWorld);
    EXPECT_EQ(part.spacingWorld, whole.spacingWorld);
    const GridIndex held = part.heldDims(), first = part.firstSample();
    const auto* wholeSamples = static_cast<const T*>(whole.samples.get());
    const auto* partSamples = static_cast<const T*>(part.samples.get());
    const std::int64_t components = whole.components;
    for (std::int64_t z = 0; z < held[2]; ++z)
        for (std::int64_t y = 0; y < held[1]; ++y) {
            const std::int64_t from = ((z + first[2]) * whole.dims[1] + y + first[1]) * whole.dims[0] + first[0];
            ASSERT_EQ(std::memcmp(partSamples + (z * held[1] + y) * held[0] * components,
                                  wholeSamples + from * components, std::size_t(held[0] * components) * sizeof(T)),
                      0)
                << "row " << y << ", " << z;
        }
}

void expectBricksOf(const SceneDescription& description, int ranks)
{
    const Scene whole = loadScene(description);
    std::int64_t cells = 0;
    double maxVector = 0, lo = 1e300, hi = -1e300;
    for (const Scene& part : loadParts(description, kBricks, ranks)) {
        ASSERT_TRUE(part.bricked());
        description.field.precision == FieldPrecision::float16 ? expectPartOf<std::uint16_t>(*whole.field, *part.field)
                                                               : expectPartOf<float>(*whole.field, *part.field);
        if (whole.scalarField) expectPartOf<float>(*whole.scalarField, *part.scalarField);
        const Brick& brick = *part.field->brick;
        cells += (brick.cellHi[0] - brick.cellLo[0]) * (brick.cellHi[1] - brick.cellLo[1]) *
                 (brick.cellHi[2] - brick.cellLo[2]);
        maxVector = std::max(maxVector, part.maxVector);
        if (!part.scalarRangeKnown) continue;
        lo = std::min(lo, part.scalarRange[0]);
        hi = std::max(hi, part.scalarRange[1]);
    }
    const GridIndex& dims = whole.field->dims;
    EXPECT_EQ(cells, (dims[0] - 1) * (dims[1] - 1) * (dims[2] - 1));
    EXPECT_EQ(maxVector, whole.maxVector);
    if (!whole.scalarRangeKnown) return;
    EXPECT_EQ(lo, whole.scalarRange[0]);
    EXPECT_EQ(hi, whole.scalarRange[1]);
}

TEST(LoadBricks, OfABuiltInFlow)
{
    for (const int ranks : {2, 3, 8}) expectBricksOf(describe("abc:20,17,13", "teapot:500", "abc:mag"), ranks);
}

TEST(LoadBricks, OfImageFiles)
{
    for (const auto& [name, encoding] : {std::pair("a.vti", Encoding::raw), std::pair("b.vti", Encoding::zlib),
                                         std::pair("c.vti", Encoding::ascii), std::pair("d.pvti", Encoding::raw)}) {
        const TempFolder folder;
        GridSample sample;
        sample.encoding = encoding;
        writeGridFile(folder.file(name), sample);
        for (const int ranks : {2, 3, 5}) expectBricksOf(describe(folder.file(name), "slice:0,0,1:0,0,1", "p"), ranks);
    }
}

/// A header beside raw values: read by offset.
void writeNrrd(const std::string& header, const std::string& raw, const std::string& place)
{
    std::string values;
    for (int z = 0; z < 7; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 9; ++x)
                for (const float v : {float(x), float(y * 10), float(z * 100)})
                    values.append(reinterpret_cast<const char*>(&v), sizeof v);
    writeBytes(raw, values);
    writeBytes(header, "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 9 8 7\nkinds: vector domain domain domain\n" +
                           place + "\nendian: little\nencoding: raw\ndata file: " +
                           std::filesystem::path(raw).filename().string() + "\n");
}

TEST(LoadBricks, OfRawValuesByOffset)
{
    const TempFolder folder;
    writeNrrd(folder.file("a.nhdr"), folder.file("a.raw"), "spacings: nan 0.25 0.5 1\nspace origin: (1,2,3)");
    const SceneDescription description = describe(folder.file("a.nhdr"), "slice:2,3,5:0,0,1");
    for (const int ranks : {2, 3, 5}) expectBricksOf(description, ranks);
    const Scene whole = loadScene(description);
    EXPECT_EQ(whole.field->dims, (GridIndex{9, 8, 7}));
    EXPECT_EQ(whole.field->spacingWorld, glm::dvec3(0.25, 0.5, 1));
    EXPECT_EQ(whole.field->originWorld, glm::dvec3(1, 2, 3));
    EXPECT_EQ(whole.field->floats()[3 * (9 * 8 * 2 + 9 * 3 + 4) + 1], 30.0f);
}

TEST(LoadBricks, RawValuesThatAreMissingOrUnclear)
{
    const TempFolder folder;
    const auto complaint = [&] {
        try {
            loadScene(describe(folder.file("a.nhdr"), "boundary"));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    writeNrrd(folder.file("a.nhdr"), folder.file("a.raw"),
              "space dimension: 3\nspace directions: none (1,0,0) (0,1,0) (0,0,1)");
    EXPECT_EQ(complaint(), "");
    for (const char* turned : {"(0,1,0) (1,0,0) (0,0,1)", "(1,0,0) (0,0.9,0.1) (0,0,1)", "(1,0,0) (0,-1,0) (0,0,1)"}) {
        writeNrrd(folder.file("a.nhdr"), folder.file("a.raw"),
                  std::string("space dimension: 3\nspace directions: none ") + turned);
        EXPECT_NE(complaint().find("axes are turned"), std::string::npos) << turned << ": " << complaint();
    }
    writeNrrd(folder.file("a.nhdr"), folder.file("a.raw"), "spacings: nan 1 1 1");
    EXPECT_EQ(complaint(), "");
    std::filesystem::resize_file(folder.file("a.raw"), 1000);
    EXPECT_NE(complaint(), "");
    std::filesystem::remove(folder.file("a.raw"));
    EXPECT_NE(complaint(), "");
}

TEST(LoadBricks, WithMaskedSamplesAndInHalves)
{
    const TempFolder folder;
    GridSample sample;
    sample.nanPoints = {3, 77, 200, 503};
    sample.doubles = true;
    writeGridFile(folder.file("a.vti"), sample);
    SceneDescription description = describe(folder.file("a.vti"), "boundary", "U:mag");
    expectBricksOf(description, 4);
    description.field.precision = FieldPrecision::float16;
    expectBricksOf(description, 4);
}

TEST(LoadBricks, MoreRanksThanCellsLeaveSomeWithNothing)
{
    const SceneDescription description = describe("rotation:2,2,3", "sphere:200");
    int empty = 0;
    for (const Scene& part : loadParts(description, kBricks, 5)) {
        empty += part.field->brick->empty();
        EXPECT_EQ(part.field->brick->empty(), part.field->sampleCount() == 0);
    }
    EXPECT_EQ(empty, 3);
}

std::string complaintAbout(const SceneDescription& description)
{
    try {
        loadParts(description, kBricks, 2);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(LoadBricks, SayWhatCannotBeSplit)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    EXPECT_EQ(complaintAbout(describe(folder.file("a.vtu"))),
              folder.file("a.vtu") +
                  ": it cannot be read in bricks; expected image data (.vti, .pvti, .nhdr) of at least "
                  "two samples in x, y and z, or --bricks off");
    GridSample onCells;
    onCells.onCells = true;
    writeGridFile(folder.file("c.vti"), onCells);
    EXPECT_NE(complaintAbout(describe(folder.file("c.vti"))).find("is on the cells"), std::string::npos);
    EXPECT_EQ(
        complaintAbout(describe("")),
        "--bricks: there is nothing to split: no field, and a surface that is not in pieces; expected off or auto");
}

TEST(LoadBricks, FieldBytesComeFromTheHeader)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    EXPECT_EQ(fieldBytesOf(describe(folder.file("a.vti"))), 9u * 8 * 7 * 12);
    SceneDescription half = describe("abc:16,16,16");
    EXPECT_EQ(fieldBytesOf(half), 16u * 16 * 16 * 12);
    half.field.precision = FieldPrecision::float16;
    EXPECT_EQ(fieldBytesOf(half), 16u * 16 * 16 * 6);
    EXPECT_EQ(fieldBytesOf(describe("")), 0u);
}

}  // namespace
}  // namespace aeolic
