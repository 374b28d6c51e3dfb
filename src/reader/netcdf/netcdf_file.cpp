#include "reader/netcdf/netcdf_file.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/named_file.h"
#include "reader/binary/filled_text.h"
#include "reader/hdf5/hdf5_lock.h"
#include "reader/netcdf/netcdf_classic.h"

namespace aeolic {
namespace {

constexpr std::size_t kReadAtOnce = 4 << 20;  // Bytes of a classic file. The library's own choice is a few kilobytes.

std::optional<NumberType> numberType(nc_type type)
{
    using enum NumberType;
    constexpr std::pair<nc_type, NumberType> types[] = {
        {NC_BYTE, int8},   {NC_UBYTE, uint8}, {NC_SHORT, int16},   {NC_USHORT, uint16}, {NC_INT, int32},
        {NC_UINT, uint32}, {NC_INT64, int64}, {NC_UINT64, uint64}, {NC_FLOAT, float32}, {NC_DOUBLE, float64}};
    for (const auto& [theirs, ours] : types)
        if (theirs == type) return ours;
    return std::nullopt;
}

}  // namespace

NetcdfFile::NetcdfFile(const std::string& path) : path_(path)
{
    const std::uint64_t bytes = checkReadableFile(path);
    const Hdf5Lock lock;
    // The library takes a name with "://" for a place in the network. This form of a path has no double slashes.
    const std::string plain = std::filesystem::canonical(path).string();
    std::size_t atOnce = kReadAtOnce;
    const int status = nc__open(plain.c_str(), NC_NOWRITE, &atOnce, &id_);
    if (status == NC_ENOTNC) fail("it does not begin like a netCDF file", "netCDF");
    sound(status, "it");
    bool classic = true;
    try {
        classic = readHeader(bytes);
    } catch (...) {
        nc_close(id_);
        throw;
    }
    if (classic) return;
    // HDF5 reads the values of netCDF-4, and they are unpacked on all cores.
    nc_close(id_);
    root_ = Hdf5Object::openFile(path);
}

NetcdfFile::~NetcdfFile()
{
    if (root_) return;
    const Hdf5Lock lock;
    nc_close(id_);
}

/// Whether the file is in a classic form.
bool NetcdfFile::readHeader(std::uint64_t fileBytes)
{
    int format = 0, dimensions = 0, variables = 0, unlimited = -1;
    sound(nc_inq_format(id_, &format), "its form");
    sound(nc_inq(id_, &dimensions, &variables, nullptr, &unlimited), "its header");
    const bool classic = format != NC_FORMAT_NETCDF4 && format != NC_FORMAT_NETCDF4_CLASSIC;
    const std::uint64_t records = classic ? classicNetcdfRecords(path_, id_, fileBytes) : 0;
    char name[NC_MAX_NAME + 1];
    std::map<int, std::uint64_t> lengths;
    std::map<int, std::string> names;
    std::vector<int> numbers(std::size_t(dimensions) + 1);
    sound(nc_inq_dimids(id_, &dimensions, numbers.data(), 0), "its dimensions");
    for (int i = 0; i < dimensions; ++i) {
        std::size_t length = 0;
        sound(nc_inq_dim(id_, numbers[std::size_t(i)], name, &length), "a dimension");
        names[numbers[std::size_t(i)]] = name;
        dimensions_[name] = lengths[numbers[std::size_t(i)]] =
            classic && numbers[std::size_t(i)] == unlimited ? records : length;
    }
    for (int i = 0; i < variables; ++i) {
        int rank = 0;
        sound(nc_inq_varndims(id_, i, &rank), "a variable");
        Variable variable{i, NC_NAT, {}, {}, {}};
        numbers.resize(std::size_t(rank) + 1);
        sound(nc_inq_var(id_, i, name, &variable.type, nullptr, numbers.data(), nullptr), "a variable");
        for (int k = 0; k < rank; ++k) {
            variable.shape.push_back(lengths[numbers[std::size_t(k)]]);
            variable.dimensions.push_back(names[numbers[std::size_t(k)]]);
        }
        variables_.emplace(name, std::move(variable));
    }
    return classic;
}

std::optional<std::uint64_t> NetcdfFile::dimension(const std::string& name) const
{
    const auto found = dimensions_.find(name);
    return found == dimensions_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::uint64_t> NetcdfFile::shape(const std::string& variable) const
{
    const std::vector<std::uint64_t>& shape = find(variable).shape;
    return root_ ? object(variable).shape() : shape;
}

std::optional<NumberType> NetcdfFile::type(const std::string& variable) const
{
    return numberType(find(variable).type);
}

std::optional<std::string> NetcdfFile::text(const std::string& variable, const std::string& attribute) const
{
    const int number = find(variable).id;
    if (root_) return object(variable).text(attribute);
    const Hdf5Lock lock;
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(id_, number, attribute.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR) return std::nullopt;
    std::string text(length, '\0');
    sound(nc_get_att_text(id_, number, attribute.c_str(), text.data()), fmt::format("'{}'", attribute));
    return withoutFilling(std::move(text));
}

std::vector<std::string> NetcdfFile::variables() const
{
    std::vector<std::string> names;
    for (const auto& [name, variable] : variables_) names.push_back(name);
    return names;
}

const std::vector<std::string>& NetcdfFile::dimensions(const std::string& variable) const
{
    return find(variable).dimensions;
}

std::optional<std::vector<double>> NetcdfFile::numbers(const std::string& variable, const std::string& attribute) const
{
    const int number = find(variable).id;
    if (root_) return object(variable).reals(attribute);
    const Hdf5Lock lock;
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(id_, number, attribute.c_str(), &type, &length) != NC_NOERR || !numberType(type))
        return std::nullopt;
    std::vector<double> numbers(length);
    sound(nc_get_att_double(id_, number, attribute.c_str(), numbers.data()), fmt::format("'{}'", attribute));
    return numbers;
}

template <class Number>
std::vector<Number> NetcdfFile::read(const std::string& variable, const Slab& slab) const
{
    const Variable& found = find(variable);
    if (!numberType(found.type)) fail(fmt::format("'{}' has no numbers", variable), "numbers");
    if (root_) return object(variable).read<Number>(slab);
    const std::uint64_t count = productOf(slab.count);
    if (count == 0) return {};
    requireMemory(path_, fmt::format("reading '{}'", variable), count * sizeof(Number));
    std::vector<Number> values(count);
    const Hdf5Lock lock;
    const auto get = [&](auto function) {
        return function(id_, found.id, slab.first.data(), slab.count.data(), values.data());
    };
    int status = NC_NOERR;
    if constexpr (std::is_same_v<Number, float>)
        status = get(nc_get_vara_float);
    else if constexpr (std::is_same_v<Number, double>)
        status = get(nc_get_vara_double);
    else
        status = get(nc_get_vara_long);
    if (status != NC_ERANGE) sound(status, fmt::format("'{}'", variable));  // What is too large becomes the largest.
    return values;
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const
{
    const int number = find(variable).id;
    const std::vector<std::uint64_t> lengths = shape(variable);
    std::string all;
    if (root_) {
        all = object(variable).characters();
    } else {
        if (find(variable).type != NC_CHAR) fail(fmt::format("'{}' has no characters", variable), "characters");
        requireMemory(path_, fmt::format("reading '{}'", variable), productOf(lengths));
        all.resize(productOf(lengths));
        const Hdf5Lock lock;
        const Slab whole = wholeSlab(lengths);
        if (!all.empty())
            sound(nc_get_vara_text(id_, number, whole.first.data(), whole.count.data(), all.data()),
                  fmt::format("'{}'", variable));
    }
    const std::uint64_t length = lengths.empty() ? all.size() : lengths.back();
    std::vector<std::string> texts;
    for (std::uint64_t at = 0; length > 0 && at + length <= all.size(); at += length)
        texts.push_back(withoutFilling(all.substr(at, length)));
    return texts;
}

/// In netCDF-4. A variable that has the name of a dimension, and is not its coordinate, has another name in HDF5.
const Hdf5Object& NetcdfFile::object(const std::string& variable) const
{
    const Variable& found = find(variable);
    const std::string aside = "_nc4_non_coord_" + variable;
    if (!found.object) found.object = root_->require(root_->has(aside) ? aside : variable);
    return *found.object;
}

const NetcdfFile::Variable& NetcdfFile::find(const std::string& variable) const
{
    const auto found = variables_.find(variable);
    if (found == variables_.end()) fail(fmt::format("it has no variable '{}'", variable), "one");
    return found->second;
}

void NetcdfFile::sound(int status, const std::string& what) const
{
    if (status != NC_NOERR)
        fail(fmt::format("{} cannot be read: {}", what, nc_strerror(status)), "a complete, undamaged file");
}

void NetcdfFile::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, found, expected);
}

template std::vector<float> NetcdfFile::read(const std::string&, const Slab&) const;
template std::vector<double> NetcdfFile::read(const std::string&, const Slab&) const;
template std::vector<std::int64_t> NetcdfFile::read(const std::string&, const Slab&) const;

}  // namespace aeolic
