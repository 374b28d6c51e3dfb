#pragma once

#include <aeolic/data.h>

#include <array>
#include <string>
#include <vector>

#include "lattice.h"

/// What is drawn of the fluid: a sheet across it, x = constant, and the cylinder's wall with the flow beside it. Each
/// rank has the triangles whose lowest corner lies in its layers. Lengths are cells.
class Sheets {
public:
    Sheets(const Lattice& lattice, MPI_Comm ranks);

    /// Collective. The velocities of now.
    void update(const Lattice& lattice);

    /// This rank's piece. Its arrays stay where they are.
    aeolic::Data data() const;

    /// Collective. Writes what data() shows: a piece for each rank, and FOLDER/NAME.pvtp, which names them.
    void write(const std::string& folder, const std::string& name) const;

private:
    void addSheet(const Lattice& lattice);
    void addWall(const Lattice& lattice);

    MPI_Comm ranks_;
    std::vector<float> points_, velocities_;     ///< [points][3]
    std::vector<std::array<float, 3>> samples_;  ///< [points of the wall]: where their flow is looked up.
    std::vector<int> wallPoints_;          ///< [points of the wall]: as which point this rank has them; -1: it has not.
    std::vector<std::int64_t> triangles_;  ///< [triangles][3]
};
