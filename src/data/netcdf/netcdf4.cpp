#include <fmt/format.h>

#include <map>

#include "data/hdf5/hdf5_file.h"
#include "data/netcdf/netcdf_file.h"

namespace aeolic {
namespace {

/// Variables are the data sets of the root; so are dimensions without values of their own.
class Netcdf4 : public NetcdfFile {
public:
    explicit Netcdf4(const std::string& path) : NetcdfFile(path), root_(Hdf5Object::openFile(path)) {}

    std::optional<std::uint64_t> dimension(const std::string& name) const override
    {
        if (!root_.has(name)) return std::nullopt;
        const Hdf5Object& scale = find(name);
        if (scale.shape().size() != 1) return std::nullopt;
        return scale.shape()[0];
    }

    std::size_t variableCount() const override { return root_.names().size(); }
    bool has(const std::string& variable) const override { return root_.has(variable); }
    std::vector<std::uint64_t> shape(const std::string& variable) const override { return find(variable).shape(); }
    std::optional<NumberType> type(const std::string& variable) const override { return find(variable).type(); }

    std::optional<std::string> text(const std::string& variable, const std::string& attribute) const override
    {
        return find(variable).text(attribute);
    }

    std::vector<float> floats(const std::string& variable, const Slab& slab) const override
    {
        return find(variable).read<float>(slab);
    }
    std::vector<double> doubles(const std::string& variable, const Slab& slab) const override
    {
        return find(variable).read<double>(slab);
    }
    std::vector<std::int64_t> wholes(const std::string& variable, const Slab& slab) const override
    {
        return find(variable).read<std::int64_t>(slab);
    }

protected:
    std::vector<std::uint8_t> characters(const std::string& variable) const override
    {
        const Hdf5Object& data = find(variable);
        auto bytes = data.bytes();
        if (bytes.size() != data.count()) data.fail("its elements are not of one byte", "characters");
        return bytes;
    }

private:
    const Hdf5Object& find(const std::string& variable) const
    {
        const auto known = known_.find(variable);
        if (known != known_.end()) return known->second;
        auto found = root_.find(variable);
        if (!found || !found->isDataSet()) fail(fmt::format("it has no variable '{}'", variable), "one");
        return known_.emplace(variable, std::move(*found)).first->second;
    }

    Hdf5Object root_;
    mutable std::map<std::string, Hdf5Object> known_;
};

}  // namespace

std::unique_ptr<const NetcdfFile> openNetcdf4(const std::string& path)
{
    return std::make_unique<const Netcdf4>(path);
}

}  // namespace aeolic
