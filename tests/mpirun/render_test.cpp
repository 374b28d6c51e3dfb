#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "mpirun_testing.h"
#include "pieces_testing.h"

/// `mpirun -n N aeolic render`: the same files as from one process, byte for byte.
namespace aeolic {
namespace {

using namespace testkit;

/// The scene is coloured, has a scalar bar and an odd height, and is so close that every rank has something to draw.
const std::string kTeapot =
    "--surface teapot:4000 --field abc:24,24,24 --color-by abc:mag --size 160x121 --camera zoom=1.4 ";

class MpirunRender : public MpirunTest {
protected:
    /// `scene` by one process and by `ranks`, which take `options` as well.
    void expectSameBytes(int ranks, const std::string& scene, const std::string& options) const
    {
        const Ended alone = renderAlone(scene + " -o alone.png");
        ASSERT_EQ(alone.exitCode, 0) << alone.err;
        const Ended together = render(ranks, scene + " " + options + " -o together.png");
        ASSERT_EQ(together.exitCode, 0) << together.err;
        EXPECT_EQ(together.ours(), alone.ours()) << "a warning is given once, and of all ranks' parts";
        ASSERT_GT(bytes("alone.png").size(), 1000u);
        EXPECT_TRUE(bytes("alone.png") == bytes("together.png")) << ranks << " ranks, " << scene << options;
    }
};

/// One rank of a host asks about files, reads them and tells the others.
TEST_F(MpirunRender, OneReaderAHost)
{
    const std::string head = "# vtk DataFile Version 3.0\nmade for a test\nASCII\nDATASET ";
    std::string vectors = "POINT_DATA 8\nVECTORS u float\n";
    for (int i = 0; i < 8; ++i) vectors += "1 0.5 0.25\n";
    std::ofstream(path("grid.vtk")) << head << "STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n"
                                    << vectors;
    std::ofstream(path("cells.vtk"))
        << head << "UNSTRUCTURED_GRID\nPOINTS 8 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n"
        << "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n"
        << vectors;
    std::ofstream(path("series.pvd")) << "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"1\" "
                                         "file=\"grid.vtk\"/></Collection></VTKFile>";
    const std::filesystem::path reader =
        std::filesystem::path(AEOLIC_PROGRAM).parent_path() / "libexec/aeolic/aeolic-reader";
    ASSERT_TRUE(std::filesystem::exists(reader));
    std::ofstream(path("counted")) << "#!/bin/sh\necho >>started\nexec '" << reader.string() << "' \"$@\"\n";
    std::filesystem::permissions(path("counted"), std::filesystem::perms::owner_all);
    for (const std::string field : {"grid.vtk", "cells.vtk", "series.pvd"}) {
        std::filesystem::remove(path("started"));
        const Ended ended = mpirun("-n 4 env AEOLIC_READER=./counted " + aeolic() +
                                   "render --surface boundary --field " + field + " --size 64x48 -o a.png");
        ASSERT_EQ(ended.exitCode, 0) << ended.err;
        EXPECT_EQ(bytes("started"), "\n") << field;
    }
}

TEST_F(MpirunRender, TwoRanksHierarchical)
{
    expectSameBytes(2, kTeapot + "--steps 60", "");
}

TEST_F(MpirunRender, TwoRanksDirectWithEstimatedGuards)
{
    expectSameBytes(2, kTeapot + "--lic direct --integrator euler --steps 40", "--balance static --guard estimate");
}

TEST_F(MpirunRender, ThreeRanksThatDrawTheirGuardsAgain)
{
    expectSameBytes(3, kTeapot + "--lic direct --integrator rk4 --steps 30", "--balance pixels --guard-rows project");
}

TEST_F(MpirunRender, ThreeRanksHannKernelWithVectorsOfAnyLength)
{
    expectSameBytes(3, kTeapot + "--kernel hann --phase 1 --normalize off --steps 77", "--guard estimate");
}

TEST_F(MpirunRender, FiveRanksThatReceiveTheirGuards)
{
    expectSameBytes(5, kTeapot + "--steps 100 --background transparent", "--balance pixels --guard-rows receive");
}

TEST_F(MpirunRender, FiveRanksWithABrickEach)
{
    expectSameBytes(5, kTeapot + "--steps 40 --field-precision half", "--bricks on");
}

TEST_F(MpirunRender, AnAnimationFrameByFrame)
{
    const std::string scene = kTeapot + "--steps 40 --frames 3 --orbit 90 ";
    ASSERT_EQ(renderAlone(scene + "-o alone.png").exitCode, 0);
    const Ended together = render(3, scene + "--balance timing -o together.png");
    ASSERT_EQ(together.exitCode, 0) << together.err;
    for (const std::string frame : {"-0000.png", "-0001.png", "-0002.png"})
        EXPECT_TRUE(bytes("alone" + frame) == bytes("together" + frame)) << frame;
    EXPECT_EQ(files().size(), 6u) << "rank 0 alone writes";
}

TEST_F(MpirunRender, StatsNameEveryRanksStripe)
{
    constexpr int kRanks = 3, kHeight = 121;
    const Ended ended = render(kRanks, kTeapot + "--steps 20 --stats stats.json -o a.png");
    ASSERT_EQ(ended.exitCode, 0) << ended.err;
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    EXPECT_EQ(stats["ranks"], kRanks);
    EXPECT_EQ(stats["field_bytes_per_rank"].size(), std::size_t(kRanks));
    EXPECT_EQ(stats["peak_rss_bytes_per_rank"].size(), std::size_t(kRanks));
    const int cores = int(std::thread::hardware_concurrency());
    EXPECT_LE(stats["threads"].get<int>(), std::max(1, cores / kRanks)) << "ranks of a host share its cores";

    const auto& stripes = stats["frames"][0]["stripes"];
    ASSERT_EQ(stripes.size(), std::size_t(kRanks));
    int row = 0;
    std::int64_t pixels = 0;
    for (int r = 0; r < kRanks; ++r) {
        const auto& stripe = stripes[std::size_t(r)];
        EXPECT_EQ(stripe["rank"], r);
        EXPECT_EQ(stripe["first_row"], row);
        row += stripe["rows"].get<int>();
        pixels += stripe["pixels"].get<std::int64_t>();
        EXPECT_GT(stripe["busy_ms"], 0);
        EXPECT_GT(stripe["sent_bytes"], 0);
        EXPECT_LE(stripe["guard_rows"][0].get<int>(), stripe["first_row"].get<int>());
        EXPECT_LE(stripe["guard_rows"][1].get<int>(), kHeight - row);
    }
    EXPECT_EQ(row, kHeight);
    EXPECT_EQ(stats["image"]["covered_pixels"], pixels);
}

/// Where vectors are short, fewer guard rows are estimated. The statistics tell how many were received.
TEST_F(MpirunRender, EstimatedGuardsAreNoMoreThanTheBound)
{
    const auto guardRows = [&](const std::string& options) {
        const Ended ended = render(2, kTeapot + "--normalize off --steps 60 --stats - " + options + " -o a.png");
        EXPECT_EQ(ended.exitCode, 0) << ended.err;
        const auto stats = nlohmann::json::parse(ended.out);
        return stats["frames"][0]["stripes"][0]["guard_rows"][1].get<int>();
    };
    const std::string received = "--balance static --guard-rows receive";
    const int bound = guardRows(received + " --guard bound"), estimate = guardRows(received);
    EXPECT_LT(estimate, bound);
    EXPECT_GT(estimate, 0);
}

/// Every rank reads its own wedges of a torus alone.
TEST_F(MpirunRender, ThreeRanksWithPiecesOfASurface)
{
    testkit::TorusPieces torus;
    torus.pieces = 7;
    torus.empty = {3};
    torus.noArea = 5;
    const std::string scene = "--surface '" + writeTorusPieces(path(""), "torus", torus) +
                              "' --vectors tau --color-by q --size 150x121 --camera elevation=40 --steps 50";
    expectSameBytes(3, scene, "--bricks on");
    expectSameBytes(2, scene, "--bricks on --balance pixels --guard estimate");
    const Ended gl = render(2, scene + " --bricks on --backend gl -o gl.png");
    EXPECT_EQ(gl.exitCode, 2);
    ASSERT_EQ(gl.ours().size(), 1u) << gl.err;
    EXPECT_NE(gl.ours()[0].find("expected cpu or auto"), std::string::npos) << gl.err;
    std::filesystem::remove(path("torus_2.vtp"));
    const Ended missing = render(3, scene + " --bricks on -o missing.png");
    EXPECT_EQ(missing.exitCode, 2);
    ASSERT_EQ(missing.ours().size(), 1u) << missing.err;
    EXPECT_NE(missing.ours()[0].find("torus_2.vtp is not there"), std::string::npos) << missing.err;
}

/// Neither the surface nor the field is held by any rank as a whole.
TEST_F(MpirunRender, FiveRanksWithTrianglesInTheirBricks)
{
    testkit::TorusPieces torus;
    torus.pieces = 7;
    torus.empty = {3};
    torus.noArea = 5;
    const std::string scene = "--surface '" + writeTorusPieces(path(""), "torus", torus) +
                              "' --field abc:24,24,24 --color-by q --size 150x121 --camera elevation=40 --steps 50";
    expectSameBytes(5, scene, "--bricks on");
    expectSameBytes(2, scene, "--bricks on --balance pixels --guard estimate");
}

TEST_F(MpirunRender, ThreeRanksWithPiecesThatMove)
{
    testkit::TorusPieces torus;
    for (const double size : {1.0, 1.3}) {
        torus.size = size;
        writeTorusPieces(path(""), size > 1 ? "t_1" : "t_0", torus);
    }
    const std::string scene = "--surface 't_*.pvtp' --color-by q --size 150x121 --steps 50 --time 0.4 ";
    expectSameBytes(3, scene + "--vectors tau", "--bricks on");
    expectSameBytes(3, scene + "--field abc:24,24,24", "--bricks on --balance pixels");
}

TEST_F(MpirunRender, FiveRanksWithPiecesOfAnIsosurface)
{
    writeWindingField(path("f.vti"), true);
    const std::string field = "--field f.vti --vectors U --color-by U:mag --size 150x121 --steps 50 ";
    expectSameBytes(5, field + "--surface isosurface:p=0.1", "--bricks on");
    expectSameBytes(3, field + "--surface slice:10,-6,3.5:1,1,0.3", "--bricks on");
    const Ended outside = render(3, field + "--surface isosurface:p=9 --bricks on -o a.png");
    EXPECT_EQ(outside.exitCode, 2);
    ASSERT_EQ(outside.ours().size(), 1u) << outside.err;
    EXPECT_EQ(outside.ours(), renderAlone(field + "--surface isosurface:p=9 -o a.png").ours());
}

/// A .vti of 4 x 4 x 4 samples with a scalar p and vectors U of about `scale`, as text.
void writeGrid(const std::string& path, double scale)
{
    std::ofstream file(path);
    file << R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="0 3 0 3 0 3" Origin="-1 -1 -0.5" Spacing="0.7 0.7 0.4"><Piece Extent="0 3 0 3 0 3"><PointData>
<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">
)";
    for (int i = 0; i < 64; ++i) file << scale << ' ' << i % 4 - 1.3 * scale << ' ' << i / 16 << '\n';
    file << "</DataArray><DataArray type=\"Float32\" Name=\"p\" format=\"ascii\">\n";
    for (int i = 0; i < 64; ++i) file << scale * (i % 7) << '\n';
    file << "</DataArray></PointData></Piece></ImageData></VTKFile>\n";
}

TEST_F(MpirunRender, EveryMomentOfASeriesByAnyRanks)
{
    for (int i = 0; i < 3; ++i) writeGrid(path("step" + std::to_string(i) + ".vti"), 1 + i);
    std::ofstream(path("run.pvd")) << R"(<?xml version="1.0"?><VTKFile type="Collection"><Collection>
<DataSet timestep="1" file="step0.vti"/><DataSet timestep="1.5" file="step1.vti"/><DataSet timestep="3" file="step2.vti"/>
</Collection></VTKFile>)";
    const std::string scene =
        "--surface wave:2000 --field run.pvd --color-by p --size 110x91 --steps 40 --frames 5 --time-range 1,3";
    ASSERT_EQ(renderAlone(scene + " -o alone.png").exitCode, 0);
    for (const std::string options : {"", " --bricks on", " --balance timing --guard estimate"}) {
        const Ended together = render(3, scene + options + " -o together.png");
        ASSERT_EQ(together.exitCode, 0) << together.err;
        for (const std::string frame : {"-0000.png", "-0001.png", "-0002.png", "-0003.png", "-0004.png"}) {
            ASSERT_GT(bytes("alone" + frame).size(), 1000u);
            EXPECT_TRUE(bytes("alone" + frame) == bytes("together" + frame)) << options << frame;
        }
    }
    EXPECT_NE(bytes("alone-0001.png"), bytes("alone-0002.png"));
    // A still may move its legend out of the surface's way; an animation does not.
    const std::string bare = scene + " --scalar-bar off";
    ASSERT_EQ(renderAlone(bare + " -o bare.png").exitCode, 0);
    const Ended still = render(2,
                               "--surface wave:2000 --field run.pvd --color-by p --size 110x91 --steps 40 --time 2 "
                               "--scalar-bar off --bricks on -o still.png");
    ASSERT_EQ(still.exitCode, 0) << still.err;
    EXPECT_TRUE(bytes("still.png") == bytes("bare-0002.png"));
}

TEST_F(MpirunRender, ADamagedStepIsOneLine)
{
    writeGrid(path("step0.vti"), 1);
    std::ofstream(path("step1.vti")) << "damaged";
    const Ended ended = render(2, "--surface boundary --field 'step*.vti' --frames 3 --time-range 0,1 -o a.png");
    EXPECT_EQ(ended.exitCode, 2);
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_NE(ended.ours()[0].find("step1.vti"), std::string::npos) << ended.err;
}

struct LongScene {
    std::string name, options;
    bool canBeBricks;
    friend void PrintTo(const LongScene& scene, std::ostream* out) { *out << scene.name; }
};

/// Every number of ranks, balancer, guard and method, on several scenes.
class MpirunRenderLong : public MpirunRender, public testing::WithParamInterface<std::tuple<int, LongScene>> {};

const LongScene kLongScenes[] = {
    {"teapot", kTeapot, true},
    {"torus",
     "--surface torus:3000 --field tornado:24,24,24 --normalize off --kernel hann --size 123x143 "
     "--background transparent",
     true},
    {"body",
     "--surface " AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed.vtp --vectors wallShearStress --color-by p "
     "--camera azimuth=50,elevation=25 --size 200x151",
     false},
    {"wake",
     "--field " AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed_wake.vti --surface slice:1.1,0,0:1,0,0 --vectors U "
     "--color-by U:mag --camera azimuth=90,elevation=0 --size 150x131",
     true}};

INSTANTIATE_TEST_SUITE_P(Ranks, MpirunRenderLong,
                         testing::Combine(testing::Values(1, 2, 3, 5, 8, 13), testing::ValuesIn(kLongScenes)),
                         [](const auto& test) {
                             return std::get<1>(test.param).name + std::to_string(std::get<0>(test.param));
                         });

/// Surfaces in pieces, by every number of ranks.
class MpirunPiecesLong : public MpirunRender, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Ranks, MpirunPiecesLong, testing::Values(2, 3, 5, 8, 13));

TEST_P(MpirunPiecesLong, SameBytesWhateverTheOptions)
{
    testkit::TorusPieces torus;
    torus.pieces = 9;
    torus.strips = 4;
    writeWindingField(path("f.vti"));
    const std::string still = "--surface '" + writeTorusPieces(path(""), "torus", torus) + "'";
    writeTorusPieces(path(""), "t_0", torus);
    torus.size = 1.3;
    writeTorusPieces(path(""), "t_1", torus);
    const std::string moving = "--surface 't_*.pvtp' --time 0.4";
    for (const std::string& surface :
         {still + " --vectors tau --color-by q", still + " --field abc:24,21,22 --color-by abc:mag",
          moving + " --field abc:24,21,22 --color-by q",
          std::string("--surface isosurface:p=0.1 --field f.vti --color-by U:mag")})
        for (const std::string method : {" --lic hierarchical --steps 77", " --lic direct --steps 40"})
            for (const std::string balance :
                 {" --balance static", " --balance timing", " --balance pixels", " --balance hybrid --guard estimate"})
                expectSameBytes(GetParam(), surface + method + " --size 143x121 --camera elevation=40",
                                "--bricks on" + balance);
}

TEST_P(MpirunRenderLong, SameBytesWhateverTheOptions)
{
    const auto& [ranks, scene] = GetParam();
    for (const std::string method : {" --lic hierarchical --steps 77", " --lic direct --steps 40"}) {
        for (const std::string balance :
             {" --balance static", " --balance timing", " --balance pixels", " --balance hybrid"})
            for (const std::string guard :
                 {" --guard bound --guard-rows project", " --guard bound --guard-rows receive", " --guard estimate"})
                expectSameBytes(ranks, scene.options + method, balance + guard);
        if (scene.canBeBricks) expectSameBytes(ranks, scene.options + method, "--bricks on");
    }
}

}  // namespace
}  // namespace aeolic
