// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::io {

/// Counts what a reader meets, so that a file with a thousand faults of a kind gives one message
/// with the count and the first place.
class ProblemCounter {
public:
    /// `placeWord` names what places are: "line", "face".
    explicit ProblemCounter(std::string_view placeWord) : placeWord_(placeWord) {}

    /// One more fault: `noun` is what it befell ("face"), `what` the fault ("left out: ..."). Both
    /// are literals, the latter a `translatable` one.
    void add(ErrorCode code, std::string_view noun, const char* what, int place);

    bool empty() const { return entries_.empty(); }

    /// All faults in words: "2 faces left out: ..., first at line 7; 1 vertex ..., line 3".
    Wording summary() const;
    /// One problem per code, in order of first occurrence.
    Problems problems(const std::string& file) const;

private:
    struct Entry {
        ErrorCode code;
        std::string_view noun;
        const char* what;
        int firstPlace;
        int count;
    };

    Wording inWords(const Entry& entry) const;

    std::string_view placeWord_;
    std::vector<Entry> entries_;
};

/// Corner indices that a reader pushes for what the file does not say properly.
inline constexpr int kNoSuchPosition = -1;
inline constexpr int kNoUv = -1;      ///< the corner has none: fine
inline constexpr int kNoSuchUv = -2;  ///< the corner names one that cannot be

/// Records between two looks at `Progress::isCancelled`; a power of two.
inline constexpr int kRecordsPerCancelCheck = 1 << 16;

/// The part that all readers share: it keeps the soup's promises whatever the file says. Indices
/// are checked at the end only, as a face may come before its positions.
class SoupBuilder {
public:
    /// `name` is the file for messages; `placeWord` what places are: "line", "record".
    SoupBuilder(std::string name, std::string_view placeWord);

    /// For uvs, names, corners and position text, which readers fill themselves.
    PolygonSoup& soup() { return soup_; }

    ProblemCounter& counter() { return counter_; }

    const std::string& name() const { return name_; }

    void addPosition(const Eigen::Vector3d& position, int place) {
        noteNonFinite(position, place);
        soup_.positions.push_back(position);
    }

    void noteNonFinite(const Eigen::Vector3d& position, int place) {
        if (!position.allFinite()) {
            counter_.add(ErrorCode::NonFinitePosition, "vertex",
                         toile::translatable("without finite numbers"), place);
        }
    }

    /// Keeps the place of a position whose text is no position, so that no later index shifts.
    void addUnreadablePosition(std::string_view text, int place);
    /// Ends a face: its corners are those pushed since the last face. False where they are fewer
    /// than three; they are gone then, and listed.
    bool endFace(int place);
    /// Takes back the corners pushed since the last face, and lists it.
    void dropUnreadableFace(int place);

    Error malformed(std::string detail) const;

    Error cancelled() const { return {ErrorCode::Cancelled, Subject::file(name_)}; }

    /// Leaves out faces with indices out of range and hands the soup over.
    /// Errors: NoGeometry where no face is left.
    Result<PolygonSoup> finish();

private:
    void takeBackCorners();
    void leaveOutFacesOutOfRange();
    void clearUvsOutOfRange();

    std::string name_;
    PolygonSoup soup_;
    std::vector<int> facePlaces_;
    ProblemCounter counter_;
};

/// The names of one kind (objects, groups or materials) and which one each face carries. Fills the
/// soup's lists as it promises: both empty until the first name, a name used twice is one entry.
class FaceNames {
public:
    FaceNames(std::vector<std::string>& names, std::vector<int>& perFace)
        : names_(names), perFace_(perFace) {}

    /// The name of all faces to come, as the file has it; an empty one ends the last.
    /// @param faceCount  faces so far
    void change(std::string_view text, int faceCount);

    void addFace() {
        if (!names_.empty()) {
            perFace_.push_back(current_);
        }
    }

private:
    std::vector<std::string>& names_;
    std::vector<int>& perFace_;
    std::unordered_map<std::string, int> index_;
    int current_ = -1;
};

}  // namespace toile::io
