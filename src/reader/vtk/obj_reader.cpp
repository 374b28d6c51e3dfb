#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/binary/numbers.h"
#include "reader/binary/whole_file.h"

namespace aeolic {
namespace {

constexpr std::int64_t kReportEvery = 1 << 16;  // Lines.
constexpr const char* kCorners = "corners like 1, 1/2, 1//3 or 1/2/3, all of the same kind";

class ObjReader {
public:
    ObjReader(const std::string& path, const ProgressReport& progress)
        : path_(path), text_(wholeFile(path)), progress_(progress)
    {
        normals_->SetNumberOfComponents(3);
        normals_->SetName("Normals");
        groups_->SetName("GroupIds");
        materials_->SetName("MaterialIds");
        faces_->InsertNextValue(0);
    }

    vtkSmartPointer<vtkPolyData> read()
    {
        while (nextLine()) {
            if (number_ % kReportEvery == 0) progress_("reading the surface", double(at_) / double(text_.size()));
            const std::string_view word = nextWord();
            if (word == "v")
                points_->InsertNextPoint(threeNumbers().data());
            else if (word == "vn")
                normals_->InsertNextTuple(threeNumbers().data());
            else if (word == "f")
                readFace();
            else if (word == "g")
                ++group_;
            else if (word == "usemtl")
                material_ = known_.try_emplace(std::string(nextWord()), int(known_.size())).first->second;
        }
        requireThere(vertexLine_, highestVertex_, points_->GetNumberOfPoints(), "vertex");
        requireThere(normalLine_, highestNormal_, normals_->GetNumberOfTuples(), "normal");
        return surface();
    }

private:
    [[noreturn]] void fail(const std::string& expected) const
    {
        throw InputError(
            path_, fmt::format("line {} is '{}'", number_, withoutControls(std::string(line_.substr(0, 60)), '?')),
            expected);
    }

    /// Goes to the next line, with those that a backslash at its end joins to it. False: there is none.
    bool nextLine()
    {
        if (at_ >= text_.size()) return false;
        joined_.clear();
        for (bool more = true; more && at_ < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            line_ = std::string_view(text_).substr(at_, end - at_);
            line_ = line_.substr(0, line_.find_last_not_of(" \t\r") + 1);
            at_ = end + 1;
            ++number_;
            more = line_.ends_with('\\');
            if (more) line_.remove_suffix(1);
            if (more || !joined_.empty()) joined_ += std::string(line_) + ' ';
        }
        if (!joined_.empty()) line_ = joined_;
        rest_ = line_;
        return true;
    }

    /// The next word of the line; empty at its end.
    std::string_view nextWord()
    {
        constexpr const char* blanks = " \t\r\v\f";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(word.size());
        return word;
    }

    std::array<float, 3> threeNumbers()
    {
        std::array<float, 3> numbers{};
        for (float& number : numbers) {
            const auto read = realIn<float>(nextWord());
            if (!read) fail("three numbers");
            number = *read;
        }
        return numbers;
    }

    void readFace()
    {
        const std::size_t first = corners_.size();
        int kinds = 0;
        for (std::string_view word = nextWord(); !word.empty(); word = nextWord()) {
            const auto [kind, numbers] = cornerOf(word);
            if (corners_.size() > first && kind != kinds) fail(kCorners);
            kinds = kind;
            const vtkIdType vertex = placeOf(numbers[0], points_->GetNumberOfPoints()),
                            normal = placeOf(numbers[2], normals_->GetNumberOfTuples());
            note(vertex, highestVertex_, vertexLine_);
            note(normal, highestNormal_, normalLine_);
            corners_.push_back({vertex, normal});
            for (std::size_t k = 1; k < 3; ++k)
                if ((kind >> k & 1) != 0 && numbers[k] != numbers[0]) numbersDiffer_ = true;
        }
        if (corners_.size() < first + 3) fail("at least three corners");
        isIndexed_ = isIndexed_ || kinds > 1;
        if ((kinds & 4) == 0) allHaveNormals_ = false;
        faces_->InsertNextValue(vtkIdType(corners_.size()));
        group_ = std::max(group_, 0);
        groups_->InsertNextValue(float(group_));
        materials_->InsertNextValue(material_);
    }

    /// Which of vertex, texture and normal there are, as bits, and their numbers.
    std::pair<int, std::array<std::int64_t, 3>> cornerOf(std::string_view word) const
    {
        std::array<std::int64_t, 3> numbers{};
        int kinds = 0;
        const char *at = word.data(), *const end = at + word.size();
        for (std::size_t k = 0; k < 3; ++k) {
            if (at != end && *at != '/') {
                const auto [stop, error] = std::from_chars(at, end, numbers[k]);
                if (error != std::errc{} || numbers[k] == 0) fail(kCorners);
                kinds |= 1 << k;
                at = stop;
            }
            if (at == end) break;
            if (*at++ != '/' || k == 2) fail(kCorners);
        }
        if ((kinds & 1) == 0 || word.back() == '/') fail(kCorners);
        return {kinds, numbers};
    }

    /// Numbers below zero count back from the line; others may refer to what comes later. None there is is -1.
    vtkIdType placeOf(std::int64_t number, vtkIdType count) const
    {
        if (number < -count) fail(fmt::format("numbers from {}", -count));
        return number < 0 ? count + number : number - 1;
    }

    void note(vtkIdType place, vtkIdType& highest, std::int64_t& line) const
    {
        if (place > highest) line = number_;
        highest = std::max(highest, place);
    }

    void requireThere(std::int64_t line, vtkIdType highest, vtkIdType count, const char* what) const
    {
        if (highest >= count)
            throw InputError(path_, fmt::format("line {} refers to {} {}", line, what, highest + 1),
                             fmt::format("1 to {}", count));
    }

    vtkSmartPointer<vtkPolyData> surface()
    {
        const vtkIdType points = points_->GetNumberOfPoints(), normals = normals_->GetNumberOfTuples();
        const bool hasNormals = isIndexed_ ? normals > 0 && allHaveNormals_ : normals == points && normals > 0;
        const bool areApart = numbersDiffer_ || (hasNormals && normals != points);
        const bool isSplit = isIndexed_ && areApart && (hasNormals || normals == 0);
        vtkNew<vtkPoints> cornerPoints;
        vtkNew<vtkFloatArray> cornerNormals;
        cornerNormals->SetNumberOfComponents(3);
        cornerNormals->SetName("Normals");
        vtkNew<vtkIdTypeArray> corners;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            corners->InsertNextValue(isSplit ? vtkIdType(i) : corners_[i].vertex);
            if (isSplit) cornerPoints->InsertNextPoint(points_->GetPoint(corners_[i].vertex));
            if (isSplit && hasNormals) cornerNormals->InsertNextTuple(normals_->GetTuple(corners_[i].normal));
        }
        auto data = vtkSmartPointer<vtkPolyData>::New();
        vtkNew<vtkCellArray> faces;
        faces->SetData(faces_, corners);
        data->SetPoints(isSplit ? cornerPoints : points_);
        data->SetPolys(faces);
        if (hasNormals) data->GetPointData()->SetNormals(isSplit ? cornerNormals : normals_);
        if (!known_.empty()) data->GetCellData()->AddArray(materials_);
        data->GetCellData()->AddArray(groups_);
        return data;
    }

    struct Corner {
        vtkIdType vertex = -1, normal = -1;
    };

    std::string path_, text_, joined_;
    ProgressReport progress_;
    std::size_t at_ = 0;
    std::string_view line_, rest_;
    std::int64_t number_ = 0, vertexLine_ = 0, normalLine_ = 0;
    vtkIdType highestVertex_ = -1, highestNormal_ = -1;
    bool isIndexed_ = false, allHaveNormals_ = true, numbersDiffer_ = false;  // Some face refers to more than vertices.
    int group_ = -1, material_ = -1;                                          // Of the faces that follow; -1: none yet.
    std::map<std::string, int> known_;  // Materials, in the order in which they come.
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> normals_, groups_;
    vtkNew<vtkIntArray> materials_;
    vtkNew<vtkIdTypeArray> faces_;  // Where each begins among the corners.
    std::vector<Corner> corners_;
};

}  // namespace

vtkSmartPointer<vtkDataObject> readObj(const std::string& path, const ProgressReport& progress)
{
    return ObjReader(path, progress).read();
}

}  // namespace aeolic
