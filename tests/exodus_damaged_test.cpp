#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "part_formats_testing.h"
#include "reader/exodus/testing/sample_exodus.h"
#include "reader/hdf5/testing/sample_hdf5.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Form = SampleExodus::Form;
using Bytes = std::string;

class ExodusDamaged : public testing::Test {
protected:
    void write(const SampleExodus& sample = {}) const { writeSampleExodus(file_, sample); }

    /// Loads a side set with all that it has, and the field. What is refused is one line; empty where nothing is.
    std::string complaint(const std::string& part = ":floor") const
    {
        SceneDescription description;
        description.surface.spec = file_ + part;
        description.field.vectors = "vel";
        description.shading.colorBy = "pressure";
        return complaintOf([&] {
            loadScene(description);
            description.field.spec = file_;
            loadScene(description);
        });
    }

    void expectComplaint(const std::vector<std::string>& texts, const std::string& part = ":floor") const
    {
        expectSays(complaint(part), texts);
    }

    /// Variables of netCDF-4 are data sets.
    template <class Number>
    void replace(const std::string& variable, const std::vector<std::uint64_t>& shape,
                 const std::vector<Number>& values) const
    {
        replaceHdf5(file_, variable, shape, values);
    }

    /// Puts a number in the place of that which stands `behind` bytes behind a text of a classic file.
    void change(const std::string& text, std::size_t behind, const std::string& bytes) const
    {
        std::string all = readBytes(file_);
        const std::size_t at = all.find(text);
        ASSERT_NE(at, std::string::npos) << text;
        all.replace(at + behind, bytes.size(), bytes);
        writeBytes(file_, all);
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.e");
};

TEST_F(ExodusDamaged, OtherFiles)
{
    writeBytes(file_, "no netCDF at all");
    expectComplaint({"box.e", "does not begin like a netCDF file"});
    writeBytes(file_, std::string("CDF\7\0\0\0\0", 8));
    expectComplaint({"box.e", "does not begin like a netCDF file"});
    Bytes empty(32, '\0');
    writeBytes(file_, empty.replace(0, 4, "CDF\1"));
    expectComplaint({"box.e", "not one of Exodus"});
    {
        Hdf5Writer writer(file_);
    }
    expectComplaint({"box.e", "not one of Exodus"});
}

/// A dimension is its name, filled up to four bytes, and its length in four.
TEST_F(ExodusDamaged, DimensionsOfAClassicFile)
{
    write();
    change("num_nodes", 12, Bytes("\0\0\0\x7e", 4));
    expectComplaint({"box.e"});
    write();
    change("num_nodes", 12, Bytes("\x7f\xff\xff\xff", 4));
    expectComplaint({"box.e"});
    write();
    change("num_el_blk", 12, Bytes("\x7f\xff\xff\xff", 4));
    expectComplaint({"box.e"});
    write();
    change("num_side_sets", 16, Bytes("\x7f\xff\xff\xff", 4));
    expectComplaint({"box.e"});
    write();
    change("num_el_in_blk1", 16, Bytes("\0\0\0\x21", 4));
    expectComplaint({"box.e"}, ":low");
    write();
    change("num_dim", 8, Bytes("\0\0\0\7", 4));
    expectComplaint({"box.e"});
    write();
    change("num_side_ss1", 12, Bytes("\0\0\0\x11", 4));
    expectComplaint({"box.e"});
    write();
    change("CDF", 4, Bytes("\xff\xff\xff\xfe", 4));
    expectComplaint({"box.e"});
    change("CDF", 4, Bytes("\xff\xff\xff\xff", 4));  // As a file that was never closed has it.
    EXPECT_EQ(complaint(), "");
}

TEST_F(ExodusDamaged, Elements)
{
    using Wholes = std::vector<std::int32_t>;
    write({.form = Form::netcdf4});
    replace("connect1", {32, 8}, Wholes(256, 126));
    setHdf5Text(file_, "connect1", "elem_type", "HEX8");
    expectComplaint({"box.e", "'connect1' has the corner 126", "1 to 125"}, ":low");
    replace("connect1", {32, 8}, Wholes(256, 0));
    setHdf5Text(file_, "connect1", "elem_type", "HEX8");
    expectComplaint({"box.e", "'connect1' has the corner 0", "1 to 125"}, ":low");
    replace("connect1", {32, 7}, Wholes(224, 1));
    setHdf5Text(file_, "connect1", "elem_type", "HEX8");
    expectComplaint({"box.e", "'connect1' of HEX8 elements has 32 x 7 numbers", "32 x 8"}, ":low");
    replace("connect1", {32, 8}, Wholes(256, 1));  // Without a word about what the elements are.
    expectComplaint({"box.e", "no part 'low'"}, ":low");
    write({.form = Form::netcdf4});
    replace("num_dim", {7}, std::vector<float>(7));
    expectComplaint({"box.e", "cannot be read"});
    write({.form = Form::netcdf4});
    replace("num_el_blk", {1000000}, std::vector<float>(1000000));
    expectComplaint({"box.e", "cannot be read"});
    write({.form = Form::netcdf4});
    removeHdf5(file_, "coordy");
    expectComplaint({"box.e", "no variable 'coordy'"});
    write({.form = Form::netcdf4});
    replace("coordx", {125}, std::vector<double>(125, 1e31));
    expectComplaint({"box.e", "'floor'", "a coordinate is 1e+31"});
    write({.form = Form::netcdf4, .polyhedra = true});
    replace("facconn2", {192}, Wholes(192, 1));
    setHdf5Text(file_, "facconn2", "elem_type", "nfaced");
    expectComplaint({"box.e", "'facconn2' has the face 1 three times"}, ":high");
    replace("facconn2", {192}, Wholes(192, 193));
    setHdf5Text(file_, "facconn2", "elem_type", "nfaced");
    expectComplaint({"box.e", "'facconn2' has the face 193", "1 to 192"}, ":high");
    write({.form = Form::netcdf4, .polyhedra = true});
    replace("fbepecnt1", {192}, Wholes(192, 5));
    expectComplaint({"box.e", "'fbepecnt1' has 192 sizes of 960 in all", "of 768"}, ":high");
    replace("fbepecnt1", {192}, Wholes(192, -4));
    expectComplaint({"box.e", "'fbepecnt1' has the size -4"}, ":high");
}

/// An older form of Exodus has the coordinates of all directions in one variable.
TEST_F(ExodusDamaged, CoordinatesInOneVariable)
{
    write({.form = Form::netcdf4});
    for (const char* name : {"coordx", "coordy", "coordz"}) removeHdf5(file_, name);
    const hid_t opened = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    H5Dclose(H5Dcreate2(opened, "coord", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
    H5Fclose(opened);
    expectComplaint({"box.e", "'coord' has 0 dimensions", "axes and nodes"});
    replace("coord", {125}, std::vector<double>(125));
    expectComplaint({"box.e", "'coord' has 1 dimensions", "axes and nodes"});
    replace("coord", {2, 125}, std::vector<double>(250));
    expectComplaint({"box.e", "'/coord' has 2 x 125 elements"});
    std::vector<double> sound;
    for (const int step : {1, 5, 25})
        for (int i = 0; i < 125; ++i) sound.push_back(i / step % 5);
    replace("coord", {3, 125}, sound);
    EXPECT_EQ(complaint(), "");
}

TEST_F(ExodusDamaged, SideSets)
{
    using Wholes = std::vector<std::int32_t>;
    write({.form = Form::netcdf4});
    replace("elem_ss1", {16}, Wholes(16, 65));
    expectComplaint({"box.e", "'elem_ss1' has the element 65", "1 to 64"});
    replace("elem_ss1", {16}, Wholes(16, 0));
    expectComplaint({"box.e", "'elem_ss1' has the element 0", "1 to 64"});
    replace("elem_ss1", {15}, Wholes(15, 1));
    expectComplaint({"box.e", "'side_ss1' has 16 numbers", "15"});
    write({.form = Form::netcdf4});
    replace("side_ss1", {16}, Wholes(16, -1));
    expectComplaint({"box.e", "'side_ss1' has the side -1", "from 1"});
    replace("side_ss1", {16}, Wholes(16, 7));  // Which a hexahedron does not have.
    expectComplaint({"box.e", "have no polygons"});
    write();
    expectComplaint({"box.e", "no part 'flor'", "floor?"}, ":flor");
}

TEST_F(ExodusDamaged, Values)
{
    write({.form = Form::netcdf4});
    replace("vals_nod_var1", {2, 124}, std::vector<double>(248));
    expectComplaint({"box.e", "'vel_x' has 124 values", "125"});
    replace("vals_nod_var1", {125}, std::vector<double>(125));
    expectComplaint({"box.e", "'vals_nod_var1' has 125 numbers", "for each step"});
    write({.form = Form::netcdf4});
    replace("time_whole", {2}, std::vector<double>{1, 1});
    expectComplaint({"box.e", "its time 1 is 1", "increase"});
    write({.form = Form::netcdf4});
    replace("vals_sset_var1ss1", {2, 3}, std::vector<double>(6));
    SceneDescription description;
    description.surface.spec = file_ + ":floor";
    description.field.vectors = "vel";
    description.shading.colorBy = "shear";
    EXPECT_THROW(loadScene(description), InputError);
    write({.form = Form::netcdf4});
    replace("vals_nod_var1", {1, 125}, std::vector<double>(125));
    EXPECT_EQ(complaint(), "");
    description.shading.colorBy = "";
    description.time.moment = 0.5;  // Which the file has no vel_x of: it is missing.
    EXPECT_TRUE(std::isnan(loadScene(description).surface.pointVectors[0].x));
}

TEST_F(ExodusDamaged, EveryLengthOfAFileThatIsCutOffIsRefused)
{
    for (const Form form : {Form::classic, Form::data64, Form::netcdf4}) {
        write({.form = form});
        const std::string sound = readBytes(file_);
        for (std::size_t size = 0; size < sound.size(); size += 1 + sound.size() / 60) {
            writeBytes(file_, sound.substr(0, size));
            EXPECT_THROW(describeFile(file_), InputError) << size;
        }
    }
}

}  // namespace
}  // namespace aeolic
