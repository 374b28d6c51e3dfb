#include "data/vtk/data_message.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <mutex>

#include "aeolic/error.h"

namespace aeolic {
namespace {

constexpr int kDeepestInAnswer = 64;  // Blocks in blocks.

/// VTK hands nothing but an array's address to the function that frees it.
struct MappedArrays {
    std::mutex mutex;
    std::multimap<void*, std::shared_ptr<SharedMemory>> memory;  // Several arrays may have the same.
};

MappedArrays& mapped()
{
    static auto* all = new MappedArrays;  // Arrays may outlive everything else.
    return *all;
}

void freeMapped(void* address)
{
    std::shared_ptr<SharedMemory> last;
    MappedArrays& all = mapped();
    const std::lock_guard lock(all.mutex);
    const auto found = all.memory.find(address);
    if (found == all.memory.end()) return;
    last = std::move(found->second);
    all.memory.erase(found);
}

/// Makes mapped memory the values of an array, without a copy. The array keeps the memory. Throws std::bad_alloc.
void setMapped(vtkDataArray& array, std::shared_ptr<SharedMemory> memory, vtkIdType values)
{
    void* const address = memory->data();
    memory->expectUse(std::size_t(values) * std::size_t(array.GetDataTypeSize()));
    {
        const std::lock_guard lock(mapped().mutex);
        mapped().memory.emplace(address, std::move(memory));
    }
    array.SetVoidArray(address, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    array.SetArrayFreeFunction(freeMapped);
}

class Reader {
public:
    Reader(ByteReader& message, const std::vector<std::shared_ptr<SharedMemory>>& memory)
        : message_(message), memory_(memory)
    {
    }

    vtkSmartPointer<vtkDataObject> data(int depth = 0)
    {
        if (depth > kDeepestInAnswer) fail();
        switch (next<DataForm>()) {
            case DataForm::none: {
                const auto name = text();
                if (!name.empty()) throw std::runtime_error("a " + name);
                return nullptr;
            }
            case DataForm::blocks: {
                auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
                const auto count = next<std::uint32_t>();
                for (unsigned i = 0; i < count; ++i) {
                    const auto name = text();
                    blocks->SetBlock(i, data(depth + 1));
                    blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), name.c_str());
                }
                return blocks;
            }
            case DataForm::polygons:
                return polygons();
            case DataForm::image:
                return image();
            case DataForm::rectilinear:
                return rectilinear();
            case DataForm::structured:
                return structured();
            case DataForm::unstructured:
                return unstructured();
        }
        fail();
    }

private:
    [[noreturn]] static void fail() { throw std::runtime_error("parts that do not fit together"); }

    template <class Value>
    Value next()
    {
        Value value{};
        message_.read(value);
        return value;
    }

    std::string text()
    {
        std::string value;
        message_.read(value);
        return value;
    }

    std::array<int, 6> extent()
    {
        const auto values = next<std::array<int, 6>>();
        double samples = 1;
        for (std::size_t c = 0; c < 3; ++c) samples *= std::max(0.0, double(values[2 * c + 1]) - values[2 * c] + 1);
        if (samples > 1e15) fail();
        return values;
    }

    vtkSmartPointer<vtkDataObject> image()
    {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetExtent(extent().data());
        image->SetOrigin(next<std::array<double, 3>>().data());
        image->SetSpacing(next<std::array<double, 3>>().data());
        image->SetDirectionMatrix(next<std::array<double, 9>>().data());
        return withArrays(image);
    }

    vtkSmartPointer<vtkDataObject> rectilinear()
    {
        auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
        grid->SetExtent(extent().data());
        const auto x = array(), y = array(), z = array();
        if (!x || !y || !z) fail();
        int dims[3];
        grid->GetDimensions(dims);
        if (x->GetNumberOfTuples() != dims[0] || y->GetNumberOfTuples() != dims[1] || z->GetNumberOfTuples() != dims[2])
            fail();
        grid->SetXCoordinates(x);
        grid->SetYCoordinates(y);
        grid->SetZCoordinates(z);
        return withArrays(grid);
    }

    vtkSmartPointer<vtkDataObject> structured()
    {
        auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
        grid->SetExtent(extent().data());
        setPoints(*grid);
        int dims[3];
        grid->GetDimensions(dims);
        if (grid->GetNumberOfPoints() != vtkIdType(dims[0]) * dims[1] * dims[2]) fail();
        return withArrays(grid);
    }

    vtkSmartPointer<vtkDataObject> polygons()
    {
        auto polygons = vtkSmartPointer<vtkPolyData>::New();
        setPoints(*polygons);
        polygons->SetVerts(cells());
        polygons->SetLines(cells());
        polygons->SetPolys(cells());
        polygons->SetStrips(cells());
        return withArrays(polygons);
    }

    vtkSmartPointer<vtkDataObject> unstructured()
    {
        auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
        setPoints(*grid);
        if (next<std::uint8_t>() != 0) {
            const auto all = cells();
            const auto types = array();
            auto begins = array(), faces = array();
            if (begins && begins->GetNumberOfTuples() == 0) begins = faces = nullptr;  // There are no polyhedra.
            auto* bytes = vtkUnsignedCharArray::SafeDownCast(types);
            if (!all || !bytes || bytes->GetNumberOfTuples() != all->GetNumberOfCells()) fail();
            if (bool(begins) != bool(faces)) fail();
            const auto places = vtkIdTypeArray::SafeDownCast(begins), corners = vtkIdTypeArray::SafeDownCast(faces);
            if (begins && (!places || !corners || places->GetNumberOfTuples() != all->GetNumberOfCells())) fail();
            grid->SetCells(bytes, all, places, corners);
        }
        return withArrays(grid);
    }

    void setPoints(vtkPointSet& set)
    {
        const auto values = array();
        if (!values) return;
        if (values->GetNumberOfComponents() != 3) fail();
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetData(values);
        set.SetPoints(points);
    }

    /// Null where there are none.
    vtkSmartPointer<vtkCellArray> cells()
    {
        if (next<std::uint8_t>() == 0) return nullptr;
        const auto offsets = array(), corners = array();
        auto cells = vtkSmartPointer<vtkCellArray>::New();
        if (!offsets || !corners || !cells->SetData(offsets, corners)) fail();
        return cells;
    }

    /// Null where there is none.
    vtkSmartPointer<vtkDataArray> array()
    {
        if (next<std::uint8_t>() == 0) return nullptr;
        const std::string name = text();
        const auto type = next<std::int32_t>(), components = next<std::int32_t>();
        const auto tuples = next<std::int64_t>();
        const auto where = next<std::uint32_t>();
        const int width = type == VTK_BIT ? 0 : vtkDataArray::GetDataTypeSize(type);
        if (width <= 0 || components < 1 || tuples < 0 || tuples > (std::int64_t(1) << 56) / components / width) fail();
        const auto bytes = std::size_t(tuples) * std::size_t(components) * std::size_t(width);
        auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
        if (!values || values->GetDataTypeSize() != width) fail();
        if (!name.empty()) values->SetName(name.c_str());
        values->SetNumberOfComponents(components);
        if (where == kArrayInMessage) {
            std::span<const std::byte> copy;
            message_.read(copy);
            if (copy.size() != bytes) fail();
            values->SetNumberOfTuples(tuples);
            if (bytes > 0) std::memcpy(values->GetVoidPointer(0), copy.data(), bytes);
        } else {
            if (where >= memory_.size() || memory_[where]->size() < bytes) fail();
            setMapped(*values, memory_[where], tuples * components);
        }
        return values;
    }

    void readArrays(vtkFieldData& arrays)
    {
        const auto count = next<std::uint32_t>();
        for (std::uint32_t i = 0; i < count; ++i)
            if (const auto values = array()) arrays.AddArray(values);
    }

    void readActive(vtkDataSetAttributes& arrays)
    {
        for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
            if (const auto index = next<std::int32_t>(); index >= 0 && index < arrays.GetNumberOfArrays())
                arrays.SetActiveAttribute(index, kind);
    }

    vtkSmartPointer<vtkDataObject> withArrays(const vtkSmartPointer<vtkDataSet>& data)
    {
        readArrays(*data->GetFieldData());
        readArrays(*data->GetPointData());
        readArrays(*data->GetCellData());
        readActive(*data->GetPointData());
        readActive(*data->GetCellData());
        return data;
    }

    ByteReader& message_;
    const std::vector<std::shared_ptr<SharedMemory>>& memory_;
};

}  // namespace

vtkSmartPointer<vtkDataObject> readData(ByteReader& message, const std::vector<std::shared_ptr<SharedMemory>>& memory,
                                        const std::string& path)
{
    try {
        return Reader(message, memory).data();
    } catch (const std::runtime_error& error) {
        throw InputError(path, std::string("the reader's answer is ") + error.what(), "data sets of VTK's kinds");
    }
}

}  // namespace aeolic
