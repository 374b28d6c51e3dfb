#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "data/piece_run.h"
#include "data/vtk/arrays.h"
#include "description/file_kinds.h"
#include "reader/parts/part_source.h"

namespace aeolic {

/// A file, or a case's folder, that our own code reads at one of its times: first asked what it holds, then read with
/// the parts and arrays that are needed. Every failure is an InputError that begins with the file's name.
class OwnReader {
public:
    /// `path`: in front of messages.
    OwnReader(const std::string& path, FileUse use) : path_(path), use_(use) {}
    virtual ~OwnReader() = default;

    /// The arrays of the parts that are kept, where the file says it part by part.
    virtual const std::vector<ArrayInfo>& arrays() { return arrays_; }
    const std::vector<double>& times() const { return times_; }

    /// Empty: it is all one. Else read() gives a multi-block data set of the parts that are kept, in this order.
    virtual const std::vector<PartInfo>& parts() { return parts_; }

    /// Leaves out all parts but these (data/part_choice.h); empty: the usual ones.
    virtual void keepParts(const std::vector<std::string>& wanted) { wanted_ = wanted; }

    /// Throws InputError where one of these arrays is there at other times alone.
    virtual void requireAtTime(const std::vector<std::string>&) const {}

    /// Whether values are floats when they are read, whatever arrays() say, which depends on the parts that are kept.
    virtual bool readsFloats() const { return true; }

    /// The cells will be looked up as they are, polyhedra whole.
    virtual void keepPolyhedra() {}

    virtual vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) = 0;

    /// These of the pieces alone as one data set, perhaps an empty one. Where its polygons stand among those of all
    /// pieces may be told (kTrianglesPlaces).
    virtual vtkSmartPointer<vtkDataObject> readPieces(const std::vector<ArrayInfo>& kept, const PieceRun&)
    {
        return read(kept);
    }

protected:
    /// The numbers of the parts that are kept.
    std::vector<std::size_t> chosen() { return chosenParts(parts(), wanted_, use_, path_); }

    const std::string path_;
    const FileUse use_;
    std::vector<ArrayInfo> arrays_;
    std::vector<double> times_;
    std::vector<PartInfo> parts_;

private:
    std::vector<std::string> wanted_;
};

}  // namespace aeolic
