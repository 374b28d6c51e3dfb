#include "reader/vtk/file_header.h"

#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNrrdReader.h>

#include <algorithm>

namespace aeolic {

namespace {

constexpr const char* nrrdArrayName = "ImageFile";  // The format has no names; this one is VTK's.

std::vector<ArrayInfo> announced(vtkInformation& info)
{
    std::vector<ArrayInfo> arrays;
    for (const bool onPoints : {true, false}) {
        vtkInformationVector* all =
            info.Get(onPoints ? vtkDataObject::POINT_DATA_VECTOR() : vtkDataObject::CELL_DATA_VECTOR());
        for (int i = 0; all && i < all->GetNumberOfInformationObjects(); ++i) {
            vtkInformation* field = all->GetInformationObject(i);
            if (!field->Has(vtkDataObject::FIELD_NAME())) continue;
            ArrayInfo array{field->Get(vtkDataObject::FIELD_NAME()), onPoints, 1, VTK_VOID, false, false};
            if (field->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
                array.components = field->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
            if (field->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
                array.vtkType = field->Get(vtkDataObject::FIELD_ARRAY_TYPE());
            const int active = field->Has(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE())
                                   ? field->Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE())
                                   : 0;
            array.activeVectors = active & (1 << vtkDataSetAttributes::VECTORS);
            array.activeNormals = active & (1 << vtkDataSetAttributes::NORMALS);
            // A file with several time steps says each array once for every step.
            if (std::none_of(arrays.begin(), arrays.end(),
                             [&](const ArrayInfo& a) { return a.name == array.name && a.onPoints == onPoints; }))
                arrays.push_back(array);
        }
    }
    return arrays;
}

/// The one array of an image file that is not of the XML family.
std::vector<ArrayInfo> announcedScalars(vtkInformation& info)
{
    vtkInformation* field = vtkDataObject::GetActiveFieldInformation(&info, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                                                     vtkDataSetAttributes::SCALARS);
    if (!field || !field->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())) return {};
    ArrayInfo array{nrrdArrayName,
                    true,
                    field->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()),
                    field->Get(vtkDataObject::FIELD_ARRAY_TYPE()),
                    false,
                    false};
    array.activeVectors = array.components == 3;
    return {array};
}

}  // namespace

std::vector<ArrayInfo> announcedArrays(vtkAlgorithm& reader)
{
    vtkInformation& info = *reader.GetOutputInformation(0);
    return vtkNrrdReader::SafeDownCast(&reader) ? announcedScalars(info) : announced(info);
}

}  // namespace aeolic
