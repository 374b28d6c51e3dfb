#pragma once

#include <mpi.h>

#include <array>
#include <cstdint>
#include <vector>

/// A fluid that flows along +z past a cylinder, which lies along x: the lattice Boltzmann method with 19 velocities and
/// one relaxation time (BGK; Krüger et al., The Lattice Boltzmann Method, 2017). Lengths are cells, times are steps.
/// Each rank has some of the layers of constant z, and one more on both sides that are its neighbours'.
class Lattice {
public:
    struct Options {
        std::array<int, 3> size{32, 96, 256};
        float inflow = 0.08F;     ///< Cells a step.
        float viscosity = 0.02F;  ///< Square cells a step.
    };
    Lattice(const Options& options, MPI_Comm ranks);

    /// Collective. One step of time.
    void step();
    void setInflow(float inflow) { options_.inflow = inflow; }

    const std::array<int, 3>& size() const { return options_.size; }
    int firstLayer() const { return first_; }  ///< Of this rank.
    int endLayer() const { return end_; }      ///< Behind its last.

    /// Cells a step, after the last step. `z` may be this rank's own or the next layer. Inside the cylinder: 0.
    const float* velocity(int x, int y, int z) const { return &velocity_[3 * at(x, y, z)]; }

    float centerY() const
    {
        return float(options_.size[1]) / 2 + 1;
    }  ///< Off the middle, so that the wake begins to swing.
    float centerZ() const { return float(options_.size[2]) / 4; }
    float radius() const { return float(options_.size[1]) / 10; }

private:
    static constexpr int kWays = 19;

    std::size_t at(int x, int y, int z) const
    {
        return (std::size_t(z - first_ + 1) * std::size_t(options_.size[1]) + std::size_t(y)) *
                   std::size_t(options_.size[0]) +
               std::size_t(x);
    }
    void exchange(std::vector<float>& values, int components);
    void setToRest();
    bool isOpen(int y, int z) const;
    void streamAndCollide();
    void stepCell(int x, int y, int z, float rate);
    void stepRow(int y, int z, float rate);
    void setEnds();

    Options options_;
    MPI_Comm ranks_;
    int first_ = 0, end_ = 0, below_ = MPI_PROC_NULL, above_ = MPI_PROC_NULL;
    std::size_t cells_ = 0, layer_ = 0;
    std::array<std::vector<float>, kWays> now_, next_;
    std::vector<float> velocity_;
    std::vector<std::uint8_t> solid_;
};
