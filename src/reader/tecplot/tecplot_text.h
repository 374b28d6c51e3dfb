#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

enum class TecplotCells { ordered, lines, triangles, quads, tetrahedra, bricks, polygons, polyhedra };

/// What the head of a zone says, and where its numbers stand in the file.
struct TecplotZone {
    std::string name;
    TecplotCells cells = TecplotCells::ordered;
    bool block = false;                   ///< A variable after the other; else a point after the other.
    std::int64_t lengths[3] = {1, 1, 1};  ///< Of an ordered zone; of others the number of points stands first.
    std::int64_t elements = 0;            ///< Of a zone that is not ordered.
    std::vector<bool> inCells, passive;   ///< Of each variable. Passive ones are not there.
    std::vector<std::optional<std::size_t>> shared;  ///< The zone that has a variable's numbers.
    std::optional<std::size_t> sharedCells;          ///< The zone that has the elements.
    bool neighbours = false;                         ///< Numbers about neighbours follow the elements.
    double time = 0;
    std::int64_t strand = 0;         ///< Zones of one strand above 0 are one in time.
    std::size_t begin = 0, end = 0;  ///< Of its numbers.

    std::int64_t points() const { return lengths[0] * lengths[1] * lengths[2]; }
    std::int64_t cellCount() const;
    int dimension() const;
};

/// What the records of a file say.
struct TecplotHeads {
    std::vector<std::string> variables;
    std::vector<TecplotZone> zones;
};

/// Reads what the records of a file's text say. Numbers are passed over. Throws InputError, which begins with `path`.
TecplotHeads readTecplotHeads(std::string_view text, const std::string& path);

/// A Tecplot file in text, all of it in memory. Every failure is an InputError that begins with the file's name.
class TecplotText {
public:
    explicit TecplotText(const std::string& path);

    const std::vector<std::string>& variables() const { return variables_; }
    const std::vector<TecplotZone>& zones() const { return zones_; }

    /// The numbers of some of a zone's variables, in the order wanted; empty of what the zone does not have.
    std::vector<std::vector<double>> read(std::size_t zone, const std::vector<std::size_t>& wanted) const;

    /// The corners of a zone's elements, from 1, as many for each as its kind has.
    std::vector<std::int64_t> corners(std::size_t zone) const;

    [[noreturn]] void fail(const TecplotZone& zone, const std::string& found, const std::string& expected) const;

private:
    void take(const TecplotZone& zone, const std::vector<std::optional<std::size_t>>& columns,
              std::vector<std::vector<double>>& values, std::vector<std::int64_t>* corners) const;

    std::string path_, data_;
    std::vector<std::string> variables_;
    std::vector<TecplotZone> zones_;
};

/// How many corners elements of a kind have; 0 where each has its own number.
std::size_t tecplotCorners(TecplotCells cells);

}  // namespace aeolic
