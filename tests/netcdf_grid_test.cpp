#include <gtest/gtest.h>
#include <vtkCellData.h>

#include "data/load/file_info.h"
#include "netcdf_testing.h"

/// Grids in netCDF: where their points are, and what values these have.

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Reanalyses write maps so: packed in shorts, with the northern row first.
TEST_F(NetcdfGrids, PackedMapsFromNorthToSouth)
{
    for (const auto form : {NetcdfForm::classic, NetcdfForm::offsets64, NetcdfForm::netcdf4}) {
        {
            NetcdfWriter file(path_, form);
            file.dimension("time", 2);
            file.dimension("latitude", 3);
            file.dimension("longitude", 4);
            file.line("time", [](int i) { return 100.0 + 6 * i; }, {{"units", "hours since 1900-01-01"}});
            file.line("latitude", [](int i) { return 60.0 - 30 * i; }, {{"units", kNorth}});
            file.line("longitude", [](int i) { return 10.0 * i; }, {{"units", kEast}});
            const NetcdfWriter::Numbers packing{{"scale_factor", 0.5}, {"add_offset", 10}, {"_FillValue", -32767}};
            const std::vector<std::string> axes{"time", "latitude", "longitude"};
            file.variable(
                "u10", axes, [](int t, int y, int x) { return x == 3 ? -32767 : 4 + t * 2 + y * 10; },
                {{"units", "m s**-1"}}, packing, true);
            file.variable(
                "v10", axes, [](int, int, int) { return -20; }, {{"units", "m s**-1"}}, packing, true);
        }
        const auto data = read({"uv10", "u10"}, 106);
        ASSERT_TRUE(data);
        EXPECT_STREQ(data->GetClassName(), "vtkImageData");
        ASSERT_EQ(data->GetNumberOfPoints(), 12);
        EXPECT_EQ(placeOf(*data, 0), glm::dvec3(0, 0, 0));
        EXPECT_EQ(placeOf(*data, 11), glm::dvec3(30, 60, 0));
        // The southern row is the file's last one: (4 + 2 + 20) / 2 + 10 = 23; -20 / 2 + 10 = 0.
        EXPECT_EQ(data->GetPointData()->GetArray("u10")->GetComponent(0, 0), 23);
        EXPECT_EQ(data->GetPointData()->GetArray("u10")->GetComponent(8, 0), 13);
        EXPECT_TRUE(std::isnan(data->GetPointData()->GetArray("u10")->GetComponent(3, 0)));
        EXPECT_EQ(vectorAt(*data, "uv10", 0), glm::dvec3(23, 0, 0));
        EXPECT_TRUE(std::isnan(vectorAt(*data, "uv10", 11).x));
        EXPECT_EQ(FileReader(path_, FileUse::field).timeSteps(), (std::vector<double>{100, 106}));
    }
}

/// At 60 degrees a degree of longitude is half as long as one of latitude, so what flows north-east there climbs less
/// on the map.
TEST_F(NetcdfGrids, DirectionsAreThoseOnTheMap)
{
    {
        NetcdfWriter file(path_);
        file.dimension("lat", 3);
        file.dimension("lon", 2);
        file.line("lat", [](int i) { return 30.0 * i; }, {{"units", kNorth}});
        file.line("lon", [](int i) { return i; }, {{"units", kEast}});
        for (const char* name : {"uo", "vo"}) file.variable(name, {"lat", "lon"}, [](int, int, int) { return 1; });
    }
    const auto data = read({"uvo"});
    EXPECT_NEAR(vectorAt(*data, "uvo", 0).x, 1, 1e-6);
    const glm::dvec3 far = vectorAt(*data, "uvo", 4);
    EXPECT_NEAR(far.x / far.y, 2, 1e-6);
    EXPECT_NEAR(std::hypot(far.x, far.y), std::sqrt(2), 1e-6);
}

/// The C grid in its three spellings: one face more than cells (WRF), one less (ROMS), as many (MITgcm).
TEST_F(NetcdfGrids, ComponentsHalfACellBesideEachOther)
{
    {
        NetcdfWriter file(path_);
        for (const auto& [name, length] :
             std::map<std::string, int>{{"Time", 1}, {"sn", 3}, {"sn_stag", 4}, {"we", 4}, {"we_stag", 5}})
            file.dimension(name, std::size_t(length));
        file.variable("U", {"Time", "sn", "we_stag"}, [](int, int y, int x) { return x + 100 * y; });
        file.variable("V", {"Time", "sn_stag", "we"}, [](int, int y, int x) { return x + 100 * y; });
        file.variable("T", {"Time", "sn", "we"}, [](int, int y, int x) { return x + 10 * y; });
    }
    auto data = read({"UV", "T"});
    ASSERT_EQ(data->GetNumberOfPoints(), 12);
    EXPECT_EQ(vectorAt(*data, "UV", 6), glm::dvec3(2.5 + 100, 2 + 150, 0));
    EXPECT_EQ(data->GetPointData()->GetArray("T")->GetComponent(6, 0), 12);
    {
        NetcdfWriter file(path_);
        for (const auto& [name, length] : std::map<std::string, int>{
                 {"eta_rho", 4}, {"eta_u", 4}, {"eta_v", 3}, {"xi_rho", 5}, {"xi_u", 4}, {"xi_v", 5}})
            file.dimension(name, std::size_t(length));
        file.variable("u", {"eta_u", "xi_u"}, [](int, int y, int x) { return x + 100 * y; });
        file.variable("v", {"eta_v", "xi_v"}, [](int, int y, int x) { return x + 100 * y; });
        file.variable("zeta", {"eta_rho", "xi_rho"}, [](int, int y, int x) { return x + 10 * y; });
        for (const char* grid : {"rho", "u", "v"}) {
            const std::vector<std::string> axes{std::string("eta_") + grid, std::string("xi_") + grid};
            const double shiftX = grid[0] == 'u' ? 0.5 : 0, shiftY = grid[0] == 'v' ? 0.5 : 0;
            file.variable(std::string("lon_") + grid, axes, [&](int, int, int x) { return 20 + x + shiftX; },
                          {{"units", "degree_east"}});
            file.variable(std::string("lat_") + grid, axes, [&](int, int y, int) { return 0.01 * (y + shiftY); },
                          {{"units", "degree_north"}});
        }
    }
    data = read({"uv", "zeta"});
    EXPECT_NEAR(placeOf(*data, 6).x, 21, 1e-5);
    EXPECT_NEAR(placeOf(*data, 6).y, 0.01, 1e-6);
    ASSERT_EQ(data->GetNumberOfPoints(), 20);
    EXPECT_NEAR(glm::distance(vectorAt(*data, "uv", 6), glm::dvec3(0.5 + 100, 1 + 50, 0)), 0, 1e-4);
    EXPECT_TRUE(std::isnan(vectorAt(*data, "uv", 5).x)) << "beside the rim there is no neighbour";
    EXPECT_EQ(data->GetPointData()->GetArray("zeta")->GetComponent(6, 0), 11);
    {
        NetcdfWriter file(path_);
        for (const char* name : {"YC", "YG", "XC", "XG"}) {
            file.dimension(name, 4);
            file.line(name, [&](int i) { return i + (name[1] == 'C' ? 0.5 : 0); },
                      {{"units", "m"}, {"axis", std::string(1, name[0])}});
        }
        file.variable("U", {"YC", "XG"}, [](int, int y, int x) { return x + 100 * y; });
        file.variable("V", {"YG", "XC"}, [](int, int y, int x) { return x + 100 * y; });
    }
    data = read({"UV"});
    EXPECT_EQ(placeOf(*data, 5), glm::dvec3(1.5, 1.5, 0));
    EXPECT_EQ(vectorAt(*data, "UV", 5), glm::dvec3(1.5 + 100, 1 + 150, 0));
}

/// A grid that is turned by 90 degrees: along its lines means north for the first component.
TEST_F(NetcdfGrids, CurvilinearGridsWithTheirOwnDirections)
{
    for (const bool isEastward : {false, true}) {
        {
            NetcdfWriter file(path_);
            file.dimension("j", 3);
            file.dimension("i", 4);
            file.variable("nav_lon", {"j", "i"}, [](int, int y, int) { return -y; }, {{"units", kEast}});
            file.variable("nav_lat", {"j", "i"}, [](int, int, int x) { return x; }, {{"units", kNorth}});
            NetcdfWriter::Texts texts{{"coordinates", "nav_lon nav_lat"}};
            if (isEastward) texts["standard_name"] = "eastward_sea_water_velocity";
            file.variable(
                "uo", {"j", "i"}, [](int, int, int) { return 2; }, texts);
            file.variable("vo", {"j", "i"}, [](int, int, int) { return 0; });
        }
        const auto data = read({"uvo"});
        EXPECT_STREQ(data->GetClassName(), "vtkStructuredGrid");
        EXPECT_EQ(placeOf(*data, 6), glm::dvec3(-1, 2, 0));
        const glm::dvec3 vector = vectorAt(*data, "uvo", 6),
                         expected = isEastward ? glm::dvec3(2, 0, 0) : glm::dvec3(0, 2, 0);
        EXPECT_NEAR(glm::distance(vector, expected), 0, 1e-6);
    }
}

/// The map's edge within the grid, and places that are missing where there is land.
TEST_F(NetcdfGrids, TornCellsAreHidden)
{
    {
        NetcdfWriter file(path_);
        file.dimension("y", 2);
        file.dimension("x", 6);
        const NetcdfWriter::Numbers fill{{"_FillValue", 1e20}};
        file.variable(
            "lon", {"y", "x"}, [](int, int, int x) { return x == 5 ? 1e20 : 170 + x * 5 - (x > 2 ? 360 : 0); },
            {{"units", kEast}}, fill);
        file.variable(
            "lat", {"y", "x"}, [](int, int y, int x) { return x == 5 ? 1e20 : y; }, {{"units", kNorth}}, fill);
        for (const char* name : {"u", "v"}) file.variable(name, {"y", "x"}, [](int, int, int) { return 1; });
    }
    const auto data = read({"uv"});
    EXPECT_EQ(placeOf(*data, 3), glm::dvec3(185, 0, 0)) << "goes on beyond 180";
    vtkDataArray* const hidden = data->GetCellData()->GetArray("vtkGhostType");
    ASSERT_TRUE(hidden);
    for (int cell = 0; cell < 5; ++cell) EXPECT_EQ(hidden->GetComponent(cell, 0) != 0, cell == 4) << cell;
}

TEST_F(NetcdfGrids, DepthGrowsDownwardsAndMapsStandInEachLayer)
{
    {
        NetcdfWriter file(path_);
        file.dimension("depth", 3);
        file.dimension("lat", 2);
        file.dimension("lon", 2);
        file.line("depth",
                  [](int i) {
                      return std::array{1.0, 10.0, 100.0}[std::size_t(i)];
                  },
                  {{"units", "m"}, {"positive", "down"}});
        file.line("lat", [](int i) { return i; }, {{"units", kNorth}});
        file.line("lon", [](int i) { return 359 + i - (i > 0 ? 360 : 0); }, {{"units", kEast}});
        file.variable("water_u", {"depth", "lat", "lon"}, [](int z, int, int) { return z; });
        file.variable("water_v", {"depth", "lat", "lon"}, [](int, int, int) { return 0; });
        file.variable("surf_el", {"lat", "lon"}, [](int, int y, int x) { return x + 10 * y; });
    }
    auto data = read({"water_uv", "surf_el"});
    EXPECT_STREQ(data->GetClassName(), "vtkRectilinearGrid");
    ASSERT_EQ(data->GetNumberOfPoints(), 12);
    EXPECT_EQ(placeOf(*data, 0), glm::dvec3(359, 0, -100));
    EXPECT_EQ(placeOf(*data, 11), glm::dvec3(360, 1, -1));
    EXPECT_EQ(vectorAt(*data, "water_uv", 0).x, 2);
    EXPECT_EQ(vectorAt(*data, "water_uv", 11).x, 0);
    for (int layer = 0; layer < 3; ++layer)
        EXPECT_EQ(data->GetPointData()->GetArray("surf_el")->GetComponent(4 * layer + 3, 0), 11);
    const FileInfo info = fileInfo(path_);
    EXPECT_NE(info.text.find("--surface slice:359.5,0.5,-50.5:0,0,1 --camera"), std::string::npos) << info.text;
    data = read({"surf_el"});
    EXPECT_EQ(data->GetNumberOfPoints(), 4) << "alone it is flat";
}

}  // namespace
}  // namespace aeolic
