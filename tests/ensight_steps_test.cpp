#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_writers.h"
#include "part_formats_testing.h"
#include "reader/ensight/testing/sample_ensight.h"

/// Cases with several steps in a file, and of EnSight 6, which VTK reads.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr std::size_t kQuads = kSampleCells * kSampleCells;

class EnSightSteps : public testing::Test {
protected:
    Scene load(const std::string& surface, const std::string& field = "", std::optional<double> time = {}) const
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = "U";
        description.shading.colorBy = "p";
        description.time.moment = time;
        return loadScene(description);
    }

    void replace(const std::string& was, const std::string& with) const
    {
        std::string text = readBytes(case_);
        ASSERT_NE(text.find(was), std::string::npos) << was;
        writeBytes(case_, text.replace(text.find(was), was.size(), with));
    }

    std::string complaint(std::optional<double> time = {}) const
    {
        try {
            load(case_ + ":walls", "", time);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    /// What the sample's cases hold, by whoever reads them.
    void expectSample() const
    {
        for (const double time : {0.0, 0.75, 1.5}) {
            const Scene scene = load(case_ + ":walls", "", time);
            EXPECT_EQ(scene.surface.triangles.size(), 2 * kQuads);
            EXPECT_EQ(scene.surface.positions.size(), (kSampleCells + 1) * (kSampleCells + 1));
            expectVectors(scene, [&](const glm::dvec3& p) {
                return glm::dvec3(sampleFlow(glm::vec3(p), 0)) + glm::dvec3(time / 1.5, 0, 0);
            });
        }
        EXPECT_EQ(load("boundary", case_ + ":fluid").surface.triangles.size(), 12 * kQuads);
        EXPECT_EQ(load(case_ + ":walls", case_ + ":fluid").surface.triangles.size(), 2 * kQuads);
        const FileInfo info = fileInfo(case_);
        for (const char* word : {"walls", "fluid", "1.5", "--vectors U"})
            EXPECT_NE(info.text.find(word), std::string::npos) << info.text;
    }

    TempFolder folder_;
    std::string case_ = folder_.file("box.case");
};

/// Steps as EnSight Gold writes them into one file.
TEST_F(EnSightSteps, SeveralStepsInAFile)
{
    for (const EnSightFormat& format :
         {EnSightFormat{EnSightEncoding::fortran, true}, EnSightFormat{EnSightEncoding::binary, false},
          EnSightFormat{EnSightEncoding::ascii, false}}) {
        writeSampleEnSight(folder_.path().string(), {.format = format});
        for (const char* name : {"U", "p", "q"}) {
            EnSightBytes begin(format), end(format);
            begin.text("BEGIN TIME STEP");
            end.text("END TIME STEP");
            std::string all;
            for (const char* step : {".0000", ".0001"}) {
                const std::string file = folder_.file(std::string(name) + step);
                all += begin.bytes() + readBytes(file) + end.bytes();
                std::filesystem::remove(file);
            }
            writeBytes(folder_.file(std::string(name) + ".all"), all);
        }
        replace("1 U U.****", "1 1 U U.all");
        replace("1 q q.****", "1 1 q q.all");
        replace("1 p p.****", "1 1 p p.all");
        writeBytes(case_, readBytes(case_) + "\nFILE\nfile set: 1\nnumber of steps: 2\n");
        SCOPED_TRACE(int(format.encoding));
        expectSample();
    }
    // A name with an index, as where the steps lie in several files.
    for (const std::string name : {"U", "p", "q"}) {
        std::filesystem::rename(folder_.file(name + ".all"), folder_.file(name + ".07"));
        replace(name + ".all", name + ".**");
    }
    std::string named = readBytes(case_);
    named.resize(named.find("file set: 1\n"));
    writeBytes(case_, named + "file set: 1\nfilename index: 7\nnumber of steps: 2\n");
    expectSample();
    writeBytes(case_, named + "file set: 1\nfilename index: 7\nnumber of steps: 1\n");
    EXPECT_NE(complaint().find("file set 1 of 'U.**' has 1 steps; expected 2"), std::string::npos) << complaint();
    writeBytes(case_, named + "file set: 1\nfilename index: 7\nnumber of steps: 3\n");
    expectSample();
    const std::string steps = readBytes(folder_.file("U.07"));
    writeBytes(folder_.file("U.07"), steps.substr(0, steps.size() / 2));
    EXPECT_NE(complaint(1.5).find("U.07: at byte 0 the step 2 is not there"), std::string::npos) << complaint(1.5);
}

TEST_F(EnSightSteps, EnSight6)
{
    writeSampleEnSight6(folder_.path().string());
    expectSample();
}

/// Whoever reads the data, the picture is the same.
TEST_F(EnSightSteps, TheSamePictureAsEnSightGold)
{
    const auto picture = [&] {
        SceneDescription scene;
        scene.surface.spec = case_ + ":walls";
        scene.field.vectors = "U";
        scene.shading.colorBy = "p";
        scene.output.width = scene.output.height = 64;
        scene.run.backend = BackendChoice::cpu;
        return Renderer(scene).render().pixels;
    };
    writeSampleEnSight(folder_.path().string());
    const auto gold = picture();
    writeSampleEnSight6(folder_.path().string());
    EXPECT_EQ(picture(), gold);
}

TEST_F(EnSightSteps, DamagedCases)
{
    writeSampleEnSight6(folder_.path().string());
    const std::string geometry = readBytes(folder_.file("box.geo"));
    for (const std::size_t left : {std::size_t(0), std::size_t(40), geometry.size() / 3, geometry.size() / 2}) {
        writeBytes(folder_.file("box.geo"), geometry.substr(0, left));
        EXPECT_TRUE(complaint().starts_with(case_)) << left << complaint();
    }
    std::filesystem::remove(folder_.file("box.geo"));
    EXPECT_TRUE(complaint().starts_with(case_)) << complaint();
    writeBytes(case_, "FORMAT\ntype: ensight\n");
    EXPECT_TRUE(complaint().starts_with(case_)) << complaint();
}

}  // namespace
}  // namespace aeolic
