#include <cgns_io.h>
#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "reader/cgns/testing/sample_cgns.h"

/// CGNS files in ADF hold what those in HDF5 hold.

namespace aeolic {
namespace {

using namespace test;
using Cells = SampleCgns::Cells;

/// By the CGNS library, with the nodes that links lead to in their place.
void copyToAdf(const std::string& from, const std::string& to)
{
    int in = 0, out = 0;
    ASSERT_EQ(cgio_open_file(from.c_str(), CGIO_MODE_READ, CGIO_FILE_NONE, &in), 0);
    ASSERT_EQ(cgio_open_file(to.c_str(), CGIO_MODE_WRITE, CGIO_FILE_ADF, &out), 0);
    ASSERT_EQ(cgio_copy_file(in, out, 1), 0);
    cgio_close_file(in);
    cgio_close_file(out);
}

class CgnsAdf : public testing::Test {
protected:
    TempFolder folder_;
    const std::string hdf5_ = folder_.file("hdf5.cgns"), adf_ = folder_.file("adf.cgns");

    void write(const SampleCgns& sample)
    {
        writeSampleCgns(hdf5_, sample);
        copyToAdf(hdf5_, adf_);
    }

    static std::string sceneOf(const std::string& surface, const std::string& field, std::optional<double> time = {})
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = "Velocity";
        description.shading.colorBy = "Pressure";
        description.time.moment = time;
        return fingerprint(loadScene(description));
    }
};

TEST_F(CgnsAdf, TheSameVolumesAndBoundaries)
{
    for (const Cells cells : {Cells::structured, Cells::hexahedra, Cells::mixed, Cells::polyhedra})
        for (const bool doubles : {true, false}) {
            SCOPED_TRACE(int(cells));
            write({.cells = cells, .doubles = doubles, .steps = 3, .secondZone = true, .secondBase = true});
            for (const char* surface : {"boundary", "slice:2,2,1.3:0.1,0.2,1"})
                EXPECT_EQ(sceneOf(surface, adf_ + ":box", 0.25), sceneOf(surface, hdf5_ + ":box", 0.25)) << surface;
            EXPECT_EQ(sceneOf(adf_ + ":floor", adf_ + ":box"), sceneOf(hdf5_ + ":floor", hdf5_ + ":box"));
        }
}

TEST_F(CgnsAdf, TheSameFacts)
{
    write({.steps = 2, .secondZone = true});
    std::string adf = describeFile(adf_), hdf5 = describeFile(hdf5_);
    for (std::size_t at; (at = adf.find("adf.cgns")) != std::string::npos;) adf.replace(at, 8, "hdf5.cgns");
    const auto withoutFirstLine = [](const std::string& text) { return text.substr(text.find('\n')); };
    EXPECT_EQ(withoutFirstLine(adf), withoutFirstLine(hdf5));  // Which tells the file's size.
}

TEST_F(CgnsAdf, FilesThatEndEarlyAreRefused)
{
    write({});
    const std::string bytes = readBytes(adf_);
    for (const std::size_t length : {std::size_t(40), bytes.size() / 4, bytes.size() / 2, bytes.size() - 200}) {
        writeBytes(adf_, bytes.substr(0, length));
        try {
            describeFile(adf_);
            sceneOf("boundary", adf_);
            EXPECT_GT(length, bytes.size() / 2) << "a file of half its length is drawn";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("adf.cgns"), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace aeolic
