#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "data/scene.h"
#include "engine/renderer_internals.h"
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
    const Picture before = memory.render({scene_.camera});
    EXPECT_EQ(before.pixels, files.render({scene_.camera}).pixels);
    files.setTime(1);
    memory.setData({bent.surface(), {}});
    const Picture after = memory.render({scene_.camera});
    EXPECT_EQ(after.pixels, files.render({scene_.camera}).pixels);
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
    EXPECT_EQ(memory.render({scene_.camera}).pixels, before.pixels);
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
    EXPECT_EQ(memory.render({scene_.camera}).pixels, files.render({scene_.camera}).pixels);
    EXPECT_EQ(RendererInternals::scene(memory).field->samples.get(), second.u.data());
}

/// What a renderer of these data alone warns of.
std::vector<std::string> warningsOf(const SceneDescription& scene, const Data& data)
{
    return Renderer(scene, data).info().warnings;
}

TEST_F(MemoryTest, WarningsAreThoseOfTheDataThatAreShown)
{
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "q";
    scene_.shading.scalarBar = false;  // There is no room for it.
    const MemorySheet good(4);
    MemorySheet none(4), some(4), still(4);
    std::fill(none.tau.begin(), none.tau.end(), kNan);
    some.q[3] = some.tau[6] = some.points[0] = kNan;
    std::fill(still.tau.begin() + 15, still.tau.end(), 0.0F);
    Renderer renderer(scene_, Data{good.surface(), {}});
    renderer.render({scene_.camera});
    for (const MemorySheet* sheet : {&none, &some, &still}) {
        const auto expected = warningsOf(scene_, Data{sheet->surface(), {}});
        EXPECT_FALSE(expected.empty());
        renderer.setData(Data{sheet->surface(), {}});
        EXPECT_EQ(renderer.info().warnings, expected);
    }
    const Picture before = Renderer(scene_, Data{good.surface(), {}}).render({scene_.camera});
    renderer.setData(Data{good.surface(), {}});
    EXPECT_EQ(renderer.info().warnings, std::vector<std::string>{});
    EXPECT_EQ(renderer.render({scene_.camera}).pixels, before.pixels) << "ranges are still those of the first";
}

TEST_F(MemoryTest, WarningsOfWhatStaysStay)
{
    MemorySheet sheet(4);
    for (std::size_t i = 2; i < sheet.points.size(); i += 3) sheet.points[i] += 0.5F;
    MemorySheet gaps = sheet;
    gaps.points[0] = kNan;
    const MemoryGrid good;
    MemoryGrid still, masked;
    std::fill(still.u.begin(), still.u.end(), 0.0F);
    masked.u[30] = kNan;
    Renderer renderer(scene_, Data{gaps.surface(), good.grid()});
    const std::vector<std::string> ofGaps = renderer.info().warnings;
    EXPECT_EQ(ofGaps.size(), 1u);
    for (const MemoryGrid* grid : std::initializer_list<const MemoryGrid*>{&still, &masked, &good}) {
        renderer.setData(Data{{}, grid->grid()});
        const auto expected = warningsOf(scene_, Data{gaps.surface(), grid->grid()});
        EXPECT_EQ(renderer.info().warnings, expected);
        EXPECT_EQ(expected == ofGaps, grid == &good);
    }
    renderer.setData(Data{sheet.surface(), masked.grid()});
    EXPECT_EQ(renderer.info().warnings, warningsOf(scene_, Data{sheet.surface(), masked.grid()}));
}

TEST_F(MemoryTest, SeveralSurfacesWarnOfOtherDataOnce)
{
    SurfaceItem slice, ball;
    scene_.field.vectors = "U";
    slice.spec = "slice:0.5,0.5,0.5:0,0.2,1";
    ball.spec = "sphere";
    scene_.surfaces = {slice, ball};
    MemoryVolume good, masked;
    masked.u[3] = kNan;
    Data data, other;
    data.volume = good.volume();
    other.volume = masked.volume();
    Renderer renderer(scene_, data);
    const auto first = renderer.info().warnings;
    renderer.setData(other);
    EXPECT_EQ(renderer.info().warnings, warningsOf(scene_, other));
    EXPECT_NE(renderer.info().warnings, first);
    renderer.setData(data);
    EXPECT_EQ(renderer.info().warnings, first);
}

TEST_F(MemoryTest, EveryRankWarnsOfAllPieces)
{
    scene_.field.vectors = "tau";
    scene_.run.threads = 1;
    const auto sheetOf = [](bool whole, int rank) {
        MemorySheet sheet(8, 0, whole ? 0 : 4 * rank, whole ? 8 : 4 * rank + 4);
        std::fill(sheet.tau.end() - 27, sheet.tau.end(), rank == 1 ? kNan : sheet.tau[0]);
        return sheet;
    };
    const auto expected = warningsOf(scene_, Data{sheetOf(true, 1).surface(), {}});
    EXPECT_FALSE(expected.empty());
    runRanks(2, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const MemorySheet good(8, 0, 4 * rank, 4 * rank + 4), bad = sheetOf(false, rank);
        Renderer renderer(scene_, Data{good.surface(), {}},
                          std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        EXPECT_TRUE(renderer.info().warnings.empty());
        renderer.setData({bad.surface(), {}});
        const Renderer fresh(scene_, Data{bad.surface(), {}},
                             std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        EXPECT_FALSE(renderer.info().warnings.empty());
        EXPECT_EQ(renderer.info().warnings, fresh.info().warnings);
    });
}

TEST_F(MemoryTest, EveryRankGivesItsPiece)
{
    scene_.shading.colorBy = "q";
    scene_.field.vectors = "tau";
    scene_.run.threads = 1;
    const MemorySheet whole(8, 0.2);
    // The pieces' points at common borders are others than the whole's: normals there are those of each piece's cells.
    scene_.surface.featureAngle = 0;
    Renderer alone(scene_, Data{whole.surface(), {}});
    const Picture expected = alone.render({scene_.camera});
    alone.setData({MemorySheet(8, 0.1).surface(), {}});
    const Picture next = alone.render({scene_.camera});
    const int cut[5] = {0, 3, 3, 7, 8};  // The second rank has none.
    runRanks(4, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const auto piece = [&](double twist) { return MemorySheet(8, twist, cut[rank], cut[rank + 1]); };
        const MemorySheet mine = piece(0.2), later = piece(0.1);
        Renderer renderer(scene_, Data{mine.surface(), {}},
                          std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const Picture picture = renderer.render({scene_.camera});
        EXPECT_EQ(renderer.info().triangles, 128u);
        renderer.setData({later.surface(), {}});
        const Picture moved = renderer.render({scene_.camera});
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
