#include <gtest/gtest.h>

#include "data/scene.h"
#include "memory_scenes_testing.h"
#include "ranks/thread_communicator.h"

/// Other data in the caller's memory, and a piece of it on every rank.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

TEST_F(MemoryTest, NewDataAreDrawnAsTheNextStepOfASeriesIs)
{
    SheetSample first, second;
    second.twist = 0.2;
    writeSheetFile(folder_.file("s_0.vtp"), first);
    writeSheetFile(folder_.file("s_1.vtp"), second);
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "q";
    SceneDescription series = scene_;
    series.surface.spec = folder_.file("s_%d.vtp");
    Renderer files(series);
    const MemorySheet flat(4), bent(4, 0.2);
    Renderer memory(scene_, Data{flat.surface(), {}});
    const Picture before = memory.render(scene_.camera);
    EXPECT_EQ(before.pixels, files.render(scene_.camera).pixels);
    files.setTime(1);
    memory.setData({bent.surface(), {}});
    const Picture after = memory.render(scene_.camera);
    EXPECT_EQ(after.pixels, files.render(scene_.camera).pixels);
    EXPECT_NE(after.pixels, before.pixels);

    const MemorySheet finer(6);  // Other triangles, too.
    memory.setData({finer.surface(), {}});
    EXPECT_EQ(memory.info().triangles, 72u);
    Surface wrong = flat.surface();
    wrong.pointArrays.erase(wrong.pointArrays.begin() + 1);
    EXPECT_THROW(memory.setData({wrong, {}}), InputError) << "no array to colour by";
    EXPECT_EQ(memory.info().triangles, 72u);
    EXPECT_THROW(memory.setData({{}, MemoryGrid().grid()}), InputError) << "it was made without a grid";
    memory.setData({flat.surface(), {}});
    EXPECT_EQ(memory.render(scene_.camera).pixels, before.pixels);
}

TEST_F(MemoryTest, NewGridsCutOtherSurfaces)
{
    scene_.surface.spec = "isosurface:p=90";
    GridSample shifted;
    shifted.origin[2] += 0.1;
    shifted.dims[0] = 8;
    const MemoryGrid first, second(shifted);
    writeGridFile(folder_.file("g_0.vti"), {});
    writeGridFile(folder_.file("g_1.vti"), shifted);
    SceneDescription series = scene_;
    series.field.spec = folder_.file("g_%d.vti");
    Renderer files(series), memory(scene_, Data{{}, first.grid()});
    files.setTime(1);
    memory.setData({{}, second.grid()});
    EXPECT_EQ(memory.render(scene_.camera).pixels, files.render(scene_.camera).pixels);
    EXPECT_EQ(memory.scene().field->samples.get(), second.u.data());
}

TEST_F(MemoryTest, EveryRankGivesItsPiece)
{
    scene_.shading.colorBy = "q";
    scene_.field.vectors = "tau";
    scene_.run.threads = 1;
    const MemorySheet whole(8, 0.2);
    // The pieces' points at common borders are others than the whole's: normals there are those of each piece's cells.
    scene_.surface.featureAngleDeg = 0;
    Renderer alone(scene_, Data{whole.surface(), {}});
    const Picture expected = alone.render(scene_.camera);
    alone.setData({MemorySheet(8, 0.1).surface(), {}});
    const Picture next = alone.render(scene_.camera);
    const int cut[5] = {0, 3, 3, 7, 8};  // The second rank has none.
    runRanks(4, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const auto piece = [&](double twist) { return MemorySheet(8, twist, cut[rank], cut[rank + 1]); };
        const MemorySheet mine = piece(0.2), later = piece(0.1);
        Renderer renderer(scene_, Data{mine.surface(), {}},
                          std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const Picture picture = renderer.render(scene_.camera);
        EXPECT_EQ(renderer.info().triangles, 128u);
        renderer.setData({later.surface(), {}});
        const Picture moved = renderer.render(scene_.camera);
        if (rank != 0) return;
        EXPECT_EQ(picture.pixels, expected.pixels);
        EXPECT_EQ(moved.pixels, next.pixels);
    });
}

TEST_F(MemoryTest, RanksMustGiveTheSameArrays)
{
    scene_.field.vectors = "tau";
    const auto complaintOn = [&](const auto& change) {
        std::string said;
        runRanks(2, [&](Communicator& communicator) {
            const MemorySheet sheet(4, 0, 2 * communicator.rank(), 2 * communicator.rank() + 2);
            Data data{sheet.surface(), {}};
            if (communicator.rank() == 1) change(data);
            try {
                Renderer renderer(scene_, data, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
            } catch (const InputError& error) {
                if (communicator.rank() == 0) said = error.what();
            }
        });
        return said;
    };
    EXPECT_EQ(complaintOn([](Data&) {}), "");
    EXPECT_NE(complaintOn([](Data& data) { data.surface->pointArrays.pop_back(); }).find("the data in memory"),
              std::string::npos);
    EXPECT_NE(complaintOn([](Data& data) { data.surface->points.count = 3; }).find("does not exist"),
              std::string::npos);
}

}  // namespace
}  // namespace aeolic
