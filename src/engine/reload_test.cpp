#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"

/// A renderer that takes another scene after the process has gone to another folder.
namespace aeolic {
namespace {

using namespace test;
namespace fs = std::filesystem;

class Reload : public testing::Test {
protected:
    Reload()
    {
        fs::create_directories(folder_.file("there"));
        for (int i = 0; i < 3; ++i) {
            SheetSample sheet;
            sheet.twist = 0.3 * i;
            writeSheetFile(folder_.file("s_" + std::to_string(i) + ".vtp"), sheet);
        }
        std::ofstream(folder_.file("mine.csv")) << "0,0,0,0\n1,255,0,0\n";
        fs::current_path(folder_.file("."));
        scene_.surface.spec = "s_*.vtp";
        scene_.field.vectors = "tau";
        scene_.lic.steps = 12;
        scene_.output.width = 90;
        scene_.output.height = 70;
        scene_.run.backend = BackendChoice::cpu;
        scene_.shading.colormap = "mine.csv";
        next_ = scene_;
        next_.shading.colorBy = "q";
    }
    ~Reload() override { fs::current_path(home_); }
    void goThere() const { fs::current_path(folder_.file("there")); }

    static std::string complaint(const std::function<void()>& action)
    {
        try {
            action();
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    }

    const fs::path home_ = fs::current_path();
    TempFolder folder_;
    SceneDescription scene_, next_;
};

TEST_F(Reload, FilesAreThoseOfTheFirstFolder)
{
    const Picture expected = Renderer(next_).render({});
    Renderer renderer(scene_);
    EXPECT_NE(renderer.render({}).pixels, expected.pixels);
    goThere();
    renderer.reload(next_);
    EXPECT_EQ(renderer.render({}).pixels, expected.pixels);
    renderer.reload(scene_);
    renderer.reload(next_);
    EXPECT_EQ(renderer.render({}).pixels, expected.pixels) << "again";
}

TEST_F(Reload, NamesStayAsTyped)
{
    Renderer renderer(scene_);
    goThere();
    renderer.reload(next_);
    EXPECT_EQ(renderer.description().surface.spec, "s_*.vtp");
    EXPECT_EQ(renderer.description().shading.colormap, "mine.csv");
    fs::remove(folder_.file("s_2.vtp"));
    EXPECT_EQ(complaint([&] { renderer.setTime(2); }).substr(0, 9), "s_2.vtp: ");
    next_.surface.spec = "none.vtp";
    EXPECT_EQ(complaint([&] { renderer.reload(next_); }).substr(0, 10), "none.vtp: ");
    EXPECT_EQ(renderer.description().surface.spec, "s_*.vtp") << "everything stays";
    EXPECT_FALSE(renderer.render({}).pixels.empty());
}

/// A map that was named in another folder keeps its meaning.
TEST_F(Reload, ColourMapsKeepTheirColours)
{
    std::ofstream(folder_.file("there/later.csv")) << "0,0,0,0\n1,0,0,255\n";
    Renderer renderer(next_);
    goThere();
    ShadingOptions shading = next_.shading;
    shading.colormap = "later.csv";
    renderer.setShading(shading);
    const Picture before = renderer.render({});
    next_.shading = shading;
    renderer.reload(next_);
    EXPECT_EQ(renderer.render({}).pixels, before.pixels);
}

}  // namespace
}  // namespace aeolic
