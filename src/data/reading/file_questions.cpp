#include "data/reading/file_questions.h"

#include <filesystem>
#include <utility>

#include "data/named_file.h"
#include "data/reading/known_answers.h"
#include "data/reading/reader_pool.h"

namespace aeolic {
namespace {

constexpr std::size_t kMostPieces = 1 << 20;
constexpr std::uint64_t kLargestPiece = std::uint64_t(1) << 43;  // Bytes. Those of all can be added up.

/// From a reader, or as one answered before.
Bytes answerTo(const Bytes& request, const std::string& path, const char* what)
{
    KnownAnswers* known = KnownAnswers::current();
    if (const Bytes* before = known ? known->find(request) : nullptr) return *before;
    ReaderLease reader;
    ReaderProcess::Answer answer = reader->ask(PacketKind::look, request, {path, what}, {});
    if (known) known->keep(request, answer.text);
    return std::move(answer.text);
}

template <class Value>
Value answerTo(Question question, const std::string& path, const char* what, const std::vector<std::string>& words = {},
               FileUse use = FileUse::any)
{
    std::error_code error;
    const LookRequest request{std::filesystem::current_path(error).string(), path, question, use, words};
    return valueIn<Value>(answerTo(byteMessage(request), path, what), path);
}

std::vector<std::uint64_t> pieces(const std::string& path, FileUse use, const std::vector<std::string>& parts = {})
{
    auto bytes = answerTo<std::vector<std::uint64_t>>(Question::pieces, path, "looking for its pieces", parts, use);
    if (bytes.size() > kMostPieces) failNonsense(path);
    for (const std::uint64_t piece : bytes)
        if (piece > kLargestPiece) failNonsense(path);
    return bytes;
}

}  // namespace

std::vector<SeriesEntry> listedFiles(const std::string& path)
{
    return answerTo<std::vector<SeriesEntry>>(Question::listedFiles, path, "reading the list of files");
}

std::vector<double> timesOfCase(const std::string& path, const std::vector<std::string>& arrays)
{
    return answerTo<std::vector<double>>(Question::timesOfCase, path, "looking for its times", arrays);
}

std::vector<std::uint64_t> pieceBytesOf(const std::string& path)
{
    const FileKind* kind = namedKind(path);
    const bool apart = kind && kind->use == FileUse::surface && kind->pieces == FilePieces::apart;
    return apart ? pieces(path, FileUse::surface) : std::vector<std::uint64_t>();
}

std::vector<std::uint64_t> volumePiecesOf(const std::string& path)
{
    const FileKind* kind = namedKind(path);
    if (!kind || kind->use == FileUse::surface || kind->pieces < FilePieces::apart) return {};
    const std::vector<std::uint64_t> bytes = pieces(path, FileUse::field);
    return bytes.size() > 1 ? bytes : std::vector<std::uint64_t>();
}

SurfacePieces piecesOfSurface(const std::string& path, const std::vector<std::string>& parts)
{
    const FileKind* kind = namedKind(path);
    if (!kind || kind->pieces != FilePieces::joined)
        return {pieceBytesOf(path).size() > 1 ? Pieces::apart : Pieces::none, {}};
    std::vector<std::uint64_t> bytes = pieces(path, FileUse::surface, parts);
    if (bytes.size() < 2) return {};
    return {Pieces::joined, std::move(bytes)};
}

std::optional<SurfaceCounts> surfaceCountsOf(const std::string& path)
{
    if (namedKindHas(path, kIsFolder)) return std::nullopt;
    if (!namedKindHas(path, kTellsCounts)) {
        checkReadableFile(path);
        return std::nullopt;
    }
    return answerTo<std::optional<SurfaceCounts>>(Question::surfaceCounts, path, "reading its header");
}

FileSummary summarizeFile(const std::string& path)
{
    auto summary = answerTo<FileSummary>(Question::summary, path, "reading");
    for (const PartSummary& part : summary.parts)
        if (part.sideAcross && (*part.sideAcross < 0 || *part.sideAcross > 2)) failNonsense(path);
    return summary;
}

ColorPoints colorPointsFromXml(const std::string& text, const std::string& path)
{
    auto points = answerTo<ColorPoints>(Question::colorPoints, path, "reading the colour map", {text});
    if (points.space > ColorSpace::diverging) failNonsense(path);
    return points;
}

}  // namespace aeolic
