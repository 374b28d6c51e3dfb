#pragma once

/// Files of surfaces in pieces and of fields to cut surfaces out of, as text; for tests that know no VTK, too.

#include <string>
#include <vector>

namespace aeolic::testkit {

/// A torus about (1000.3, -20, 5), cut into wedges that share borders but no points, one .vtp each.
struct TorusPieces {
    int pieces = 4, aroundWedge = 6, aroundTube = 14;
    double size = 1;
    std::vector<int> empty;           ///< Wedges that are there, without points.
    int strips = -1;                  ///< The wedge that comes as triangle strips after its first two rows of polygons.
    bool onCells = false;             ///< Vectors and scalars on the cells.
    bool normals = false;             ///< Come with the file, but for a zero …
    int brokenNormal = -1;            ///< … in this wedge.
    int noArea = -1, notFinite = -1;  ///< Wedges with a triangle of no area, and with one of a point that is nowhere.
    int otherArrays = -1;             ///< The wedge whose arrays have other names.
};

/// Writes FOLDER/NAME.pvtp, with vectors "tau" and a scalar "q", and FOLDER/NAME_0.vtp …. Returns the former's path.
std::string writeTorusPieces(const std::string& folder, const std::string& name, const TorusPieces& torus = {});

/// A grid of 19 x 17 x 15 samples from (9, -7, 3) with vectors "U" and a scalar "p" whose isosurface at 0.1 winds
/// through all of it, in a .vti; `masked`: a box of samples in the middle that are not a number. `phase` moves it.
void writeWindingField(const std::string& path, bool masked = false, double phase = 0);

}  // namespace aeolic::testkit
