#include "data/hdf5/hdf5_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "base/text.h"
#include "data/hdf5/hdf5_heap.h"

namespace aeolic {
namespace {

constexpr char kType[] = "an HDF5 type", kSpace[] = "an HDF5 shape", kAttribute[] = "an HDF5 attribute";
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 62;
constexpr std::size_t kMostText = 1 << 16;

static_assert(std::endian::native == std::endian::little);

/// IEEE's form of four or eight bytes. Others are not read.
bool isIeee(ByteCursor& cursor, std::uint32_t bytes)
{
    const int place = cursor.u16(), precision = cursor.u16(), exponentAt = cursor.u8(), exponentBits = cursor.u8(),
              mantissaAt = cursor.u8(), mantissaBits = cursor.u8();
    const std::uint32_t bias = cursor.u32();
    if (place != 0 || mantissaAt != 0) return false;
    if (bytes == 4)
        return precision == 32 && exponentAt == 23 && exponentBits == 8 && mantissaBits == 23 && bias == 127;
    return bytes == 8 && precision == 64 && exponentAt == 52 && exponentBits == 11 && mantissaBits == 52 &&
           bias == 1023;
}

const char* nameOfClass(int type)
{
    constexpr const char* names[] = {"whole number", "floating point",  "time",     "text",
                                     "bit field",    "opaque",          "compound", "reference",
                                     "enumeration",  "variable length", "array"};
    return type <= 10 ? names[type] : "unknown";
}

Hdf5Type parseType(const Hdf5Store& store, ByteCursor& cursor, int depth)
{
    const int first = cursor.u8(), kind = first & 15;
    const std::uint32_t bits = std::uint32_t(cursor.whole(3));
    Hdf5Type type;
    type.bytes = cursor.u32();
    type.name = nameOfClass(kind);
    type.swapped = (kind == 0 || kind == 1) && (bits & 1);
    if (kind == 0) {
        const int place = cursor.u16();
        const std::uint32_t precision = cursor.u16();
        if (place == 0 && precision == 8 * type.bytes && std::has_single_bit(type.bytes) && type.bytes <= 8) {
            type.kind = Hdf5Type::Kind::number;
            type.number = NumberType(2 * std::countr_zero(type.bytes) + (bits & 8 ? 0 : 1));
        }
    } else if (kind == 1 && !(bits & 0x40) && isIeee(cursor, type.bytes)) {
        type.kind = Hdf5Type::Kind::number;
        type.number = type.bytes == 4 ? NumberType::float32 : NumberType::float64;
    } else if (kind == 3) {
        type.kind = Hdf5Type::Kind::text;
    } else if (kind == 8 && depth == 0) {
        return parseType(store, cursor, 1);
    } else if (kind == 9 && (bits & 15) == 1) {
        type.kind = Hdf5Type::Kind::variableText;
    }
    if (type.bytes == 0) store.fail(fmt::format("{} has no bytes", kType));
    return type;
}

std::string trimmedText(std::span<const std::uint8_t> bytes)
{
    std::string text(bytes.begin(), std::find(bytes.begin(), bytes.end(), std::uint8_t{0}));
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return withoutControls(std::move(text), '?');
}

}  // namespace

std::uint64_t Hdf5Space::count() const
{
    if (none) return 0;
    std::uint64_t product = 1;
    for (const std::uint64_t length : shape) product *= length;
    return product;
}

Hdf5Type parseHdf5Type(const Hdf5Store& store, std::span<const std::uint8_t> message)
{
    ByteCursor cursor = store.cursor(message, kType);
    return parseType(store, cursor, 0);
}

Hdf5Space parseHdf5Space(const Hdf5Store& store, std::span<const std::uint8_t> message)
{
    ByteCursor cursor = store.cursor(message, kSpace);
    const int version = cursor.u8();
    if (version != 1 && version != 2) store.fail(fmt::format("{} has the version {}", kSpace, version));
    const int rank = cursor.u8(), flags = cursor.u8();
    if (rank > 32) store.fail(fmt::format("{} has {} dimensions", kSpace, rank));
    Hdf5Space space;
    if (version == 1)
        cursor.skip(5);
    else
        space.none = cursor.u8() == 2;
    std::uint64_t product = 1;
    bool empty = false;
    for (int i = 0; i < rank; ++i) {
        const std::uint64_t length = store.length(cursor);
        empty = empty || length == 0;
        if (length > kMostElements || (length > 0 && product > kMostElements / length))
            store.fail(fmt::format("{} has too many elements", kSpace));
        product *= std::max<std::uint64_t>(length, 1);
        space.shape.push_back(length);
    }
    space.most = space.shape;
    if (flags & 1)
        for (std::uint64_t& length : space.most) length = store.length(cursor);
    return space;
}

std::optional<Hdf5Attribute> parseHdf5Attribute(const Hdf5Store& store, std::span<const std::uint8_t> message,
                                                const std::string& wanted)
{
    ByteCursor cursor = store.cursor(message, kAttribute);
    const int version = cursor.u8(), flags = cursor.u8();
    if (version < 1 || version > 3) store.fail(fmt::format("{} has the version {}", kAttribute, version));
    const std::size_t nameBytes = cursor.u16(), typeBytes = cursor.u16(), spaceBytes = cursor.u16();
    if (version == 3) cursor.skip(1);
    const auto part = [&](std::size_t bytes) {
        const auto taken = cursor.take(bytes);
        if (version == 1) cursor.skip(std::min(cursor.left(), (8 - bytes % 8) % 8));
        return taken;
    };
    Hdf5Attribute attribute;
    attribute.name = trimmedText(part(nameBytes));
    if (attribute.name != wanted) return std::nullopt;
    const auto type = part(typeBytes), space = part(spaceBytes);
    const auto resolved = [&](Hdf5MessageKind kind, std::span<const std::uint8_t> data, int flag) {
        if (version > 1 && (flags & flag)) return sharedHdf5Message(store, int(kind), data).data;
        return std::vector<std::uint8_t>(data.begin(), data.end());
    };
    attribute.type = parseHdf5Type(store, resolved(Hdf5MessageKind::datatype, type, 1));
    attribute.space = parseHdf5Space(store, resolved(Hdf5MessageKind::dataspace, space, 2));
    const std::uint64_t count = attribute.space.count();
    if (count > cursor.left() / attribute.type.bytes)
        store.fail(fmt::format("the HDF5 attribute '{}' has {} elements", attribute.name, count));
    const auto data = cursor.take(count * attribute.type.bytes);
    attribute.data.assign(data.begin(), data.end());
    return attribute;
}

std::vector<std::string> hdf5Texts(const Hdf5Store& store, const Hdf5Type& type, std::uint64_t count,
                                   std::span<const std::uint8_t> data)
{
    std::vector<std::string> texts;
    ByteCursor cursor = store.cursor(data, "a text in HDF5");
    for (std::uint64_t i = 0; i < count; ++i) {
        if (type.kind == Hdf5Type::Kind::text) {
            texts.push_back(trimmedText(cursor.take(type.bytes)));
        } else {
            const std::uint32_t length = cursor.u32();
            const std::uint64_t address = store.address(cursor);
            const std::uint32_t index = cursor.u32();
            if (length > kMostText) store.fail(fmt::format("a text in HDF5 has {} bytes", length));
            const auto bytes =
                length == 0 ? std::vector<std::uint8_t>() : readGlobalHeap(store, address, index, length);
            texts.push_back(trimmedText(bytes));
        }
    }
    return texts;
}

}  // namespace aeolic
