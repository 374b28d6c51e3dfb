#include "lattice.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace {

// Rest, the six faces, the twelve edges of a cube; each way is followed by the opposite one.
constexpr int kWay[19][3] = {{0, 0, 0},  {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},  {0, -1, 0}, {0, 0, 1},   {0, 0, -1},
                             {1, 1, 0},  {-1, -1, 0}, {1, -1, 0},  {-1, 1, 0}, {1, 0, 1},  {-1, 0, -1}, {1, 0, -1},
                             {-1, 0, 1}, {0, 1, 1},   {0, -1, -1}, {0, 1, -1}, {0, -1, 1}};
constexpr int opposite(int way)
{
    return way == 0 ? 0 : way % 2 ? way + 1 : way - 1;
}
constexpr float weight(int way)
{
    return way == 0 ? 1.0F / 3 : way < 7 ? 1.0F / 18 : 1.0F / 36;
}

float equilibrium(int way, float density, const float u[3])
{
    const float along = float(kWay[way][0]) * u[0] + float(kWay[way][1]) * u[1] + float(kWay[way][2]) * u[2];
    const float square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    return weight(way) * density * (1 + 3 * along + 4.5F * along * along - 1.5F * square);
}

}  // namespace

Lattice::Lattice(const Options& options, MPI_Comm ranks) : options_(options), ranks_(ranks)
{
    int rank = 0, count = 1;
    MPI_Comm_rank(ranks, &rank);
    MPI_Comm_size(ranks, &count);
    const int layers = options.size[2];
    if (layers < 2 * count)
        throw std::invalid_argument("the last number of --size has to be twice the number of ranks");
    first_ = int(std::int64_t(layers) * rank / count);
    end_ = int(std::int64_t(layers) * (rank + 1) / count);
    if (rank > 0) below_ = rank - 1;
    if (rank + 1 < count) above_ = rank + 1;
    layer_ = std::size_t(options.size[0]) * std::size_t(options.size[1]);
    cells_ = layer_ * std::size_t(end_ - first_ + 2);
    for (int way = 0; way < kWays; ++way) {
        now_[std::size_t(way)].resize(cells_);
        next_[std::size_t(way)].resize(cells_);
    }
    velocity_.resize(3 * cells_);
    solid_.resize(cells_);
    setToRest();
}

void Lattice::setToRest()
{
    const float inflow[3] = {0, 0, options_.inflow};
    for (int z = first_ - 1; z <= end_; ++z)
        for (int y = 0; y < options_.size[1]; ++y)
            for (int x = 0; x < options_.size[0]; ++x) {
                const float dy = float(y) - centerY(), dz = float(z) - centerZ();
                const std::size_t cell = at(x, y, z);
                solid_[cell] = dy * dy + dz * dz < radius() * radius();
                for (int k = 0; k < 3; ++k) velocity_[3 * cell + std::size_t(k)] = solid_[cell] ? 0 : inflow[k];
                for (int way = 0; way < kWays; ++way)
                    now_[std::size_t(way)][cell] = equilibrium(way, 1, &velocity_[3 * cell]);
            }
}

/// The layers beside this rank's own are what its neighbours have there.
void Lattice::exchange(std::vector<float>& values, int components)
{
    const std::size_t layer = layer_ * std::size_t(components);
    float *lowest = values.data(), *first = lowest + layer;
    float *last = lowest + layer * std::size_t(end_ - first_), *highest = last + layer;
    MPI_Sendrecv(last, int(layer), MPI_FLOAT, above_, 0, lowest, int(layer), MPI_FLOAT, below_, 0, ranks_,
                 MPI_STATUS_IGNORE);
    MPI_Sendrecv(first, int(layer), MPI_FLOAT, below_, 1, highest, int(layer), MPI_FLOAT, above_, 1, ranks_,
                 MPI_STATUS_IGNORE);
}

void Lattice::step()
{
    for (int way = 0; way < kWays; ++way)
        if (kWay[way][2] != 0) exchange(now_[std::size_t(way)], 1);
    streamAndCollide();
    now_.swap(next_);
    setEnds();
    exchange(velocity_, 3);
}

void Lattice::streamAndCollide()
{
    const float rate = 1 / (3 * options_.viscosity + 0.5F);
    const int nx = options_.size[0];
    for (int z = first_; z < end_; ++z)
        for (int y = 0; y < options_.size[1]; ++y) {
            const bool open = isOpen(y, z);
            if (open) stepRow(y, z, rate);
            for (int x = 0; x < nx; x += open ? nx - 1 : 1) stepCell(x, y, z, rate);
        }
}

/// Whether the row and those around it are all fluid, and do not go round.
bool Lattice::isOpen(int y, int z) const
{
    if (y == 0 || y + 1 == options_.size[1]) return false;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            if (solid_[at(0, y + dy, z + dz)]) return false;
    return true;
}

/// Each cell takes what comes from its neighbours, what hits the cylinder comes back, and all of it relaxes towards its
/// equilibrium. x and y go round.
void Lattice::stepCell(int x, int y, int z, float rate)
{
    const int nx = options_.size[0], ny = options_.size[1];
    const std::size_t cell = at(x, y, z);
    if (solid_[cell]) return;
    float in[kWays], density = 0, u[3] = {0, 0, 0};
    for (int way = 0; way < kWays; ++way) {
        const int fx = x - kWay[way][0], fy = y - kWay[way][1];
        const std::size_t from = at(fx < 0     ? nx - 1
                                    : fx == nx ? 0
                                               : fx,
                                    fy < 0     ? ny - 1
                                    : fy == ny ? 0
                                               : fy,
                                    z - kWay[way][2]);
        in[way] = solid_[from] ? now_[std::size_t(opposite(way))][cell] : now_[std::size_t(way)][from];
        density += in[way];
        for (int k = 0; k < 3; ++k) u[k] += in[way] * float(kWay[way][k]);
    }
    for (int k = 0; k < 3; ++k) velocity_[3 * cell + std::size_t(k)] = u[k] /= density;
    for (int way = 0; way < kWays; ++way)
        next_[std::size_t(way)][cell] = in[way] + rate * (equilibrium(way, density, u) - in[way]);
}

/// The same for the cells of an open row but for its ends, many at once.
void Lattice::stepRow(int y, int z, float rate)
{
    const std::size_t nx = std::size_t(options_.size[0]), row = at(0, y, z);
    thread_local std::vector<float> sums;
    sums.assign(4 * nx, 0);
    float *density = sums.data(), *ux = density + nx, *uy = ux + nx, *uz = uy + nx;
    const auto comingIn = [&](int way) {
        return &now_[std::size_t(way)][at(0, y - kWay[way][1], z - kWay[way][2])] - kWay[way][0];
    };
    for (int way = 0; way < kWays; ++way) {
        const float *in = comingIn(way), wx = float(kWay[way][0]), wy = float(kWay[way][1]), wz = float(kWay[way][2]);
        for (std::size_t x = 1; x + 1 < nx; ++x) {
            density[x] += in[x];
            ux[x] += in[x] * wx;
            uy[x] += in[x] * wy;
            uz[x] += in[x] * wz;
        }
    }
    for (std::size_t x = 1; x + 1 < nx; ++x) {
        float* v = &velocity_[3 * (row + x)];
        v[0] = ux[x] /= density[x];
        v[1] = uy[x] /= density[x];
        v[2] = uz[x] /= density[x];
    }
    for (int way = 0; way < kWays; ++way) {
        const float* in = comingIn(way);
        float* out = &next_[std::size_t(way)][row];
        const float wx = float(kWay[way][0]), wy = float(kWay[way][1]), wz = float(kWay[way][2]), part = weight(way);
        for (std::size_t x = 1; x + 1 < nx; ++x) {
            const float along = wx * ux[x] + wy * uy[x] + wz * uz[x];
            const float square = ux[x] * ux[x] + uy[x] * uy[x] + uz[x] * uz[x];
            const float rest = part * density[x] * (1 + 3 * along + 4.5F * along * along - 1.5F * square);
            out[x] = in[x] + rate * (rest - in[x]);
        }
    }
}

/// The fluid comes in at the first layer, and leaves behind the last one as it is there.
void Lattice::setEnds()
{
    const float inflow[3] = {0, 0, options_.inflow};
    for (int y = 0; y < options_.size[1]; ++y)
        for (int x = 0; x < options_.size[0]; ++x) {
            if (below_ == MPI_PROC_NULL) {
                std::copy(inflow, inflow + 3, &velocity_[3 * at(x, y, first_)]);
                for (int way = 0; way < kWays; ++way)
                    for (const int z : {first_ - 1, first_})
                        now_[std::size_t(way)][at(x, y, z)] = equilibrium(way, 1, inflow);
            }
            if (above_ == MPI_PROC_NULL)
                for (int way = 0; way < kWays; ++way)
                    now_[std::size_t(way)][at(x, y, end_)] = now_[std::size_t(way)][at(x, y, end_ - 1)];
        }
}
