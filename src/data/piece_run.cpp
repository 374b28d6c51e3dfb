#include "data/piece_run.h"

namespace aeolic {

PieceRun runOf(const FieldPart& part, const std::vector<std::uint64_t>& bytes)
{
    std::uint64_t total = 0;
    for (const std::uint64_t piece : bytes) total += piece;
    PieceRun run;
    std::uint64_t before = 0;
    for (const std::uint64_t piece : bytes) {  // A piece goes to the rank in whose share its middle lies.
        const double middle = (double(before) + 0.5 * double(piece)) / double(total);
        const int rank = int(middle * part.ranks);
        run.begin += rank < part.rank;
        run.end += rank <= part.rank;
        before += piece;
    }
    return run;
}

}  // namespace aeolic
