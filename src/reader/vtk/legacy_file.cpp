#include "reader/vtk/format_readers.h"

#include <vtkCallbackCommand.h>
#include <vtkDataObjectTypes.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPolyDataReader.h>
#include <vtkRectilinearGridReader.h>
#include <vtkStructuredGridReader.h>
#include <vtkStructuredPointsReader.h>
#include <vtkUnstructuredGridReader.h>

#include "aeolic/error.h"
#include "data/vtk/messages.h"
#include "reader/vtk/text_numbers.h"

namespace aeolic {
namespace {

vtkSmartPointer<vtkDataReader> readerOf(int type)
{
    switch (type) {
        case VTK_POLY_DATA:
            return vtkSmartPointer<vtkPolyDataReader>::New();
        case VTK_UNSTRUCTURED_GRID:
            return vtkSmartPointer<vtkUnstructuredGridReader>::New();
        case VTK_STRUCTURED_GRID:
            return vtkSmartPointer<vtkStructuredGridReader>::New();
        case VTK_RECTILINEAR_GRID:
            return vtkSmartPointer<vtkRectilinearGridReader>::New();
        case VTK_STRUCTURED_POINTS:
            return vtkSmartPointer<vtkStructuredPointsReader>::New();
        default:
            return nullptr;
    }
}

/// VTK tells its progress first when it has opened the file, which it does with the classic locale.
void openedFile(vtkObject* reader, unsigned long, void* progress, void*)
{
    auto* file = static_cast<vtkDataReader*>(reader);
    if (file->GetIStream()) file->GetIStream()->imbue(textNumbers());
    (*static_cast<const ProgressReport*>(progress))("reading the file", file->GetProgress());
}

}  // namespace

vtkSmartPointer<vtkDataObject> readLegacy(const std::string& path, const ProgressReport& progress)
{
    const VtkMessages messages;
    vtkNew<vtkGenericDataObjectReader> header;
    header->SetFileName(path.c_str());
    const int type = header->ReadOutputType();
    const auto reader = readerOf(type);
    if (messages.failed())
        throw InputError(path, "it does not begin like a legacy VTK file (" + messages.firstError() + ")",
                         "'# vtk DataFile Version N.N', a title, and ASCII or BINARY in the first three lines");
    if (!reader)
        throw InputError(path, "its fourth line names no data set",
                         "DATASET STRUCTURED_POINTS, STRUCTURED_GRID, RECTILINEAR_GRID, UNSTRUCTURED_GRID or POLYDATA");
    ProgressReport report = progress;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(openedFile);
    observer->SetClientData(&report);
    reader->AddObserver(vtkCommand::ProgressEvent, observer);
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllColorScalarsOn();
    reader->ReadAllTCoordsOn();
    reader->ReadAllFieldsOn();
    // Update() would go through all words of uniform grids first, to find out what their scalars are.
    auto data = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
    reader->ReadMeshSimple(path, data);
    if (messages.failed())
        throw InputError(path, "it cannot be read (" + messages.firstError() + ")", "a complete, undamaged file");
    return data;
}

}  // namespace aeolic
