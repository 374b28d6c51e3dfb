#pragma once

#include <string>

namespace aeolic {

enum class FileUse { surface, field, any };

/// One kind of file that can be read, known by its extension. The help, the messages and the table in
/// docs/file-formats.md are made of these rows.
struct FileKind {
    const char* extension;  ///< ".vtp", in lower case. "" stands for a folder.
    FileUse use;            ///< `any`: either; the file's content decides.
    const char* kind;       ///< What is in it, as messages say it: "polygons".
    const char* format;     ///< "VTK XML polydata"
    const char* holds;      ///< Which vectors and scalars.
    const char* reader;     ///< Whose code reads it: "VTK" or "own".
    bool parts = false;     ///< --surface FILE:PART
    bool times = false;     ///< One such file can hold several.
};

inline constexpr FileKind fileKinds[] = {
    {"", FileUse::any, "an OpenFOAM case", "OpenFOAM case, its folder", "faces of patches, cells", "own, cells VTK",
     true, true},
    {".foam", FileUse::any, "an OpenFOAM case", "OpenFOAM case, by a file in its folder", "faces of patches, cells",
     "own, cells VTK", true, true},
    {".openfoam", FileUse::any, "an OpenFOAM case", "the same", "faces of patches, cells", "own, cells VTK", true,
     true},
    {".vtp", FileUse::surface, "polygons", "VTK XML polydata", "points, cells", "VTK", false, true},
    {".pvtp", FileUse::surface, "polygons", "VTK XML polydata in pieces", "points, cells", "VTK", false, false},
    {".vtm", FileUse::any, "a multi-block data set", "VTK XML multi-block, nested", "points, cells of its blocks",
     "own, blocks VTK", true, false},
    {".vtmb", FileUse::any, "a multi-block data set", "the same", "points, cells of its blocks", "own, blocks VTK",
     true, false},
    {".case", FileUse::any, "an EnSight case", "EnSight Gold case", "points, cells of its parts", "own", true, true},
    {".encas", FileUse::any, "an EnSight case", "the same", "points, cells of its parts", "own", true, true},
    {".cgns", FileUse::any, "a CGNS file", "CGNS in HDF5", "points, cells of its zones and boundaries", "own", true,
     true},
    {".e", FileUse::any, "an Exodus file", "Exodus II", "points, elements, sides of its blocks and side sets", "own",
     true, true},
    {".exo", FileUse::any, "an Exodus file", "the same", "points, elements, sides of its blocks and side sets", "own",
     true, true},
    {".ex2", FileUse::any, "an Exodus file", "the same", "points, elements, sides of its blocks and side sets", "own",
     true, true},
    {".exii", FileUse::any, "an Exodus file", "the same", "points, elements, sides of its blocks and side sets", "own",
     true, true},
    {".vtkhdf", FileUse::any, "a VTKHDF file", "VTKHDF: image, unstructured grid, polydata, or several",
     "points, cells of its blocks", "own", true, true},
    {".hdf", FileUse::any, "a VTKHDF file", "the same", "points, cells of its blocks", "own", true, true},
    {".tec", FileUse::any, "a Tecplot file", "Tecplot in text", "points, cells of its zones", "own", true, true},
    {".dat", FileUse::any, "a Tecplot file", "the same", "points, cells of its zones", "own", true, true},
    {".cas", FileUse::any, "a Fluent case", "Fluent case, with the .dat beside it", "cells and faces of its zones",
     "own", true, false},
    {".msh", FileUse::any, "a Fluent mesh", "Fluent mesh", "none", "own", true, false},
    {".stl", FileUse::surface, "triangles", "STL", "none", "VTK"},
    {".ply", FileUse::surface, "polygons", "PLY", "none", "own"},
    {".obj", FileUse::surface, "polygons", "Wavefront OBJ", "none", "VTK"},
    {".vtk", FileUse::any, "a legacy VTK file", "legacy VTK, polygons or a grid", "points, cells", "own"},
    {".vti", FileUse::field, "image data", "VTK XML uniform grid", "points, cells", "VTK", false, true},
    {".pvti", FileUse::field, "image data", "VTK XML uniform grid in pieces", "points, cells", "VTK"},
    {".nhdr", FileUse::field, "image data", "NRRD header beside raw values", "points", "VTK"},
    {".nrrd", FileUse::field, "image data", "NRRD header and raw values", "points", "VTK"},
    {".vtr", FileUse::field, "a rectilinear grid", "VTK XML rectilinear grid", "points, cells", "VTK", false, true},
    {".pvtr", FileUse::field, "a rectilinear grid", "VTK XML rectilinear grid in pieces", "points, cells", "VTK"},
    {".vts", FileUse::field, "a structured grid", "VTK XML curvilinear grid", "points, cells", "VTK", false, true},
    {".pvts", FileUse::field, "a structured grid", "VTK XML curvilinear grid in pieces", "points, cells", "VTK"},
    {".vtu", FileUse::field, "an unstructured grid", "VTK XML unstructured grid", "points, cells", "VTK", false, true},
    {".pvtu", FileUse::field, "an unstructured grid", "VTK XML unstructured grid in pieces", "points, cells", "VTK"},
};

/// The kind of a file by its extension, in upper or lower case; null where there is none. Never that of a folder.
const FileKind* fileKindOf(const std::string& path);

/// ".vtp .pvtp …, or an OpenFOAM case's folder": the kinds that fit the use.
std::string fileKindsText(FileUse use);

/// The text with "{surfaces}" and "{fields}" replaced by those lists.
std::string withFileKinds(std::string text);

/// The table of docs/file-formats.md, in Markdown.
std::string fileKindsTable();

}  // namespace aeolic
