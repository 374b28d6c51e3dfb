#include "data/vtk/data_message.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
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
#include <cstring>

namespace aeolic {
namespace {

constexpr std::size_t kSmallBytes = std::size_t(64) << 10;  // Bytes that stand in the message.

DataForm formOf(vtkDataObject* data)
{
    if (!data) return DataForm::none;
    if (vtkMultiBlockDataSet::SafeDownCast(data)) return DataForm::blocks;
    if (vtkPolyData::SafeDownCast(data)) return DataForm::polygons;
    if (vtkImageData::SafeDownCast(data)) return DataForm::image;
    if (vtkRectilinearGrid::SafeDownCast(data)) return DataForm::rectilinear;
    if (vtkStructuredGrid::SafeDownCast(data)) return DataForm::structured;
    if (vtkUnstructuredGrid::SafeDownCast(data)) return DataForm::unstructured;
    return DataForm::none;
}

class Writer {
public:
    Writer(ByteWriter& message, AnswerMemory& memory) : message_(message), memory_(memory) {}

    void add(vtkDataObject* data)
    {
        const DataForm form = formOf(data);
        message_.add(form);
        if (form == DataForm::none) {
            message_.add(std::string(data ? data->GetClassName() : ""));
        } else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data)) {
            message_.add(std::uint32_t(blocks->GetNumberOfBlocks()));
            for (unsigned i = 0; i < blocks->GetNumberOfBlocks(); ++i) {
                const char* name =
                    blocks->HasMetaData(i) ? blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
                message_.add(std::string(name ? name : ""));
                add(blocks->GetBlock(i));
            }
        } else {
            add(*static_cast<vtkDataSet*>(data));
        }
    }

private:
    void add(vtkDataSet& data)
    {
        if (auto* image = vtkImageData::SafeDownCast(&data)) {
            addExtent(image->GetExtent());
            for (const double* three : {image->GetOrigin(), image->GetSpacing()})
                message_.addAll(three[0], three[1], three[2]);
            for (int i = 0; i < 9; ++i) message_.add(image->GetDirectionMatrix()->GetData()[i]);
        } else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
            addExtent(rectilinear->GetExtent());
            for (vtkDataArray* axis :
                 {rectilinear->GetXCoordinates(), rectilinear->GetYCoordinates(), rectilinear->GetZCoordinates()})
                add(axis);
        } else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) {
            addExtent(structured->GetExtent());
        }
        if (auto* set = vtkPointSet::SafeDownCast(&data)) add(set->GetPoints() ? set->GetPoints()->GetData() : nullptr);
        if (auto* polygons = vtkPolyData::SafeDownCast(&data)) {
            for (vtkCellArray* cells :
                 {polygons->GetVerts(), polygons->GetLines(), polygons->GetPolys(), polygons->GetStrips()})
                add(*cells);
        } else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data)) {
            message_.add(std::uint8_t(grid->GetNumberOfCells() > 0));
            if (grid->GetNumberOfCells() > 0) {
                add(*grid->GetCells());
                add(grid->GetCellTypesArray());
                add(grid->GetFaceLocations());
                add(grid->GetFaces());
            }
        }
        addArrays(*data.GetFieldData());
        addArrays(*data.GetPointData());
        addArrays(*data.GetCellData());
        addActive(*data.GetPointData());
        addActive(*data.GetCellData());
    }

    void addExtent(const int* extent)
    {
        for (int i = 0; i < 6; ++i) message_.add(extent[i]);
    }

    void add(vtkCellArray& cells)
    {
        message_.add(std::uint8_t(cells.GetNumberOfCells() > 0));
        if (cells.GetNumberOfCells() == 0) return;
        add(cells.GetOffsetsArray());
        add(cells.GetConnectivityArray());
    }

    /// Numbers only. Bits become bytes of 0 and 1.
    void add(vtkDataArray* array)
    {
        vtkSmartPointer<vtkDataArray> plain = array;
        if (array && array->GetDataType() == VTK_BIT) {
            plain = vtkSmartPointer<vtkUnsignedCharArray>::New();
            plain->SetName(array->GetName());
            plain->SetNumberOfComponents(array->GetNumberOfComponents());
            plain->SetNumberOfTuples(array->GetNumberOfTuples());
            for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
                for (int c = 0; c < array->GetNumberOfComponents(); ++c)
                    plain->SetComponent(i, c, array->GetComponent(i, c));
        } else if (array && !array->HasStandardMemoryLayout()) {
            plain = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
            plain->DeepCopy(array);
            plain->SetName(array->GetName());
        }
        message_.add(std::uint8_t(plain != nullptr));
        if (!plain) return;
        kept_.push_back(plain);
        const std::size_t bytes = std::size_t(plain->GetNumberOfValues()) * std::size_t(plain->GetDataTypeSize());
        message_.add(std::string(plain->GetName() ? plain->GetName() : ""));
        message_.addAll(std::int32_t(plain->GetDataType()), std::int32_t(plain->GetNumberOfComponents()),
                        std::int64_t(plain->GetNumberOfTuples()));
        const void* values = bytes > 0 ? plain->GetVoidPointer(0) : nullptr;
        const bool small = bytes < kSmallBytes;
        message_.add(small ? kArrayInMessage : memory_.place(values, bytes));
        if (!small) return;
        Bytes copy(bytes);
        if (bytes > 0) std::memcpy(copy.data(), values, bytes);
        message_.add(copy);
    }

    static std::vector<vtkDataArray*> numbersOf(vtkFieldData& arrays)
    {
        std::vector<vtkDataArray*> all;
        for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
            if (vtkDataArray* array = arrays.GetArray(i)) all.push_back(array);
        return all;
    }

    void addArrays(vtkFieldData& arrays)
    {
        const auto numbers = numbersOf(arrays);
        message_.add(std::uint32_t(numbers.size()));
        for (vtkDataArray* array : numbers) add(array);
    }

    void addActive(vtkDataSetAttributes& arrays)
    {
        const auto numbers = numbersOf(arrays);
        for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind) {
            const auto found = std::find(numbers.begin(), numbers.end(), arrays.GetAttribute(kind));
            message_.add(std::int32_t(found == numbers.end() ? -1 : found - numbers.begin()));
        }
    }

    ByteWriter& message_;
    AnswerMemory& memory_;
    std::vector<vtkSmartPointer<vtkDataArray>> kept_;
};

}  // namespace

void addData(ByteWriter& message, vtkDataObject* data, AnswerMemory& memory)
{
    Writer(message, memory).add(data);
}

}  // namespace aeolic
