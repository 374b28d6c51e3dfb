#include "reader/hdf5/hdf5_dataset.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "reader/hdf5/hdf5_handle.h"

namespace aeolic {
namespace {

static_assert(std::endian::native == std::endian::little);

const char* nameOfClass(H5T_class_t type)
{
    constexpr const char* names[] = {"whole number", "floating point",  "time",     "text",
                                     "bit field",    "opaque",          "compound", "reference",
                                     "enumeration",  "variable length", "array"};
    return type >= 0 && type < int(std::size(names)) ? names[type] : "unknown";
}

/// The first bytes of all elements, then the second … as HDF5 writes them; bytes that fill no element stay behind.
std::vector<std::uint8_t> unshuffled(const std::vector<std::uint8_t>& data, std::size_t width)
{
    if (width < 2 || width > data.size()) return data;
    std::vector<std::uint8_t> out(data.size());
    const std::size_t count = data.size() / width;
    for (std::size_t byte = 0; byte < width; ++byte)
        for (std::size_t i = 0; i < count; ++i) out[i * width + byte] = data[byte * count + i];
    std::copy(data.begin() + std::ptrdiff_t(count * width), data.end(), out.begin() + std::ptrdiff_t(count * width));
    return out;
}

/// Whether a file that HDF5 names is found beside the one that names it, or as it is named.
bool isThere(const std::string& from, const std::string& named)
{
    std::error_code error;
    return std::filesystem::exists(std::filesystem::path(from).parent_path() / named, error) ||
           std::filesystem::exists(named, error);
}

}  // namespace

/// How a data set is cut into chunks that are packed by nothing but shuffle and deflate.
struct Hdf5DataSet::Chunks {
    std::vector<std::uint64_t> lengths;        ///< Elements of a chunk in each dimension.
    std::uint64_t bytes = 0;                   ///< Of a chunk without filters.
    std::size_t width = 0;                     ///< Of what was shuffled, in bytes.
    int shuffleAt = -1, deflateAt = -1;        ///< Their places among the filters.
    std::vector<std::uint64_t> begin, across;  ///< In each dimension the first chunk that is wanted, and how many are.
};

Hdf5DataSet::Hdf5DataSet(hid_t id, const std::string& file, const std::string& name) : id_(id), file_(file), name_(name)
{
    const Hdf5Handle space(H5Dget_space(id));
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0) fail("cannot be read: " + lastHdf5Fault());
    shape_.resize(std::size_t(rank));
    std::vector<hsize_t> lengths(shape_.size() + 1);
    H5Sget_simple_extent_dims(space, lengths.data(), nullptr);
    std::copy_n(lengths.begin(), shape_.size(), shape_.begin());
    count_ = H5Sget_simple_extent_type(space) == H5S_NULL ? 0 : 1;
    count_ *= productOf(shape_);
    const Hdf5Handle type(H5Dget_type(id));
    const H5T_class_t kind = H5Tget_class(type);
    const std::size_t bytes = H5Tget_size(type);
    swapped_ = H5Tget_order(type) == H5T_ORDER_BE;
    if (kind == H5T_INTEGER && std::has_single_bit(bytes) && bytes <= 8) {
        type_ = NumberType(2 * std::countr_zero(bytes) + (H5Tget_sign(type) == H5T_SGN_NONE ? 1 : 0));
        exact_ = H5Tget_precision(type) == 8 * bytes;
    } else if (kind == H5T_FLOAT) {
        type_ = bytes <= 4 ? NumberType::float32 : NumberType::float64;
        for (const hid_t ieee : {H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE})
            exact_ = exact_ || H5Tequal(type, ieee) > 0;
    } else {
        kind_ = nameOfClass(kind);
    }
}

template <class Number>
std::vector<Number> Hdf5DataSet::read(const Slab& slab) const
{
    std::optional<Chunks> chunks;
    Number fill{};
    {
        const Hdf5Lock lock;
        if (!type_) fail(fmt::format("has elements of the kind {}", kind_), "whole numbers or floating-point numbers");
        if (!isWithin(slab, shape_))
            fail(fmt::format("has {} elements", fmt::join(shape_, " x ")), "more, by what refers to them");
        if (count_ == 0 || productOf(slab.count) == 0) return {};
        const Hdf5Handle creation(H5Dget_create_plist(id_));
        requireOtherFiles(creation);
        chunks = plainChunks(creation, slab);
        if (H5Pget_fill_value(creation, nativeHdf5Type<Number>(), &fill) < 0) fill = Number{};
    }
    const std::uint64_t count = productOf(slab.count);
    requireMemory(file_, fmt::format("reading '{}'", name_), count * sizeof(Number));
    std::vector<Number> values(count, fill);
    if (chunks)
        parallelFor(productOf(chunks->across), [&](std::size_t i) { readChunk(*chunks, i, slab, values); });
    else
        readByLibrary(nativeHdf5Type<Number>(), slab, values.data());
    return values;
}

std::string Hdf5DataSet::characters() const
{
    const Hdf5Lock lock;
    const Hdf5Handle type(H5Dget_type(id_));
    if (H5Tget_class(type) != H5T_STRING || H5Tget_size(type) != 1) fail("has no characters", "characters");
    std::string all(count_, '\0');
    if (count_ > 0) readByLibrary(type, wholeSlab(shape_), all.data());
    return all;
}

/// The library gives the fill value for what it finds no file of.
void Hdf5DataSet::requireOtherFiles(hid_t creation) const
{
    std::vector<std::string> files;
    std::string name(4096, '\0');
    std::size_t virtualParts = 0;
    if (H5Pget_layout(creation) == H5D_VIRTUAL) H5Pget_virtual_count(creation, &virtualParts);
    for (std::size_t i = 0; i < virtualParts; ++i)
        if (H5Pget_virtual_filename(creation, i, name.data(), name.size()) >= 0) files.emplace_back(name.c_str());
    for (int i = 0; i < H5Pget_external_count(creation); ++i)
        if (H5Pget_external(creation, unsigned(i), name.size(), name.data(), nullptr, nullptr) >= 0)
            files.emplace_back(name.c_str());
    for (const std::string& file : files)
        // "." is this file; "%b" in a name stands for a number.
        if (file != "." && file.find('%') == std::string::npos && !isThere(file_, file))
            fail(fmt::format("has values in the file '{}', which is not there", file), "that file beside this one");
}

/// Nothing where the library must unpack the data set, or converts it to numbers.
std::optional<Hdf5DataSet::Chunks> Hdf5DataSet::plainChunks(hid_t creation, const Slab& slab) const
{
    if (!exact_ || H5Pget_layout(creation) != H5D_CHUNKED) return std::nullopt;
    unsigned options = 0;
    H5Pget_chunk_opts(creation, &options);
    if (options & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) return std::nullopt;
    Chunks chunks;
    const int filters = H5Pget_nfilters(creation);
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0, value = 0;
        std::size_t values = 1;
        const H5Z_filter_t filter = H5Pget_filter2(creation, unsigned(i), &flags, &values, &value, 0, nullptr, nullptr);
        if (filter == H5Z_FILTER_SHUFFLE && i == 0) {
            chunks.shuffleAt = i;
            chunks.width = value;
        } else if (filter == H5Z_FILTER_DEFLATE && i == filters - 1) {
            chunks.deflateAt = i;
        } else {
            return std::nullopt;
        }
    }
    std::vector<hsize_t> lengths(shape_.size());
    if (H5Pget_chunk(creation, int(lengths.size()), lengths.data()) < 0) return std::nullopt;
    chunks.lengths.assign(lengths.begin(), lengths.end());
    chunks.bytes = productOf(chunks.lengths) * bytesOf(*type_);
    for (std::size_t i = 0; i < shape_.size(); ++i) {
        const std::uint64_t last = slab.first[i] + slab.count[i] - 1;
        chunks.begin.push_back(slab.first[i] / chunks.lengths[i]);
        chunks.across.push_back(last / chunks.lengths[i] - chunks.begin[i] + 1);
    }
    return chunks;
}

/// Threads call it at once. Only the library's part of the work must wait for others.
template <class Number>
void Hdf5DataSet::readChunk(const Chunks& chunks, std::uint64_t number, const Slab& slab,
                            std::vector<Number>& values) const
{
    std::vector<hsize_t> first(shape_.size());
    for (std::size_t i = first.size(); i-- > 0; number /= chunks.across[i])
        first[i] = (chunks.begin[i] + number % chunks.across[i]) * chunks.lengths[i];
    std::vector<std::uint8_t> data;
    std::uint32_t skipped = 0;  // A bit for each filter that was left out.
    {
        const Hdf5Lock lock;
        hsize_t bytes = 0;
        bool known = H5Dget_chunk_storage_size(id_, first.data(), &bytes) >= 0;
        if (!known) {
            // That may mean that it was never written. This call tells so, but goes through all chunks.
            haddr_t address = HADDR_UNDEF;
            unsigned mask = 0;
            if (H5Dget_chunk_info_by_coord(id_, first.data(), &mask, &address, &bytes) >= 0) {
                if (address == HADDR_UNDEF) return;
                known = true;
            }
        }
        if (known && bytes == 0) return;
        data.resize(bytes);
        if (!known || H5Dread_chunk(id_, H5P_DEFAULT, first.data(), &skipped, data.data()) < 0)
            fail("cannot be read: " + lastHdf5Fault());
    }
    if (chunks.deflateAt >= 0 && !(skipped >> chunks.deflateAt & 1)) {
        std::vector<std::uint8_t> unpacked(chunks.bytes);
        uLongf bytes = unpacked.size();
        if (uncompress(unpacked.data(), &bytes, data.data(), data.size()) != Z_OK || bytes != chunks.bytes)
            fail("has a chunk that cannot be unpacked");
        data = std::move(unpacked);
    }
    if (chunks.shuffleAt >= 0 && !(skipped >> chunks.shuffleAt & 1)) data = unshuffled(data, chunks.width);
    if (data.size() < chunks.bytes) fail(fmt::format("has a chunk of {} bytes", data.size()));
    forEachRun({{first.begin(), first.end()}, chunks.lengths}, slab,
               [&](std::uint64_t source, std::uint64_t target, std::uint64_t count) {
                   convertNumbers<Number>(data.data() + source * bytesOf(*type_), *type_, swapped_,
                                          {values.data() + target, count});
               });
}

void Hdf5DataSet::readByLibrary(hid_t type, const Slab& slab, void* values) const
{
    const Hdf5Lock lock;
    const std::vector<hsize_t> first(slab.first.begin(), slab.first.end()), count(slab.count.begin(), slab.count.end());
    const Hdf5Handle file(H5Dget_space(id_)),
        memory(count.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(int(count.size()), count.data(), nullptr));
    if (!count.empty()) H5Sselect_hyperslab(file, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr);
    if (H5Dread(id_, type, memory, file, H5P_DEFAULT, values) < 0) fail("cannot be read: " + lastHdf5Fault());
}

void Hdf5DataSet::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(file_, fmt::format("'{}' {}", name_, found), expected);
}

template std::vector<float> Hdf5DataSet::read(const Slab&) const;
template std::vector<double> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int8_t> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int32_t> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int64_t> Hdf5DataSet::read(const Slab&) const;

}  // namespace aeolic
