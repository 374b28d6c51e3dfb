#include "data/vtk/messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <mutex>

namespace aeolic {

namespace {

std::recursive_mutex outletMutex;

/// "ERROR: In ../IO/XML/vtkXMLReader.cxx, line 578\nvtkXMLReader (0x5581): Error opening file x\n\n" -> "Error opening file x".
std::string oneLine(const char* text)
{
    std::string line = text ? text : "";
    if (const std::size_t address = line.find("(0x"); address != std::string::npos)
        if (const std::size_t end = line.find("): ", address); end != std::string::npos) line.erase(0, end + 3);
    std::string out;
    for (const char c : line) {
        const bool space = static_cast<unsigned char>(c) <= ' ';
        if (!space)
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    while (!out.empty() && (out.back() == ' ' || out.back() == '.')) out.pop_back();
    return out.empty() ? "no reason was given" : out;
}

}  // namespace

/// Filters report from their own threads, so the texts are guarded.
class MessageCollector : public vtkOutputWindow {
public:
    static MessageCollector* New() { VTK_STANDARD_NEW_BODY(MessageCollector); }
    vtkTypeMacro(MessageCollector, vtkOutputWindow)

    void DisplayText(const char*) override {}
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override { keep(error, text); }
    void DisplayWarningText(const char* text) override { keep(warning, text); }
    void DisplayGenericWarningText(const char* text) override { keep(warning, text); }

    std::string read(const std::string& kept)
    {
        const std::lock_guard lock(textMutex_);
        return kept;
    }

    std::string error, warning;

private:
    void keep(std::string& kept, const char* text)
    {
        const std::lock_guard lock(textMutex_);
        if (kept.empty()) kept = oneLine(text);
    }
    std::mutex textMutex_;
};

VtkMessages::VtkMessages()
{
    outletMutex.lock();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    previous_ = vtkOutputWindow::GetInstance();
    collector_ = vtkSmartPointer<MessageCollector>::New();
    vtkOutputWindow::SetInstance(collector_);
}

VtkMessages::~VtkMessages()
{
    vtkOutputWindow::SetInstance(previous_);
    outletMutex.unlock();
}

std::string VtkMessages::firstError() const
{
    return collector_->read(collector_->error);
}

std::string VtkMessages::firstWarning() const
{
    return collector_->read(collector_->warning);
}

}  // namespace aeolic
