#include "reader/vtk/foam_patches.h"

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
#include "data/vtk/surface/polydata_mesh.h"
#include "reader/openfoam/foam_stream.h"
#include "reader/openfoam/foam_surface.h"

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

/// A field was left out of the list because of its file. Reading that file reports the fault.
void requireSoundField(const FoamCase& foam, const std::string& region, double time, const std::string& name)
{
    if (name.empty() || foam.times.empty() || name.find('/') != std::string::npos) return;
    const auto path = (std::filesystem::path(foamTimeFolder(foam.folders[0], time)) / region / name).string();
    if (!foamFileOf(path).empty()) FoamStream(path).finish();
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

FoamPatches::FoamPatches(const std::string& path, std::optional<double> time) : foam_(findFoamCase(path))
{
    time_ = time.value_or(firstFoamTime(foam_));
}

void FoamPatches::keepParts(std::vector<std::string> wanted)
{
    if (!chosen_.empty() && wanted == wanted_) return;
    wanted_ = std::move(wanted);
    chosen_ = chooseFoamParts(foam_, foamParts(foam_, time_), wanted_);
    const bool walls = std::all_of(chosen_.begin(), chosen_.end(), [](const FoamPart& p) { return p.type == "wall"; });
    fields_ = foam_.times.empty() ? std::vector<FoamField>() : foamFields(foam_, region(), time_);
    arrays_ = foamArrays(fields_, walls ? "wallShearStress" : "U");
}

void FoamPatches::requireAtTime(const std::vector<std::string>& arrays) const
{
    for (const std::string& name : arrays) {
        requireSoundField(foam_, region(), time_, name);
        requireFoamFieldAt(foam_, region(), time_, name);
    }
}

vtkSmartPointer<vtkDataObject> FoamPatches::read(const std::vector<ArrayInfo>& kept) const
{
    std::vector<FoamField> wanted;
    for (const ArrayInfo& array : kept) wanted.push_back({array.name, array.components});
    const PieceRun all{0, int(foam_.folders.size())};
    return polygonsOf(readFoamSurface(foam_, chosen_, time_, wanted, run_.value_or(all)), wanted, run_.has_value());
}

}  // namespace aeolic
