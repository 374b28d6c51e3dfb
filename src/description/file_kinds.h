#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aeolic {

/// What a file is read for. The last two are uses of kinds alone: nothing is opened for them.
enum class FileUse : std::uint8_t { surface, field, any, list, colorMap };

/// What else there is to know of a kind of file before one is opened.
enum FileFact : unsigned {
    kHasParts = 1,     ///< --surface FILE:PART
    kHasTimes = 2,     ///< One such file can hold several.
    kHasBlocks = 4,    ///< Its parts are data sets of any kind.
    kTellsCounts = 8,  ///< Its header tells how many points and polygons there are.
    kNamesFiles = 16,  ///< Its values stand in other files: its own size says nothing, and it is asked for its times.
    kIsFolder = 32,    ///< It stands for the folder that it is in, which may be named itself.
    kHasMaps = 64,     ///< x and y are places on a map; z has another unit.
};

/// How files of a kind and pieces of a whole go together.
enum class FilePieces : std::uint8_t {
    none,
    piece,   ///< Such files can be the pieces of one volume.
    whole,   ///< It lies in pieces, and is read as one.
    apart,   ///< It lies in pieces that can be read one by one.
    joined,  ///< Likewise; points of two pieces at the same place are one.
};

/// One kind of file that can be read, known by its endings. The help, the messages and the table in
/// docs/file-formats.md are made of these rows, and `src/reader/vtk/format_registry.cpp` says what reads them.
struct FileKind {
    const char* endings;  ///< ".e .exo", in lower case, with a space between two.
    FileUse use;          ///< `any`: a surface or a field, by what is in it.
    const char* kind;     ///< What is in it, as messages say it: "polygons".
    const char* format;   ///< "VTK XML polydata"
    const char* holds;    ///< Which vectors and scalars.
    const char* reader;   ///< Whose code reads it: "VTK" or "own".
    unsigned facts = 0;
    FilePieces pieces = FilePieces::none;

    constexpr bool has(FileFact fact) const { return (facts & fact) != 0; }
    constexpr bool holdsData() const { return use <= FileUse::any; }
};

inline constexpr FileKind fileKinds[] = {
    {".foam .openfoam", FileUse::any, "an OpenFOAM case", "OpenFOAM case", "faces of patches, cells", "own",
     kHasParts | kHasTimes | kNamesFiles | kIsFolder, FilePieces::joined},
    {".vtp", FileUse::surface, "polygons", "VTK XML polydata", "points, cells", "VTK", kHasTimes | kTellsCounts},
    {".pvtp", FileUse::surface, "polygons", "VTK XML polydata in pieces", "points, cells", "VTK", 0, FilePieces::apart},
    {".vtm .vtmb", FileUse::any, "a multi-block data set", "VTK XML multi-block, nested", "points, cells of its blocks",
     "own, blocks VTK", kHasParts | kHasBlocks},
    {".vthb", FileUse::any, "an AMR data set", "VTK XML AMR, uniform grids in levels", "points, cells of its blocks",
     "own, blocks VTK", kHasParts | kHasBlocks},
    {".case .encas", FileUse::any, "an EnSight case", "EnSight case, Gold or 6", "points, cells of its parts",
     "own; VTK", kHasParts | kHasTimes | kNamesFiles},
    {".cgns", FileUse::any, "a CGNS file", "CGNS in HDF5 or ADF", "points, cells of its zones and boundaries", "own",
     kHasParts | kHasTimes},
    {".e .exo .ex2 .exii .g", FileUse::any, "an Exodus file", "Exodus II",
     "points, elements, sides of its blocks and side sets", "own", kHasParts | kHasTimes},
    {".vtkhdf .hdf", FileUse::any, "a VTKHDF file", "VTKHDF: image, unstructured grid, polydata, or several",
     "points, cells of its blocks", "own", kHasParts | kHasTimes},
    {".nc .nc4 .cdf", FileUse::field, "a netCDF grid", "netCDF grid of an ocean or the air (CF)", "points", "own",
     kHasTimes | kHasMaps},
    {".tec .dat .plt", FileUse::any, "a Tecplot file", "Tecplot in text", "points, cells of its zones", "own",
     kHasParts | kHasTimes},
    {".cas", FileUse::any, "a Fluent case", "Fluent case, with the .dat beside it", "cells and faces of its zones",
     "own", kHasParts},
    {".msh", FileUse::any, "a Fluent mesh", "Fluent mesh", "none", "own", kHasParts},
    {".stl", FileUse::surface, "triangles", "STL", "none", "VTK", kTellsCounts},
    {".ply", FileUse::surface, "polygons", "PLY", "none", "own", kTellsCounts},
    {".obj", FileUse::surface, "polygons", "Wavefront OBJ", "none", "own"},
    {".vtk", FileUse::any, "a legacy VTK file", "legacy VTK, polygons or a grid", "points, cells", "VTK"},
    {".vti", FileUse::field, "image data", "VTK XML uniform grid", "points, cells", "VTK", kHasTimes},
    {".pvti", FileUse::field, "image data", "VTK XML uniform grid in pieces", "points, cells", "VTK", 0,
     FilePieces::whole},
    {".nhdr", FileUse::field, "image data", "NRRD header beside raw values", "points", "VTK"},
    {".nrrd", FileUse::field, "image data", "NRRD header and raw values", "points", "VTK"},
    {".vtr", FileUse::field, "a rectilinear grid", "VTK XML rectilinear grid", "points, cells", "VTK", kHasTimes},
    {".pvtr", FileUse::field, "a rectilinear grid", "VTK XML rectilinear grid in pieces", "points, cells", "VTK", 0,
     FilePieces::whole},
    {".vts", FileUse::field, "a structured grid", "VTK XML curvilinear grid", "points, cells", "VTK", kHasTimes},
    {".pvts", FileUse::field, "a structured grid", "VTK XML curvilinear grid in pieces", "points, cells", "VTK", 0,
     FilePieces::whole},
    {".vtu", FileUse::any, "an unstructured grid", "VTK XML unstructured grid", "points, cells", "VTK", kHasTimes,
     FilePieces::piece},
    {".pvtu", FileUse::field, "an unstructured grid", "VTK XML unstructured grid in pieces", "points, cells", "VTK", 0,
     FilePieces::apart},
    {".pvd", FileUse::list, "a list of files", "ParaView's collection", "", "own"},
    {".series", FileUse::list, "a list of files", "ParaView's series", "", "own"},
    {".json .xml .csv", FileUse::colorMap, "a colour map", "ParaView's colours, or a table of them", "", "own"},
};
static_assert(fileKinds[0].has(kIsFolder));

/// The kind of what a folder holds.
inline constexpr const FileKind& folderKind = fileKinds[0];

/// The kind of a file by its ending, in upper or lower case, of ".e-s002", a later part of a run, by ".e"; null where
/// there is none. Never that of a folder.
const FileKind* fileKindOf(std::string_view path);

/// A kind of file that people bring and that is not read, and what reads it and writes one that is.
struct UnreadKind {
    const char* endings;  ///< ".xdmf .xmf", in lower case; a name may end in more than one: ".cas.h5".
    const char* format;   ///< "XDMF"
    const char* instead;  ///< "VTK's files, as ParaView saves them"
};

inline constexpr UnreadKind unreadKinds[] = {
    {".xdmf .xmf .xdmf2 .xmf2 .xdmf3", "XDMF",
     "VTK's files, as ParaView saves them (File > Save Data), or 'meshio convert NAME.xdmf NAME.vtu'"},
    {".cas.h5 .dat.h5 .msh.h5", "Fluent's format in HDF5",
     "the form before it (.cas and .dat), which Fluent writes after '/file/cff-files? no'"},
    {".cas.gz .dat.gz", "a packed Fluent case", "the case unpacked, as gunzip does it"},
    {".szplt", "Tecplot's SZL", "Tecplot in text (.dat), as Tecplot 360 writes it (File > Write Data)"},
    {".grib .grb .grib2 .grb2", "GRIB", "arrays in Python, as xarray with cfgrib gives them: aeolic.lic2d"},
    {".silo", "Silo", "VTK's files, as VisIt exports them"},
    {".bp", "ADIOS", "VTK's files, as ParaView saves them"},
    {".ccm .ccmg .sim", "STAR-CCM+", "CGNS or EnSight Gold, as STAR-CCM+ exports them"},
    {".res", "a CFX result", "CGNS or EnSight Gold, as CFD-Post exports them"},
    {".h5 .hdf5 .he5", "HDF5 of no kind that is known",
     "VTKHDF (.vtkhdf) or CGNS (.cgns): a name that ends so is read"},
    {".su2", "a mesh of SU2", "what SU2 writes with it: .vtu, .cgns or .dat"},
    {".inp .unv .bdf .nas", "a mesh of a structural code", "'meshio convert NAME NEW.vtu'"},
};

/// Null where the kind is read, or not known.
const UnreadKind* unreadKindOf(std::string_view path);

/// ".vtp .pvtp …, or an OpenFOAM case's folder": the endings of data for the use.
std::string fileKindsText(FileUse use);

/// The text with what fileKindsText() says of surfaces and of fields in the place of "{surfaces}" and "{fields}". It
/// has no other braces.
std::string withFileKinds(std::string_view text);

}  // namespace aeolic
