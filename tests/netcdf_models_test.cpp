#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkXMLRectilinearGridWriter.h>

#include "aeolic/renderer.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "describe_testing.h"
#include "netcdf_testing.h"

/// Grids in netCDF as models of oceans and of the air write them: which variables are vectors, and what is no grid.

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

using NetcdfModels = NetcdfGrids;

/// A fourth dimension is time, whatever it is called.
TEST_F(NetcdfModels, TheFirstOfFourDimensionsIsTime)
{
    {
        NetcdfWriter file(path_);
        for (const char* name : {"month", "level", "lat", "lon"}) file.dimension(name, 2);
        file.line("month", [](int i) { return 1 + 6 * i; }, {});
        for (const char* name : {"u", "v"})
            file.variable(name, {"month", "level", "lat", "lon"}, [](int z, int, int) { return z; });
    }
    EXPECT_EQ(FileReader(path_, FileUse::field).timeSteps(), (std::vector<double>{1, 7}));
    EXPECT_EQ(vectorAt(*read({"uv"}), "uv", 7).x, 1);
}

/// MATLAB's order: x before y.
TEST_F(NetcdfModels, DimensionsInAnyOrder)
{
    {
        NetcdfWriter file(path_);
        addMap(file, 2, 3);
        file.dimension("time", 2);
        for (const char* name : {"u", "v"})
            file.variable(name, {"lon", "lat", "time"},
                          [&](int x, int y, int t) { return name[0] == 'u' ? x + 10 * y + 100 * t : 0; });
    }
    EXPECT_EQ(vectorAt(*read({"uv"}), "uv", 2).x, 2);
    EXPECT_EQ(vectorAt(*read({"uv"}, 1), "uv", 5).x, 112);
}

/// The CF conventions' names, where those of the variables tell nothing.
TEST_F(NetcdfModels, VectorsByTheirStandardNames)
{
    {
        NetcdfWriter file(path_);
        addMap(file, 2, 2);
        file.variable("vozocrtx", {"lat", "lon"}, [](int, int, int) { return 3; },
                      {{"standard_name", "sea_water_x_velocity"}});
        file.variable("vomecrty", {"lat", "lon"}, [](int, int, int) { return 4; },
                      {{"standard_name", "sea_water_y_velocity"}});
        file.variable("sos", {"lat", "lon"}, [](int, int, int) { return 35; });
    }
    EXPECT_EQ(vectorAt(*read({"sea_water_velocity"}), "sea_water_velocity", 0), glm::dvec3(3, 4, 0));
    const FileInfo info = fileInfo(path_);
    EXPECT_NE(info.text.find("sea_water_velocity"), std::string::npos) << info.text;
    EXPECT_NO_THROW(loadScene(describe("boundary", path_)));
    EXPECT_NO_THROW(loadScene(describe("image", path_)));
}

/// Names that differ in a letter only, beside a flow.
TEST_F(NetcdfModels, WhatIsNoFlowIsNoVector)
{
    {
        NetcdfWriter file(path_);
        addMap(file, 2, 2);
        const auto one = [](int, int, int) { return 1; };
        for (const char* name : {"CLOX", "CLOY"}) file.variable(name, {"lat", "lon"}, one, {{"units", "mol/mol"}});
        for (const char* name : {"e3u", "e3v"}) file.variable(name, {"lat", "lon"}, one, {{"units", "m"}});
        for (const char* name : {"mask_u", "mask_v"}) file.variable(name, {"lat", "lon"}, one);
        for (const char* name : {"MAPFAC_U", "MAPFAC_V"}) file.variable(name, {"lat", "lon"}, one);
        for (const char* name : {"uo", "vo", "wo"}) file.variable(name, {"lat", "lon"}, one, {{"units", "m s-1"}});
    }
    std::vector<std::string> vectors;
    FileReader reader(path_, FileUse::field);
    for (const ArrayInfo& array : reader.announcedArrays())
        if (array.components == 3) vectors.push_back(array.name);
    EXPECT_EQ(vectors, (std::vector<std::string>{"uvo", "MAPFAC_UV"}));
    EXPECT_NE(fileInfo(path_).text.find("--vectors uvo "), std::string::npos);
}

/// Members of an ensemble; bytes without a sign; a variable of its dimension's name; what stands on another grid.
TEST_F(NetcdfModels, OddFiles)
{
    for (const NetcdfForm form : {NetcdfForm::classic, NetcdfForm::netcdf4}) {
        {
            NetcdfWriter file(path_, form);
            file.dimension("number", 3);
            file.dimension("z", 2);
            file.dimension("lat", 2);
            file.dimension("lon", 3);
            file.line("number", [](int i) { return std::array{2, 0, 1}[std::size_t(i)]; }, {});
            file.variable("z", {"lat", "z", "lon"}, [](int, int, int x) { return x; });
            for (const char* name : {"u", "v"})
                file.variable(name, {"number", "lat", "lon"}, [](int n, int, int x) { return 10 * n + x; });
            file.variable(
                "p", {"lat", "lon"}, [](int, int, int) { return -56; }, {{"_Unsigned", "true"}},
                {{"scale_factor", 0.1}}, true);
        }
        const auto data = read({"uv", "p"});
        ASSERT_EQ(data->GetNumberOfPoints(), 6);
        EXPECT_EQ(vectorAt(*data, "uv", 5), glm::dvec3(2, 2, 0));
        EXPECT_NEAR(data->GetPointData()->GetArray("p")->GetComponent(0, 0), 6548, 1e-2);
        EXPECT_NE(failure({"uv", "z"}).find("'z' stands on another grid than 'uv'; expected arrays of one"),
                  std::string::npos)
            << failure({"uv", "z"});
    }
}

/// A grid with a pole of its own: its lines are no longitudes, and east is not along them.
TEST_F(NetcdfModels, RotatedPolesAndIdealizedRuns)
{
    for (const bool isIdealized : {false, true}) {
        {
            NetcdfWriter file(path_);
            file.dimension("rlat", 3);
            file.dimension("rlon", 3);
            file.line("rlat", [](int i) { return i; }, {{"units", "degrees"}, {"standard_name", "grid_latitude"}});
            file.line("rlon", [](int i) { return i; }, {{"units", "degrees"}, {"standard_name", "grid_longitude"}});
            const double size = isIdealized ? 0 : 1;
            file.variable("lon", {"rlat", "rlon"}, [&](int, int y, int) { return -size * y; }, {{"units", kEast}});
            file.variable("lat", {"rlat", "rlon"}, [&](int, int, int x) { return size * x; }, {{"units", kNorth}});
            file.variable("uas", {"rlat", "rlon"}, [](int, int, int) { return 2; },
                          {{"units", "m s-1"}, {"standard_name", "eastward_wind"}, {"coordinates", "lon lat"}});
            file.variable("vas", {"rlat", "rlon"}, [](int, int, int) { return 0; }, {{"units", "m s-1"}});
        }
        const auto data = read({"uvas"});
        EXPECT_EQ(placeOf(*data, 5), isIdealized ? glm::dvec3(2, 1, 0) : glm::dvec3(-1, 2, 0));
        EXPECT_NEAR(glm::distance(vectorAt(*data, "uvas", 5), glm::dvec3(2, 0, 0)), 0, 1e-6);
    }
}

TEST_F(NetcdfModels, WhatIsNoGridIsSaid)
{
    {
        NetcdfWriter file(path_);
        file.dimension("nCells", 9);
        file.dimension("level", 2);
        file.variable("lonCell", {"nCells"}, [](int, int, int x) { return x; }, {{"units", "rad"}});
        file.variable("latCell", {"nCells"}, [](int, int, int x) { return x; }, {{"units", "rad"}});
        file.variable("u", {"nCells", "level"}, [](int, int, int) { return 1; });
    }
    EXPECT_EQ(failure(), path_ +
                             ": its values stand on a mesh without a grid, along 'nCells'; expected variables over "
                             "latitude and longitude, or x and y (CF conventions)");
    {
        NetcdfWriter file(path_);
        file.dimension("n", 9);
        file.variable("p", {"n"}, [](int, int, int) { return 1; });
    }
    EXPECT_NE(failure().find("it has no variable on a grid"), std::string::npos) << failure();
    {
        NetcdfWriter file(path_);
        file.dimension("lat", 3);
        file.dimension("lon", 3);
        file.line("lat", [](int i) { return i % 2; }, {{"units", kNorth}});
        for (const char* name : {"u", "v"}) file.variable(name, {"lat", "lon"}, [](int, int, int) { return 1; });
    }
    EXPECT_NE(failure({"uv"}).find("its coordinate 'lat' has the values 1 and 0 beside each other"), std::string::npos)
        << failure({"uv"});
}

/// What a file of VTK's holds is the same picture.
TEST_F(NetcdfModels, TheSamePictureAsAFileOfVtk)
{
    writeSampleNetcdf(path_, NetcdfForm::classic);
    vtkNew<vtkXMLRectilinearGridWriter> writer;
    writer->SetInputData(read({"uvo", "thetao"}));
    writer->SetFileName(folder_.file("a.vtr").c_str());
    ASSERT_TRUE(writer->Write());
    const auto picture = [](const std::string& file) {
        SceneDescription scene = describe("slice:6,50,-10:0,0,1", file, "thetao");
        scene.field.vectors = "uvo";
        scene.output.width = scene.output.height = 64;
        scene.run.backend = BackendChoice::cpu;
        return Renderer(scene).render();
    };
    const DrawnFrame own = picture(path_), vtks = picture(folder_.file("a.vtr"));
    EXPECT_EQ(own.pixels, vtks.pixels);
    EXPECT_NE(own.pixels, std::vector<std::uint8_t>(own.pixels.size(), own.pixels.front())) << "something is drawn";
}

}  // namespace
}  // namespace aeolic
