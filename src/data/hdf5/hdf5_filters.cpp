#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "data/hdf5/hdf5_layout.h"

namespace aeolic {
namespace {

enum Known { deflated = 1, shuffled = 2, fletcher = 3 };

constexpr std::size_t kChecksums = 64;  // Bytes that filters put in front of deflate may have added.

std::vector<std::uint8_t> inflated(const std::vector<std::uint8_t>& data, std::uint64_t bytes)
{
    std::vector<std::uint8_t> out;
    if (bytes > kMostRatio * data.size() + kChecksums) return out;
    out.resize(bytes + kChecksums);
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return {};
    std::size_t read = 0, written = 0;
    int status = Z_OK;
    while (status == Z_OK) {
        constexpr std::size_t most = std::size_t{1} << 30;  // zlib counts in 32 bits.
        stream.next_in = const_cast<Bytef*>(data.data() + read);
        stream.avail_in = uInt(std::min(most, data.size() - read));
        stream.next_out = out.data() + written;
        stream.avail_out = uInt(std::min(most, out.size() - written));
        const uInt in = stream.avail_in, room = stream.avail_out;
        status = inflate(&stream, Z_NO_FLUSH);
        read += in - stream.avail_in;
        written += room - stream.avail_out;
        if (in == stream.avail_in && room == stream.avail_out) break;
    }
    inflateEnd(&stream);
    if (status != Z_STREAM_END) return {};
    out.resize(written);
    return out;
}

/// The first bytes of all elements, then the second … as HDF5 writes them; what does not fill an element stays behind.
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

std::uint32_t fletcher32(std::span<const std::uint8_t> data)
{
    std::uint32_t first = 0, second = 0;
    const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
    const auto add = [&](std::uint32_t word) {
        first += word;
        second += first;
    };
    for (std::size_t at = 0; at + 1 < data.size();) {
        for (int k = 0; k < 360 && at + 1 < data.size(); ++k, at += 2) add(std::uint32_t(data[at]) << 8 | data[at + 1]);
        first = fold(first);
        second = fold(second);
    }
    if (data.size() % 2 == 1) {
        add(std::uint32_t(data.back()) << 8);
        first = fold(first);
        second = fold(second);
    }
    return fold(second) << 16 | fold(first);
}

/// Takes the checksum off; false where it is wrong.
bool checksumHolds(const Hdf5Store& store, std::vector<std::uint8_t>& data)
{
    if (data.size() < 4) return false;
    ByteCursor tail = store.cursor(std::span<const std::uint8_t>(data).last(4), "an HDF5 checksum");
    const std::uint32_t found = tail.u32();
    data.resize(data.size() - 4);
    return found == fletcher32(data);
}

std::string nameOf(const Hdf5Filter& filter)
{
    switch (filter.id) {
        case 4:
            return "szip";
        case 5:
            return "nbit";
        case 6:
            return "scaleoffset";
        case 307:
            return "bzip2";
        case 32000:
            return "lzf";
        case 32001:
            return "blosc";
        case 32004:
            return "lz4";
        case 32015:
            return "zstd";
        default:
            return fmt::format("{}", filter.id);
    }
}

}  // namespace

void requireKnownFilters(const Hdf5Store& store, const std::vector<Hdf5Filter>& filters, const std::string& name)
{
    for (const Hdf5Filter& filter : filters)
        if (filter.id < deflated || filter.id > fletcher)
            store.fail(fmt::format("'{}' is packed by the HDF5 filter {}", name, nameOf(filter)),
                       "deflate, shuffle, fletcher32 or none (h5repack -f GZIP=1 writes it so)");
}

std::vector<std::uint8_t> unfiltered(const Hdf5Store& store, std::vector<std::uint8_t> data,
                                     const std::vector<Hdf5Filter>& filters, std::uint32_t skipped, std::uint64_t bytes,
                                     const std::string& name)
{
    const auto damaged = [&](const char* what) { store.fail(fmt::format("a chunk of '{}' {}", name, what)); };
    for (std::size_t i = filters.size(); i-- > 0;) {
        if (skipped >> i & 1) continue;
        if (filters[i].id == deflated) {
            data = inflated(data, bytes);
            if (data.empty()) damaged("cannot be unpacked");
        } else if (filters[i].id == shuffled) {
            data = unshuffled(data, filters[i].size);
        } else if (!checksumHolds(store, data)) {
            damaged("has a wrong checksum");
        }
    }
    if (data.size() != bytes) damaged("has another size than the others");
    return data;
}

}  // namespace aeolic
