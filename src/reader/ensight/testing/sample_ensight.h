#pragma once

/// A small EnSight Gold case for the tests; compiled into the tests only.

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "reader/ensight/ensight_stream.h"

namespace aeolic::test {

/// Text and numbers as they stand in an EnSight file.
class EnSightBytes {
public:
    explicit EnSightBytes(const EnSightFormat& format) : format_(format) {}

    EnSightBytes& text(const std::string& line);
    EnSightBytes& whole(const std::vector<int>& values);
    EnSightBytes& reals(const std::vector<float>& values);
    const std::string& bytes() const { return bytes_; }

private:
    void record(const void* data, std::size_t size);
    void word(std::uint32_t bits);

    EnSightFormat format_;
    std::string bytes_;
};

struct SampleElements {
    const char* kind;
    std::vector<std::vector<int>>
        cells;  ///< From 1. Of "nfaced": its faces, one after the other, each begun by its size.
};

struct SamplePart {
    const char* name;
    std::vector<glm::vec3> points;
    std::vector<SampleElements> elements;
};

constexpr int kSampleCells = 4;  ///< Of the box and of the walls, along each side.

SamplePart sampleFluid();  ///< A box of hexahedra, [0, 4]^3.
SamplePart sampleWalls();  ///< A bent sheet of quads, [0, 4]^2.
SamplePart sampleMixed();  ///< An element of each other kind, ghosts too, about (10, 0, 0).

/// Nodes have U = sampleFlow() and q; elements p = their number. In the part "walls", q is undefined at the first point
/// and p is there for the second element alone, if `gaps`.
struct SampleEnSight {
    EnSightFormat format = {};
    bool ids = false, extents = false, mixed = false, gaps = false;
    bool blocks = false;  ///< A part "slab" (curvilinear) and a part "cube" (uniform) more.
};

glm::vec3 sampleFlow(const glm::vec3& point, int step);

/// Writes box.case, box.geo, and for the times 0 and 1.5 U.0000, p.0000, q.0000, U.0001 …
void writeSampleEnSight(const std::string& folder, const SampleEnSight& sample = {});

/// The parts "fluid" and "walls" with U and p as a case of EnSight 6 in text: one list of points for all parts.
void writeSampleEnSight6(const std::string& folder);

}  // namespace aeolic::test
