// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <type_traits>

#include "app/document/document_state.h"
#include "core/toile/toile.h"

namespace toile::app {

class Document;

/// A snapshot of the pattern for files.
class PatternNow {
public:
    /// @param only  the pieces to use; none: all
    /// @param settlingShare  share of the total time for flattening, if flat pieces are still warm
    PatternNow(const Document& document, std::set<int> only, double settlingShare = 0.7);

    /// Flattens what is not flat yet, lays the pattern out and passes it to `use`, a function of
    /// `(const ExportSource&, const Progress&)` to a Result.
    template <class Use>
    auto with(const ExportOptions& options, Progress& progress, const Use& use) const
        -> std::invoke_result_t<Use, const ExportSource&, const Progress&> {
        const FinishedPattern made = finished(progress);
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        return use(made.source(options, words_), progress);
    }

    /// True if files of both are the same, apart from the language.
    bool operator==(const PatternNow& other) const {
        return only_ == other.only_ && derived_ == other.derived_ && state_ == other.state_;
    }

private:
    FinishedPattern finished(Progress& progress) const;

    std::set<int> only_;
    double settlingShare_;
    Derived derived_;
    DocumentState state_;  ///< the parts that pieces and their drawing follow from
    DrawingWords words_;
};

}  // namespace toile::app
