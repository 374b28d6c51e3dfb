#include "reader/cgns/testing/sample_cgns_writer_testing.h"

namespace aeolic::test {
namespace {

class ElementsWriter {
public:
    ElementsWriter(const CgnsFile& file, const SampleCgns& sample) : file_(file), sample_(sample) {}

    std::array<cgsize_t, 3> write()
    {
        if (sample_.cells == SampleCgns::Cells::polyhedra)
            writePolyhedra();
        else
            writeHexahedra();
        return begins_;
    }

private:
    static std::vector<cgsize_t> hexahedron(int i, int j, int k)
    {
        std::vector<cgsize_t> corners;
        for (const int up : {0, 1})
            for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                corners.push_back(pointNumber(i + a, j + b, k + up));
        return corners;
    }

    template <class Take>
    static void forEachCell(const Take& take)
    {
        for (int k = 0; k < kCells; ++k)
            for (int j = 0; j < kCells; ++j)
                for (int i = 0; i < kCells; ++i) take(hexahedron(i, j, k));
    }

    int section(const char* name, CGNS_ENUMT(ElementType_t) type, cgsize_t count, const std::vector<cgsize_t>& corners,
                const std::vector<cgsize_t>& offsets = {})
    {
        int number = 0;
        if (offsets.empty())
            sound(cg_section_write(file_.file_, file_.base_, file_.zone_, name, type, next_, next_ + count - 1, 0,
                                   corners.data(), &number));
        else
            sound(cg_poly_section_write(file_.file_, file_.base_, file_.zone_, name, type, next_, next_ + count - 1, 0,
                                        corners.data(), offsets.data(), &number));
        next_ += count;
        return number;
    }

    /// The two cells of a face are written where `parents` says so; 0: none.
    void parents(int number, const std::vector<cgsize_t>& first, const std::vector<cgsize_t>& second) const
    {
        if (!sample_.parents) return;
        std::vector<cgsize_t> all(first);
        all.insert(all.end(), second.begin(), second.end());
        all.resize(4 * first.size());
        sound(cg_parent_data_write(file_.file_, file_.base_, file_.zone_, number, all.data()));
    }

    void writeHexahedra()
    {
        std::vector<cgsize_t> corners, offsets{0};
        const bool mixed = sample_.cells == SampleCgns::Cells::mixed;
        forEachCell([&](const std::vector<cgsize_t>& cell) {
            if (mixed) corners.push_back(CGNS_ENUMV(HEXA_8));
            corners.insert(corners.end(), cell.begin(), cell.end());
            offsets.push_back(cgsize_t(corners.size()));
        });
        constexpr cgsize_t count = kCells * kCells * kCells;
        if (mixed)
            section("cells", CGNS_ENUMV(MIXED), count, corners, offsets);
        else
            section("cells", CGNS_ENUMV(HEXA_8), count, corners);
        for (int side = 0; side < 3 && sample_.faces; ++side) {
            corners.clear();
            std::vector<cgsize_t> first;
            for (int b = 0; b < kCells; ++b)
                for (int a = 0; a < kCells; ++a) {
                    for (const auto& [da, db] :
                         {std::pair{0, 0}, {side == 1, side != 1}, {1, 1}, {side != 1, side == 1}})
                        corners.push_back(side == 2 ? pointNumber(0, a + da, b + db)
                                                    : pointNumber(a + da, b + db, side == 0 ? 0 : kCells));
                    first.push_back(side == 2 ? 1 + kCells * (a + kCells * b)
                                              : 1 + a + kCells * (b + (side == 0 ? 0 : kCells * (kCells - 1))));
                }
            const char* names[] = {"floorFaces", "lidFaces", "inletFaces"};
            begins_[std::size_t(side)] = next_;
            const int number = section(names[side], CGNS_ENUMV(QUAD_4), kCells * kCells, corners);
            parents(number, first, std::vector<cgsize_t>(first.size(), 0));
        }
    }

    /// Faces across x, then y, then z, of which the first and last layers are the sides. The sides that are boundaries
    /// are runs: inlet (x = 0), floor (z = 0), lid (z = 4).
    void writePolyhedra()
    {
        std::vector<cgsize_t> corners, offsets{0}, first, second;
        std::vector<std::vector<cgsize_t>> cellFaces(kCells * kCells * kCells);
        constexpr cgsize_t faces = 3 * kPoints * kCells * kCells;
        for (int d = 0; d < 3; ++d)
            for (int layer = 0; layer < kPoints; ++layer) {
                if (layer == 0 && d == 0) begins_[2] = cgsize_t(offsets.size());
                if (layer == 0 && d == 2) begins_[0] = cgsize_t(offsets.size());
                if (layer == kCells && d == 2) begins_[1] = cgsize_t(offsets.size());
                for (int b = 0; b < kCells; ++b)
                    for (int a = 0; a < kCells; ++a) {
                        const auto number = cgsize_t(offsets.size());
                        const auto at = [&](int along, int da, int db) {
                            int place[3];
                            place[d] = along;
                            place[(d + 1) % 3] = d == 1 ? b + db : a + da;
                            place[(d + 2) % 3] = d == 1 ? a + da : b + db;
                            return std::array<int, 3>{place[0], place[1], place[2]};
                        };
                        const int turn[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                        for (int k = 0; k < 4; ++k) {
                            const auto& t = (d == 1) != (layer == 0 && !sample_.turned) ? turn[(4 - k) % 4] : turn[k];
                            const auto p = at(layer, t[0], t[1]);
                            corners.push_back(pointNumber(p[0], p[1], p[2]));
                        }
                        offsets.push_back(cgsize_t(corners.size()));
                        const auto cellAt = [&](int along) -> cgsize_t {
                            if (along < 0 || along >= kCells) return 0;
                            const auto p = at(along, 0, 0);
                            return 1 + p[0] + kCells * (p[1] + kCells * p[2]);
                        };
                        const cgsize_t before = cellAt(layer - 1), behind = cellAt(layer);
                        if (before > 0) cellFaces[std::size_t(before - 1)].push_back(number);
                        if (behind > 0)
                            cellFaces[std::size_t(behind - 1)].push_back(before > 0 || sample_.turned ? -number
                                                                                                      : number);
                        const bool outer = before == 0;
                        first.push_back(faces + (outer ? behind : before));
                        second.push_back(outer || behind == 0 ? 0 : faces + behind);
                    }
            }
        const int number = section("faces", CGNS_ENUMV(NGON_n), faces, corners, offsets);
        parents(number, first, second);
        corners.clear();
        offsets = {0};
        for (const auto& cell : cellFaces) {
            corners.insert(corners.end(), cell.begin(), cell.end());
            offsets.push_back(cgsize_t(corners.size()));
        }
        section("cells", CGNS_ENUMV(NFACE_n), cgsize_t(cellFaces.size()), corners, offsets);
    }

    const CgnsFile& file_;
    const SampleCgns& sample_;
    cgsize_t next_ = 1;
    std::array<cgsize_t, 3> begins_{};  // Of the faces of floor, lid and inlet.
};

}  // namespace

std::array<cgsize_t, 3> writeBoxElements(const CgnsFile& file, const SampleCgns& sample)
{
    return ElementsWriter(file, sample).write();
}

}  // namespace aeolic::test
