// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/base/worker.h"
#include "core/compare/comparison.h"

namespace toile {

class EndingWorkers;

}  // namespace toile

namespace toile::app {

class Document;
class JobRunner;
struct Scene;

/// Result of one method for one piece.
struct ComparedPiece {
    std::shared_ptr<const PieceResult> result{};  ///< flat, or the reason for failure
    ComparedFigures figures{};                    ///< seams: neighbours by the same method
    std::shared_ptr<const Scene> scene{};         ///< of this piece only; null if not flat
    PieceResults all{};  ///< the garment's results by this method; some are null
};

/// Compares methods for the selected piece, or the first flat one. Works on its own thread, one
/// method at a time, and yields to the window's jobs. Reuses results from the document and earlier
/// comparisons. GUI thread only.
class MethodComparison : public QObject {
    Q_OBJECT

public:
    enum class Stage { Waiting, Working, Done, Failed };

    struct Entry {
        Method method;
        Stage stage = Stage::Waiting;
        ComparedPiece made{};  ///< if finished
        QString problem{};     ///< a program fault, if it failed
    };

    /// @param ordinary  jobs of the window, which take precedence
    MethodComparison(const Document& document, const JobRunner& ordinary,
                     QObject* parent = nullptr);

    /// Starts working and following the document.
    void begin();
    /// Stops and drops all results.
    void end();

    /// Keeps the results of methods that stay.
    void setMethods(std::vector<Method> methods);
    /// Index into the garment's pieces.
    int piece() const { return subject_.piece; }

    /// One per method.
    const std::vector<Entry>& entries() const { return entries_; }
    bool isBusy() const;

signals:
    /// The entries or the stage of one have changed.
    void changed();

private:
    /// The subject of the entries.
    struct Subject {
        std::shared_ptr<const Garment> garment{};
        FlattenOptions options{};  ///< ignoring the method
        int piece = -1;

        bool operator==(const Subject&) const = default;
    };

    void refresh();
    void next();
    int chosenPiece() const;
    Entry* firstIn(Stage stage);
    void take(Attempt<ComparedPiece> made, bool isCancelled);
    PieceResults known(const PieceResults& before, const FlattenOptions& options) const;

    const Document& document_;
    const JobRunner& ordinary_;
    std::shared_ptr<EndingWorkers> ending_;  ///< of cancelled jobs
    QTimer pause_;                           ///< waits for a series of edits to end
    bool isActive_ = false;
    Subject subject_;
    std::vector<Method> methods_;
    std::vector<Entry> entries_;
    Worker<ComparedPiece> worker_;
};

}  // namespace toile::app
