#include <vtkCellData.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageDataToPointSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <limits>

#include "data/vtk/testing/sample_writers.h"

namespace aeolic::test {

namespace {

double stretched(double x, double stretch)
{
    return x + stretch * x * x;
}

vtkSmartPointer<vtkUnsignedCharArray> flags(const char* name, vtkIdType count, int value, const std::vector<int>& at,
                                            int atValue)
{
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName(name);
    array->SetNumberOfTuples(count);
    array->FillValue(static_cast<unsigned char>(value));
    for (const int i : at) array->SetValue(i, static_cast<unsigned char>(atValue));
    return array;
}

void addGridArrays(vtkDataSet& data, const GridSample& sample)
{
    const vtkIdType count = sample.onCells ? data.GetNumberOfCells() : data.GetNumberOfPoints();
    auto vectors = newArray(sample.doubles, "U", sample.components, count);
    auto second = newArray(sample.doubles, "W", 3, count);
    auto scalars = newArray(sample.doubles, "p", 1, count);
    double x[3], bounds[6];
    for (vtkIdType i = 0; i < count; ++i) {
        data.GetPoint(sample.onCells ? 0 : i, x);
        if (sample.onCells) {
            data.GetCellBounds(i, bounds);
            for (int c = 0; c < 3; ++c) x[c] = 0.5 * (bounds[2 * c] + bounds[2 * c + 1]);
        }
        const auto u = sampleVector(x[0], x[1], x[2]);
        for (int c = 0; c < sample.components; ++c) vectors->SetComponent(i, c, sample.scale * u[std::size_t(c)]);
        second->SetTuple(i, u.data());
        scalars->SetTuple1(i, sample.scale * sampleScalar(x[0], x[1], x[2]));
    }
    for (const int i : sample.nanPoints) vectors->SetComponent(i, 1, std::numeric_limits<double>::quiet_NaN());
    for (const int i : sample.infinitePoints) vectors->SetComponent(i, 2, std::numeric_limits<double>::infinity());
    auto* attributes = sample.onCells ? static_cast<vtkDataSetAttributes*>(data.GetCellData()) : data.GetPointData();
    const auto keep = [&](const char* name) {
        return std::find(sample.leaveOut.begin(), sample.leaveOut.end(), name) == sample.leaveOut.end();
    };
    if (keep("U")) attributes->AddArray(vectors);
    if (sample.secondVectors) attributes->AddArray(second);
    if (keep("p")) attributes->AddArray(scalars);
    if (!sample.maskedPoints.empty())
        attributes->AddArray(flags("vtkValidPointMask", count, 1, sample.maskedPoints, 0));
    if (!sample.hiddenPoints.empty())
        attributes->AddArray(flags(vtkDataSetAttributes::GhostArrayName(), count, 0, sample.hiddenPoints,
                                   vtkDataSetAttributes::HIDDENPOINT));
}

void hideBeyond(vtkDataSet& data, const GridSample& sample)
{
    const bool cells = sample.hidesCells;
    std::vector<int> hidden;
    double p[3], box[6];
    for (vtkIdType i = 0; i < (cells ? data.GetNumberOfCells() : data.GetNumberOfPoints()); ++i) {
        if (cells)
            data.GetCellBounds(i, box);
        else
            data.GetPoint(i, p);
        if ((cells ? 0.5 * (box[0] + box[1]) : p[0]) > sample.hiddenBeyondX) hidden.push_back(int(i));
    }
    if (hidden.empty()) return;
    const int flag = cells ? int(vtkDataSetAttributes::HIDDENCELL) : int(vtkDataSetAttributes::HIDDENPOINT);
    (cells ? static_cast<vtkDataSetAttributes*>(data.GetCellData()) : data.GetPointData())
        ->AddArray(flags(vtkDataSetAttributes::GhostArrayName(),
                         cells ? data.GetNumberOfCells() : data.GetNumberOfPoints(), 0, hidden, flag));
}

vtkSmartPointer<vtkImageData> makeImage(const GridSample& sample)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(sample.dims.data());
    image->SetOrigin(sample.origin.data());
    image->SetSpacing(sample.spacing.data());
    if (sample.turned) image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
    return image;
}

vtkSmartPointer<vtkDataSet> makeRectilinear(const GridSample& sample)
{
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(sample.dims.data());
    vtkNew<vtkDoubleArray> axes[3];
    for (std::size_t c = 0; c < 3; ++c)
        for (int i = 0; i < sample.dims[c]; ++i) {
            const double x = sample.origin[c] + i * sample.spacing[c];
            axes[c]->InsertNextValue(c == 0 ? stretched(x, sample.stretch) : x);
        }
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    return grid;
}

vtkSmartPointer<vtkDataSet> makeStructured(const GridSample& sample)
{
    vtkNew<vtkImageDataToPointSet> convert;
    convert->SetInputData(makeImage(sample));
    convert->Update();
    vtkSmartPointer<vtkStructuredGrid> grid = convert->GetOutput();
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
        double x[3];
        grid->GetPoint(i, x);
        grid->GetPoints()->SetPoint(i, stretched(x[0], sample.stretch), x[1], x[2]);
    }
    return grid;
}

/// Tetrahedra, or hexahedra.
vtkSmartPointer<vtkDataSet> makeUnstructured(const GridSample& sample)
{
    if (sample.hexahedra) {
        const auto structured = makeStructured(sample);
        auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
        grid->SetPoints(vtkStructuredGrid::SafeDownCast(structured)->GetPoints());
        vtkNew<vtkIdList> corners;
        for (vtkIdType cell = 0; cell < structured->GetNumberOfCells(); ++cell) {
            structured->GetCellPoints(cell, corners);
            grid->InsertNextCell(structured->GetCellType(cell), corners);
        }
        return grid;
    }
    vtkNew<vtkDataSetTriangleFilter> split;
    split->SetInputData(makeStructured(sample));
    split->Update();
    return split->GetOutput();
}

vtkSmartPointer<vtkDataSet> makeGrid(const std::string& extension, const GridSample& sample)
{
    const std::string kinds[] = {".vti", ".vtr", ".vts", ".vtu"};
    std::string kind = extension == ".vtk" ? kinds[sample.legacyKind] : extension;
    if (kind.starts_with(".p")) kind.erase(1, 1);
    vtkSmartPointer<vtkDataSet> data = kind == ".vti"   ? vtkSmartPointer<vtkDataSet>(makeImage(sample))
                                       : kind == ".vtr" ? makeRectilinear(sample)
                                       : kind == ".vts" ? makeStructured(sample)
                                                        : makeUnstructured(sample);
    addGridArrays(*data, sample);
    hideBeyond(*data, sample);
    return data;
}

}  // namespace

std::array<double, 3> sampleVector(double x, double y, double z)
{
    return {1 + x, 2 * y, x - z};
}

double sampleScalar(double x, double y, double z)
{
    return x + 10 * y + 100 * z;
}

void writeGridFile(const std::string& path, const GridSample& sample)
{
    writeDataSet(path, *makeGrid(extension(path), sample), sample.encoding);
}

void writeGridSteps(const std::string& path, const std::vector<GridSample>& samples)
{
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetNumberOfTimeSteps(int(samples.size()));
    writer->SetInputData(makeGrid(".vti", samples.front()));
    writer->Start();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        writer->SetInputData(makeGrid(".vti", samples[i]));
        writer->WriteNextTime(double(i));
    }
    writer->Stop();
}

}  // namespace aeolic::test
