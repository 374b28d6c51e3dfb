#include "data/vtk/file_reader.h"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArraySelection.h>
#include <vtkDataObjectTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkDataSetReader.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNrrdReader.h>
#include <vtkOBJReader.h>
#include <vtkSTLReader.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPDataObjectReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/vtk/file_checks.h"
#include "data/vtk/messages.h"
#include "data/vtk/ply_reader.h"

namespace aeolic {

namespace {

constexpr const char* surfaceFiles = ".vtp .pvtp .vtm .stl .ply .obj, or .vtk with polygons";
constexpr const char* fieldFiles = ".vti .vtr .vts .vtu .pvti .pvtr .pvts .pvtu .nhdr .nrrd, or .vtk with a grid";

constexpr const char* nrrdArrayName = "ImageFile";  // The format has no names; this one is VTK's.

struct Format {
    const char* extension;
    FileReader::Use use;
    const char* kind;
    vtkSmartPointer<vtkAlgorithm> (*make)();
};

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

using Use = FileReader::Use;
const Format formats[] = {
    {".vtp", Use::surface, "polygons", make<vtkXMLPolyDataReader>},
    {".pvtp", Use::surface, "polygons", make<vtkXMLPPolyDataReader>},
    {".vtm", Use::surface, "a multi-block data set", make<vtkXMLMultiBlockDataReader>},
    {".stl", Use::surface, "triangles", make<vtkSTLReader>},
    {".ply", Use::surface, "polygons", nullptr},  // Our own readPly().
    {".obj", Use::surface, "polygons", make<vtkOBJReader>},
    {".vtk", Use::any, "a legacy VTK file", make<vtkDataSetReader>},
    {".vti", Use::field, "image data", make<vtkXMLImageDataReader>},
    {".pvti", Use::field, "image data", make<vtkXMLPImageDataReader>},
    {".nhdr", Use::field, "image data", make<vtkNrrdReader>},
    {".nrrd", Use::field, "image data", make<vtkNrrdReader>},
    {".vtr", Use::field, "a rectilinear grid", make<vtkXMLRectilinearGridReader>},
    {".pvtr", Use::field, "a rectilinear grid", make<vtkXMLPRectilinearGridReader>},
    {".vts", Use::field, "a structured grid", make<vtkXMLStructuredGridReader>},
    {".pvts", Use::field, "a structured grid", make<vtkXMLPStructuredGridReader>},
    {".vtu", Use::field, "an unstructured grid", make<vtkXMLUnstructuredGridReader>},
    {".pvtu", Use::field, "an unstructured grid", make<vtkXMLPUnstructuredGridReader>},
};

const Format& chooseFormat(const std::string& path, const std::string& extension, Use use)
{
    const auto* format =
        std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return extension == f.extension; });
    const std::string expected = use == Use::surface ? fmt::format("a surface: {}", surfaceFiles)
                                 : use == Use::field ? fmt::format("a field: {}", fieldFiles)
                                                     : fmt::format("{}; {}", surfaceFiles, fieldFiles);
    if (format == std::end(formats))
        throw InputError(
            path, extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'", expected);
    if (use == Use::surface && format->use == Use::field)
        throw InputError(path, fmt::format("{} is a field, not a surface", format->kind),
                         fmt::format("{} (cut a surface out with --field {} --surface boundary)", expected, path));
    if (use == Use::field && format->use == Use::surface)
        throw InputError(path, fmt::format("{} are a surface, not a field", format->kind),
                         fmt::format("{} (a surface goes to --surface)", expected));
    return *format;
}

void readAllAttributes(vtkDataSetReader& reader)
{
    reader.ReadAllScalarsOn();
    reader.ReadAllVectorsOn();
    reader.ReadAllNormalsOn();
    reader.ReadAllFieldsOn();
}

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

/// VTK takes the axis of the components for one of space where "space directions" has a "none" for it.
void checkNrrd(const std::string& path, vtkInformation& info)
{
    std::ifstream file(path, std::ios::binary);
    std::string line;
    while (std::getline(file, line) && line.size() > 1)
        if (line.starts_with("space directions:") && line.find("none") != std::string::npos)
            throw InputError(path, "its 'space directions' have a 'none' for the components",
                             "'spacings' instead, with nan for the components");
    const int* extent = info.Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    if (!extent || extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4])
        throw InputError(path, "its header gives no size in x, y and z", "three axes of kind domain");
}

struct ProgressTarget {
    vtkAlgorithm* algorithm;
    ProgressReport report;
    const char* what;
};

void forwardProgress(vtkObject*, unsigned long, void* client, void*)
{
    const auto* target = static_cast<ProgressTarget*>(client);
    target->report(target->what, target->algorithm->GetProgress());
}

}  // namespace

std::string extensionOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::string kindOf(vtkDataObject& data)
{
    switch (data.GetDataObjectType()) {
        case VTK_POLY_DATA:
            return "polygons";
        case VTK_IMAGE_DATA:
        case VTK_STRUCTURED_POINTS:
        case VTK_UNIFORM_GRID:
            return "image data";
        case VTK_RECTILINEAR_GRID:
            return "a rectilinear grid";
        case VTK_STRUCTURED_GRID:
            return "a structured grid";
        case VTK_UNSTRUCTURED_GRID:
            return "an unstructured grid";
        case VTK_MULTIBLOCK_DATA_SET:
            return "a multi-block data set";
        default:
            return data.GetClassName();
    }
}

FileReader::FileReader(std::string path, Use use, std::optional<double> time)
    : path_(std::move(path)), extension_(extensionOf(path_))
{
    fileBytes_ = checkReadableFile(path_);
    const Format& format = chooseFormat(path_, extension_, use);
    if (!format.make) return;
    reader_ = format.make();

    const VtkMessages messages;
    if (auto* xml = vtkXMLReader::SafeDownCast(reader_)) {
        if (!xml->CanReadFile(path_.c_str()))
            throw InputError(path_, "it does not begin like a VTK file of this kind",
                             fmt::format("a VTK XML file with {}", format.kind));
        xml->SetFileName(path_.c_str());
        announces_ = !vtkXMLMultiBlockDataReader::SafeDownCast(reader_);
    } else if (auto* nrrd = vtkNrrdReader::SafeDownCast(reader_)) {
        if (!nrrd->CanReadFile(path_.c_str()))
            throw InputError(path_, "it does not begin like an NRRD file", "NRRD0001 to NRRD0005");
        nrrd->SetFileName(path_.c_str());
        announces_ = true;
    } else if (auto* legacy = vtkDataSetReader::SafeDownCast(reader_)) {
        legacy->SetFileName(path_.c_str());
        readAllAttributes(*legacy);
        checkComplete(path_, extension_, fileBytes_);
        if (legacy->ReadOutputType() < 0)
            throw InputError(path_, "it does not begin like a VTK file", "a legacy VTK file");
    } else if (auto* other = vtkAbstractPolyDataReader::SafeDownCast(reader_)) {
        other->SetFileName(path_.c_str());
    }
    checkComplete(path_, extension_, fileBytes_);
    reader_->UpdateInformation();
    if (vtkNrrdReader::SafeDownCast(reader_)) checkNrrd(path_, *reader_->GetOutputInformation(0));
    if (messages.failed())
        throw InputError(path_, "its header cannot be read (" + messages.firstError() + ")", format.kind);

    vtkInformation* info = reader_->GetOutputInformation(0);
    if (announces_)
        announced_ = kept_ = vtkNrrdReader::SafeDownCast(reader_) ? announcedScalars(*info) : announced(*info);
    if (info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS())) {
        const double* steps = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        timeSteps_.assign(steps, steps + info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
        if (time) info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), *time);
    }
    const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    if (announces_ && extent && std::string(format.kind) == "image data") {
        image_.emplace();
        std::copy(extent, extent + 6, image_->wholeExtent.begin());
        const GridIndex dims = image_->wholeDims();
        image_->brick.cellHi = image_->own.cellHi = {dims[0] - 1, dims[1] - 1, dims[2] - 1};
    }
}

GridIndex FileReader::imageDims() const
{
    GridIndex dims = image_ ? image_->wholeDims() : GridIndex{0, 0, 0};
    for (std::int64_t& samples : dims) samples = std::max<std::int64_t>(samples, 0);
    return dims;
}

glm::dvec3 FileReader::imageSpacing() const
{
    double spacing[3] = {1, 1, 1};
    if (image_) reader_->GetOutputInformation(0)->Get(vtkDataObject::SPACING(), spacing);
    return {spacing[0], spacing[1], spacing[2]};
}

ImagePiece FileReader::keepBrick(const FieldPart& part, bool withNeighbours)
{
    const GridIndex dims = imageDims();
    if (*std::min_element(dims.begin(), dims.end()) < 2)
        throw InputError(path_, "it cannot be read in bricks",
                         "image data (.vti, .pvti, .nhdr) of at least two samples in x, y and z, or --bricks off");
    const glm::dvec3 spacing = imageSpacing();
    image_->own = BrickTree(dims, {spacing.x, spacing.y, spacing.z}, part.ranks).brick(part.rank);
    image_->brick = withNeighbours ? image_->own.grown(dims) : image_->own;
    wholeImage_ = false;
    return *image_;
}

FileReader::~FileReader() = default;

void FileReader::keepOnly(const std::vector<ArrayInfo>& arrays)
{
    auto* xml = vtkXMLReader::SafeDownCast(reader_);
    if (!announces_ || !xml) return;  // An NRRD file has one array.
    kept_.clear();
    xml->GetPointDataArraySelection()->DisableAllArrays();
    xml->GetCellDataArraySelection()->DisableAllArrays();
    for (const ArrayInfo& array : announced_) {
        const bool wanted = std::any_of(arrays.begin(), arrays.end(), [&](const ArrayInfo& a) {
            return a.name == array.name && a.onPoints == array.onPoints;
        });
        if (!wanted && !isMaskName(array.name)) continue;
        kept_.push_back(array);
        (array.onPoints ? xml->GetPointDataArraySelection() : xml->GetCellDataArraySelection())
            ->EnableArray(array.name.c_str());
    }
}

void FileReader::requireMemoryToRead() const
{
    if (!image_) {  // At least what is in the file, whatever its form.
        requireMemory(path_, "reading it", fileBytes_);
        return;
    }
    const GridIndex dims = wholeImage_ ? imageDims() : image_->brick.sampleDims();
    const double points = double(dims[0]) * double(dims[1]) * double(dims[2]);
    double bytes = 0;
    for (const ArrayInfo& array : kept_) {
        const int typeBytes = std::max(1, vtkDataArray::GetDataTypeSize(array.vtkType));
        const bool converted = array.vtkType != VTK_FLOAT && !isMaskName(array.name);
        bytes += points * array.components * (typeBytes + (converted ? 4 : 0));
    }
    requireMemory(path_, fmt::format("image data of {} x {} x {} points", dims[0], dims[1], dims[2]),
                  static_cast<std::uint64_t>(std::min(bytes, 1e19)));
}

template <class Update>
vtkSmartPointer<vtkDataObject> FileReader::update(const Update& run)
{
    const VtkMessages messages;
    try {
        run();
    } catch (const std::bad_alloc&) {
        throw InputError(path_, "there is not enough memory to read it", "a smaller file or a larger machine");
    }
    if (messages.failed())
        throw InputError(path_, "it cannot be read (" + messages.firstError() + ")", "a complete, undamaged file");
    vtkSmartPointer<vtkDataObject> data = reader_->GetOutputDataObject(0);
    if (!data) throw InputError(path_, "nothing could be read", "a complete, undamaged file");
    return data;
}

vtkSmartPointer<vtkDataObject> FileReader::readExtent(const std::array<int, 6>& extent)
{
    return update([&] { reader_->UpdateExtent(extent.data()); });
}

vtkSmartPointer<vtkDataObject> FileReader::readPiece(int piece)
{
    const int all = vtkXMLPDataObjectReader::SafeDownCast(reader_)->GetNumberOfPieces();
    const auto data = update([&] { reader_->UpdatePiece(piece, all, 0); });
    auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
    copy->ShallowCopy(data);  // The reader's own changes with the next.
    return copy;
}

vtkSmartPointer<vtkDataObject> FileReader::read(const ProgressReport& progress, const char* what)
{
    requireMemoryToRead();
    if (!reader_) return readPly(path_, progress);
    ProgressTarget target{reader_, progress, what};
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(forwardProgress);
    observer->SetClientData(&target);
    const unsigned long tag = reader_->AddObserver(vtkCommand::ProgressEvent, observer);
    const auto data = update([&] {
        if (wholeImage_)
            reader_->Update();
        else
            reader_->UpdateExtent(image_->extent().data());
    });
    reader_->RemoveObserver(tag);
    return data;
}

}  // namespace aeolic
