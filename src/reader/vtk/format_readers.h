#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "data/progress.h"
#include "data/reading/questions.h"
#include "reader/vtk/own_reader.h"

/// The readers of single formats that give VTK's data (format_registry.h). `time`: one of the file's times; none: the
/// first. All throw InputError, which begins with the file's name.
namespace aeolic {

/// A case of EnSight 6 by VTK's reader. Our own reads those of EnSight Gold.
std::unique_ptr<OwnReader> openEnSight6(const std::string& path, FileUse use, std::optional<double> time);

/// A VTK XML multi-block file (.vtm, .vtmb): a tree of names over files, some of which may be such files themselves.
/// Only the files of blocks that are wanted are opened. A block that lacks an array which others have gets one of NaN.
/// Such a file has no times.
std::unique_ptr<OwnReader> openMultiBlock(const std::string& path, FileUse use, std::optional<double> time);

/// A netCDF file of grids, as models of oceans and of the air write them. A file may hold several grids: what is read
/// is the one that the arrays which are kept need.
std::unique_ptr<OwnReader> openNetcdfGrid(const std::string& path, FileUse use, std::optional<double> time);

/// A VTKHDF file: image data, an unstructured grid or polygons, or several of them as parts.
std::unique_ptr<OwnReader> openVtkHdf(const std::string& path, FileUse use, std::optional<double> time);

/// VTK's reader of NRRD files, for headers that VTK 9.1 misunderstands: one whose last line has no end keeps it busy
/// for ever, and a space before the sizes takes the components for an axis. It refuses headers without a type, with
/// sizes or spacings that are none, and values that are not raw.
vtkSmartPointer<vtkAlgorithm> makeNrrdReader();

/// The counts in the header of a surface's file: of VTK's XML, of PLY, of binary STL; nothing where it tells none.
std::optional<SurfaceCounts> countsOfXml(const std::string& path);
std::optional<SurfaceCounts> countsOfPly(const std::string& path);
std::optional<SurfaceCounts> countsOfStl(const std::string& path);

/// VTK takes what is left of an STL file that was cut off for a smaller surface. Throws InputError unless the file is
/// as long as its header says, or is text with a last line.
void checkStl(const std::string& path, std::uint64_t fileBytes);

/// Reads a legacy VTK file (.vtk) of polygons or a grid, in text or binary, with all its arrays.
vtkSmartPointer<vtkDataObject> readLegacy(const std::string& path, const ProgressReport& progress);

/// Reads a Wavefront OBJ file: vertices, faces, and normals where every face has them, or none and there are as many
/// as vertices. A corner with a normal or a texture of another number than its vertex makes every corner a point of its
/// own. Groups and materials of the faces become arrays of numbers. Lines, points and textures are skipped.
///
/// Throws InputError, which names the line, where a vertex has no three numbers or a face refers to what is not there.
vtkSmartPointer<vtkDataObject> readObj(const std::string& path, const ProgressReport& progress);

/// Reads a PLY file (Greg Turk, "The PLY Polygon File Format", 1994): text or binary of either byte order. Vertices x,
/// y, z, normals nx, ny, nz, the faces' vertex_indices (or vertex_index); every other number of a vertex or face
/// becomes a float array of its name. Anything else is skipped.
///
/// Our own, alone among the formats, because VTK 9.1's reader frees memory twice or reads outside of it where a file is
/// cut off, lacks a property or has an index out of range. Throws InputError where the file ends early or a number
/// makes no sense.
vtkSmartPointer<vtkDataObject> readPly(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
