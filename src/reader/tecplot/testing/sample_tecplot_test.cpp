#include "reader/tecplot/testing/sample_tecplot.h"

#include <fmt/format.h>

#include <fstream>

namespace aeolic::test {
namespace {

constexpr int kPoints = 5;

class ZoneText {
public:
    explicit ZoneText(const SampleTecplot& sample) : sample_(sample) {}

    std::string write(int layers, const char* name, double height, int step) const
    {
        const bool box = layers > 1;
        const int cells = box ? 64 : 16;
        std::string text = fmt::format("ZONE T=\"{}\"", name);
        if (sample_.ordered)
            text += fmt::format(", I={}, J={}, K={}, ZONETYPE=Ordered", kPoints, kPoints, layers);
        else
            text += fmt::format(" N={} E={}\n F={} ET={}", kPoints * kPoints * layers, cells,
                                sample_.block ? "FEBLOCK" : "FEPOINT", box ? "BRICK" : "QUADRILATERAL");
        if (sample_.ordered) text += sample_.block ? "\nDATAPACKING=BLOCK" : " DATAPACKING=POINT";
        if (sample_.block) text += " VARLOCATION=([8]=CELLCENTERED, [1-7]=NODAL)";
        if (sample_.steps > 0) text += fmt::format("\nSTRANDID={}, SOLUTIONTIME={}", box ? 1 : 2, 0.5 * step);
        if (sample_.shared) text += box ? "" : "\nVARSHARELIST=([1-7]=1)";
        return text + "\nDT=(DOUBLE DOUBLE DOUBLE SINGLE\nSINGLE)\n" +
               numbers(layers, height, step, !sample_.shared || box) + elements(layers);
    }

    /// `points`, `cells`: which of the numbers.
    std::string numbers(int layers, double height, int step, bool points, bool cells = true) const
    {
        std::vector<std::vector<double>> columns(8);
        for (int k = 0; k < layers; ++k)
            for (int j = 0; j < kPoints; ++j)
                for (int i = 0; i < kPoints; ++i) {
                    const glm::dvec3 p(i, j, k + height), flow = tecplotFlow(p) + glm::dvec3(step, 0, 0);
                    const double row[] = {p.x, p.y, p.z, flow.x, flow.y, flow.z, p.x + 10 * p.y + 100 * p.z};
                    for (std::size_t c = 0; c < 7; ++c) columns[c].push_back(row[c]);
                }
        for (int i = 0; i < (layers > 1 ? 64 : 16); ++i) columns[7].push_back(i + step);
        std::string text;
        if (!sample_.block) {
            for (std::size_t i = 0; points && i < columns[0].size(); ++i) {
                for (std::size_t c = 0; c < 7; ++c) text += fmt::format("{} ", columns[c][i]);
                text += "0\n";
            }
            return text;
        }
        for (std::size_t c = points ? 0 : 7; c < (cells ? 8U : 7U); ++c)
            for (std::size_t i = 0; i < columns[c].size();) {
                std::size_t count = 1;
                while (sample_.repeats && i + count < columns[c].size() && columns[c][i + count] == columns[c][i])
                    ++count;
                text += count > 1 ? fmt::format("{}*{}\n", count, columns[c][i])
                                  : fmt::format("{}{}", columns[c][i], i % 5 == 4 ? "\n" : " ");
                i += count;
            }
        return text + "\n";
    }

private:
    std::string elements(int layers) const
    {
        std::string text;
        if (sample_.ordered) return text;
        for (int k = 0; k < std::max(layers - 1, 1); ++k)
            for (int j = 0; j + 1 < kPoints; ++j)
                for (int i = 0; i + 1 < kPoints; ++i) {
                    const int at = 1 + i + kPoints * (j + kPoints * k);
                    text += fmt::format("{} {} {} {}", at, at + 1, at + 1 + kPoints, at + kPoints);
                    const int up = at + kPoints * kPoints;
                    if (layers > 1) text += fmt::format(" {} {} {} {}", up, up + 1, up + 1 + kPoints, up + kPoints);
                    text += "\n";
                }
        return text;
    }

    const SampleTecplot& sample_;
};

}  // namespace

glm::dvec3 tecplotFlow(const glm::dvec3& p)
{
    return {1 + p.x, 2 * p.y, p.x - p.z};
}

void writeSampleTecplot(const std::string& path, const SampleTecplot& sample)
{
    std::ofstream file(path);
    const ZoneText text(sample);
    file << "# a comment\nTITLE = \"a box\"\nVARIABLES = \"X\", \"Y\"\n\"Z\" U V W \"T\"\n\"p\"\n";
    if (sample.shared)
        file << "ZONE T=\"hidden\" I=25 DATAPACKING=BLOCK PASSIVEVARLIST=[8]\nAUXDATA a=\"b\"\n"
             << text.numbers(1, 5, 0, true, false);
    for (int step = 0; step < std::max(sample.steps, 1); ++step)
        file << text.write(kPoints, "box", 0, step) << "\n" << text.write(1, "sheet", 5, step);
}

void writeTecplotSurface(const std::string& path, const SampleSurface& surface)
{
    std::ofstream file(path);
    file << fmt::format(
        "TITLE=\"\"\nVARIABLES=X Y Z VectorX VectorY VectorZ Scalar\nZONE T=\"Surface\" ZONETYPE=FETRIANGLE N={} E={} "
        "DATAPACKING=BLOCK{}\n",
        surface.points.size(), surface.triangles.size(), surface.onCells ? " VARLOCATION=([4-7]=CELLCENTERED)" : "");
    for (int c = 0; c < 3; ++c)
        for (const glm::dvec3& p : surface.points) file << fmt::format("{}\n", p[c]);
    for (int c = 0; c < 3; ++c)
        for (const glm::dvec3& v : surface.vectors) file << fmt::format("{}\n", v[c]);
    for (const double s : surface.scalars) file << fmt::format("{}\n", s);
    for (const auto& t : surface.triangles) file << fmt::format("{} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
}

}  // namespace aeolic::test
