#include "reader/fluent/testing/sample_fluent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

namespace aeolic::test {
namespace {

using Form = SampleFluent::Form;
using Corners = std::vector<int>;  // From 0.

constexpr int kCells = 4;

struct Face {
    Corners corners;  ///< Seen from outside of the first cell.
    int cells[2] = {0, 0};
    std::string zone;
};

class Writer {
public:
    Writer(const std::string& path, const SampleFluent& sample) : file_(path, std::ios::binary), sample_(sample)
    {
        file_ << "(0 \"a mesh (of a test)\")\n(2 " << (sample.flat ? 2 : 3) << ")\n";
        if (sample.form != Form::text) file_ << "(4 (" << (sample.bigEndian ? 70 : 60) << " 0 0 1 2 4 4 4 8 8 4 4))\n";
    }

    void section(int index, const std::string& head)
    {
        if (sample_.form == Form::text)
            file_ << fmt::format("({} ({})(\n", index, head);
        else
            file_ << fmt::format("({} ({})(", index + (sample_.form == Form::floats ? 2000 : 3000), head);
        index_ = index;
    }

    void end()
    {
        if (sample_.form == Form::text)
            file_ << "))\n";
        else
            file_ << fmt::format("\nEnd of Binary Section   {})\n",
                                 index_ + (sample_.form == Form::floats ? 2000 : 3000));
    }

    void text(const std::string& text) { file_ << text; }
    void wholes(const std::vector<int>& numbers)
    {
        for (const int number : numbers)
            sample_.form == Form::text ? void(file_ << fmt::format("{:x} ", number)) : bytes(std::int32_t(number));
        if (sample_.form == Form::text) file_ << "\n";
    }

    void reals(const std::vector<double>& numbers)
    {
        for (const double number : numbers) {
            if (sample_.form == Form::text)
                file_ << fmt::format("{} ", number);
            else if (sample_.form == Form::floats)
                bytes(float(number));
            else
                bytes(number);
        }
        if (sample_.form == Form::text) file_ << "\n";
    }

private:
    template <class Number>
    void bytes(Number number)
    {
        char own[sizeof number];
        std::memcpy(own, &number, sizeof number);
        if (sample_.bigEndian) std::reverse(own, own + sizeof own);
        file_.write(own, sizeof own);
    }

    std::ofstream file_;
    const SampleFluent& sample_;
    int index_ = 0;
};

struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<Face> faces;
    std::vector<glm::dvec3> middles;
};

Mesh boxMesh()
{
    Mesh mesh;
    constexpr int across = kCells + 1;
    const auto node = [](int i, int j, int k) { return i + across * (j + across * k); };
    const auto cell = [](int i, int j, int k) {
        return i < 0 || j < 0 || k < 0 || i >= kCells || j >= kCells || k >= kCells ? 0
                                                                                    : 1 + i + kCells * (j + kCells * k);
    };
    for (int k = 0; k <= kCells; ++k)
        for (int j = 0; j <= kCells; ++j)
            for (int i = 0; i <= kCells; ++i) mesh.points.emplace_back(i, j, k);
    for (int k = 0; k < kCells; ++k)
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i) mesh.middles.emplace_back(i + 0.5, j + 0.5, k + 0.5);
    for (int d = 0; d < 3; ++d)
        for (int layer = 0; layer <= kCells; ++layer)
            for (int b = 0; b < kCells; ++b)
                for (int a = 0; a < kCells; ++a) {
                    // `a` runs along the direction that runs fastest of the two others.
                    const int fast = d == 0 ? 1 : 0, slow = d == 2 ? 1 : 2;
                    const auto at = [&](int da, int db) {
                        int place[3];
                        place[d] = layer;
                        place[fast] = a + da;
                        place[slow] = b + db;
                        return node(place[0], place[1], place[2]);
                    };
                    int place[3];
                    place[d] = layer;
                    place[fast] = a;
                    place[slow] = b;
                    const int behind = cell(place[0], place[1], place[2]);
                    --place[d];
                    const int before = cell(place[0], place[1], place[2]);
                    Face face{{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, {before, behind}, "interior"};
                    // Seen from larger numbers, but for y, whose others are x and z; and at the low sides from below.
                    if ((d == 1) != (before == 0)) std::swap(face.corners[1], face.corners[3]);
                    if (before == 0) std::swap(face.cells[0], face.cells[1]);
                    if (before == 0 || behind == 0)
                        face.zone = d == 2 ? (layer == 0 ? "floor" : "lid") : d == 0 && layer == 0 ? "inlet" : "rest";
                    mesh.faces.push_back(std::move(face));
                }
    return mesh;
}

Mesh flatMesh()
{
    Mesh mesh;
    constexpr int across = kCells + 1;
    const auto cell = [](int i, int j) {
        return i < 0 || j < 0 || i >= kCells || j >= kCells ? 0 : 1 + i + kCells * j;
    };
    for (int j = 0; j <= kCells; ++j)
        for (int i = 0; i <= kCells; ++i) mesh.points.emplace_back(i, j, 0);
    for (int j = 0; j < kCells; ++j)
        for (int i = 0; i < kCells; ++i) mesh.middles.emplace_back(i + 0.5, j + 0.5, 0);
    for (const bool across_ : {false, true})
        for (int j = 0; j <= kCells; ++j)
            for (int i = 0; i <= kCells; ++i) {
                if (across_ ? i == kCells : j == kCells) continue;
                const int at = i + across * j, before = across_ ? cell(i, j - 1) : cell(i - 1, j), behind = cell(i, j);
                Face face{{at, at + (across_ ? 1 : across)}, {before, behind}, "interior"};
                if (before == 0) std::swap(face.cells[0], face.cells[1]);
                if (before == 0 || behind == 0)
                    face.zone = across_ ? (j == 0 ? "floor" : "lid") : i == 0 ? "inlet" : "rest";
                mesh.faces.push_back(std::move(face));
            }
    return mesh;
}

Mesh shapesMesh()
{
    Mesh mesh;
    const std::vector<glm::dvec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<glm::dvec3> prism{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1.5, 0}, {0, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0.5, 1.5, 1}, {0, 1, 1}};
    const struct {
        std::vector<glm::dvec3> points;
        std::vector<Corners> faces;
    } cells[] = {
        {cube, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
        {{cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]},
         {{0, 1, 4, 3}, {0, 2, 1}, {3, 4, 5}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
        {{cube[0], cube[1], cube[2], cube[3], cube[4]}, {{0, 1, 4}, {1, 2, 4}, {0, 3, 2, 1}, {2, 3, 4}, {3, 0, 4}}},
        {{cube[0], cube[1], cube[3], cube[4]}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
        {prism,
         {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}, {0, 1, 6, 5}, {1, 2, 7, 6}, {2, 3, 8, 7}, {3, 4, 9, 8}, {4, 0, 5, 9}}},
    };
    int number = 0;
    for (const auto& cell : cells) {
        const int first = int(mesh.points.size());
        for (const glm::dvec3& p : cell.points) mesh.points.push_back(p + glm::dvec3(2.0 * number, 0, 0));
        mesh.middles.emplace_back(2.0 * number + 0.5, 0.5, 0.5);
        ++number;
        for (Corners face : cell.faces) {
            for (int& corner : face) corner += first;
            mesh.faces.push_back({face, {number, 0}, "floor"});
        }
    }
    return mesh;
}

const std::pair<const char*, const char*> kZones[] = {{"interior", "interior"},
                                                      {"floor", "wall"},
                                                      {"lid", "wall"},
                                                      {"inlet", "velocity-inlet"},
                                                      {"rest", "pressure-outlet"}};

/// Writes the zones' faces one after the other; gets where each begins.
std::map<std::string, std::pair<int, int>> writeFaces(Writer& writer, const Mesh& mesh)
{
    std::map<std::string, std::pair<int, int>> places;
    int next = 1, id = 3;
    const int kinds[] = {2, 3, 3, 0xa, 5};
    for (const auto& [name, type] : kZones) {
        std::vector<const Face*> own;
        for (const Face& face : mesh.faces)
            if (face.zone == name) own.push_back(&face);
        const int zone = id++;
        if (own.empty()) continue;
        const std::size_t size = own[0]->corners.size();
        const bool same =
            std::all_of(own.begin(), own.end(), [&](const Face* face) { return face->corners.size() == size; });
        writer.section(13,
                       fmt::format("{:x} {:x} {:x} {:x} {:x}", zone, next, next + int(own.size()) - 1, kinds[zone - 3],
                                   same && size <= 4 ? size
                                   : zone % 2 == 0   ? 0
                                                     : 5));
        for (const Face* face : own) {
            std::vector<int> numbers;
            if (!same || size > 4) numbers.push_back(int(face->corners.size()));
            // Turned around a thumb that points into the first cell.
            for (auto corner = face->corners.rbegin(); corner != face->corners.rend(); ++corner)
                numbers.push_back(*corner + 1);
            numbers.insert(numbers.end(), {face->cells[0], face->cells[1]});
            writer.wholes(numbers);
        }
        writer.end();
        places[name] = {next, next + int(own.size()) - 1};
        next += int(own.size());
    }
    return places;
}

void writeData(const std::string& path, const SampleFluent& sample, const Mesh& mesh,
               const std::map<std::string, std::pair<int, int>>& places)
{
    Writer writer(path, sample);
    writer.text(fmt::format("(33 ({} {} {}))\n", mesh.middles.size(), mesh.faces.size(), mesh.points.size()));
    const auto begin = [&](int number, int zone, int width, int first, int last) {
        writer.section(300, fmt::format("{} {} {} 0 0 {} {}", number, zone, width, first, last));
    };
    const int cells = int(mesh.middles.size());
    begin(1, 2, 1, 1, cells);
    for (int i = 0; i < cells; ++i) writer.reals({double(i)});
    writer.end();
    for (int c = 0; c < (sample.flat ? 2 : 3); ++c) {
        begin(111 + c, 2, 1, 1, cells);
        for (const glm::dvec3& p : mesh.middles) writer.reals({fluentFlow(p)[c]});
        writer.end();
    }
    const auto [first, last] = places.at("floor");
    begin(19, 4, sample.flat ? 2 : 3, first, last);
    for (int i = 0; i <= last - first; ++i)
        writer.reals(sample.flat ? std::vector<double>{double(i), 0} : std::vector<double>{double(i), 0, 1});
    writer.end();
}

}  // namespace

glm::dvec3 fluentFlow(const glm::dvec3& p)
{
    return {1 + p.x, 2 * p.y, p.x - p.z};
}

void writeSampleFluent(const std::string& path, const SampleFluent& sample)
{
    const Mesh mesh = sample.shapes ? shapesMesh() : sample.flat ? flatMesh() : boxMesh();
    std::map<std::string, std::pair<int, int>> places;
    {
        Writer writer(path, sample);
        const int points = int(mesh.points.size()), cells = int(mesh.middles.size()), faces = int(mesh.faces.size());
        writer.text(fmt::format("(10 (0 1 {:x} 0 {}))\n(12 (0 1 {:x} 0))\n(13 (0 1 {:x} 0))\n", points,
                                sample.flat ? 2 : 3, cells, faces));
        writer.section(10, fmt::format("1 1 {:x} 1 {}", points, sample.flat ? 2 : 3));
        for (const glm::dvec3& p : mesh.points)
            writer.reals(sample.flat ? std::vector<double>{p.x, p.y} : std::vector<double>{p.x, p.y, p.z});
        writer.end();
        writer.text(fmt::format("(12 (2 1 {:x} 1 {}))\n", cells, sample.shapes ? 7 : sample.flat ? 3 : 4));
        places = writeFaces(writer, mesh);
        if (sample.names) {
            writer.text("(39 (2 fluid air 1)())\n");
            int zone = 3;
            for (const auto& [name, type] : kZones) writer.text(fmt::format("(45 ({} {} {})())\n", zone++, type, name));
        }
    }
    if (sample.data) writeData(std::filesystem::path(path).replace_extension(".dat").string(), sample, mesh, places);
}

}  // namespace aeolic::test
