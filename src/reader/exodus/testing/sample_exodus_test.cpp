#include "reader/exodus/testing/sample_exodus.h"

#include <vtk_exodusII.h>

#include <algorithm>
#include <stdexcept>

namespace aeolic::test {
namespace {

constexpr int kCells = 4, kPoints = kCells + 1;

void sound(int status)
{
    if (status < 0) throw std::runtime_error("the Exodus library refuses");
}

class ExodusFile {
public:
    ExodusFile(const std::string& path, SampleExodus::Form form, bool doubles)
    {
        const int modes[] = {EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_64BIT_DATA, EX_NETCDF4};
        int here = 8, there = doubles ? 8 : 4;
        sound(file = ex_create(path.c_str(), EX_CLOBBER | modes[int(form)], &here, &there));
    }
    ~ExodusFile() { ex_close(file); }
    ExodusFile(const ExodusFile&) = delete;
    ExodusFile& operator=(const ExodusFile&) = delete;

    void init(std::size_t nodes, int elements, int blocks, int sets, int faces = 0) const
    {
        ex_init_params params{};
        params.num_dim = 3;
        params.num_nodes = std::int64_t(nodes);
        params.num_elem = elements;
        params.num_elem_blk = blocks;
        params.num_side_sets = sets;
        params.num_face = faces;
        params.num_face_blk = faces > 0;
        sound(ex_put_init_ext(file, &params));
    }

    void points(const std::vector<glm::dvec3>& points) const
    {
        std::vector<double> axes[3];
        for (const glm::dvec3& p : points)
            for (int c = 0; c < 3; ++c) axes[c].push_back(p[c]);
        sound(ex_put_coord(file, axes[0].data(), axes[1].data(), axes[2].data()));
    }

    void block(int id, const char* type, int count, int nodes, const std::vector<int>& corners) const
    {
        sound(ex_put_block(file, EX_ELEM_BLOCK, id, type, count, nodes, 0, 0, 0));
        sound(ex_put_conn(file, EX_ELEM_BLOCK, id, corners.data(), nullptr, nullptr));
    }

    void names(ex_entity_type type, std::vector<std::string> names) const
    {
        auto pointers = pointersOf(names);
        sound(ex_put_names(file, type, pointers.data()));
    }

    void variables(ex_entity_type type, std::vector<std::string> names) const
    {
        auto pointers = pointersOf(names);
        sound(ex_put_variable_param(file, type, int(names.size())));
        sound(ex_put_variable_names(file, type, int(names.size()), pointers.data()));
    }

    void values(int step, ex_entity_type type, int variable, int id, const std::vector<double>& values) const
    {
        sound(ex_put_var(file, step + 1, type, variable, id, std::int64_t(values.size()), values.data()));
    }

    int file = 0;

private:
    static std::vector<char*> pointersOf(std::vector<std::string>& names)
    {
        std::vector<char*> pointers;
        for (std::string& name : names) pointers.push_back(name.data());
        return pointers;
    }
};

int node(int i, int j, int k)
{
    return 1 + i + kPoints * (j + kPoints * k);
}

/// `split`: how many nodes stand in front of those that upper blocks have of their own.
std::vector<int> hexahedron(int i, int j, int k, int split)
{
    std::vector<int> corners;
    for (const int up : {0, 1})
        for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            corners.push_back(node(i + a, j + b, k + up) + (k < kCells / 2 ? 0 : split));
    return corners;
}

constexpr int kSides[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};

/// Every cell has six faces of its own; those between two cells are there twice.
void writePolyhedra(const ExodusFile& file, const std::vector<std::vector<int>>& cells)
{
    std::vector<int> corners, sizes(6 * cells.size(), 4), faces, faceCounts(cells.size(), 6);
    for (const auto& cell : cells)
        for (const auto& side : kSides) {
            faces.push_back(int(faces.size()) + 1);
            for (const int corner : side) corners.push_back(cell[std::size_t(corner)]);
        }
    ex_block block{};
    block.id = 1;
    block.type = EX_FACE_BLOCK;
    std::copy_n("nsided", 7, block.topology);
    block.num_entry = std::int64_t(sizes.size());
    block.num_nodes_per_entry = std::int64_t(corners.size());
    sound(ex_put_block_param(file.file, block));
    sound(ex_put_conn(file.file, EX_FACE_BLOCK, 1, corners.data(), nullptr, nullptr));
    sound(ex_put_entity_count_per_polyhedra(file.file, EX_FACE_BLOCK, 1, sizes.data()));
    block.id = 20;
    block.type = EX_ELEM_BLOCK;
    std::copy_n("nfaced", 7, block.topology);
    block.num_entry = std::int64_t(cells.size());
    block.num_nodes_per_entry = 0;
    block.num_faces_per_entry = std::int64_t(faces.size());
    sound(ex_put_block_param(file.file, block));
    sound(ex_put_conn(file.file, EX_ELEM_BLOCK, 20, nullptr, nullptr, faces.data()));
    sound(ex_put_entity_count_per_polyhedra(file.file, EX_ELEM_BLOCK, 20, faceCounts.data()));
}

std::vector<glm::dvec3> boxPoints(bool sheet, bool split)
{
    std::vector<glm::dvec3> points;
    std::vector<int> layers{0, 1, 2, 3, 4};
    if (split) layers.insert(layers.begin() + 2, 2);
    if (sheet) layers.push_back(5);
    for (const int k : layers)
        for (int j = 0; j < kPoints; ++j)
            for (int i = 0; i < kPoints; ++i) points.emplace_back(i, j, k);
    return points;
}

void writeSides(const ExodusFile& file)
{
    constexpr int layer = kCells * kCells;
    for (int set = 0; set < 3; ++set) {
        std::vector<int> elements, sides;
        for (int b = 0; b < kCells; ++b)
            for (int a = 0; a < kCells; ++a) {
                elements.push_back(1 + (set == 0   ? a + kCells * b
                                        : set == 1 ? a + kCells * b + layer * (kCells - 1)
                                                   : kCells * a + layer * b));
                sides.push_back(set == 0 ? 5 : set == 1 ? 6 : 4);
            }
        sound(ex_put_set_param(file.file, EX_SIDE_SET, 100 + set, std::int64_t(elements.size()), 0));
        sound(ex_put_set(file.file, EX_SIDE_SET, 100 + set, elements.data(), sides.data()));
    }
}

void writeValues(const ExodusFile& file, const SampleExodus& sample, const std::vector<glm::dvec3>& points)
{
    std::vector<std::string> nodal{"vel_x", "vel_y", "vel_z", "temp"};
    if (sample.moves) nodal.insert(nodal.end(), {"disp_x", "disp_y", "disp_z"});
    file.variables(EX_NODAL, nodal);
    file.variables(EX_ELEM_BLOCK, {"pressure"});
    file.variables(EX_SIDE_SET, {"shear"});
    std::vector<int> table{1, 0, 0};
    sound(ex_put_truth_table(file.file, EX_SIDE_SET, 3, 1, table.data()));
    for (int step = 0; step < sample.steps; ++step) {
        const double time = 0.5 * step;
        sound(ex_put_time(file.file, step + 1, &time));
        std::vector<double> values[7];
        for (const glm::dvec3& p : points) {
            const glm::dvec3 flow = exodusFlow(p) + glm::dvec3(step, 0, 0);
            for (int c = 0; c < 3; ++c) values[c].push_back(flow[c]);
            values[3].push_back(p.x + 10 * p.y + 100 * p.z);
            for (int c = 0; c < 3; ++c) values[4 + c].push_back(c == 2 ? step : 0);
        }
        for (std::size_t k = 0; k < nodal.size(); ++k) file.values(step, EX_NODAL, int(k) + 1, 1, values[k]);
        std::vector<double> low, high, shear;
        for (int i = 0; i < 32; ++i) {
            low.push_back(i + step);
            high.push_back(32 + i + step);
            if (i < 16) shear.push_back(i);
        }
        file.values(step, EX_ELEM_BLOCK, 1, 10, low);
        file.values(step, EX_ELEM_BLOCK, 1, 20, high);
        if (sample.shells) file.values(step, EX_ELEM_BLOCK, 1, 30, std::vector<double>(16, step));
        file.values(step, EX_SIDE_SET, 1, 100, shear);
    }
}

}  // namespace

glm::dvec3 exodusFlow(const glm::dvec3& p)
{
    return {1 + p.x, 2 * p.y, p.x - p.z};
}

void writeSampleExodus(const std::string& path, const SampleExodus& sample)
{
    const ExodusFile file(path, sample.form, sample.doubles);
    const auto points = boxPoints(sample.shells, sample.split);
    const int cells = kCells * kCells * kCells;
    file.init(points.size(), cells + (sample.shells ? 16 : 0), sample.shells ? 3 : 2, 3,
              sample.polyhedra ? 6 * cells / 2 : 0);
    file.points(points);
    std::vector<std::vector<int>> halves[2];
    for (int k = 0; k < kCells; ++k)
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i)
                halves[k / 2].push_back(hexahedron(i, j, k, sample.split ? kPoints * kPoints : 0));
    for (int half = 0; half < 2; ++half) {
        if (half == 1 && sample.polyhedra) {
            writePolyhedra(file, halves[half]);
            continue;
        }
        std::vector<int> corners;
        for (const auto& cell : halves[half]) corners.insert(corners.end(), cell.begin(), cell.end());
        file.block(10 + 10 * half, half == 0 ? "HEX8" : "hex", 32, 8, corners);
    }
    if (sample.shells) {
        std::vector<int> corners;
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i)
                for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                    corners.push_back(node(i + a, j + b, 5 + sample.split));
        file.block(30, "SHELL4", 16, 4, corners);
    }
    if (sample.names)
        file.names(EX_ELEM_BLOCK, sample.shells ? std::vector<std::string>{"low", "high", "sheet"}
                                                : std::vector<std::string>{"low", "high"});
    writeSides(file);
    if (sample.names) file.names(EX_SIDE_SET, {"floor", "lid", "inlet"});
    if (sample.values) writeValues(file, sample, points);
}

void writeExodusElements(const std::string& path)
{
    struct Element {
        const char* type;
        int nodes, sides;
        std::vector<glm::dvec3> corners;
    };
    const std::vector<glm::dvec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const Element elements[] = {
        {"HEX27", 27, 6, cube},
        {"TETRA10", 10, 4, {cube[0], cube[1], cube[3], cube[4]}},
        {"WEDGE", 6, 5, {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]}},
        {"PYRAMID5", 5, 5, {cube[0], cube[1], cube[2], cube[3], cube[4]}},
        {"SHELL4", 4, 2, {cube[0], cube[1], cube[2], cube[3]}},
        {"TRISHELL3", 3, 2, {cube[0], cube[1], cube[3]}},
    };
    std::vector<glm::dvec3> points;
    std::vector<int> sideElements, sides;
    for (std::size_t e = 0; e < std::size(elements); ++e) {
        // The nodes between the corners are anywhere: they are not used.
        for (int n = 0; n < elements[e].nodes; ++n)
            points.push_back(glm::dvec3(2.0 * double(e), 0, 0) + (std::size_t(n) < elements[e].corners.size()
                                                                      ? elements[e].corners[std::size_t(n)]
                                                                      : glm::dvec3(0.5)));
        for (int side = 1; side <= elements[e].sides; ++side) {
            sideElements.push_back(int(e) + 1);
            sides.push_back(side);
        }
    }
    const ExodusFile file(path, SampleExodus::Form::offsets64, true);
    file.init(points.size(), int(std::size(elements)), int(std::size(elements)), 1);
    file.points(points);
    int first = 1;
    for (std::size_t e = 0; e < std::size(elements); ++e) {
        std::vector<int> corners;
        for (int n = 0; n < elements[e].nodes; ++n) corners.push_back(first++);
        file.block(int(e) + 1, elements[e].type, 1, elements[e].nodes, corners);
    }
    sound(ex_put_set_param(file.file, EX_SIDE_SET, 1, std::int64_t(sides.size()), 0));
    sound(ex_put_set(file.file, EX_SIDE_SET, 1, sideElements.data(), sides.data()));
    file.names(EX_SIDE_SET, {"all"});
}

std::vector<std::vector<int>> exodusSides(const std::string& path)
{
    int here = 8, there = 0;
    float version = 0;
    const int file = ex_open(path.c_str(), EX_READ, &here, &there, &version);
    sound(file);
    int length = 0;
    sound(ex_get_side_set_node_list_len(file, 1, &length));
    std::vector<int> counts(1000), nodes(std::size_t(length) + 1000);
    sound(ex_get_side_set_node_list(file, 1, counts.data(), nodes.data()));
    ex_close(file);
    std::vector<std::vector<int>> sides;
    int at = 0;
    for (std::size_t i = 0; counts[i] > 0; at += counts[i++])
        sides.emplace_back(nodes.begin() + at, nodes.begin() + at + counts[i]);
    return sides;
}

void writeExodusSurface(const std::string& path, const SampleSurface& surface, SampleExodus::Form form)
{
    const ExodusFile file(path, form, surface.doubles);
    file.init(surface.points.size(), int(surface.triangles.size()), 1, 0);
    file.points(surface.points);
    std::vector<int> corners;
    for (const auto& triangle : surface.triangles)
        for (const std::int64_t corner : triangle) corners.push_back(int(corner) + 1);
    file.block(1, "TRISHELL3", int(surface.triangles.size()), 3, corners);
    file.names(EX_ELEM_BLOCK, {"Surface"});
    const ex_entity_type kind = surface.onCells ? EX_ELEM_BLOCK : EX_NODAL;
    file.variables(kind, {"Vector_x", "Vector_y", "Vector_z", "Scalar"});
    const double time = 0;
    sound(ex_put_time(file.file, 1, &time));
    for (int c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (const glm::dvec3& v : surface.vectors) values.push_back(v[c]);
        file.values(0, kind, c + 1, 1, values);
    }
    file.values(0, kind, 4, 1, surface.scalars);
}

}  // namespace aeolic::test
