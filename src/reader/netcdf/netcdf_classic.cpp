#include "reader/netcdf/netcdf_classic.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "aeolic/error.h"

namespace aeolic {
namespace {

std::uint64_t filledUp(std::uint64_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

/// The parts of a file, which follow each other (NetCDF Users Guide, appendix "File Format Specifications").
class Layout {
public:
    explicit Layout(int id) : id_(id)
    {
        nc_inq_format(id, &format_);
        count_ = format_ == NC_FORMAT_CDF5 ? 8 : 4;
        int dimensions = 0, variables = 0, attributes = 0;
        nc_inq(id, &dimensions, &variables, &attributes, &unlimited_);
        header = 4 + count_ + 3 * (4 + count_);
        for (int i = 0; i < dimensions; ++i) {
            std::size_t length = 0;
            nc_inq_dim(id, i, name_.data(), &length);
            header += nameBytes() + count_;
            lengths_.push_back(length);
        }
        addAttributes(NC_GLOBAL, attributes);
        for (int i = 0; i < variables; ++i) addVariable(i);
        // Records of a single variable are not filled up.
        if (recordVariables_ == 1) record = lastBytes_;
        if (unlimited_ >= 0) records = lengths_[std::size_t(unlimited_)];
    }

    bool recordsAreCounted() const
    {
        return records != (count_ == 8 ? std::numeric_limits<std::uint64_t>::max() : 0xffffffffU);
    }

    std::uint64_t header = 0, fixed = 0, record = 0, records = 0;
    std::uint64_t unfilled = 0;  ///< Bytes that may be missing at the end, because they only fill it up.

private:
    std::uint64_t nameBytes() const { return count_ + filledUp(std::string(name_.data()).size()); }

    void addAttributes(int variable, int attributes)
    {
        for (int i = 0; i < attributes; ++i) {
            nc_type type = NC_CHAR;
            std::size_t length = 0, bytes = 0;
            nc_inq_attname(id_, variable, i, name_.data());
            nc_inq_att(id_, variable, name_.data(), &type, &length);
            nc_inq_type(id_, type, nullptr, &bytes);
            header += nameBytes() + 4 + count_ + filledUp(length * bytes);
        }
    }

    void addVariable(int variable)
    {
        nc_type type = NC_CHAR;
        int rank = 0, attributes = 0;
        std::size_t bytes = 0;
        nc_inq_varndims(id_, variable, &rank);
        std::vector<int> dimensions(std::size_t(rank) + 1);
        nc_inq_var(id_, variable, name_.data(), &type, nullptr, dimensions.data(), &attributes);
        nc_inq_type(id_, type, nullptr, &bytes);
        header += nameBytes() + count_ + std::uint64_t(rank) * count_ + 4 + count_ + 4 + count_ +
                  (format_ == NC_FORMAT_CLASSIC ? 4 : 8);
        addAttributes(variable, attributes);
        const bool grows = rank > 0 && dimensions[0] == unlimited_;
        std::uint64_t all = bytes;
        for (int i = grows; i < rank; ++i) all *= lengths_[std::size_t(dimensions[std::size_t(i)])];
        std::uint64_t& sum = grows ? record : fixed;
        sum += filledUp(all);
        if (!grows && recordVariables_ > 0) return;
        unfilled = filledUp(all) - all;
        lastBytes_ = all;
        recordVariables_ += grows;
        if (recordVariables_ == 1) unfilled = 0;
    }

    int id_, format_ = 0, unlimited_ = -1, recordVariables_ = 0;
    std::uint64_t count_ = 4, lastBytes_ = 0;
    std::array<char, NC_MAX_NAME + 1> name_{};
    std::vector<std::uint64_t> lengths_;
};

}  // namespace

std::uint64_t classicNetcdfRecords(const std::string& path, int id, std::uint64_t fileBytes)
{
    const Layout layout(id);
    const std::uint64_t begin = layout.header + layout.fixed;
    if (!layout.recordsAreCounted())
        return layout.record > 0 && fileBytes > begin ? (fileBytes - begin) / layout.record : 0;
    const std::uint64_t end = begin + layout.records * layout.record;
    if (end > fileBytes + layout.unfilled)
        throw InputError(path, fmt::format("it is cut off: it has {} bytes", fileBytes),
                         fmt::format("{} for all that it says it has", end));
    return layout.records;
}

}  // namespace aeolic
