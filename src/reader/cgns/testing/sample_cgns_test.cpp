#include "reader/cgns/testing/sample_cgns.h"

#include <algorithm>
#include <filesystem>

#include "reader/cgns/testing/sample_cgns_writer_testing.h"

namespace aeolic::test {
namespace {

class Box {
public:
    Box(CgnsFile& file, const SampleCgns& sample, const char* name, double shift)
        : file_(file), sample_(sample), name_(name), shift_(shift)
    {
        structured_ = sample.cells == SampleCgns::Cells::structured;
    }

    void write()
    {
        if (structured_)
            file_.zone(name_, {kPoints, kPoints, kPoints, kCells, kCells, kCells, 0, 0, 0}, true);
        else
            file_.zone(name_, {kPoints * kPoints * kPoints, kCells * kCells * kCells, 0}, false);
        writePoints();
        if (!structured_) begins_ = writeBoxElements(file_, sample_);
        for (int step = 0; step < std::max(sample_.steps, 1); ++step) writeSolutions(step);
        if (shift_ == 0) writeBoundaries();
        if (sample_.steps > 0) writePointers();
        if (sample_.onFaces) writeRegion();
    }

private:
    int layer() const { return sample_.rind && structured_ ? 1 : 0; }

    std::vector<cgsize_t> shape(int length) const
    {
        if (!structured_) return {cgsize_t(length) * length * length};
        return std::vector<cgsize_t>(3, length + 2 * layer());
    }

    void writeRind() const
    {
        const int layers[] = {1, 1, 1, 1, 1, 1};
        if (layer() > 0) sound(cg_rind_write(layers));
    }

    void writePoints() const
    {
        int grid = 0;
        sound(cg_grid_write(file_.file_, file_.base_, file_.zone_, "GridCoordinates", &grid));
        file_.go({{"Zone_t", file_.zone_}, {"GridCoordinates_t", 1}});
        writeRind();
        const auto points = boxPoints(shift_, layer());
        const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
        for (int c = 0; c < 3; ++c) file_.array(names[c], component(points, c), shape(kPoints), sample_.doubles);
    }

    void writeSolutions(int step) const
    {
        const std::string at = sample_.steps > 0 ? std::to_string(step) : "";
        int solution = 0;
        sound(cg_sol_write(file_.file_, file_.base_, file_.zone_, ("Points" + at).c_str(), CGNS_ENUMV(Vertex),
                           &solution));
        file_.go({{"Zone_t", file_.zone_}, {"FlowSolution_t", solution}});
        writeRind();
        std::vector<glm::dvec3> flow;
        std::vector<double> density;
        for (const glm::dvec3& p : boxPoints(shift_, layer())) {
            flow.push_back(cgnsFlow(p) + glm::dvec3(step, 0, 0));
            density.push_back(p.x + 10 * p.y + 100 * p.z);
        }
        const char* names[] = {"VelocityX", "VelocityY", "VelocityZ"};
        for (int c = 0; c < 3; ++c) file_.array(names[c], component(flow, c), shape(kPoints), sample_.doubles);
        file_.array("Density", density, shape(kPoints), sample_.doubles);
        if (sample_.vertexOnly) return;
        sound(cg_sol_write(file_.file_, file_.base_, file_.zone_, ("Cells" + at).c_str(), CGNS_ENUMV(CellCenter),
                           &solution));
        file_.go({{"Zone_t", file_.zone_}, {"FlowSolution_t", solution}});
        writeRind();
        std::vector<double> pressure;
        for (int k = -layer(); k < kCells + layer(); ++k)
            for (int j = -layer(); j < kCells + layer(); ++j)
                for (int i = -layer(); i < kCells + layer(); ++i)
                    pressure.push_back(i + kCells * (j + kCells * k) + step);
        file_.array("Pressure", pressure, shape(kCells), sample_.doubles);
    }

    void writeBoundaries() const
    {
        const char* names[] = {"floor", "lid", "inlet"};
        const CGNS_ENUMT(BCType_t) types[] = {CGNS_ENUMV(BCWallViscous), CGNS_ENUMV(BCWall), CGNS_ENUMV(BCInflow)};
        for (int side = 0; side < 3; ++side) {
            int number = 0;
            std::vector<cgsize_t> numbers;
            const cgsize_t from[] = {1, 1, side == 1 ? kPoints : 1},
                           to[] = {side == 2 ? 1 : kPoints, kPoints, side == 2 ? kPoints : from[2]};
            auto set = CGNS_ENUMV(PointRange);
            cgsize_t count = 2;
            if (structured_) {
                numbers.assign(from, from + 3);
                numbers.insert(numbers.end(), to, to + 3);
            } else if (sample_.byPoints) {
                set = CGNS_ENUMV(PointList);
                for (cgsize_t k = from[2]; k <= to[2]; ++k)
                    for (cgsize_t j = from[1]; j <= to[1]; ++j)
                        for (cgsize_t i = from[0]; i <= to[0]; ++i)
                            numbers.push_back(pointNumber(int(i) - 1, int(j) - 1, int(k) - 1));
                count = cgsize_t(numbers.size());
            } else if (sample_.lists) {
                set = CGNS_ENUMV(PointList);
                for (cgsize_t i = 0; i < kCells * kCells; ++i) numbers.push_back(begins_[std::size_t(side)] + i);
                count = cgsize_t(numbers.size());
            } else {
                numbers = {begins_[std::size_t(side)], begins_[std::size_t(side)] + kCells * kCells - 1};
            }
            sound(cg_boco_write(file_.file_, file_.base_, file_.zone_, names[side], types[side], set, count,
                                numbers.data(), &number));
            if (!structured_ && !sample_.byPoints)
                sound(
                    cg_boco_gridlocation_write(file_.file_, file_.base_, file_.zone_, number, CGNS_ENUMV(FaceCenter)));
            if (side > 0) continue;
            file_.go({{"Zone_t", file_.zone_}, {"ZoneBC_t", 1}, {"BC_t", number}});
            sound(cg_famname_write("ground"));
        }
    }

    void writePointers() const
    {
        sound(cg_ziter_write(file_.file_, file_.base_, file_.zone_, "ZoneIterativeData"));
        file_.go({{"Zone_t", file_.zone_}, {"ZoneIterativeData_t", 1}});
        for (const char* kind : {"Points", "Cells"}) {
            if (sample_.vertexOnly && std::string(kind) == "Cells") continue;
            std::string names;
            for (int step = 0; step < sample_.steps; ++step) {
                std::string name = (sample_.shortPointers ? "" : kind) + std::to_string(step);
                name.resize(32, ' ');
                names += name;
            }
            const cgsize_t shape[] = {32, sample_.steps};
            const char* array = kind[0] == 'P' ? "FlowSolutionVertexPointers" : "FlowSolutionCenterPointers";
            sound(cg_array_write(array, CGNS_ENUMV(Character), 2, shape, names.data()));
        }
    }

    void writeRegion() const
    {
        int region = 0;
        sound(cg_subreg_bcname_write(file_.file_, file_.base_, file_.zone_, "onFloor", 2, "floor", &region));
        file_.go({{"Zone_t", file_.zone_}, {"ZoneSubRegion_t", region}});
        sound(cg_gridlocation_write(CGNS_ENUMV(FaceCenter)));
        std::vector<double> shear, pressure;
        for (int i = 0; i < kCells * kCells; ++i) {
            shear.push_back(i);
            pressure.push_back(1000 + i);
        }
        const char* names[] = {"ShearX", "ShearY", "ShearZ"};
        for (const char* name : names) file_.array(name, shear, {kCells * kCells}, sample_.doubles);
        file_.array("Pressure", pressure, {kCells * kCells}, sample_.doubles);
    }

    CgnsFile& file_;
    const SampleCgns& sample_;
    const char* name_;
    double shift_;
    bool structured_ = true;
    std::array<cgsize_t, 3> begins_{};  // Of the faces of floor, lid and inlet.
};

void writeSheet(CgnsFile& file)
{
    std::vector<glm::dvec3> points;
    for (int j = 0; j < kPoints; ++j)
        for (int i = 0; i < kPoints; ++i) points.emplace_back(i, j, 5);
    file.base("Sheets", 2, 3);
    file.zone("sheet", {kPoints, kPoints, kCells, kCells, 0, 0}, true);
    int grid = 0;
    sound(cg_grid_write(file.file_, file.base_, file.zone_, "GridCoordinates", &grid));
    file.go({{"Zone_t", file.zone_}, {"GridCoordinates_t", 1}});
    const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    for (int c = 0; c < 3; ++c) file.array(names[c], component(points, c), {kPoints, kPoints}, true);
}

}  // namespace

glm::dvec3 cgnsFlow(const glm::dvec3& p)
{
    return {1 + p.x, 2 * p.y, p.x - p.z};
}

void writeSampleCgns(const std::string& path, const SampleCgns& sample)
{
    CgnsFile file(path);
    const int base = file.base("Base", 3, 3);
    if (!sample.grid.empty()) {
        const std::string named = std::filesystem::path(sample.grid).filename().string();
        file.go({});
        sound(cg_goto(file.file_, base, "end"));
        sound(cg_link_write("box", named.c_str(), "/Base/box"));
        return;
    }
    Box(file, sample, "box", 0).write();
    if (sample.secondZone) Box(file, sample, "other", 4).write();
    if (sample.steps > 0) {
        sound(cg_biter_write(file.file_, base, "BaseIterativeData", sample.steps));
        sound(cg_goto(file.file_, base, "BaseIterativeData_t", 1, "end"));
        std::vector<double> times;
        for (int step = 0; step < sample.steps; ++step) times.push_back(0.5 * step);
        file.array("TimeValues", times, {sample.steps}, true);
    }
    if (sample.secondBase) writeSheet(file);
}

void writeCgnsSurface(const std::string& path, const SampleSurface& surface)
{
    CgnsFile file(path);
    file.base("Base", 2, 3);
    const auto points = cgsize_t(surface.points.size()), triangles = cgsize_t(surface.triangles.size());
    file.zone("Surface", {points, triangles, 0}, false);
    int number = 0;
    sound(cg_grid_write(file.file_, file.base_, file.zone_, "GridCoordinates", &number));
    file.go({{"Zone_t", file.zone_}, {"GridCoordinates_t", 1}});
    const char* axes[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    for (int c = 0; c < 3; ++c) file.array(axes[c], component(surface.points, c), {points}, surface.doubles);
    std::vector<cgsize_t> corners;
    for (const auto& triangle : surface.triangles)
        for (const std::int64_t corner : triangle) corners.push_back(corner + 1);
    sound(cg_section_write(file.file_, file.base_, file.zone_, "triangles", CGNS_ENUMV(TRI_3), 1, triangles, 0,
                           corners.data(), &number));
    sound(cg_sol_write(file.file_, file.base_, file.zone_, "Solution",
                       surface.onCells ? CGNS_ENUMV(CellCenter) : CGNS_ENUMV(Vertex), &number));
    file.go({{"Zone_t", file.zone_}, {"FlowSolution_t", number}});
    const cgsize_t values = surface.onCells ? triangles : points;
    const char* vectors[] = {"VectorX", "VectorY", "VectorZ"};
    for (int c = 0; c < 3; ++c) file.array(vectors[c], component(surface.vectors, c), {values}, surface.doubles);
    file.array("Scalar", surface.scalars, {values}, surface.doubles);
}

}  // namespace aeolic::test
