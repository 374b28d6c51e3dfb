#include <fmt/format.h>
#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"

/// Parts that do not belong together, and steps that one rank cannot read for all.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class DealtFaults : public testing::Test {
protected:
    /// FOLDER/all.pvd, whose only time has these files.
    std::string collect(const std::vector<std::string>& files) const
    {
        std::string sets;
        for (std::size_t i = 0; i < files.size(); ++i)
            sets += fmt::format("<DataSet timestep=\"0\" part=\"{}\" file=\"{}\"/>\n", i, files[i]);
        writeBytes(path("all.pvd"), "<VTKFile type=\"Collection\"><Collection>\n" + sets + "</Collection></VTKFile>\n");
        return path("all.pvd");
    }

    /// Every rank, of one or of three, refuses the scene with this line.
    static void expectRefused(const SceneDescription& description, const std::string& line)
    {
        for (const int ranks : {1, 3})
            runRanks(ranks, [&](Communicator& communicator) {
                CommunicatorAgreement agreement(communicator);
                std::string said;
                try {
                    const LoadedScene loaded(description, {}, agreement);
                } catch (const InputError& error) {
                    said = error.what();
                }
                EXPECT_EQ(said, line) << ranks << " ranks";
            });
    }

    std::string path(const std::string& name) const { return folder_.file(name); }

    TempFolder folder_;
};

TEST_F(DealtFaults, PartsOfASurfaceHaveTheSameArrays)
{
    writeSheetFile(path("with.vtp"));
    SheetSample plain;
    plain.arrays = false;
    plain.shift = {1, 0, 0.1};
    writeSheetFile(path("without.vtp"), plain);
    const std::string other =
        ": it has other arrays to draw than the parts before; expected the same in all parts of a "
        "surface, on points or on cells";
    expectRefused(describe(collect({"with.vtp", "without.vtp"}), "tornado", "q"), path("without.vtp") + other);
    expectRefused(describe(collect({"without.vtp", "with.vtp"}), "tornado", "q"), path("with.vtp") + other);
    const Scene uncoloured = loadScene(describe(collect({"with.vtp", "without.vtp"}), "tornado"));
    EXPECT_FALSE(uncoloured.surface.triangles.empty()) << "arrays that are not drawn may differ";
}

TEST_F(DealtFaults, APartWithoutTheArrayIsNamed)
{
    writeGridFile(path("with.vtu"));
    GridSample other;
    other.leaveOut = {"U"};
    writeGridFile(path("without.vtu"), other);
    SceneDescription description = describe("sphere:9", collect({"with.vtu", "without.vtu"}));
    description.field.vectors = "U";
    expectRefused(description, path("without.vtu") +
                                   ": no array 'U' on its points; expected the arrays of the first part in every part");
}

/// One rank reads a surface for all. Those that did not fail have read what comes behind it.
TEST_F(DealtFaults, AfterAStepThatCannotBeReadAllRanksGoOnTogether)
{
    for (int i = 0; i < 3; ++i) {
        SheetSample sheet;
        sheet.twist = 0.1 * i;
        writeSheetFile(path(fmt::format("s_{}.vtp", i)), sheet);
        GridSample around;
        around.scale = 1 + i;
        around.origin = {-1, -0.5, -0.5};
        writeGridFile(path(fmt::format("f_{}.vti", i)), around);
        writeGridFile(path(fmt::format("c_{}.vtu", i)), around);
    }
    const std::string sound = readBytes(path("s_1.vtp"));
    for (const char* field : {"f_%d.vti", "c_%d.vtu"})
        for (const int ranks : {1, 2, 3}) {
            writeBytes(path("s_1.vtp"), sound.substr(0, sound.size() / 2));
            std::mutex mutex;
            std::vector<std::string> shown;
            const auto onEachRank = [&](Communicator& communicator) {
                CommunicatorAgreement agreement(communicator);
                LoadedScene scene(describe(path("s_%d.vtp"), path(field), "U:mag"), {}, agreement);
                scene.moveTo(2);
                const std::string before = fingerprint(scene.scene());
                EXPECT_THROW(scene.moveTo(1), InputError);
                scene.moveTo(2);
                EXPECT_EQ(fingerprint(scene.scene()), before) << field << ", " << ranks << " ranks";
                agreement.together([&] {
                    if (communicator.rank() == 0) writeBytes(path("s_1.vtp"), sound);
                });
                scene.moveTo(1);
                const std::lock_guard lock(mutex);
                shown.push_back(fingerprint(scene.scene()));
            };
            runRanks(ranks, onEachRank);
            for (const std::string& each : shown) EXPECT_EQ(each, shown.front());
        }
}

}  // namespace
}  // namespace aeolic
