#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <limits>

#include "data/vtk/testing/sample_writers.h"

namespace aeolic::test {

namespace {

void addSheetArrays(vtkPolyData& sheet, const SheetSample& sample)
{
    const vtkIdType points = sheet.GetNumberOfPoints(), cells = sheet.GetNumberOfCells();
    auto tau = newArray(false, "tau", sample.tauComponents, points), q = newArray(false, "q", 1, points);
    auto normals = newArray(false, "Normals", 3, points);
    auto cellTau = newArray(false, "cellTau", 3, cells), cellQ = newArray(true, "cellQ", 1, cells);
    for (vtkIdType i = 0; i < points; ++i) {
        const double x = double(i % (sample.n + 1)) / sample.n, y = double(i / (sample.n + 1)) / sample.n;
        const double vector[3] = {1, x, 0.1};
        for (int c = 0; c < sample.tauComponents; ++c) tau->SetComponent(i, c, sample.scale * vector[c]);
        q->SetTuple1(i, sample.scale * (x + y));
        normals->SetTuple3(i, 0, 0, -5);  // Not those of the sheet: to be told from computed ones.
    }
    for (vtkIdType i = 0; i < cells; ++i) {
        cellTau->SetTuple3(i, sample.scale * 2, 0, sample.scale * 0.2);
        cellQ->SetTuple1(i, sample.scale * double(i));
    }
    sheet.GetPointData()->AddArray(tau);
    sheet.GetPointData()->AddArray(q);
    sheet.GetCellData()->AddArray(cellTau);
    sheet.GetCellData()->AddArray(cellQ);
    if (sample.normals) sheet.GetPointData()->SetNormals(normals);
}

vtkSmartPointer<vtkPolyData> makeSheet(const SheetSample& sample)
{
    auto sheet = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> polys, lines, vertices;
    const int n = sample.n;
    const auto bad = std::numeric_limits<double>::quiet_NaN();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, y = double(j) / n;
            points->InsertNextPoint(sample.allNan ? bad : x + sample.shift[0], y + sample.shift[1],
                                    0.1 * x + sample.twist * x * y + sample.shift[2]);
        }
    for (const int i : sample.nanPoints) points->SetPoint(i, bad, 0, 0);
    for (vtkIdType j = 0; j < n; ++j)
        for (vtkIdType i = 0; i < n; ++i) {
            const vtkIdType a = j * (n + 1) + i;
            const vtkIdType quad[4] = {a, a + 1, a + n + 2, a + n + 1};
            if (sample.cells == SheetSample::Cells::lines)
                lines->InsertNextCell(2, quad);
            else if (sample.cells == SheetSample::Cells::vertices)
                vertices->InsertNextCell(1, quad);
            else
                polys->InsertNextCell(4, quad);
        }
    for (int k = 0; k < sample.degenerate; ++k) {
        const vtkIdType line[3] = {0, 1, 0};
        polys->InsertNextCell(3, line);
    }
    if (sample.badIndex) {
        const vtkIdType far[3] = {0, 1, 1000000};
        polys->InsertNextCell(3, far);
    }
    sheet->SetPoints(points);
    sheet->SetVerts(vertices);
    sheet->SetLines(lines);
    sheet->SetPolys(polys);
    if (sample.arrays) addSheetArrays(*sheet, sample);
    if (sample.cells != SheetSample::Cells::triangles && sample.cells != SheetSample::Cells::strips) return sheet;
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(sheet);
    vtkNew<vtkStripper> strips;
    strips->SetInputConnection(triangles->GetOutputPort());
    vtkPolyDataAlgorithm* last = triangles;
    if (sample.cells == SheetSample::Cells::strips) last = strips;
    last->Update();
    vtkSmartPointer<vtkPolyData> result = last->GetOutput();
    return result;
}

template <class Writer>
void writeWith(const std::string& path, vtkDataObject& data)
{
    vtkNew<Writer> writer;
    writer->SetInputData(&data);
    writer->SetFileName(path.c_str());
    writer->Write();
}

}  // namespace

void writeSheetFile(const std::string& path, const SheetSample& sample)
{
    const auto sheet = makeSheet(sample);
    const std::string kind = extension(path);
    if (kind == ".stl") {
        vtkNew<vtkSTLWriter> writer;
        writer->SetInputData(sheet);
        writer->SetFileName(path.c_str());
        if (sample.encoding != Encoding::ascii) writer->SetFileTypeToBinary();
        writer->Write();
    } else if (kind == ".ply") {
        vtkNew<vtkPLYWriter> writer;
        writer->SetInputData(sheet);
        writer->SetFileName(path.c_str());
        if (sample.encoding == Encoding::ascii) writer->SetFileTypeToASCII();
        writer->Write();
    } else if (kind == ".obj") {
        writeWith<vtkOBJWriter>(path, *sheet);
    } else if (kind == ".vtm") {
        SheetSample other = sample;
        other.shift = {1, 0, 0.1};
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, sheet);
        blocks->SetBlock(1, makeSheet(other));
        writeWith<vtkXMLMultiBlockDataWriter>(path, *blocks);
    } else {
        writeDataSet(path, *sheet, sample.encoding);
    }
}

}  // namespace aeolic::test
