#include <vtkCompositeDataIterator.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkSTLReader.h>
#include <vtkUnstructuredGrid.h>

#include "reader/openfoam/foam_stream.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/modules/nrrd_reader.h"

namespace aeolic {
namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

void readFolder(const FoamCase& foam, const std::string& folder, double time, const std::vector<FoamField>& fields,
                bool polyhedra, vtkAppendFilter& append)
{
    vtkNew<vtkOpenFOAMReader> reader;
    reader->SetFileName((folder + "/case.foam").c_str());
    reader->SetListTimeStepsByControlDict(false);
    reader->SetSkipZeroTime(false);
    reader->SetCreateCellToPoint(false);
    reader->SetDecomposePolyhedra(!polyhedra);
    const FoamStream points(foamMeshFile(folder, foam.regions.front(), time, "points"));
    reader->SetUse64BitLabels(points.longLabels());
    reader->SetUse64BitFloats(points.longScalars());
    reader->UpdateInformation();
    reader->DisableAllPatchArrays();
    for (const std::string& region : foam.regions)
        reader->SetPatchArrayStatus((region.empty() ? "internalMesh" : region + "/internalMesh").c_str(), 1);
    reader->DisableAllCellArrays();
    for (const FoamField& field : fields) reader->SetCellArrayStatus(field.name.c_str(), 1);
    reader->DisableAllPointArrays();
    reader->DisableAllLagrangianArrays();
    reader->UpdateTimeStep(time);
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject())) {
            vtkNew<vtkUnstructuredGrid> copy;
            copy->ShallowCopy(grid);
            append.AddInputData(copy);
        }
}

}  // namespace
}  // namespace aeolic

extern "C" const aeolic::VtkModule aeolicVtkModule{aeolic::make<vtkSTLReader>, aeolic::makeNrrdReader,
                                                   aeolic::readFolder};
