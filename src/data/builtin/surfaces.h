#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/mesh/surface_mesh.h"
#include "description/builtin_names.h"

namespace aeolic {

/// A surface that needs no file: NAME[:TRIANGLES], TRIANGLES from 2 to 50,000,000.
///
/// | name   | what                                                            | default triangles |
/// |--------|-----------------------------------------------------------------|-------------------|
/// | teapot | Newell's teapot with a bottom, z up, as long as the data (6.43) | 25,000            |
/// | sphere | radius 1                                                        | 25,000            |
/// | torus  | around z, radii 1 and 0.4                                       | 25,000            |
/// | plane  | [-1, 1] x [-1, 1] at z = 0, normal +z                           | 512               |
/// | wave   | [-1, 1] x [-1, 1], z = 0.1 sin(2 pi (x - t / 5)) at time t       | 25,000            |
///
/// TRIANGLES is rounded up to the next even tessellation, never down: the teapot has 64 n^2 - 8 n triangles (n >= 2 per
/// patch edge), plane and wave 2 n^2, sphere and torus 1 or 2 percent more than asked at 25,000 and above. Normals are
/// those of the exact surface; triangles turn counter-clockwise seen from outside. Sphere, torus, plane and wave share
/// their points; the teapot's patches each have their own, and where patches meet the positions are equal bit by bit.
///
/// Throws InputError for an unknown name, a bad count, or a mesh larger than the available memory.
/// Cost: parallel, 10 to 50 million triangles a second and core.
SurfaceMesh makeBuiltinSurface(const std::string& spec, double time = 0);

/// How many triangles it has, at least. It has half as many points or more. Throws InputError for a bad `spec`.
std::uint64_t builtinSurfaceTriangles(const std::string& spec);

/// Moments to choose from, over a period; none for a surface that stands still. Any other moment can be had as well.
std::vector<double> builtinSurfaceTimes(const std::string& spec);

/// The bounds within which it stays at all times. `mesh`: one moment of it.
Bounds builtinSurfaceBounds(const std::string& spec, const SurfaceMesh& mesh);

}  // namespace aeolic
