#include "data/vtk/surface/foam_file.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>

#include <algorithm>
#include <filesystem>

#include "aeolic/error.h"
#include "data/openfoam/foam_stream.h"
#include "data/openfoam/foam_surface.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {
namespace {

/// `numbered`: with their places among those of all processors.
vtkSmartPointer<vtkPolyData> polygonsOf(const FoamSurface& surface, const std::vector<FoamField>& fields, bool numbered)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(vtkIdType(surface.points.size()));
    for (std::size_t i = 0; i < surface.points.size(); ++i) points->SetPoint(vtkIdType(i), &surface.points[i].x);
    vtkNew<vtkIdTypeArray> begins, corners;
    begins->SetNumberOfValues(vtkIdType(surface.begins.size()));
    std::copy(surface.begins.begin(), surface.begins.end(), begins->GetPointer(0));
    corners->SetNumberOfValues(vtkIdType(surface.corners.size()));
    std::copy(surface.corners.begin(), surface.corners.end(), corners->GetPointer(0));
    vtkNew<vtkCellArray> polygons;
    polygons->SetData(begins, corners);
    data->SetPoints(points);
    data->SetPolys(polygons);
    for (const FoamField& field : fields) {
        const std::vector<float>& values = surface.values.at(field.name);
        vtkNew<vtkFloatArray> array;
        array->SetName(field.name.c_str());
        array->SetNumberOfComponents(field.components);
        array->SetNumberOfTuples(vtkIdType(values.size()) / field.components);
        std::copy(values.begin(), values.end(), array->GetPointer(0));
        data->GetCellData()->AddArray(array);
    }
    if (numbered) {
        vtkNew<vtkTypeUInt64Array> places;
        places->SetName(kTrianglesPlaces);
        places->SetNumberOfValues(vtkIdType(surface.places.size()));
        std::copy(surface.places.begin(), surface.places.end(), places->GetPointer(0));
        data->GetCellData()->AddArray(places);
    }
    return data;
}

/// The file of a field that was left out of the list says itself what is wrong with it.
void requireSoundField(const FoamCase& foam, const std::string& region, double time, const std::string& name)
{
    if (name.empty() || foam.times.empty() || name.find('/') != std::string::npos) return;
    const auto path = (std::filesystem::path(foamTimeFolder(foam.folders[0], time)) / region / name).string();
    if (!foamFileOf(path).empty()) FoamStream(path).finish();
}

void want(const ArrayInfo& array, std::vector<FoamField>& fields)
{
    const auto same = [&](const FoamField& field) { return field.name == array.name; };
    if (std::none_of(fields.begin(), fields.end(), same)) fields.push_back({array.name, array.components});
}

}  // namespace

double firstFoamTime(const FoamCase& foam)
{
    return foam.times.empty() ? 0 : foam.times.front();
}

std::vector<ArrayInfo> foamArrays(const std::vector<FoamField>& fields, const std::string& preferred)
{
    std::vector<ArrayInfo> arrays;
    ArrayInfo* active = nullptr;
    arrays.reserve(fields.size());
    for (const FoamField& field : fields) {
        arrays.push_back({field.name, false, field.components, VTK_FLOAT});
        if (field.components == 3 && (field.name == preferred || (field.name == "U" && !active)))
            active = &arrays.back();
    }
    if (active) active->activeVectors = true;
    return arrays;
}

LoadedSurface readFoamFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress)
{
    progress("reading the surface", 0);
    const FoamCase foam = findFoamCase(path);
    const double time = arrays.timeInFile.value_or(firstFoamTime(foam));
    const std::string where = foam.times.size() > 1 ? fmt::format("{}, time {}", path, time) : path;
    const std::vector<FoamPart> parts = chooseFoamParts(foam, foamParts(foam, time), arrays.parts);
    const std::string& region = parts.front().region;
    std::vector<FoamField> fields;
    if (!foam.times.empty()) fields = foamFields(foam, region, time);
    const bool walls = std::all_of(parts.begin(), parts.end(), [](const FoamPart& p) { return p.type == "wall"; });
    const std::vector<ArrayInfo> available = foamArrays(fields, walls ? "wallShearStress" : "U");

    SurfaceArrays chosen = arrays;
    std::vector<FoamField> wanted;
    if (arrays.wantVectors) {
        requireSoundField(foam, region, time, arrays.vectors);
        requireFoamFieldAt(foam, region, time, arrays.vectors);
        const ArrayInfo& vectors = chooseVectors(available, arrays.vectors, where);
        chosen.vectors = vectors.name;
        want(vectors, wanted);
    }
    requireFoamFieldAt(foam, region, time, arrays.colorBy);
    if (!arrays.colorBy.empty())
        if (const auto scalar = findScalar(available, arrays.colorBy, where)) want(scalar->array, wanted);
    const std::vector<std::uint64_t> processors(foam.folders.size(), 1);
    const FoamSurface faces = readFoamSurface(foam, parts, time, wanted, runOf(arrays.part, processors));
    LoadedSurface surface = meshFromPolyData(*polygonsOf(faces, wanted, arrays.part.split()), path, chosen);
    surface.arrays = listArrays(available);
    surface.offered = offeredArrays(available);
    progress("reading the surface", 1);
    return surface;
}

}  // namespace aeolic
