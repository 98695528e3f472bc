// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "app/document/document_change.h"
#include "app/jobs/job_runner.h"
#include "core/compare/comparison.h"

namespace toile {

class EndingWorkers;

}  // namespace toile

namespace toile::app {

class Document;
struct Scene;

/// What one method makes of one piece.
struct ComparedPiece {
    std::shared_ptr<const PieceResult> result{};  ///< flat, or the reason why not
    ComparedFigures figures{};                    ///< seams: with pieces flattened alike
    std::shared_ptr<const Scene> scene{};         ///< of this piece alone; null where not flat
};

/// One piece of the document by several methods, kept as the document is. The work is done on a
/// thread of its own, one method after the other, and gives way to the window's own jobs: while
/// these run nothing is begun. What the document's own flattening has found, or an earlier
/// comparison, is taken over. GUI thread only.
class MethodComparison : public QObject {
    Q_OBJECT

public:
    enum class Stage {
        Waiting,  ///< its turn comes
        Working,
        Done,    ///< `made` is there
        Failed,  ///< a fault of the program, see `problem`
    };

    struct Entry {
        Method method;
        Stage stage = Stage::Waiting;
        ComparedPiece made{};
        QString problem{};
    };

    /// @param ordinary  the window's own jobs
    MethodComparison(const Document& document, const JobRunner& ordinary,
                     QObject* parent = nullptr);

    /// Works from now on, and follows the document.
    void begin();
    /// Stops, and forgets all that was found.
    void end();

    /// In the order wanted, each once. Those that are there already stay as they are.
    void setMethods(std::vector<Method> methods);
    /// @param piece  of the garment; others are brought to one that is
    void setPiece(int piece);
    int piece() const { return piece_; }

    /// Cancels what runs and waits, until `goOn` or a change of the garment or of what is asked.
    void stop();
    void goOn();

    /// One per method.
    const std::vector<Entry>& entries() const { return entries_; }
    bool isStopped() const { return isStopped_; }
    /// True while any method is still to come, if not stopped.
    bool isBusy() const;
    /// Of all methods together, in [0, 1].
    double fraction() const;

signals:
    /// Entries are others, or one has come on.
    void changed();
    void progressed(double fraction);

private:
    /// What the entries are about.
    struct Subject {
        std::shared_ptr<const Garment> garment{};
        FlattenOptions options{};  ///< the method aside
        int piece = -1;

        bool operator==(const Subject&) const = default;
    };

    void onDocumentChanged(DocumentChanges what);
    void onIdle();
    void refresh();
    void next();
    void choosePiece();
    Entry* working();
    PieceResults known(const FlattenOptions& options) const;
    void keep(const PieceResults& results);

    const Document& document_;
    const JobRunner& ordinary_;
    JobRunner runner_;
    std::shared_ptr<EndingWorkers> ending_;  ///< of cancelled jobs
    QTimer pause_;                           ///< lets a series of edits pass
    bool isActive_ = false, isStopped_ = false;
    Subject subject_;
    std::vector<Method> methods_;
    int piece_ = 0;
    std::string pieceName_;
    std::vector<Entry> entries_;
    PieceResults kept_;  ///< what was found, one per piece and method
};

}  // namespace toile::app
