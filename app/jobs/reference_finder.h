// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/document/reference.h"
#include "core/base/result.h"

namespace toile::app {

class Document;

/// How does a reference pattern lie on a pattern?
struct ReferenceQuestion {
    std::shared_ptr<const Pattern> pattern{};
    std::shared_ptr<const PatternFile> file{};
    std::vector<std::string> names{};  ///< of the pieces, as the user calls them

    bool operator==(const ReferenceQuestion&) const = default;
};

/// Reads a pattern by its ending. Errors: of `readPatternFile`.
/// @param path  absolute
Result<ReferenceFile> readReference(const std::filesystem::path& path);

/// The question for the document; none if no reference pattern is open, or there is no pattern yet.
std::optional<ReferenceQuestion> referenceQuestion(const Document& document);

/// Pairs the pieces and lays the file's outlines on them. Pure. Cost: of `matchPatterns`.
ReferenceMatch layReference(const ReferenceQuestion& question);

/// Lays the document's reference pattern on its pieces on another thread, whenever one of the two
/// changes, and shows the result (`Document::showReference`). GUI thread only.
class ReferenceFinder : public QObject {
    Q_OBJECT

public:
    explicit ReferenceFinder(Document& document, QObject* parent = nullptr);

signals:
    /// Once for each file: how many pieces were found in it, and which were not.
    void paired(const QString& sentence);

private:
    void ask();
    void take(const Attempt<ReferenceMatch>& made);
    QString summaryOf(const ReferenceMatch& found) const;

    Document& document_;
    std::weak_ptr<const PatternFile> told_;  ///< reported last
    Follower<ReferenceQuestion, ReferenceMatch> follower_;
};

}  // namespace toile::app
