#pragma once

/// Small data files for the tests, with known contents; compiled into the tests only.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace aeolic::test {

/// A folder of its own, removed at the end.
class TempFolder {
public:
    TempFolder();
    ~TempFolder();
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

enum class Encoding { raw, zlib, ascii };

/// A box of samples of U = (1 + x, 2 y, x - z) and p = x + 10 y + 100 z: linear, so that any interpolation is exact.
struct GridSample {
    std::array<int, 3> dims{9, 8, 7};
    std::array<double, 3> origin{-1, -0.5, 0.25}, spacing{0.25, 0.25, 0.25};
    Encoding encoding = Encoding::raw;
    bool doubles = false;
    bool onCells = false;  ///< Arrays on the cells, sampled at their centres.
    bool turned = false;   ///< A direction matrix: 90 degrees about z.
    double stretch = 0;    ///< Coordinates x -> x + stretch * x^2 where the kind of grid allows it.
    std::vector<int> nanPoints, infinitePoints, maskedPoints, hiddenPoints;
    double hiddenBeyondX = 1e30;        ///< vtkGhostType hides the points, or …
    bool hidesCells = false;            ///< … the cells whose middle is farther in x.
    bool hexahedra = false;             ///< A .vtu has these instead of tetrahedra.
    std::vector<std::string> leaveOut;  ///< "U" or "p".
    int components = 3;                 ///< How many U has.
    bool secondVectors = false;         ///< A second array of three components, "W", and none active.
    double scale = 1;                   ///< U and p are multiplied by it.
    int legacyKind = 0;  ///< What a .vtk holds: 0 structured points, 1 rectilinear, 2 structured, 3 unstructured.
};

std::array<double, 3> sampleVector(double x, double y, double z);
double sampleScalar(double x, double y, double z);

/// Writes the format of the extension: .vti .vtr .vts .vtu .vtk .pvti .pvtr .pvts .pvtu.
void writeGridFile(const std::string& path, const GridSample& sample = {});

/// One .vti with several time steps, 0, 1, 2 ….
void writeGridSteps(const std::string& path, const std::vector<GridSample>& samples);

/// A sheet of n x n quads on [0, 1]^2 at z = 0.1 x, with tau = (1, x, 0.1) and q = x + y on its points, and cellTau =
/// (2, 0, 0.2), cellQ = the quad's number on its cells.
struct SheetSample {
    enum class Cells { triangles, quads, strips, lines, vertices };
    Cells cells = Cells::quads;
    int n = 4;
    Encoding encoding = Encoding::raw;
    bool arrays = true, normals = false, allNan = false, badIndex = false;
    int tauComponents = 3;
    std::vector<int> nanPoints;
    int degenerate = 0;  ///< Triangles with a repeated point, added.
    std::array<double, 3> shift{0, 0, 0};
    double twist = 0;  ///< z is more by this times x * y: bent quads, whose shorter diagonal goes by the sign.
    double scale = 1;  ///< tau, q, cellTau and cellQ are multiplied by it.
};

/// Writes the format of the extension: .vtp .pvtp .vtm (of two sheets side by side, the second shifted by (1, 0, 0.1))
/// .stl .ply .obj .vtk.
void writeSheetFile(const std::string& path, const SheetSample& sample = {});

/// Rows from top to bottom, as decoded by VTK.
struct DecodedPng {
    int width = 0, height = 0, channels = 0;
    std::vector<unsigned char> pixels;
};
DecodedPng readPng(const std::string& path);

std::string readBytes(const std::string& path);
void writeBytes(const std::string& path, const std::string& bytes);

}  // namespace aeolic::test
