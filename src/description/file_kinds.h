#pragma once

#include <string>

namespace aeolic {

enum class FileUse { surface, field, any };

/// One kind of file that can be read, known by its extension. The help, the messages and the table in
/// docs/file-formats.md are made of these rows.
struct FileKind {
    const char* extension;  ///< ".vtp", in lower case. "" stands for a folder.
    FileUse use;            ///< `any`: either, by what is in it.
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
    {".vtm", FileUse::surface, "a multi-block data set", "VTK XML multi-block, nested", "points, cells of its blocks",
     "VTK", true, false},
    {".case", FileUse::any, "an EnSight case", "EnSight Gold case", "points, cells of its parts", "own", true, true},
    {".encas", FileUse::any, "an EnSight case", "the same", "points, cells of its parts", "own", true, true},
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

/// ".vtp .pvtp …, or an OpenFOAM case's folder": the kinds that fit the use.
std::string fileKindsText(FileUse use);

/// The text with "{surfaces}" and "{fields}" replaced by those lists.
std::string withFileKinds(std::string text);

/// The table of docs/file-formats.md, in Markdown.
std::string fileKindsTable();

}  // namespace aeolic
