#pragma once

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "data/vtk/testing/sample_files.h"
#include "data/vtk/testing/sample_writers.h"

/// A volume in pieces, and files of it.
namespace aeolic::slab_pieces_testing {

using namespace test;

inline constexpr int kSide = 9;  // Cells of the sample volume in x, y and z.

/// Slabs along x of a cube of hexahedra, one .vtu each; the second is empty. Vectors "U" and a scalar "r",
/// on the cells or on the points.
struct SlabPieces {
    std::vector<int> begins{0, 3, 3, 5, kSide};  ///< Where each slab begins, and where the last ends.
    bool onCells = true;
    double phase = 0;
    glm::dvec3 originWorld{0};
    double sizeWorld = 1;

    glm::dvec3 vectorAt(const glm::dvec3& p) const
    {
        return {std::sin(3 * p.y + phase), std::cos(4 * p.x), 0.3 + p.z * p.x};
    }
    double scalarAt(const glm::dvec3& p) const { return glm::length(p - glm::dvec3(0.5)) + 0.05 * phase; }
};

inline void writeSlab(const std::string& path, const SlabPieces& slabs, int begin, int end)
{
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> vectors, scalars;
    vectors->SetName("U");
    vectors->SetNumberOfComponents(3);
    scalars->SetName("r");
    const auto add = [&](const glm::dvec3& p) {
        const glm::dvec3 v = slabs.vectorAt(p);
        vectors->InsertNextTuple3(v.x, v.y, v.z);
        scalars->InsertNextValue(float(slabs.scalarAt(p)));
    };
    const int across = kSide + 1;
    for (int x = begin; x <= end && begin < end; ++x)
        for (int y = 0; y < across; ++y)
            for (int z = 0; z < across; ++z) {
                const glm::dvec3 p = glm::dvec3(x, y, z) / double(kSide);
                const glm::dvec3 world = slabs.originWorld + slabs.sizeWorld * p;
                points->InsertNextPoint(&world.x);
                if (!slabs.onCells) add(p);
            }
    grid->SetPoints(points);
    for (int x = 0; x < end - begin; ++x)
        for (int y = 0; y < kSide; ++y)
            for (int z = 0; z < kSide; ++z) {
                const auto id = [&](int dx, int dy, int dz) {
                    return vtkIdType((x + dx) * across + y + dy) * across + z + dz;
                };
                const vtkIdType corners[] = {id(0, 0, 0), id(1, 0, 0), id(1, 1, 0), id(0, 1, 0),
                                             id(0, 0, 1), id(1, 0, 1), id(1, 1, 1), id(0, 1, 1)};
                grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
                if (slabs.onCells) add((glm::dvec3(begin + x, y, z) + 0.5) / double(kSide));
            }
    vtkDataSetAttributes* values = grid->GetPointData();
    if (slabs.onCells) values = grid->GetCellData();
    values->AddArray(vectors);
    values->AddArray(scalars);
    writeDataSet(path, *grid, Encoding::raw);
}

/// Returns the path of FOLDER/NAME.pvtu.
inline std::string writeSlabs(const std::string& folder, const std::string& name, const SlabPieces& slabs = {})
{
    std::string sources;
    for (std::size_t i = 0; i + 1 < slabs.begins.size(); ++i) {
        const std::string piece = fmt::format("{}_{}.vtu", name, i);
        writeSlab(folder + "/" + piece, slabs, slabs.begins[i], slabs.begins[i + 1]);
        sources += fmt::format("<Piece Source=\"{}\"/>\n", piece);
    }
    const std::string arrays =
        "<PDataArray type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\"/>\n"
        "<PDataArray type=\"Float32\" Name=\"r\"/>\n";
    const std::string on = slabs.onCells ? "PCellData" : "PPointData";
    writeBytes(folder + "/" + name + ".pvtu",
               "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<" +
                   on + ">\n" + arrays + "</" + on +
                   ">\n<PPoints><PDataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>\n" +
                   sources + "</PUnstructuredGrid>\n</VTKFile>\n");
    return folder + "/" + name + ".pvtu";
}

}  // namespace aeolic::slab_pieces_testing
