#include "reader/file_server.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <span>
#include <stdexcept>
#include <thread>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/named_file.h"
#include "data/reading/questions.h"
#include "data/vtk/data_message.h"
#include "data/vtk/reader_messages.h"
#include "reader/shared_malloc.h"
#include "reader/vtk/color_map_xml.h"
#include "reader/vtk/format_registry.h"
#include "reader/vtk/summarize.h"

namespace aeolic {
namespace {

constexpr const char* kLarger = "an undamaged file, a smaller one or a larger machine";

void tellProgress(const char*, double fraction, void* context)
{
    static_cast<const PacketSocket*>(context)->send(PacketKind::progress, std::as_bytes(std::span(&fraction, 1)));
}

FileFacts factsOf(DataFile& file)
{
    FileFacts facts;
    facts.announcesArrays = file.announcesArrays();
    facts.arraysByParts = file.readsFloats();
    if (facts.announcesArrays && !facts.arraysByParts) facts.arrays = file.announcedArrays();
    facts.parts = file.parts();
    facts.timeSteps = file.timeSteps();
    facts.wholeExtent = file.wholeExtent();
    facts.spacingWorld = file.imageSpacing();
    return facts;
}

/// Lets this process take no more memory than the machine has, and no more than `most` bytes beside what it has now.
/// Comes before each file, which begins with all of it. With sanitizers it does nothing.
void limitMemory([[maybe_unused]] std::uint64_t most)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // The libraries' own files take address space, but no memory to speak of, and so does each thread: 8 MiB for its
    // stack, and twice 64 MiB where malloc() begins to keep memory for it.
    constexpr std::uint64_t ofThread = std::uint64_t(136) << 20, ofLibraries = std::uint64_t(4) << 30;
    const std::uint64_t besides = ofLibraries + std::thread::hardware_concurrency() * ofThread;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    static const rlim_t given = limit.rlim_cur;  // By who started the caller.
    limit.rlim_cur = given;                      // What is available is counted without the limit of the file before.
    setrlimit(RLIMIT_AS, &limit);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::uint64_t taken = pages * std::uint64_t(sysconf(_SC_PAGESIZE)), available = availableMemoryBytes();
    const std::uint64_t allowed = std::min(available, most);
    if (allowed >= UINT64_MAX - taken - besides) return;
    limit.rlim_cur = std::min<rlim_t>(taken + allowed + besides, given);
    setrlimit(RLIMIT_AS, &limit);
#endif
}

/// What the kind of file can be asked. Throws LostPeer where it cannot: no caller asks it then.
template <class Ask>
Ask asked(const std::string& path, Ask FormatReader::*question)
{
    const FileKind* kind = namedKind(path);
    const Ask ask = kind ? formatOf(*kind).*question : nullptr;
    if (!ask) throw LostPeer();
    return ask;
}

/// Looks at a file for a Question, and adds what it asks for to the message. Throws InputError.
void addAnswer(ByteWriter& message, const LookRequest& request, const ProgressReport& progress)
{
    const std::string& path = request.path;
    switch (request.question) {
        case Question::listedFiles:
            checkReadableFile(path);
            return message.add(asked(path, &FormatReader::listed)(path));
        case Question::timesOfCase:
            return message.add(asked(path, &FormatReader::times)(path, request.words));
        case Question::pieces:
            return message.add(asked(path, &FormatReader::pieces)(path, request.use, request.words));
        case Question::surfaceCounts:
            return message.add(asked(path, &FormatReader::counts)(path));
        case Question::summary:
            return message.add(summaryOf(path, progress));
        case Question::colorPoints:
            return message.add(colorPointsInXml(request.words.at(0), path));
    }
    throw LostPeer();
}

OwnedFile sealedCopy(const void* bytes, std::size_t count)
{
    OwnedFile file(memfd_create("aeolic-copy", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file || ftruncate(file.get(), off_t(count)) != 0) throw std::bad_alloc();
    void* const memory = mmap(nullptr, count, PROT_READ | PROT_WRITE, MAP_SHARED, file.get(), 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    std::memcpy(memory, bytes, count);
    munmap(memory, count);
    if (fcntl(file.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0)
        throw std::bad_alloc();
    return file;
}

/// The memory of one answer, as sealed files: that of the arrays themselves, or a copy where it is no file.
class AnswerFiles : public AnswerMemory {
public:
    /// Throws std::bad_alloc.
    std::uint32_t place(const void* bytes, std::size_t count) override
    {
        const auto [at, isNew] = placed_.try_emplace({bytes, count}, std::uint32_t(files_.size()));
        if (!isNew) return at->second;
        OwnedFile file = sealedFileOf(bytes, count);
        files_.push_back(file ? std::move(file) : sealedCopy(bytes, count));
        return at->second;
    }

    std::vector<int> descriptors() const
    {
        std::vector<int> all;
        for (const OwnedFile& file : files_) all.push_back(file.get());
        return all;
    }

private:
    std::vector<OwnedFile> files_;
    std::map<std::pair<const void*, std::size_t>, std::uint32_t> placed_;  // Data sets may have arrays in common.
};

}  // namespace

void FileServer::serve()
{
    try {
        for (;;)
            if (const auto packet = caller_.receive(-1)) answer(*packet);
    } catch (const LostPeer&) {
    }
}

void FileServer::answer(const Packet& packet)
{
    const auto refuse = [&](const std::string& text) {
        caller_.send(PacketKind::refusal, std::as_bytes(std::span(text)));
    };
    try {
        ByteReader message(packet.bytes);
        ByteWriter answer;
        if (packet.kind == PacketKind::open)
            open(message, answer);
        else if (packet.kind == PacketKind::look)
            look(message, answer);
        else if (packet.kind == PacketKind::close)
            file_.reset();
        else if (!file_)
            throw LostPeer();
        else if (packet.kind == PacketKind::arrays)
            tellArrays(message, answer);
        else if (packet.kind == PacketKind::read)
            read(message, answer);
        else
            return;
        const Bytes bytes = answer.take();
        caller_.send(PacketKind::answer, bytes);
    } catch (const LostPeer&) {
        throw;
    } catch (const InputError& error) {
        refuse(error.what());
    } catch (const TooLong& error) {
        refuse(InputError(path_, error.what(), "a file of fewer parts and arrays").what());
    } catch (const std::bad_alloc&) {
        refuse(InputError(path_, "there is not enough memory to read it", kLarger).what());
    } catch (const std::length_error&) {  // More than any machine has.
        refuse(InputError(path_, "there is not enough memory to read it", kLarger).what());
    }
}

/// Leaves the file before, and makes room for this one. Relative names start from the caller's folder.
void FileServer::enter(const std::string& folder, const std::string& path)
{
    path_ = path;
    file_.reset();
    const bool isThere = !folder.empty() && chdir(folder.c_str()) == 0;
    if (!isThere && std::filesystem::path(path).is_relative())
        throw InputError(path, "no such file: the current folder is gone", "a file that can be read");
    limitMemory(mostMemoryOf(path));
}

void FileServer::look(ByteReader& message, ByteWriter& answer)
{
    LookRequest request;
    message.read(request);
    enter(request.folder, request.path);
    addAnswer(answer, request, {tellProgress, const_cast<PacketSocket*>(&caller_)});
}

void FileServer::open(ByteReader& message, ByteWriter& answer)
{
    OpenRequest request;
    message.read(request);
    enter(request.folder, request.path);
    file_ = std::make_unique<DataFile>(request.path, request.use, request.time);
    answer.add(factsOf(*file_));
}

void FileServer::tellArrays(ByteReader& message, ByteWriter& answer)
{
    ArraysRequest request;
    message.read(request);
    file_->keepParts(request.parts);
    file_->requireAtTime(request.atTime);
    answer.add(file_->announcedArrays());
}

void FileServer::read(ByteReader& message, ByteWriter& answer)
{
    ReadRequest request;
    message.read(request);
    file_->keepParts(request.parts);
    if (request.arrays) file_->keepOnly(*request.arrays);
    if (request.polyhedra) file_->keepPolyhedra();
    const ProgressReport progress{tellProgress, const_cast<PacketSocket*>(&caller_)};
    AnswerFiles files;
    {
        const auto data =
            request.pieces ? file_->readPieces(*request.pieces) : file_->read(progress, "reading", request.extent);
        addData(answer, data, files);
    }
    file_->forget();
    const std::vector<int> all = files.descriptors();
    for (std::size_t i = 0; i < all.size(); i += PacketSocket::kMostFiles)
        caller_.send(PacketKind::memory, {},
                     std::span(all).subspan(i, std::min(PacketSocket::kMostFiles, all.size() - i)));
}

}  // namespace aeolic
