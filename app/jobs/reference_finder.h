// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/document/document_change.h"
#include "app/document/reference.h"

namespace toile::app {

class Document;

/// What is to be found out of a reference pattern.
struct ReferenceQuestion {
    std::shared_ptr<const Pattern> pattern{};
    std::shared_ptr<const PatternFile> file{};
    std::vector<std::string> names{};  ///< of the pieces, as a person calls them
};
bool isSameQuestion(const ReferenceQuestion& a, const ReferenceQuestion& b);

/// Lays the document's reference pattern on its pieces, on another thread, whenever one of the two
/// is another, and shows what comes of it (`Document::showReference`). GUI thread only.
class ReferenceFinder : public QObject {
    Q_OBJECT

public:
    explicit ReferenceFinder(Document& document, QObject* parent = nullptr);

signals:
    /// Once for each file: how many pieces were found in it, and which were not.
    void paired(const QString& sentence);

private:
    void onChanged(DocumentChanges what);
    void take(const Attempt<ReferenceMatch>& made);
    QString summaryOf(const ReferenceMatch& found) const;

    Document& document_;
    std::weak_ptr<const PatternFile> told_;  ///< of which something was said last
    Answerer<ReferenceQuestion, ReferenceMatch> answerer_;
};

}  // namespace toile::app
