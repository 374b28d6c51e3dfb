#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/loaded_surface.h"
#include "data/reading/questions.h"

/// What is asked of files that are not opened for their values. Another process looks (data/reading/reader_pool.h), and
/// nothing that it answers is used unchecked. Every failure is an InputError that begins with the file's name.
namespace aeolic {

/// The files that a list names (.pvd, .series), in its order. Whether they are there and times make sense is not judged
/// here.
std::vector<SeriesEntry> listedFiles(const std::string& path);

/// The times of a case whose values stand in other files; empty where nothing changes. `arrays`: only those times with
/// all of these arrays that are there at any time; an empty name stands for none.
std::vector<double> timesOfCase(const std::string& path, const std::vector<std::string>& arrays = {});

/// Bytes of each file that a .pvtp names as a piece; empty for any other file. Throws where one is missing.
std::vector<std::uint64_t> pieceBytesOf(const std::string& path);

/// Bytes of each piece in which a volume of cells lies on disk (.pvtu, a decomposed case), or of each of the same size
/// where they are not counted; empty where it is whole. Throws where one is missing.
std::vector<std::uint64_t> volumePiecesOf(const std::string& path);

/// The pieces in which a surface lies on disk, and can be read one by one.
struct SurfacePieces {
    Pieces lies = Pieces::none;
    std::vector<std::uint64_t> bytes;  ///< Of each, likewise. Empty where they are apart: pieceBytesOf() tells it.
};
SurfacePieces piecesOfSurface(const std::string& path, const std::vector<std::string>& parts);

/// The counts in the header of a surface's file (.vtp, .ply, binary .stl); nothing for other files. Throws for a file
/// that cannot be read.
std::optional<SurfaceCounts> surfaceCountsOf(const std::string& path);

/// Reads all of the file; of an OpenFOAM case no more than its patches, at its first time. Throws what loading would
/// throw.
FileSummary summarizeFile(const std::string& path);

/// The points of a colour map in ParaView's XML, whose text has been read. `path` stands in front of messages.
ColorPoints colorPointsFromXml(const std::string& text, const std::string& path);

}  // namespace aeolic
