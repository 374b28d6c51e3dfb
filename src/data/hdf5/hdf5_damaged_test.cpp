#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/memory_testing.h"
#include "data/hdf5/hdf5_file.h"
#include "data/hdf5/hdf5_links.h"
#include "data/hdf5/sample_hdf5.h"
#include "data/vtk/sample_files.h"
#include "part_formats_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Puts a number of `width` bytes in the place of what stands there, the lowest byte first.
void put(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t width)
{
    for (std::size_t i = 0; i < width; ++i) bytes[at + i] = char(value >> (8 * i) & 255);
}

class Hdf5Damaged : public testing::Test {
protected:
    /// What is said of the numbers of a data set; empty where nothing is.
    std::string complaint(const std::string& name) const
    {
        return complaintOf([&] { Hdf5Object::openFile(file_).require(name).read<double>(); });
    }

    TempFolder folder_;
    std::string file_ = folder_.file("a.h5");
};

/// Each link's path has three of the next, so that all of them are 3 + 9 + 27 … in number.
TEST_F(Hdf5Damaged, LinksToPathsOfManyLinks)
{
    {
        Hdf5Writer writer(file_);
        for (int i = 0; i < 3; ++i) writer.softLink(fmt::format("l{}", i), fmt::format("l{0}/l{0}/l{0}", i + 1));
        writer.softLink("l3", "/");
    }
    const Hdf5Object root = Hdf5Object::openFile(file_);
    EXPECT_EQ(root.require("l1").name(), "/");  // 13 links.
    EXPECT_EQ(root.require("l1").require("l1").name(), "/");
    expectSays(complaintOf([&] { root.find("l0"); }), {"a.h5", "'/'", "its links lead on for ever"});
}

/// One of many chunks was written, so the index holds one block of entries. A secondary block has room for the
/// addresses of 16 such blocks.
TEST_F(Hdf5Damaged, AnArrayOfChunksWhoseBlocksAreAllTheSame)
{
    {
        Hdf5Writer writer(file_, true);
        const hsize_t dims[] = {16372}, most[] = {H5S_UNLIMITED}, chunk[] = {1}, first = 10000, count = 1;
        const hid_t space = H5Screate_simple(1, dims, most), list = H5Pcreate(H5P_DATASET_CREATE),
                    part = H5Screate_simple(1, &count, nullptr);
        H5Pset_chunk(list, 1, chunk);
        const hid_t data = H5Dcreate2(writer.file(), "d", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &count, nullptr);
        const double value = 1;
        H5Dwrite(data, H5T_NATIVE_DOUBLE, part, space, H5P_DEFAULT, &value);
        for (const hid_t id : {data, part, list, space}) H5Idec_ref(id);
    }
    EXPECT_EQ(complaint("d"), "");
    std::string bytes = readBytes(file_);
    const std::size_t block = bytes.find("EASB");
    ASSERT_NE(block, std::string::npos);
    // Behind sign, version, kind, the array's address and the place of the first entry: the addresses of 16 blocks.
    const std::size_t begin = block + 18, end = begin + 16 * 8;
    const std::string nowhere(8, '\xff');
    std::string written;
    for (std::size_t at = begin; at < end; at += 8)
        if (bytes.compare(at, 8, nowhere) != 0) written = bytes.substr(at, 8);
    ASSERT_EQ(written.size(), 8U);
    for (std::size_t at = begin; at < end; at += 8) bytes.replace(at, 8, written);
    const std::vector<std::uint8_t> checked(bytes.begin() + std::ptrdiff_t(block), bytes.begin() + std::ptrdiff_t(end));
    put(bytes, end, hdf5Checksum(checked), 4);
    writeBytes(file_, bytes);
    expectSays(complaint("d"), {"a.h5", "an HDF5 extensible array goes on for ever"});
}

/// A few kilobytes unpack to a chunk that the process has no memory left for.
TEST_F(Hdf5Damaged, AChunkThatThereIsNoMemoryFor)
{
    {
        Hdf5Writer writer(file_);
        Hdf5SampleLayout layout;
        layout.chunk = {8U << 20};
        layout.most = {H5S_UNLIMITED};
        layout.deflate = true;
        writer.data<double>("d", {1}, {0.5}, layout);
    }
    EXPECT_EQ(complaint("d"), "");
    const TightAddressSpace tight(100U << 20);
    if (!tight.set()) GTEST_SKIP() << "this process cannot have so little memory";
    expectSays(complaint("d"), {"a.h5", "reading '/d'", "needs"});
}

/// Attributes become types that stand in another header, which is their own.
TEST_F(Hdf5Damaged, AHeaderWhoseMessagesStandElsewhere)
{
    constexpr char kAttribute = 12, kType = 3, kShared = 2;
    for (const int count : {16, 17}) {
        {
            Hdf5Writer writer(file_);
            writer.data<double>("d", {1}, {0.5});
            for (int i = 0; i < count; ++i) writer.attribute<std::int32_t>("d", fmt::format("shared{:02}", i), {i});
        }
        std::uint64_t address = 0;
        {
            const Hdf5Store store(file_);
            address = readHdf5Links(store, readHdf5Header(store, store.rootAddress())).at(0).address;
        }
        std::string bytes = readBytes(file_);
        for (std::size_t at = bytes.find("shared"); at != std::string::npos; at = bytes.find("shared", at + 1)) {
            // In front of the name are the message's kind, size and flags, and the attribute's version and sizes.
            if (bytes[at - 16] != kAttribute) continue;
            put(bytes, at - 16, kType, 2);
            put(bytes, at - 12, kShared, 1);
            put(bytes, at - 8, 1, 8);  // The version.
            put(bytes, at, address, 8);
        }
        writeBytes(file_, bytes);
        const std::string said = complaint("d");
        EXPECT_EQ(said.empty(), count == 16) << said;
        if (count > 16) expectSays(said, {"a.h5", "has too many messages that stand elsewhere", "16 at most"});
    }
}

}  // namespace
}  // namespace aeolic
