#include "reader/hdf5/testing/sample_hdf5.h"

#include <stdexcept>
#include <type_traits>

#include "reader/hdf5/hdf5_file.h"

namespace aeolic::test {
namespace {

hid_t sound(hid_t id)
{
    if (id < 0) throw std::runtime_error("the HDF5 library refuses");
    return id;
}

/// Closes what it was given.
class Id {
public:
    explicit Id(hid_t id) : id_(sound(id)) {}
    ~Id() { H5Idec_ref(id_); }
    Id(const Id&) = delete;
    Id& operator=(const Id&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
};

template <class Number>
hid_t nativeType()
{
    if (std::is_same_v<Number, float>) return H5T_NATIVE_FLOAT;
    if (std::is_same_v<Number, double>) return H5T_NATIVE_DOUBLE;
    const hid_t wholes[] = {H5T_NATIVE_INT8,  H5T_NATIVE_UINT8,  H5T_NATIVE_INT16, H5T_NATIVE_UINT16,
                            H5T_NATIVE_INT32, H5T_NATIVE_UINT32, H5T_NATIVE_INT64, H5T_NATIVE_UINT64};
    const int width = sizeof(Number) == 1 ? 0 : sizeof(Number) == 2 ? 1 : sizeof(Number) == 4 ? 2 : 3;
    return wholes[2 * width + (std::is_signed_v<Number> ? 0 : 1)];
}

std::vector<hsize_t> lengths(const std::vector<std::uint64_t>& shape)
{
    return {shape.begin(), shape.end()};
}

hid_t createList(hid_t kind)
{
    return H5Pcreate(kind);
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::string& path, bool newest, std::uint64_t userBytes)
{
    const Id access(createList(H5P_FILE_ACCESS)), create(createList(H5P_FILE_CREATE));
    if (newest) sound(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST));
    if (userBytes > 0) sound(H5Pset_userblock(create, userBytes));
    file_ = sound(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, create, access));
}

Hdf5Writer::~Hdf5Writer()
{
    H5Fclose(file_);
}

void Hdf5Writer::group(const std::string& path, bool ordered)
{
    const Id links(createList(H5P_LINK_CREATE)), create(createList(H5P_GROUP_CREATE));
    sound(H5Pset_create_intermediate_group(links, 1));
    if (ordered) sound(H5Pset_link_creation_order(create, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    const Id group(H5Gcreate2(file_, path.c_str(), links, create, H5P_DEFAULT));
}

void Hdf5Writer::softLink(const std::string& path, const std::string& target)
{
    sound(H5Lcreate_soft(target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT));
}

template <class Number>
void Hdf5Writer::data(const std::string& path, const std::vector<std::uint64_t>& shape,
                      const std::vector<Number>& values, const Hdf5SampleLayout& layout, hid_t fileType)
{
    const Id links(createList(H5P_LINK_CREATE)), create(createList(H5P_DATASET_CREATE));
    sound(H5Pset_create_intermediate_group(links, 1));
    const auto dims = lengths(shape), most = lengths(layout.most), chunk = lengths(layout.chunk);
    if (layout.compact) sound(H5Pset_layout(create, H5D_COMPACT));
    if (!chunk.empty()) sound(H5Pset_chunk(create, int(chunk.size()), chunk.data()));
    if (layout.early) sound(H5Pset_alloc_time(create, H5D_ALLOC_TIME_EARLY));
    if (layout.shuffle) sound(H5Pset_shuffle(create));
    if (layout.deflate) sound(H5Pset_deflate(create, 6));
    if (layout.checksum) sound(H5Pset_fletcher32(create));
    const Id space(shape.empty()
                       ? H5Screate(H5S_SCALAR)
                       : H5Screate_simple(int(dims.size()), dims.data(), most.empty() ? nullptr : most.data()));
    const Id data(H5Dcreate2(file_, path.c_str(), fileType < 0 ? nativeType<Number>() : fileType, space, links, create,
                             H5P_DEFAULT));
    if (!values.empty()) sound(H5Dwrite(data, nativeType<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

template <class Number>
void Hdf5Writer::attribute(const std::string& path, const std::string& name, const std::vector<Number>& values)
{
    const hsize_t count = values.size();
    const Id object(H5Oopen(file_, path.c_str(), H5P_DEFAULT)), space(H5Screate_simple(1, &count, nullptr));
    const Id attribute(H5Acreate2(object, name.c_str(), nativeType<Number>(), space, H5P_DEFAULT, H5P_DEFAULT));
    sound(H5Awrite(attribute, nativeType<Number>(), values.data()));
}

void Hdf5Writer::text(const std::string& path, const std::string& name, const std::string& value, std::size_t bytes)
{
    const Id type(H5Tcopy(H5T_C_S1)), space(H5Screate(H5S_SCALAR)), object(H5Oopen(file_, path.c_str(), H5P_DEFAULT));
    std::string filled = value;
    filled.resize(bytes == 0 ? std::max<std::size_t>(value.size(), 1) : bytes);
    sound(H5Tset_size(type, filled.size()));
    sound(H5Tset_strpad(type, H5T_STR_NULLPAD));
    const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
    sound(H5Awrite(attribute, type, filled.data()));
}

void Hdf5Writer::variableText(const std::string& path, const std::string& name, const std::string& value)
{
    const Id type(H5Tcopy(H5T_C_S1)), space(H5Screate(H5S_SCALAR)), object(H5Oopen(file_, path.c_str(), H5P_DEFAULT));
    sound(H5Tset_size(type, H5T_VARIABLE));
    const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
    const char* characters = value.c_str();
    sound(H5Awrite(attribute, type, &characters));
}

void setHdf5Text(const std::string& file, const std::string& path, const std::string& attribute,
                 const std::string& value)
{
    const Id opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)),
        object(H5Oopen(opened, path.c_str(), H5P_DEFAULT));
    const Id type(H5Tcopy(H5T_C_S1)), space(H5Screate(H5S_SCALAR));
    sound(H5Tset_size(type, value.size()));
    const Id written(H5Acreate2(object, attribute.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
    sound(H5Awrite(written, type, value.data()));
}

void removeHdf5(const std::string& file, const std::string& path)
{
    const Id opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    sound(H5Ldelete(opened, path.c_str(), H5P_DEFAULT));
}

template <class Number>
void replaceHdf5(const std::string& file, const std::string& path, const std::vector<std::uint64_t>& shape,
                 const std::vector<Number>& values)
{
    removeHdf5(file, path);
    const Id opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    const auto dims = lengths(shape);
    const Id space(H5Screate_simple(int(dims.size()), dims.data(), nullptr));
    const Id data(H5Dcreate2(opened, path.c_str(), nativeType<Number>(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    if (!values.empty()) sound(H5Dwrite(data, nativeType<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

namespace {

void copyNumbers(const Hdf5Object& from, const std::string& path, Hdf5Writer& to)
{
    switch (*from.type()) {
        case NumberType::float64:
            return to.data(path, from.shape(), from.read<double>());
        case NumberType::float32:
            return to.data(path, from.shape(), from.read<float>());
        case NumberType::int8:
            return to.data(path, from.shape(), from.read<std::int8_t>());
        case NumberType::int32:
            return to.data(path, from.shape(), from.read<std::int32_t>());
        default:
            return to.data(path, from.shape(), from.read<std::int64_t>());
    }
}

void copyGroup(const Hdf5Object& from, const std::string& path, Hdf5Writer& to)
{
    for (const std::string& name : from.names()) {
        const auto object = from.find(name);
        if (!object) continue;
        const std::string own = path + "/" + name;
        if (object->isDataSet()) {
            if (object->type()) copyNumbers(*object, own, to);
            continue;
        }
        to.group(own);
        for (const char* attribute : {"name", "label", "type"})
            if (const auto text = object->text(attribute)) to.text(own, attribute, *text, attribute[0] == 't' ? 3 : 33);
        copyGroup(*object, own, to);
    }
}

}  // namespace

void copyInOldForm(const std::string& from, const std::string& to)
{
    Hdf5Writer writer(to);
    copyGroup(Hdf5Object::openFile(from), "", writer);
}

template <class Number>
void instantiate(Hdf5Writer& writer)
{
    writer.data<Number>("", {}, {});
    writer.attribute<Number>("", "", {});
    replaceHdf5<Number>("", "", {}, {});
}
template void instantiate<float>(Hdf5Writer&);
template void instantiate<double>(Hdf5Writer&);
template void instantiate<std::int8_t>(Hdf5Writer&);
template void instantiate<std::uint8_t>(Hdf5Writer&);
template void instantiate<std::int16_t>(Hdf5Writer&);
template void instantiate<std::int32_t>(Hdf5Writer&);
template void instantiate<std::uint32_t>(Hdf5Writer&);
template void instantiate<std::int64_t>(Hdf5Writer&);
template void instantiate<std::uint64_t>(Hdf5Writer&);

}  // namespace aeolic::test
