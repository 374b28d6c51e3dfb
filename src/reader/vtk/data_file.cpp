#include "reader/vtk/data_file.h"

#include <fmt/format.h>
#include <vtkAbstractPolyDataReader.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArraySelection.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLPDataObjectReader.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/named_file.h"
#include "data/vtk/linear_cells.h"
#include "data/vtk/messages.h"
#include "reader/vtk/block_arrays.h"
#include "reader/vtk/part_blocks.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {

namespace {

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

constexpr const char* nrrdArrayName = "ImageFile";  // The format has no names; this one is VTK's.

/// The arrays that a reader of the XML family announces before it reads them.
std::vector<ArrayInfo> announced(vtkInformation& info)
{
    std::vector<ArrayInfo> arrays;
    for (const bool onPoints : {true, false}) {
        vtkInformationVector* all =
            info.Get(onPoints ? vtkDataObject::POINT_DATA_VECTOR() : vtkDataObject::CELL_DATA_VECTOR());
        for (int i = 0; all && i < all->GetNumberOfInformationObjects(); ++i) {
            vtkInformation* field = all->GetInformationObject(i);
            if (!field->Has(vtkDataObject::FIELD_NAME())) continue;
            ArrayInfo array{field->Get(vtkDataObject::FIELD_NAME()), onPoints, 1,
                            field->Get(vtkDataObject::FIELD_ARRAY_TYPE())};
            if (field->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
                array.components = field->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
            const int active = field->Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE());
            array.activeVectors = active & (1 << vtkDataSetAttributes::VECTORS);
            array.activeNormals = active & (1 << vtkDataSetAttributes::NORMALS);
            // A file with several time steps says each array once for every step.
            addOthers(arrays, {array});
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
    const int components = field->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
    return {{nrrdArrayName, true, components, field->Get(vtkDataObject::FIELD_ARRAY_TYPE()), components == 3}};
}

}  // namespace

DataFile::DataFile(std::string path, FileUse use, std::optional<double> time) : path_(std::move(path))
{
    if (!namedKindHas(path_, kIsFolder)) fileBytes_ = checkReadableFile(path_);
    kind_ = &chooseKind(path_, use);
    format_ = &formatOf(*kind_);
    if (format_->open) own_ = format_->open(path_, use, time);
    if (format_->openParts) own_ = std::make_unique<PartBlocks>(format_->openParts(path_, time), path_, use);
    if (own_) {
        announces_ = true;
        timeSteps_ = own_->times();
    }
    if (!format_->makeReader) return;
    reader_ = format_->makeReader();

    const VtkMessages messages;
    if (auto* xml = vtkXMLReader::SafeDownCast(reader_)) {
        if (!xml->CanReadFile(path_.c_str()))
            throw InputError(path_, "it does not begin like a VTK file of this kind",
                             fmt::format("a VTK XML file with {}", kind_->kind));
        xml->SetFileName(path_.c_str());
        announces_ = true;
    } else if (auto* nrrd = vtkNrrdReader::SafeDownCast(reader_)) {
        if (!nrrd->CanReadFile(path_.c_str()))
            throw InputError(path_, "it does not begin like an NRRD file", "NRRD0001 to NRRD0005");
        nrrd->SetFileName(path_.c_str());
        announces_ = true;
    } else if (auto* other = vtkAbstractPolyDataReader::SafeDownCast(reader_)) {
        other->SetFileName(path_.c_str());
    }
    if (format_->check) format_->check(path_, fileBytes_);
    if (vtkXMLPDataObjectReader::SafeDownCast(reader_)) pieceFilesOf(path_);
    reader_->UpdateInformation();
    if (messages.failed())
        throw InputError(placeOf(messages), "its header cannot be read (" + messages.firstError() + ")", kind_->kind);

    vtkInformation* info = reader_->GetOutputInformation(0);
    if (announces_)
        announced_ = kept_ = vtkNrrdReader::SafeDownCast(reader_) ? announcedScalars(*info) : announced(*info);
    if (info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS())) {
        const double* steps = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        timeSteps_.assign(steps, steps + info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
        if (time) info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), *time);
    }
    const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    if (announces_ && extent && std::string(kind_->kind) == "image data")
        std::copy(extent, extent + 6, wholeExtent_.emplace().begin());
}

glm::dvec3 DataFile::imageSpacing() const
{
    double spacing[3] = {1, 1, 1};
    if (wholeExtent_) reader_->GetOutputInformation(0)->Get(vtkDataObject::SPACING(), spacing);
    return {spacing[0], spacing[1], spacing[2]};
}

DataFile::~DataFile() = default;

void DataFile::keepParts(const std::vector<std::string>& parts)
{
    if (!own_) return;
    own_->keepParts(parts);
    asked_ = false;
}

const std::vector<ArrayInfo>& DataFile::announcedArrays()
{
    if (own_ && !asked_) announced_ = kept_ = own_->arrays();
    asked_ = true;
    return announced_;
}

void DataFile::keepOnly(const std::vector<ArrayInfo>& arrays)
{
    auto* xml = vtkXMLReader::SafeDownCast(reader_);
    if (!announces_ || (!xml && !own_)) return;  // An NRRD file has one array.
    announcedArrays();
    kept_.clear();
    if (xml) {
        xml->GetPointDataArraySelection()->DisableAllArrays();
        xml->GetCellDataArraySelection()->DisableAllArrays();
    }
    for (const ArrayInfo& array : announced_) {
        const bool wanted = findInfo(arrays, array.name, array.onPoints) != nullptr;
        if (!wanted && !isMaskName(array.name) && array.name != kHigherOrderDegrees) continue;
        kept_.push_back(array);
        if (!xml) continue;
        (array.onPoints ? xml->GetPointDataArraySelection() : xml->GetCellDataArraySelection())
            ->EnableArray(array.name.c_str());
    }
}

void DataFile::requireMemoryToRead(const std::optional<std::array<int, 6>>& extent) const
{
    if (!wholeExtent_) {  // At least the file's own arrays.
        requireMemory(path_, "reading it", fileBytes_);
        return;
    }
    std::array<std::int64_t, 3> dims{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto& e = extent ? *extent : *wholeExtent_;
        dims[c] = std::max<std::int64_t>(0, std::int64_t(e[2 * c + 1]) - e[2 * c] + 1);
    }
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

/// This file, or one of its pieces that VTK complains about.
std::string DataFile::placeOf(const VtkMessages& messages) const
{
    return messages.place().empty() ? path_ : messages.place();
}

template <class Update>
vtkSmartPointer<vtkDataObject> DataFile::update(const Update& run)
{
    const VtkMessages messages;
    run();
    if (messages.failed())
        throw InputError(placeOf(messages), "it cannot be read (" + messages.firstError() + ")",
                         "a complete, undamaged file");
    vtkSmartPointer<vtkDataObject> data = reader_->GetOutputDataObject(0);
    if (!data) throw InputError(path_, "nothing could be read", "a complete, undamaged file");
    return data;
}

void DataFile::forget()
{
    if (!reader_) return;
    if (vtkDataObject* data = reader_->GetOutputDataObject(0)) data->Initialize();
    reader_->Modified();
}

vtkSmartPointer<vtkDataObject> DataFile::withLinearCells(vtkSmartPointer<vtkDataObject> data) const
{
    if (data) makeCellsLinear(*data, path_);
    return data;
}

vtkSmartPointer<vtkDataObject> DataFile::readPieces(const PieceRun& run)
{
    if (own_) {
        announcedArrays();
        return withLinearCells(own_->readPieces(kept_, run));
    }
    const int all = vtkXMLPDataObjectReader::SafeDownCast(reader_)->GetNumberOfPieces();
    const auto data = update([&] { reader_->UpdatePiece(run.begin, all, 0); });
    auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
    copy->ShallowCopy(data);  // The reader changes its own output when it reads the next piece.
    return withLinearCells(copy);
}

vtkSmartPointer<vtkDataObject> DataFile::read(const ProgressReport& progress, const char* what,
                                              const std::optional<std::array<int, 6>>& extent)
{
    if (own_) {
        progress(what, 0);
        announcedArrays();
        return withLinearCells(own_->read(kept_));
    }
    requireMemoryToRead(extent);
    if (!reader_) return withLinearCells(format_->read(path_, progress));
    ProgressTarget target{reader_, progress, what};
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(forwardProgress);
    observer->SetClientData(&target);
    const unsigned long tag = reader_->AddObserver(vtkCommand::ProgressEvent, observer);
    auto data = update([&] {
        if (extent && wholeExtent_) {
            std::array<int, 6> samples = *extent;
            reader_->UpdateExtent(samples.data());
        } else {
            reader_->Update();
        }
    });
    reader_->RemoveObserver(tag);
    return withLinearCells(data);
}

}  // namespace aeolic
