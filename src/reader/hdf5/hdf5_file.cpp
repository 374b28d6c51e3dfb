#include "reader/hdf5/hdf5_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/named_file.h"
#include "reader/binary/filled_text.h"
#include "reader/hdf5/hdf5_handle.h"

namespace aeolic {
namespace {

constexpr char kUndamaged[] = "a complete, undamaged file";

/// What the library writes into a text of its caller's: call(characters, their number) gives how many there are.
template <class Call>
std::string textOf(const Call& call)
{
    const auto length = call(nullptr, 0);
    std::string text(std::size_t(std::max<decltype(length)>(length, 0)) + 1, '\0');
    if (length > 0) call(text.data(), text.size());
    text.pop_back();
    return text;
}

/// Files of a data set's values are looked for beside the file that names them. All who open it must say so.
Hdf5Handle openObject(hid_t at, const std::string& path)
{
    H5O_info_t info{};
    if (H5Oget_info_by_name2(at, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0)
        return Hdf5Handle(H5I_INVALID_HID);
    if (info.type != H5O_TYPE_DATASET) return Hdf5Handle(H5Oopen(at, path.c_str(), H5P_DEFAULT));
    const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS));
    H5Pset_efile_prefix(access, "${ORIGIN}");
    return Hdf5Handle(H5Dopen2(at, path.c_str(), access));
}

}  // namespace

struct Hdf5Object::State {
    Hdf5Handle id;
    std::string file, name;
    std::optional<Hdf5DataSet> data;
    mutable std::optional<std::vector<std::string>> names;

    explicit State(Hdf5Handle opened) : id(std::move(opened))
    {
        file = textOf([&](char* to, std::size_t size) { return H5Fget_name(id, to, size); });
        name = withoutControls(textOf([&](char* to, std::size_t size) { return H5Iget_name(id, to, size); }), '?');
        if (H5Iget_type(id) == H5I_DATASET) data.emplace(id, file, name);
    }
    State(const State&) = delete;  // `data` refers to it.

    /// Reads an attribute of some classes of types as numbers.
    template <class Number>
    std::optional<std::vector<Number>> numbers(const std::string& attribute, bool realsToo) const
    {
        const Hdf5Lock lock;
        if (H5Aexists(id, attribute.c_str()) <= 0) return std::nullopt;
        const Hdf5Handle opened(H5Aopen(id, attribute.c_str(), H5P_DEFAULT)), type(H5Aget_type(opened)),
            space(H5Aget_space(opened));
        const H5T_class_t kind = H5Tget_class(type);
        if (kind != H5T_INTEGER && !(realsToo && kind == H5T_FLOAT)) return std::nullopt;
        const auto count = std::uint64_t(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0));
        std::vector<Number> values(count);
        if (count > 0 && H5Aread(opened, nativeHdf5Type<Number>(), values.data()) < 0)
            throw InputError(file, fmt::format("'{}' of '{}' cannot be read: {}", attribute, name, lastHdf5Fault()),
                             kUndamaged);
        return values;
    }
};

Hdf5Object Hdf5Object::openFile(const std::string& file)
{
    checkReadableFile(file);
    const Hdf5Lock lock;
    if (H5Fis_hdf5(file.c_str()) <= 0) throw InputError(file, "it does not begin like an HDF5 file", "HDF5");
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_file_locking(access, false, true);  // Programs that still write it lock it, and not all file systems can.
    const Hdf5Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access));
    if (opened < 0) throw InputError(file, "it cannot be opened as HDF5: " + lastHdf5Fault(), kUndamaged);
    Hdf5Handle root = openObject(opened, "/");
    if (root < 0) throw InputError(file, "it has no root: " + lastHdf5Fault(), kUndamaged);
    return Hdf5Object(std::make_shared<const State>(std::move(root)));
}

const std::string& Hdf5Object::file() const
{
    return state_->file;
}

const std::string& Hdf5Object::name() const
{
    return state_->name;
}

bool Hdf5Object::isDataSet() const
{
    return state_->data.has_value();
}

std::pair<std::uint64_t, std::uint64_t> Hdf5Object::identity() const
{
    const Hdf5Lock lock;
    H5O_info_t info{};
    H5Oget_info2(state_->id, &info, H5O_INFO_BASIC);
    return {info.fileno, info.addr};
}

const std::vector<std::string>& Hdf5Object::names() const
{
    const Hdf5Lock lock;
    if (state_->names) return *state_->names;
    std::vector<std::string> names;
    unsigned order = 0;
    if (H5Iget_type(state_->id) == H5I_GROUP) {
        const Hdf5Handle creation(H5Gget_create_plist(state_->id));
        H5Pget_link_creation_order(creation, &order);
        const auto take = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
            static_cast<std::vector<std::string>*>(to)->emplace_back(name);
            return 0;
        };
        if (H5Literate(state_->id, order & H5P_CRT_ORDER_TRACKED ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME, H5_ITER_INC,
                       nullptr, take, &names) < 0)
            fail("its links cannot be read: " + lastHdf5Fault(), kUndamaged);
    }
    state_->names = std::move(names);
    return *state_->names;
}

bool Hdf5Object::has(const std::string& name) const
{
    const Hdf5Lock lock;
    return H5Lexists(state_->id, name.c_str(), H5P_DEFAULT) > 0;
}

std::optional<Hdf5Object> Hdf5Object::find(const std::string& path) const
{
    const Hdf5Lock lock;
    Hdf5Handle found = openObject(state_->id, path);
    if (found >= 0) return Hdf5Object(std::make_shared<const State>(std::move(found)));
    const std::string fault = lastHdf5Fault();
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        const std::string start = path.substr(0, end);
        if (!has(start)) return std::nullopt;
        if (end < path.size() && openObject(state_->id, start) >= 0) continue;
        failAtLink(start, fault);
    }
}

void Hdf5Object::failAtLink(const std::string& link, const std::string& fault) const
{
    H5L_info_t info{};
    H5Lget_info(state_->id, link.c_str(), &info, H5P_DEFAULT);
    if (info.type == H5L_TYPE_HARD) fail(fmt::format("'{}' cannot be opened: {}", link, fault), kUndamaged);
    std::string value(info.u.val_size + 1, '\0');
    H5Lget_val(state_->id, link.c_str(), value.data(), info.u.val_size, H5P_DEFAULT);
    const char *file = nullptr, *target = value.c_str();
    if (info.type == H5L_TYPE_EXTERNAL) {
        unsigned flags = 0;
        H5Lunpack_elink_val(value.data(), info.u.val_size, &flags, &file, &target);
    }
    fail(fmt::format("its link '{}' to '{}'{} leads nowhere", link, target, file ? fmt::format(" in '{}'", file) : ""),
         file ? "a link to what that file has, beside this one" : "a link to an object");
}

Hdf5Object Hdf5Object::require(const std::string& path) const
{
    const auto found = find(path);
    if (!found) fail(fmt::format("it has no '{}'", path), "one");
    return *found;
}

std::optional<std::vector<std::int64_t>> Hdf5Object::wholeNumbers(const std::string& attribute) const
{
    return state_->numbers<std::int64_t>(attribute, false);
}

std::optional<std::vector<double>> Hdf5Object::reals(const std::string& attribute) const
{
    return state_->numbers<double>(attribute, true);
}

std::optional<std::string> Hdf5Object::text(const std::string& attribute) const
{
    const Hdf5Lock lock;
    if (H5Aexists(state_->id, attribute.c_str()) <= 0) return std::nullopt;
    const Hdf5Handle opened(H5Aopen(state_->id, attribute.c_str(), H5P_DEFAULT)), type(H5Aget_type(opened)),
        space(H5Aget_space(opened));
    if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return std::nullopt;
    if (H5Tis_variable_str(type) > 0) {
        char* characters = nullptr;
        if (H5Aread(opened, type, &characters) < 0 || !characters) return std::nullopt;
        std::string text(characters);
        H5free_memory(characters);
        return withoutFilling(std::move(text));
    }
    std::string text(H5Tget_size(type), '\0');
    if (H5Aread(opened, type, text.data()) < 0) return std::nullopt;
    return withoutFilling(std::move(text));
}

const Hdf5DataSet& Hdf5Object::data() const
{
    if (!isDataSet()) fail("it is a group", "numbers");
    return *state_->data;
}

void Hdf5Object::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(file(), fmt::format("'{}': {}", name(), found), expected);
}

}  // namespace aeolic
