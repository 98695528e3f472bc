// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "core/garment/split.h"

namespace toile {

/// Names for the pieces of one file: those of the file where they tell pieces apart, made unique.
class PieceNames {
public:
    PieceNames(const PolygonSoup& soup, SplitMode mode);

    /// What the file calls the piece that a face belongs to: by the mode's own kind of name, else
    /// its object, its group; "panel" where a UV map's islands have no names of their own, else
    /// "piece".
    std::string inFile(int face) const;
    /// The name itself the first time, then with " 2", " 3"; panels without a name are numbered
    /// from 1.
    std::string unique(const std::string& wanted);

private:
    const PolygonSoup& soup_;
    SplitMode mode_;
    std::set<std::string> taken_;
    std::map<std::string, int> nextNumber_;  ///< thousands of pieces may share a name
};

}  // namespace toile
