#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/vtk/testing/sample_files.h"

/// Headers of NRRD files that VTK 9.1 alone would misread.
namespace aeolic {
namespace {

using namespace test;

class NrrdHeader : public testing::Test {
protected:
    void SetUp() override
    {
        std::string values;
        for (int i = 0; i < 3 * 60; ++i) {
            const float value = float(i);
            values.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
        writeBytes(folder_.file("a.raw"), values);
        values_ = values;
    }

    FileSummary summaryOf(const std::string& name, const std::string& bytes) const
    {
        writeBytes(folder_.file(name), bytes);
        return fileInfo(folder_.file(name)).summary;
    }

    static void expectVectors(const FileSummary& file, double spacing)
    {
        EXPECT_EQ(file.dims, (std::array<int, 3>{5, 4, 3}));
        ASSERT_EQ(file.arrays.size(), 1u);
        EXPECT_EQ(file.arrays[0].components, 3);
        EXPECT_EQ((*file.arrays[0].range)[0], std::sqrt(5.0));
        EXPECT_EQ((*file.spacingWorld)[1], spacing);
    }

    TempFolder folder_;
    std::string values_;
};

const std::string plain =
    "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 5 4 3\nspacings: nan 1 2 1\nencoding: raw\nendian: little\n";
const std::string ofSlicer =
    "NRRD0004\n# Complete NRRD file format specification at:\ntype: float\ndimension: 4\n"
    "space: left-posterior-superior\nsizes: 3 5 4 3\nspace directions: none (1,0,0) (0,2,0) (0,0,1)\n"
    "kinds: vector domain domain domain\nendian: little\nencoding: raw\nspace origin: (0,0,0)\n";

TEST_F(NrrdHeader, MayEndWithoutALineEnd)
{
    expectVectors(summaryOf("a.nhdr", plain + "data file: a.raw\n"), 2);
    expectVectors(summaryOf("a.nhdr", plain + "data file: a.raw"), 2);
    expectVectors(summaryOf("a.nrrd", plain + "\n" + values_), 2);
}

TEST_F(NrrdHeader, MaySayItsSpaceBeforeItsSizes)
{
    expectVectors(summaryOf("a.nhdr", ofSlicer + "data file: a.raw\n"), 2);
    expectVectors(summaryOf("a.nrrd", ofSlicer + "\n" + values_), 2);
}

TEST_F(NrrdHeader, WithBinaryNumbersIsRefusedAtOnce)
{
    const std::string numbers(8, '\0');
    for (const char* name : {"a.nhdr", "a.nrrd"}) {
        try {
            summaryOf(name, plain + "space origin: (0,0,0)" + numbers + "\ndata file: a.raw\n");
            FAIL() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("its header is not all text"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace aeolic
