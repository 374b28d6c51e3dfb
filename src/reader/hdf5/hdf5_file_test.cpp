#include "reader/hdf5/hdf5_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "reader/hdf5/testing/sample_hdf5.h"

namespace aeolic {
namespace {

using namespace test;
using Lengths = std::vector<std::uint64_t>;
constexpr std::uint64_t kUnlimited = H5S_UNLIMITED;

std::vector<double> counting(std::uint64_t count)
{
    std::vector<double> values(count);
    std::iota(values.begin(), values.end(), 0.25);
    return values;
}

std::uint64_t product(const Lengths& shape)
{
    return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

/// One file in each of HDF5's two forms, the oldest and the newest.
class Hdf5Forms : public testing::TestWithParam<bool> {
protected:
    std::string path() const { return folder_.file("a.h5"); }
    TempFolder folder_;
};

TEST_P(Hdf5Forms, EveryLayoutGivesWhatWasWritten)
{
    struct Case {
        const char* name;
        Lengths shape;
        Hdf5SampleLayout layout;
    };
    const Case cases[] = {
        {"single", {}, {}},
        {"row", {7}, {}},
        {"compact", {3, 5}, {.compact = true}},
        {"contiguous", {4, 3, 5}, {}},
        {"chunks", {10, 7, 5}, {.chunk = {3, 2, 4}}},
        {"onechunk", {10, 7}, {.chunk = {10, 7}}},
        {"onepacked", {10, 7}, {.chunk = {10, 7}, .deflate = true}},
        {"packed", {33, 17}, {.chunk = {8, 8}, .deflate = true}},
        {"shuffled", {33, 17}, {.chunk = {8, 8}, .deflate = true, .shuffle = true}},
        {"checked", {33, 17}, {.chunk = {8, 8}, .checksum = true}},
        {"all", {33, 17}, {.chunk = {8, 8}, .deflate = true, .shuffle = true, .checksum = true}},
        {"early", {33, 17}, {.chunk = {8, 8}, .early = true}},
        {"earlyLimited", {33, 17}, {.chunk = {8, 8}, .most = {40, 90}, .early = true}},
        {"limited", {33, 17}, {.chunk = {8, 8}, .most = {64, 100}}},
        {"grows", {1000}, {.chunk = {3}, .most = {kUnlimited}}},
        {"growsPacked", {1000}, {.chunk = {3}, .most = {kUnlimited}, .deflate = true}},
        {"growsAcross", {9, 300}, {.chunk = {2, 3}, .most = {20, kUnlimited}}},
        {"growsBoth", {30, 40}, {.chunk = {3, 4}, .most = {kUnlimited, kUnlimited}}},
        {"growsBothPacked", {30, 40}, {.chunk = {3, 4}, .most = {kUnlimited, kUnlimited}, .deflate = true}},
        {"manyChunks", {5000}, {.chunk = {1}}},
        {"manyPacked", {5000}, {.chunk = {1}, .deflate = true}},
        {"manyGrow", {40000}, {.chunk = {1}, .most = {kUnlimited}}},
        {"manyTree", {60, 60}, {.chunk = {1, 1}, .most = {kUnlimited, kUnlimited}}},
        {"nothing", {0, 3}, {.chunk = {2, 2}, .most = {kUnlimited, 3}}},
    };
    {
        Hdf5Writer writer(path(), GetParam());
        for (const Case& each : cases) writer.data(each.name, each.shape, counting(product(each.shape)), each.layout);
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (const Case& each : cases) {
        const Hdf5Object data = root.require(each.name);
        EXPECT_EQ(data.shape(), each.shape) << each.name;
        EXPECT_EQ(data.type(), NumberType::float64) << each.name;
        EXPECT_EQ(data.read<double>(), counting(product(each.shape))) << each.name;
    }
}

TEST_P(Hdf5Forms, SlabsOfEveryLayout)
{
    const Lengths shape{9, 6, 5};
    const Hdf5SampleLayout layouts[] = {
        {}, {.compact = true}, {.chunk = {2, 4, 5}}, {.chunk = {3, 6, 5}, .most = {kUnlimited, 6, 5}, .deflate = true}};
    const Slab slabs[] = {{{0, 0, 0}, shape},     {{3, 2, 1}, {4, 3, 2}}, {{8, 0, 0}, {1, 6, 5}},
                          {{0, 5, 4}, {9, 1, 1}}, {{2, 1, 0}, {1, 4, 5}}, {{2, 2, 2}, {0, 1, 1}}};
    const std::vector<double> all = counting(product(shape));
    {
        Hdf5Writer writer(path(), GetParam());
        for (int i = 0; i < 4; ++i) writer.data("d" + std::to_string(i), shape, all, layouts[i]);
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (int i = 0; i < 4; ++i)
        for (const Slab& slab : slabs) {
            std::vector<float> expected;
            for (std::uint64_t x = 0; x < slab.count[0]; ++x)
                for (std::uint64_t y = 0; y < slab.count[1]; ++y)
                    for (std::uint64_t z = 0; z < slab.count[2]; ++z)
                        expected.push_back(
                            float(all[((slab.first[0] + x) * 6 + slab.first[1] + y) * 5 + slab.first[2] + z]));
            EXPECT_EQ(root.require("d" + std::to_string(i)).read<float>(slab), expected) << i;
        }
    EXPECT_THROW(root.require("d0").read<float>({{8, 0, 0}, {2, 1, 1}}), InputError);
    EXPECT_THROW(root.require("d2").read<float>({{~std::uint64_t{0}, 0, 0}, {2, 1, 1}}), InputError);
    EXPECT_THROW(root.require("d2").read<float>({{0}, {1}}), InputError);
}

TEST_P(Hdf5Forms, EveryTypeInBothByteOrders)
{
    const std::pair<const char*, hid_t> types[] = {
        {"i8", H5T_STD_I8LE},    {"u8", H5T_STD_U8BE},    {"i16", H5T_STD_I16BE}, {"u16", H5T_STD_U16LE},
        {"i32", H5T_STD_I32BE},  {"u32", H5T_STD_U32LE},  {"i64", H5T_STD_I64BE}, {"u64", H5T_STD_U64LE},
        {"f32", H5T_IEEE_F32BE}, {"f64", H5T_IEEE_F64BE}, {"f4", H5T_IEEE_F32LE}};
    const std::vector<double> values{0, 1, 2, 100, 127};
    {
        Hdf5Writer writer(path(), GetParam());
        for (const auto& [name, type] : types) writer.data(name, {5}, values, {}, type);
        writer.data<std::int64_t>("negative", {2}, {-1, -300}, {}, H5T_STD_I16BE);
        const hid_t odd = H5Tcopy(H5T_STD_I32LE);
        H5Tset_precision(odd, 24);
        writer.data<std::int32_t>("odd", {2}, {1, 2}, {}, odd);
        H5Tclose(odd);
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (const auto& [name, type] : types) {
        EXPECT_EQ(root.require(name).read<double>(), values) << name;
        EXPECT_EQ(root.require(name).read<std::int64_t>(), (std::vector<std::int64_t>{0, 1, 2, 100, 127})) << name;
        EXPECT_EQ(root.require(name).read<std::int8_t>(), (std::vector<std::int8_t>{0, 1, 2, 100, 127})) << name;
    }
    EXPECT_EQ(root.require("negative").read<std::int32_t>(), (std::vector<std::int32_t>{-1, -300}));
    EXPECT_EQ(root.require("negative").read<float>(), (std::vector<float>{-1, -300}));
    EXPECT_EQ(root.require("odd").read<float>(), (std::vector<float>{1, 2}));
}

TEST_P(Hdf5Forms, GroupsOfFewAndOfManyLinks)
{
    const int counts[] = {0, 1, 5, 40, 700, 6000};
    {
        Hdf5Writer writer(path(), GetParam());
        for (const int count : counts)
            for (const bool ordered : {false, true}) {
                const std::string name = "g" + std::to_string(count) + (ordered ? "o" : "");
                writer.group(name, ordered);
                for (int i = count; i-- > 0;) writer.group(name + "/member" + std::to_string(i));
            }
        H5Lcreate_soft("/g5/member3", writer.file(), "soft", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_soft("loop", writer.file(), "loop", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_external("b.h5", "/x", writer.file(), "other", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_hard(writer.file(), "/g5", writer.file(), "/g1/up", H5P_DEFAULT, H5P_DEFAULT);
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (const int count : counts)
        for (const bool ordered : {false, true}) {
            std::vector<std::string> expected;
            for (int i = count; i-- > 0;) expected.push_back("member" + std::to_string(i));
            if (!ordered && count == 1) expected.push_back("up");
            if (!ordered) std::sort(expected.begin(), expected.end());
            EXPECT_EQ(root.require("g" + std::to_string(count) + (ordered ? "o" : "")).names(), expected);
        }
    EXPECT_EQ(root.require("soft").identity(), root.require("g5/member3").identity());
    EXPECT_EQ(root.require("g700/member699/").name(), "/g700/member699");
    EXPECT_TRUE(root.require("g1/up/member4").find("/g5").has_value());
    EXPECT_THROW(root.find("other"), InputError);
    EXPECT_FALSE(root.find("g5/none"));
    EXPECT_TRUE(root.has("other"));
    EXPECT_THROW(root.find("loop"), InputError);
}

TEST_P(Hdf5Forms, FewAndManyAttributes)
{
    {
        Hdf5Writer writer(path(), GetParam());
        for (const int count : {3, 300}) {
            const std::string name = "g" + std::to_string(count);
            writer.group(name);
            writer.text(name, "label", "Zone_t", 33);
            writer.text(name, "blank", "X   ");
            writer.variableText(name, "long", std::string(900, 'x'));
            writer.attribute<std::int32_t>(name, "version", {1, -2});
            writer.attribute<double>(name, "real", {0.5});
            for (int i = 0; i < count; ++i) writer.attribute<std::int64_t>(name, "a" + std::to_string(i), {i});
        }
        writer.data<float>("d", {1}, {1});
        writer.text("d", "units", "m/s");
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (const int count : {3, 300}) {
        const Hdf5Object group = root.require("g" + std::to_string(count));
        EXPECT_EQ(group.text("label"), "Zone_t");
        EXPECT_EQ(group.text("blank"), "X");
        EXPECT_EQ(group.text("long"), std::string(900, 'x'));
        EXPECT_EQ(group.wholeNumbers("version"), (std::vector<std::int64_t>{1, -2}));
        EXPECT_EQ(group.reals("real"), std::vector<double>{0.5});
        EXPECT_FALSE(group.wholeNumbers("real"));
        EXPECT_FALSE(group.text("real"));
        EXPECT_FALSE(group.text("nothing"));
        for (int i = 0; i < count; ++i)
            EXPECT_EQ(group.wholeNumbers("a" + std::to_string(i)), std::vector<std::int64_t>{i});
    }
    EXPECT_EQ(root.require("d").text("units"), "m/s");
}

TEST_P(Hdf5Forms, WhatWasNeverWrittenHasTheFillValue)
{
    {
        Hdf5Writer writer(path(), GetParam());
        writer.data<float>("zeros", {3}, {});
        writer.data<float>("chunks", {30}, {}, {.chunk = {4}, .most = {kUnlimited}});
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    EXPECT_EQ(root.require("zeros").read<float>(), std::vector<float>(3, 0));
    EXPECT_EQ(root.require("chunks").read<float>(), std::vector<float>(30, 0));
}

TEST_P(Hdf5Forms, FillValuesAndTypesThatHaveANameOfTheirOwn)
{
    {
        Hdf5Writer writer(path(), GetParam());
        const hsize_t dims[] = {6}, most[] = {H5S_UNLIMITED}, chunk[] = {2}, first = 2, count = 2;
        const hid_t space = H5Screate_simple(1, dims, most), list = H5Pcreate(H5P_DATASET_CREATE),
                    type = H5Tcopy(H5T_IEEE_F32BE), part = H5Screate_simple(1, &count, nullptr);
        H5Tcommit2(writer.file(), "type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        const float fill = -7, values[] = {1, 2};
        H5Pset_chunk(list, 1, chunk);
        H5Pset_fill_value(list, H5T_NATIVE_FLOAT, &fill);
        const hid_t data = H5Dcreate2(writer.file(), "d", type, space, H5P_DEFAULT, list, H5P_DEFAULT);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &count, nullptr);
        H5Dwrite(data, H5T_NATIVE_FLOAT, part, space, H5P_DEFAULT, values);
        const hid_t attribute = H5Acreate2(data, "a", type, part, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, H5T_NATIVE_FLOAT, values);
        for (const hid_t id : {attribute, data, type, part, list, space}) H5Idec_ref(id);
    }
    const Hdf5Object data = Hdf5Object::openFile(path()).require("d");
    EXPECT_EQ(data.read<float>(), (std::vector<float>{-7, -7, 1, 2, -7, -7}));
    EXPECT_EQ(data.reals("a"), (std::vector<double>{1, 2}));
}

TEST_P(Hdf5Forms, WhatIsNotReadIsRefusedByName)
{
    {
        Hdf5Writer writer(path(), GetParam());
        const hsize_t dims[] = {64};
        const hid_t space = H5Screate_simple(1, dims, nullptr);
        const hid_t pair = H5Tcreate(H5T_COMPOUND, 8);
        H5Tinsert(pair, "re", 0, H5T_NATIVE_FLOAT);
        H5Dclose(H5Dcreate2(writer.file(), "pair", pair, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        H5Tclose(pair);
        H5Sclose(space);
        writer.group("group");
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    const auto complaint = [&](const char* name) -> std::string {
        try {
            root.require(name).read<float>();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(complaint("pair").find("'/pair' has elements of the kind compound"), std::string::npos)
        << complaint("pair");
    EXPECT_NE(complaint("group").find("'/group': it is a group"), std::string::npos) << complaint("group");
    EXPECT_NE(complaint("none").find("it has no 'none'"), std::string::npos) << complaint("none");
}

/// What the library unpacks by itself, alone and below deflate.
TEST_P(Hdf5Forms, FiltersThatOnlyTheLibraryUndoes)
{
    const std::pair<const char*, herr_t (*)(hid_t)> filters[] = {
        {"nbit", [](hid_t list) { return H5Pset_nbit(list); }},
        {"scaleoffset", [](hid_t list) { return H5Pset_scaleoffset(list, H5Z_SO_INT, H5Z_SO_INT_MINBITS_DEFAULT); }},
        {"fletcher32", [](hid_t list) { return H5Pset_fletcher32(list); }},
        {"szip", [](hid_t list) { return H5Pset_szip(list, H5_SZIP_NN_OPTION_MASK, 8); }}};
    std::vector<std::int32_t> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::int32_t(i * i % 1000);
    {
        Hdf5Writer writer(path(), GetParam());
        for (const auto& [name, set] : filters)
            for (const bool deflated : {false, true}) {
                const hsize_t dims[] = {1000}, chunk[] = {96};
                const hid_t space = H5Screate_simple(1, dims, nullptr), list = H5Pcreate(H5P_DATASET_CREATE);
                H5Pset_chunk(list, 1, chunk);
                ASSERT_GE(set(list), 0) << name;
                if (deflated) H5Pset_deflate(list, 6);
                const hid_t data = H5Dcreate2(writer.file(), (name + std::string(deflated ? "z" : "")).c_str(),
                                              H5T_STD_I32LE, space, H5P_DEFAULT, list, H5P_DEFAULT);
                ASSERT_GE(H5Dwrite(data, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
                for (const hid_t id : {data, list, space}) H5Idec_ref(id);
            }
    }
    const Hdf5Object root = Hdf5Object::openFile(path());
    for (const auto& [name, set] : filters)
        for (const char* more : {"", "z"}) {
            const Hdf5Object data = root.require(name + std::string(more));
            EXPECT_EQ(data.read<std::int32_t>(), values) << name << more;
            EXPECT_EQ(data.read<double>({{500}, {3}}),
                      (std::vector<double>(values.begin() + 500, values.begin() + 503)));
        }
}

TEST_P(Hdf5Forms, ValuesInOtherFiles)
{
    std::filesystem::create_directory(folder_.file("parts"));
    const auto values = counting(6);
    for (const char* part : {"one", "two"}) {
        Hdf5Writer writer(folder_.file("parts/") + part + ".h5", GetParam());
        writer.data(
            "d", {3},
            std::vector<double>(values.begin() + (part[0] == 't' ? 3 : 0), values.end() - (part[0] == 't' ? 0 : 3)));
    }
    writeBytes(folder_.file("parts/raw"), {reinterpret_cast<const char*>(values.data()), 6 * sizeof(double)});
    {
        Hdf5Writer writer(path(), GetParam());
        const hsize_t dims[] = {6}, part[] = {3};
        const hid_t space = H5Screate_simple(1, dims, nullptr), source = H5Screate_simple(1, part, nullptr),
                    joined = H5Pcreate(H5P_DATASET_CREATE), raw = H5Pcreate(H5P_DATASET_CREATE);
        for (const hsize_t begin : {0, 3}) {
            H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, part, nullptr);
            H5Pset_virtual(joined, space, begin == 0 ? "parts/one.h5" : "parts/two.h5", "/d", source);
        }
        H5Sselect_all(space);
        H5Pset_external(raw, "parts/raw", 0, 6 * sizeof(double));
        H5Dclose(H5Dcreate2(writer.file(), "joined", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, joined, H5P_DEFAULT));
        H5Dclose(H5Dcreate2(writer.file(), "raw", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, raw, H5P_DEFAULT));
        H5Lcreate_external("parts/two.h5", "/d", writer.file(), "linked", H5P_DEFAULT, H5P_DEFAULT);
        for (const hid_t id : {space, source, joined, raw}) H5Idec_ref(id);
    }
    const auto read = [&](const char* name) { return Hdf5Object::openFile(path()).require(name).read<double>(); };
    EXPECT_EQ(read("joined"), values);
    EXPECT_EQ(read("raw"), values);
    EXPECT_EQ(read("linked"), (std::vector<double>(values.begin() + 3, values.end())));
    for (const char* file : {"parts/two.h5", "parts/raw"}) std::filesystem::remove(folder_.file(file));
    const auto complaint = [&](const char* name) -> std::string {
        try {
            read(name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    for (const auto& [name, missing] :
         {std::pair{"joined", "parts/two.h5"}, {"raw", "parts/raw"}, {"linked", "parts/two.h5"}})
        EXPECT_NE(complaint(name).find(missing), std::string::npos) << name << ": " << complaint(name);
}

TEST_P(Hdf5Forms, LinksInACircleEnd)
{
    const std::string other = folder_.file("b.h5");
    for (const auto& [file, named] : {std::pair{path(), "b.h5"}, {other, "a.h5"}}) {
        Hdf5Writer writer(file, GetParam());
        H5Lcreate_external(named, "/x", writer.file(), "x", H5P_DEFAULT, H5P_DEFAULT);
    }
    EXPECT_THROW(Hdf5Object::openFile(path()).find("x"), InputError);
}

TEST_P(Hdf5Forms, BytesInFrontOfTheFile)
{
    {
        Hdf5Writer writer(path(), GetParam(), 1024);
        writer.data("d", {100}, counting(100));
    }
    EXPECT_EQ(Hdf5Object::openFile(path()).require("d").read<double>(), counting(100));
}

TEST_P(Hdf5Forms, AFileThatIsCutOffIsRefused)
{
    {
        Hdf5Writer writer(path(), GetParam());
        writer.group("g", true);
        for (int i = 0; i < 20; ++i)
            writer.data("g/d" + std::to_string(i), {100}, counting(100), {.chunk = {30}, .deflate = true});
    }
    const std::string bytes = readBytes(path());
    for (std::size_t size = 1; size < bytes.size(); size += 1 + size / 50) {
        writeBytes(path(), bytes.substr(0, size));
        EXPECT_THROW(Hdf5Object::openFile(path()), InputError) << size;
    }
}

std::string nameOfForm(const testing::TestParamInfo<bool>& form)
{
    return form.param ? "newest" : "oldest";
}
INSTANTIATE_TEST_SUITE_P(Hdf5, Hdf5Forms, testing::Bool(), nameOfForm);

}  // namespace
}  // namespace aeolic
