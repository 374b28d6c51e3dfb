#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/progress.h"
#include "data/reading/questions.h"
#include "description/file_kinds.h"
#include "reader/parts/part_source.h"
#include "reader/vtk/own_reader.h"

namespace aeolic {

/// What reads files of one kind. All throw InputError, which begins with the file's name. `time`: one of its times;
/// none: the first.
struct FormatReader {
    const char* endings;         ///< Those of the kind (description/file_kinds.h).
    std::uint64_t unpacked = 0;  ///< Bytes of memory that a byte of the file becomes at most; 0: nobody knows.

    // One of these four opens or reads files that hold data.
    std::unique_ptr<PartSource> (*openParts)(const std::string& path, std::optional<double> time) = nullptr;
    std::unique_ptr<OwnReader> (*open)(const std::string& path, FileUse use, std::optional<double> time) = nullptr;
    vtkSmartPointer<vtkAlgorithm> (*makeReader)() = nullptr;
    vtkSmartPointer<vtkDataObject> (*read)(const std::string& path, const ProgressReport& progress) = nullptr;

    /// Comes before the reader that makeReader() makes.
    void (*check)(const std::string& path, std::uint64_t fileBytes) = nullptr;

    // What can be asked of a file that is not opened for it.
    /// Points and polygons of a surface. Formats with kTellsCounts have it.
    std::optional<SurfaceCounts> (*counts)(const std::string& path) = nullptr;
    /// The times that the file tells. Formats with kNamesFiles have it. `arrays`: of these a time has
    /// to have each that any time has.
    std::vector<double> (*times)(const std::string& path, const std::vector<std::string>& arrays) = nullptr;
    /// The bytes of each piece, or 1 where nobody knows. Formats in pieces have it. `parts`: the parts that are meant.
    std::vector<std::uint64_t> (*pieces)(const std::string& path, FileUse use,
                                         const std::vector<std::string>& parts) = nullptr;
    std::vector<SeriesEntry> (*listed)(const std::string& path) = nullptr;                      ///< Of lists of files.
    FileSummary (*summary)(const std::string& path, const ProgressReport& progress) = nullptr;  ///< Null: by opening.
};

/// What reads the files of the kind.
const FormatReader& formatOf(const FileKind& kind);

/// The most bytes of memory that reading a sound file at `path` takes; the largest number where nobody knows.
std::uint64_t mostMemoryOf(const std::string& path);

/// The kind of the file or folder at `path`. Throws InputError where there is none that holds data, or none fit for
/// `use`.
const FileKind& chooseKind(const std::string& path, FileUse use);

}  // namespace aeolic
