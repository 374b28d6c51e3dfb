#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

#include "aeolic/error.h"
#include "reader/binary/numbers.h"
#include "reader/vtk/ply_header.h"

namespace aeolic {

namespace {

constexpr std::uint64_t reportEvery = 1 << 16;

/// The numbers behind the header, one after the other.
class PlyNumbers {
public:
    PlyNumbers(std::istream& file, PlyHeader::Format format) : file_(file), format_(format) {}

    /// Nothing at the end of the file, or where a text is no number.
    std::optional<double> next(NumberType type)
    {
        return format_ == PlyHeader::Format::text ? nextText() : nextBinary(type);
    }

private:
    std::optional<double> nextText()
    {
        return file_ >> word_ ? realIn<double>(word_) : std::nullopt;  // "nan" and "inf" are numbers here.
    }

    std::optional<double> nextBinary(NumberType type)
    {
        std::array<std::uint8_t, 8> raw;
        if (!file_.read(reinterpret_cast<char*>(raw.data()), std::streamsize(bytesOf(type)))) return std::nullopt;
        double value = 0;
        convertNumbers<double>(raw.data(), type, format_ == PlyHeader::Format::bigEndian, {&value, 1});
        return value;
    }

    std::istream& file_;
    PlyHeader::Format format_;
    std::string word_;
};

class PlyReader {
public:
    PlyReader(const std::string& path, const ProgressReport& progress)
        : path_(path),
          progress_(progress),
          file_(path, std::ios::binary),
          header_(readPlyHeader(file_, path)),
          numbers_(file_, header_.format),
          fileBytes_(std::filesystem::file_size(path))
    {
    }

    vtkSmartPointer<vtkPolyData> read()
    {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face")
                readFaces(element);
            else
                skip(element);
        }
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetPolys(faces_);
        for (const auto& array : pointArrays_) data->GetPointData()->AddArray(array);
        for (const auto& array : faceArrays_) data->GetCellData()->AddArray(array);
        if (normals_->GetNumberOfTuples() > 0) data->GetPointData()->SetNormals(normals_);
        return data;
    }

private:
    using Arrays = std::vector<vtkSmartPointer<vtkFloatArray>>;

    [[noreturn]] void failCutOff(const PlyElement& element, std::uint64_t found) const
    {
        throw InputError(path_, fmt::format("the data ends at '{}' {} or is not a number", element.name, found),
                         fmt::format("the {} that the header declares", element.count));
    }

    double next(const PlyElement& element, NumberType type, std::uint64_t item)
    {
        const auto value = numbers_.next(type);
        if (!value) failCutOff(element, item);
        return *value;
    }

    /// The list's entries, into entries_.
    void readList(const PlyElement& element, const PlyProperty& property, std::uint64_t item)
    {
        const double length = next(element, property.countType, item);
        if (!(length >= 0 && length <= double(fileBytes_)))
            throw InputError(path_, fmt::format("'{}' {} has a list of {}", element.name, item, length),
                             "0 or more, and no more than the file has bytes");
        entries_.resize(std::size_t(length));
        for (double& entry : entries_) entry = next(element, property.type, item);
    }

    void readVertices(const PlyElement& element)
    {
        static const std::string names[] = {"x", "y", "z", "nx", "ny", "nz"};
        std::vector<int> slots;  // For each property which of the six numbers above it is, or -1.
        int known = 0;
        for (const PlyProperty& property : element.properties) {
            const auto* name = std::ranges::find(names, property.isList ? "" : property.name);
            slots.push_back(name == std::end(names) ? -1 : int(name - names));
            if (slots.back() >= 0) known |= 1 << slots.back();
            if (slots.back() == 0 && property.type == NumberType::float64) points_->SetDataTypeToDouble();
        }
        if ((known & 7) != 7) throw InputError(path_, "a vertex has no x, y and z", "three numbers");
        normals_->SetNumberOfComponents(3);
        normals_->SetName("Normals");
        pointArrays_ = readItems(
            element, slots, [](const PlyProperty&, std::uint64_t) {},
            [&] {
                points_->InsertNextPoint(values_.data());
                if (known == 63) normals_->InsertNextTuple(values_.data() + 3);
            });
    }

    void readFaces(const PlyElement& element)
    {
        if (std::ranges::none_of(element.properties, isCorners))
            throw InputError(path_, "a face has no list of vertices", "a list vertex_indices");
        const auto takeList = [&](const PlyProperty& property, std::uint64_t face) {
            if (isCorners(property)) insertFace(face);
        };
        faceArrays_ = readItems(element, std::vector<int>(element.properties.size(), -1), takeList, [] {});
    }

    void skip(const PlyElement& element)
    {
        readItems(
            element, std::vector<int>(element.properties.size(), 0), [](const PlyProperty&, std::uint64_t) {}, [] {});
    }

    /// Numbers go to the slot of `values_` that `slots` says for each property, or, where it is -1, into an array of
    /// the property's name. takeList(property, item) gets each list in entries_, and takeItem() ends each item.
    template <class TakeList, class TakeItem>
    Arrays readItems(const PlyElement& element, const std::vector<int>& slots, const TakeList& takeList,
                     const TakeItem& takeItem)
    {
        if (element.properties.empty()) return {};
        Arrays arrays(slots.size());  // Null where numbers have a slot, and for lists.
        for (std::size_t k = 0; k < slots.size(); ++k) {
            if (slots[k] >= 0 || element.properties[k].isList) continue;
            arrays[k] = vtkSmartPointer<vtkFloatArray>::New();
            arrays[k]->SetName(element.properties[k].name.c_str());
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < slots.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                if (property.isList) {
                    readList(element, property, i);
                    takeList(property, i);
                    continue;
                }
                const double value = next(element, property.type, i);
                if (arrays[k])
                    arrays[k]->InsertNextValue(static_cast<float>(value));
                else
                    values_[std::size_t(slots[k])] = value;
            }
            takeItem();
            if (i % reportEvery == 0) progress_("reading the surface", double(file_.tellg()) / double(fileBytes_));
        }
        std::erase_if(arrays, [](const auto& array) { return !array; });
        return arrays;
    }

    void insertFace(std::uint64_t face)
    {
        corners_.clear();
        for (const double entry : entries_) {
            if (!(entry >= 0 && entry <= 1e15))
                throw InputError(path_, fmt::format("face {} refers to vertex {}", face, entry), "an index from 0");
            corners_.push_back(vtkIdType(entry));  // Whether it exists is judged with all surfaces.
        }
        faces_->InsertNextCell(vtkIdType(corners_.size()), corners_.data());
    }

    static bool isCorners(const PlyProperty& property)
    {
        return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    std::string path_;
    ProgressReport progress_;
    std::ifstream file_;
    PlyHeader header_;
    PlyNumbers numbers_;
    std::uint64_t fileBytes_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> faces_;
    vtkNew<vtkFloatArray> normals_;
    Arrays pointArrays_, faceArrays_;
    std::array<double, 6> values_{};  // Of a vertex: x, y, z, nx, ny, nz.
    std::vector<double> entries_;
    std::vector<vtkIdType> corners_;
};

}  // namespace

vtkSmartPointer<vtkDataObject> readPly(const std::string& path, const ProgressReport& progress)
{
    return PlyReader(path, progress).read();
}

}  // namespace aeolic
