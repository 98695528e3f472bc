// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/problem_tally.h"
#include "core/io/soup.h"

namespace toile {

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

    ProblemTally& tally() { return tally_; }

    const std::string& name() const { return name_; }

    void addPosition(const Eigen::Vector3d& position, int place) {
        noteNonFinite(position, place);
        soup_.positions.push_back(position);
    }

    void noteNonFinite(const Eigen::Vector3d& position, int place) {
        if (!position.allFinite()) {
            tally_.add(ErrorCode::NonFinitePosition, "vertex", "without finite numbers", place);
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

    Error cancelled() const { return {ErrorCode::Cancelled, name_, ""}; }

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
    ProblemTally tally_;
};

/// Refuses a file so large that a count in it might not fit an int (2 GiB).
std::optional<Error> refuseTooLarge(const std::string& bytes, const std::string& name);

}  // namespace toile
