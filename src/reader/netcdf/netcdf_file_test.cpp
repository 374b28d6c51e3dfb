#include "reader/netcdf/netcdf_file.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"

/// What the Exodus library does not write. All else is tested with its files (tests/exodus_test.cpp).
namespace aeolic {
namespace {

using namespace test;

/// A header of the form CDF-1, word by word.
class Words {
public:
    Words& operator()(std::uint32_t word)
    {
        for (int byte = 3; byte >= 0; --byte) bytes_ += char(word >> (8 * byte) & 255);
        return *this;
    }
    Words& operator()(const std::string& name)
    {
        (*this)(std::uint32_t(name.size()));
        bytes_ += name;
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        return *this;
    }
    Words& raw(const std::string& bytes)
    {
        bytes_ += bytes;
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

constexpr std::uint32_t kRecords = 3, kStreamed = 0xffffffff, kShort = 3;

/// Records of `variables` variables of one short each, "a", "b" …
std::string shorts(int variables, std::uint32_t records, const std::string& data)
{
    Words words;
    words.raw("CDF\1")(records)(10)(1)("t")(0)(0)(0)(11)(std::uint32_t(variables));
    const auto header = std::uint32_t(words.bytes().size() + std::size_t(variables) * 36);
    for (int i = 0; i < variables; ++i)
        words(std::string(1, char('a' + i)))(1)(0)(0)(0)(kShort)(4)(header + 4 * std::uint32_t(i));
    const std::size_t end = words.bytes().size();
    return words.bytes() + std::string(header - end, '\0') + data;
}

class Netcdf : public testing::Test {
protected:
    void write(const std::string& bytes) const { writeBytes(path_, bytes); }

    TempFolder folder_;
    std::string path_ = folder_.file("a.nc");
};

using Wholes = std::vector<std::int64_t>;

/// Records of one variable alone are not filled up to four bytes.
TEST_F(Netcdf, RecordsOfOneVariableStandCloseTogether)
{
    write(shorts(1, kRecords, std::string("\0\1\0\2\0\3", 6)));
    EXPECT_EQ(NetcdfFile(path_).read<std::int64_t>("a"), (Wholes{1, 2, 3}));
}

TEST_F(Netcdf, RecordsOfSeveralVariablesAreFilledUp)
{
    write(shorts(2, kRecords, std::string("\0\1..\0\2..\0\3..\0\4..\0\5..\0\6..", 24)));
    EXPECT_EQ(NetcdfFile(path_).read<std::int64_t>("a"), (Wholes{1, 3, 5}));
    EXPECT_EQ(NetcdfFile(path_).read<std::int64_t>("b"), (Wholes{2, 4, 6}));
    EXPECT_EQ(NetcdfFile(path_).dimension("t"), 3U);
}

/// A program that ended too early has not written how many records there are.
TEST_F(Netcdf, RecordsThatWereNotCountedAreThoseThatFit)
{
    write(shorts(1, kStreamed, std::string("\0\1\0\2\0\3\0", 7)));
    EXPECT_EQ(NetcdfFile(path_).read<std::int64_t>("a"), (Wholes{1, 2, 3}));
}

TEST_F(Netcdf, RecordsThatAreNotThereAreRefused)
{
    write(shorts(1, kRecords, std::string("\0\1\0\2\0", 5)));
    EXPECT_THROW(NetcdfFile{path_}, InputError);
}

}  // namespace
}  // namespace aeolic
