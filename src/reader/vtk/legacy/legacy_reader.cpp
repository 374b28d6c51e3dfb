#include "reader/vtk/legacy/legacy_reader.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkStructuredPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
#include "reader/vtk/legacy/legacy_attributes.h"
#include "reader/vtk/legacy/legacy_text.h"

namespace aeolic {
namespace {

class LegacyReader {
public:
    LegacyReader(const std::string& path, const ProgressReport& progress) : text_(path), progress_(progress) {}

    vtkSmartPointer<vtkDataObject> read()
    {
        std::string keyword = text_.keyword();
        vtkNew<vtkFieldData> before;
        while (keyword == "FIELD" || keyword == "METADATA") {  // Of the whole file.
            keyword == "FIELD" ? readLegacyField(text_, *before) : text_.skipToBlankLine();
            keyword = text_.keyword();
        }
        if (keyword != "DATASET") fail(keyword, "DATASET");
        kind_ = text_.keyword();
        data_ = makeSet();
        readStructure();
        finishStructure();
        for (int i = 0; i < before->GetNumberOfArrays(); ++i)
            data_->GetFieldData()->AddArray(before->GetAbstractArray(i));
        return data_;
    }

private:
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const
    {
        std::string shown;
        for (const char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
        if (found.empty()) shown = "nothing";
        throw InputError(text_.path(), "found " + shown, expected);
    }

    vtkSmartPointer<vtkDataSet> makeSet() const
    {
        if (kind_ == "STRUCTURED_POINTS") return vtkSmartPointer<vtkStructuredPoints>::New();
        if (kind_ == "STRUCTURED_GRID") return vtkSmartPointer<vtkStructuredGrid>::New();
        if (kind_ == "RECTILINEAR_GRID") return vtkSmartPointer<vtkRectilinearGrid>::New();
        if (kind_ == "UNSTRUCTURED_GRID") return vtkSmartPointer<vtkUnstructuredGrid>::New();
        if (kind_ == "POLYDATA") return vtkSmartPointer<vtkPolyData>::New();
        fail("DATASET " + kind_, "STRUCTURED_POINTS, STRUCTURED_GRID, RECTILINEAR_GRID, UNSTRUCTURED_GRID or POLYDATA");
    }

    void readStructure()
    {
        bool structure = true;  // What follows POINT_DATA and CELL_DATA belongs to these.
        vtkDataSetAttributes* attributes = nullptr;
        std::int64_t tuples = 0;
        while (!text_.atEnd()) {
            progress_("reading the file", text_.share());
            const std::string keyword = text_.keyword();
            if (keyword == "METADATA") {
                text_.skipToBlankLine();
            } else if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
                if (std::exchange(structure, false)) finishStructure();
                const bool onPoints = keyword == "POINT_DATA";
                tuples = text_.count(onPoints ? "the number of points" : "the number of cells");
                const vtkIdType all = onPoints ? data_->GetNumberOfPoints() : data_->GetNumberOfCells();
                if (tuples != all) fail(fmt::format("{} {}", keyword, tuples), fmt::format("{}", all));
                attributes =
                    onPoints ? static_cast<vtkDataSetAttributes*>(data_->GetPointData()) : data_->GetCellData();
            } else if (attributes ? !readLegacyAttribute(text_, keyword, *attributes, tuples) : !readPart(keyword)) {
                fail(keyword, attributes ? "an attribute" : "a part of " + kind_);
            }
        }
    }

    bool readPart(const std::string& keyword)
    {
        const bool cells = kind_ == "UNSTRUCTURED_GRID", polygons = kind_ == "POLYDATA";
        if (keyword == "FIELD")
            readLegacyField(text_, *data_->GetFieldData());
        else if (keyword == "DIMENSIONS" && !cells && !polygons)
            readDimensions();
        else if (kind_ == "STRUCTURED_POINTS" && (keyword == "SPACING" || keyword == "ASPECT_RATIO"))
            readThree(spacing_);
        else if (kind_ == "STRUCTURED_POINTS" && keyword == "ORIGIN")
            readThree(origin_);
        else if (kind_ == "RECTILINEAR_GRID" && keyword.size() == 13 && keyword.ends_with("_COORDINATES") &&
                 keyword[0] >= 'X' && keyword[0] <= 'Z')
            readAxis(std::size_t(keyword[0] - 'X'));
        else if (keyword == "POINTS" && vtkPointSet::SafeDownCast(data_))
            readPoints();
        else if (cells && keyword == "CELLS")
            readCells(*grid_);
        else if (cells && keyword == "CELL_TYPES")
            types_ = text_.array("int", text_.count("the number of cells"), 1, "cell types");
        else
            return polygons && readPolygons(keyword);
        return true;
    }

    bool readPolygons(const std::string& keyword)
    {
        auto& data = static_cast<vtkPolyData&>(*data_);
        vtkNew<vtkCellArray> cells;
        if (keyword == "VERTICES")
            data.SetVerts(cells);
        else if (keyword == "LINES")
            data.SetLines(cells);
        else if (keyword == "POLYGONS")
            data.SetPolys(cells);
        else if (keyword == "TRIANGLE_STRIPS")
            data.SetStrips(cells);
        else
            return false;
        readCells(*cells);
        return true;
    }

    void readDimensions()
    {
        double points = 1;
        for (int& samples : dims_) {
            samples = int(text_.count("a number of samples", 1 << 30));
            if (samples < 1) fail("a dimension of 0", "three numbers from 1");
            points *= samples;
        }
        if (points > 1e15) fail(fmt::format("{} x {} x {} samples", dims_[0], dims_[1], dims_[2]), "fewer");
    }

    void readThree(std::array<double, 3>& numbers)
    {
        for (double& number : numbers) number = text_.number("three numbers");
    }

    void readAxis(std::size_t axis)
    {
        const std::int64_t count = text_.count("the number of coordinates");
        axes_[axis] = text_.array(text_.word("a type of values"), count, 1, "coordinates");
        if (!axes_[axis]) fail("coordinates that are text", "numbers");
    }

    void readPoints()
    {
        const std::int64_t count = text_.count("the number of points");
        const auto values = text_.array(text_.word("a type of values"), count, 3, "points");
        if (!values || values->GetDataType() == VTK_BIT) fail("points that are not numbers", "three numbers each");
        vtkNew<vtkPoints> points;
        points->SetData(values);
        static_cast<vtkPointSet&>(*data_).SetPoints(points);
    }

    /// Up to version 4.2 each cell is its number of corners and the corners; in 5 there are offsets and corners.
    void readCells(vtkCellArray& cells)
    {
        const std::int64_t count = text_.count("the number of cells"), size = text_.count("the size of the cells");
        vtkNew<vtkIdTypeArray> offsets, corners;
        if (text_.takes("OFFSETS")) {
            copy(*numbers("offsets", count), *offsets);
            if (!text_.takes("CONNECTIVITY")) fail("offsets without CONNECTIVITY", "CONNECTIVITY");
            copy(*numbers("corners", size), *corners);
            if (count == 0) offsets->InsertNextValue(0);
        } else {
            const auto all = text_.array("int", size, 1, "cells");
            offsets->InsertNextValue(0);
            std::int64_t at = 0;
            for (std::int64_t cell = 0; cell < count; ++cell) {
                const double length = at < size ? all->GetComponent(at++, 0) : -1;
                if (length < 0 || length > double(size - at))
                    fail(fmt::format("cell {} of {:g} corners", cell, length), "no more than there are");
                for (const std::int64_t end = at + std::int64_t(length); at < end; ++at)
                    corners->InsertNextValue(vtkIdType(all->GetComponent(at, 0)));
                offsets->InsertNextValue(corners->GetNumberOfValues());
            }
        }
        for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i) {
            const vtkIdType end = offsets->GetValue(i);
            const bool first = i == 0, last = i + 1 == offsets->GetNumberOfValues();
            if (end < (first ? 0 : offsets->GetValue(i - 1)) || (first && end != 0) ||
                (last && end != corners->GetNumberOfValues()))
                fail(fmt::format("offset {}", end),
                     fmt::format("offsets from 0 to {} that do not decrease", corners->GetNumberOfValues()));
        }
        cells.SetData(offsets, corners);
    }

    vtkSmartPointer<vtkDataArray> numbers(const char* what, std::int64_t count)
    {
        auto array = text_.array(text_.word("a type of values"), count, 1, what);
        if (!array) fail("text", what);
        return array;
    }

    static void copy(vtkDataArray& from, vtkIdTypeArray& to)
    {
        to.SetNumberOfValues(from.GetNumberOfValues());
        for (vtkIdType i = 0; i < from.GetNumberOfValues(); ++i) {
            const double value = from.GetComponent(i, 0);  // -1: none there can be.
            to.SetValue(i, value >= 0 && value < 1e15 ? vtkIdType(value) : -1);
        }
    }

    void finishStructure()
    {
        if (std::exchange(finished_, true)) return;
        if (auto* image = vtkImageData::SafeDownCast(data_)) {
            image->SetDimensions(dims_.data());
            image->SetSpacing(spacing_.data());
            image->SetOrigin(origin_.data());
        } else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data_)) {
            for (std::size_t c = 0; c < 3; ++c)
                if (!axes_[c] || axes_[c]->GetNumberOfTuples() != dims_[c])
                    fail(fmt::format("{} coordinates in {}", axes_[c] ? axes_[c]->GetNumberOfTuples() : 0, "xyz"[c]),
                         fmt::format("{}", dims_[c]));
            rectilinear->SetDimensions(dims_.data());
            rectilinear->SetXCoordinates(axes_[0]);
            rectilinear->SetYCoordinates(axes_[1]);
            rectilinear->SetZCoordinates(axes_[2]);
        } else if (auto* structured = vtkStructuredGrid::SafeDownCast(data_)) {
            const vtkIdType points = vtkIdType(dims_[0]) * dims_[1] * dims_[2];
            if (structured->GetNumberOfPoints() != points)
                fail(fmt::format("{} points", structured->GetNumberOfPoints()), fmt::format("{}", points));
            structured->SetDimensions(dims_.data());
        } else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data_)) {
            finishCells(*grid);
        }
    }

    /// The corners of a polyhedron are its faces here.
    void finishCells(vtkUnstructuredGrid& grid)
    {
        const vtkIdType cells = grid_->GetNumberOfCells();
        if ((types_ ? types_->GetNumberOfTuples() : 0) != cells)
            fail(fmt::format("{} cell types", types_ ? types_->GetNumberOfTuples() : 0),
                 fmt::format("{}, one for each cell", cells));
        grid.Allocate(cells);
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        for (vtkIdType cell = 0; cell < cells; ++cell) {
            const double type = types_->GetComponent(cell, 0);
            if (!(type >= 0 && type <= 255)) fail(fmt::format("cell type {}", type), "0 to 255");
            grid_->GetCellAtId(cell, size, corners);
            if (int(type) != VTK_POLYHEDRON) {
                grid.InsertNextCell(int(type), size, corners);
                continue;
            }
            const std::vector<std::int64_t> faces(corners, corners + size);
            if (!facesAreSound(faces, std::uint64_t(grid.GetNumberOfPoints())))
                fail(fmt::format("no valid polyhedron in cell {}", cell), "faces of points");
            grid.InsertNextCell(VTK_POLYHEDRON, corners[0], corners + 1);
        }
    }

    LegacyText text_;
    ProgressReport progress_;
    std::string kind_;
    vtkSmartPointer<vtkDataSet> data_;
    vtkNew<vtkCellArray> grid_;
    vtkSmartPointer<vtkDataArray> types_;
    std::array<vtkSmartPointer<vtkDataArray>, 3> axes_;
    std::array<int, 3> dims_{1, 1, 1};
    std::array<double, 3> spacing_{1, 1, 1}, origin_{0, 0, 0};
    bool finished_ = false;
};

}  // namespace

vtkSmartPointer<vtkDataObject> readLegacy(const std::string& path, const ProgressReport& progress)
{
    return LegacyReader(path, progress).read();
}

}  // namespace aeolic
