// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::io {

/// Counts the faults that a reader finds, so that a thousand faults of a kind give one message with
/// the count and the first place.
class ProblemCounter {
public:
    /// `placeWord` is the word for places: "line", "face".
    explicit ProblemCounter(std::string_view placeWord) : placeWord_(placeWord) {}

    /// Counts one more fault: `noun` is the affected element ("face"), `what` the fault ("left out:
    /// ..."). Both are literals, the latter a `translatable` one.
    void add(ErrorCode code, std::string_view noun, const char* what, int place);

    bool empty() const { return entries_.empty(); }

    /// All faults as text: "2 faces left out: ..., first at line 7; 1 vertex ..., line 3".
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

/// Corner indices that a reader pushes for missing or unreadable values.
inline constexpr int kNoSuchPosition = -1;
inline constexpr int kNoUv = -1;      ///< the corner has none: no fault
inline constexpr int kNoSuchUv = -2;  ///< the corner names an invalid one

/// Records between two checks of `Progress::isCancelled`; a power of two.
inline constexpr int kRecordsPerCancelCheck = 1 << 16;

/// The part shared by all readers: it guarantees the soup's invariants whatever the file contains.
/// Indices are checked at the end only, as a face may come before its positions.
class SoupBuilder {
public:
    /// `name` is the file for messages; `placeWord` the word for places: "line", "record".
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

    /// Adds a placeholder for an unreadable position, so that later indices do not shift.
    void addUnreadablePosition(std::string_view text, int place);
    /// Ends a face: its corners are those pushed since the last face. False if there are fewer than
    /// three; they are then removed, and the face is listed.
    bool endFace(int place);
    /// Removes the corners pushed since the last face, and lists the face.
    void dropUnreadableFace(int place);

    Error malformed(std::string detail) const;

    Error cancelled() const { return {ErrorCode::Cancelled, Subject::file(name_)}; }

    /// Drops faces with indices out of range and returns the soup.
    /// Errors: NoGeometry if no face is left.
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

/// The names of one kind (objects, groups or materials) and the name of each face. Fills the soup's
/// lists as it requires: both empty until the first name, a name used twice is one entry.
class FaceNames {
public:
    FaceNames(std::vector<std::string>& names, std::vector<int>& perFace)
        : names_(names), perFace_(perFace) {}

    /// Sets the name of all following faces, as in the file; an empty one ends the last.
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

namespace toile {

/// The names of one kind, and the index of each face's name: -1 for none. Empty: no names.
struct ArrayNames {
    std::vector<std::string> names{};
    std::span<const int> ofFace{};  ///< one per face, or empty
};

/// A mesh in a caller's memory, row by row.
struct MeshInArrays {
    std::span<const double> positions;  ///< three numbers each
    std::span<const double> uvs{};      ///< two numbers each
    std::span<const int> faceStart;     ///< #faces + 1, ascending from 0 to #corners
    std::span<const int> corners;       ///< position index per corner
    std::span<const int> cornerUvs{};   ///< uv index per corner, -1 for none; empty: no uvs
    ArrayNames objects{}, groups{}, materials{};
    /// Decimals with which an export repeats the positions, as a file's own digits; negative: as
    /// many as reproduce the numbers.
    int decimals = -1;
};

/// The soup that a reader makes of a file with this mesh: invalid rows are dropped and listed by
/// their index, from 0.
/// @param name  used in messages only
/// Precondition: the sizes fit each other. Errors: NoGeometry. Cost: linear, one copy. Pure.
Result<PolygonSoup> soupOfArrays(const MeshInArrays& mesh, const std::string& name);

}  // namespace toile
