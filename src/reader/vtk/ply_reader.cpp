#include "reader/vtk/ply_reader.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <bit>
#include <charconv>
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
    std::optional<double> next(PlyType type)
    {
        return format_ == PlyHeader::Format::text ? nextText() : nextBinary(type);
    }

private:
    std::optional<double> nextText()
    {
        double value = 0;
        if (!(file_ >> word_)) return std::nullopt;
        const char* end = word_.data() + word_.size();
        const auto [stop, error] = readReal(word_.data(), end, value);  // "nan" and "inf" are numbers here.
        return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
    }

    std::optional<double> nextBinary(PlyType type)
    {
        char raw[8];
        const int bytes = bytesOf(type);
        if (!file_.read(raw, bytes)) return std::nullopt;
        std::uint64_t bits = 0;
        for (int i = 0; i < bytes; ++i) {
            const int at = format_ == PlyHeader::Format::bigEndian ? bytes - 1 - i : i;
            bits |= std::uint64_t(static_cast<unsigned char>(raw[at])) << (8 * i);
        }
        switch (type) {
            case PlyType::int8:
                return static_cast<std::int8_t>(bits);
            case PlyType::int16:
                return static_cast<std::int16_t>(bits);
            case PlyType::int32:
                return static_cast<std::int32_t>(bits);
            case PlyType::float32:
                return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
            case PlyType::float64:
                return std::bit_cast<double>(bits);
            default:
                return double(bits);
        }
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

    double next(const PlyElement& element, PlyType type, std::uint64_t item)
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
            const auto* name = std::find(std::begin(names), std::end(names), property.isList ? "" : property.name);
            slots.push_back(name == std::end(names) ? -1 : int(name - names));
            if (slots.back() >= 0) known |= 1 << slots.back();
            if (slots.back() == 0 && property.type == PlyType::float64) points_->SetDataTypeToDouble();
        }
        if ((known & 7) != 7) throw InputError(path_, "a vertex has no x, y and z", "three numbers");
        pointArrays_ = arraysFor(element, slots);
        normals_->SetNumberOfComponents(3);
        normals_->SetName("Normals");
        double values[6] = {};
        for (std::uint64_t i = 0; i < element.count; ++i) {
            std::size_t array = 0;
            for (std::size_t k = 0; k < slots.size(); ++k) {
                if (element.properties[k].isList) {
                    readList(element, element.properties[k], i);
                    continue;
                }
                const double value = next(element, element.properties[k].type, i);
                if (slots[k] >= 0)
                    values[slots[k]] = value;
                else
                    pointArrays_[array++]->InsertNextValue(static_cast<float>(value));
            }
            points_->InsertNextPoint(values);
            if (known == 63) normals_->InsertNextTuple(values + 3);
            report(i);
        }
    }

    void readFaces(const PlyElement& element)
    {
        const std::vector<int> slots(element.properties.size(), -1);
        faceArrays_ = arraysFor(element, slots);
        bool hasCorners = false;
        for (const PlyProperty& property : element.properties) hasCorners |= isCorners(property);
        if (!hasCorners) throw InputError(path_, "a face has no list of vertices", "a list vertex_indices");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            std::size_t array = 0;
            for (const PlyProperty& property : element.properties) {
                if (!property.isList) {
                    faceArrays_[array++]->InsertNextValue(static_cast<float>(next(element, property.type, i)));
                    continue;
                }
                readList(element, property, i);
                if (isCorners(property)) insertFace(i);
            }
            report(i);
        }
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

    void skip(const PlyElement& element)
    {
        if (element.properties.empty()) return;
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                if (property.isList)
                    readList(element, property, i);
                else
                    next(element, property.type, i);
            }
    }

    static bool isCorners(const PlyProperty& property)
    {
        return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    /// One array for each number that has no slot.
    static Arrays arraysFor(const PlyElement& element, const std::vector<int>& slots)
    {
        Arrays arrays;
        for (std::size_t k = 0; k < slots.size(); ++k)
            if (slots[k] < 0 && !element.properties[k].isList) {
                arrays.push_back(vtkSmartPointer<vtkFloatArray>::New());
                arrays.back()->SetName(element.properties[k].name.c_str());
            }
        return arrays;
    }

    void report(std::uint64_t item)
    {
        if (item % reportEvery == 0) progress_("reading the surface", double(file_.tellg()) / double(fileBytes_));
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
    std::vector<double> entries_;
    std::vector<vtkIdType> corners_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> readPly(const std::string& path, const ProgressReport& progress)
{
    return PlyReader(path, progress).read();
}

}  // namespace aeolic
