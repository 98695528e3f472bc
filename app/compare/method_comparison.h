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

/// What one method makes of one piece.
struct ComparedPiece {
    std::shared_ptr<const PieceResult> result{};  ///< flat, or the reason why not
    ComparedFigures figures{};                    ///< seams: with pieces flattened alike
    std::shared_ptr<const Scene> scene{};         ///< of this piece alone; null where not flat
    PieceResults all{};  ///< what is known of the garment's pieces by this method, some null
};

/// The selected piece of the document by several methods, or the first flat one. Works on a thread
/// of its own, one method after the other, and yields to the window's own jobs. Takes over what the
/// document's own flattening or an earlier comparison has found. GUI thread only.
class MethodComparison : public QObject {
    Q_OBJECT

public:
    enum class Stage { Waiting, Working, Done, Failed };

    struct Entry {
        Method method;
        Stage stage = Stage::Waiting;
        ComparedPiece made{};  ///< once it is done
        QString problem{};     ///< a fault of the program, if it failed
    };

    /// @param ordinary  the window's own jobs
    MethodComparison(const Document& document, const JobRunner& ordinary,
                     QObject* parent = nullptr);

    /// Works from now on, and follows the document.
    void begin();
    /// Stops, and drops everything that was found.
    void end();

    /// Keeps what is known of those that were there before.
    void setMethods(std::vector<Method> methods);
    /// Index into the garment's pieces.
    int piece() const { return subject_.piece; }

    /// One per method.
    const std::vector<Entry>& entries() const { return entries_; }
    bool isBusy() const;

signals:
    /// The entries, or the stage of one.
    void changed();

private:
    /// What the entries are about.
    struct Subject {
        std::shared_ptr<const Garment> garment{};
        FlattenOptions options{};  ///< the method aside
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
    QTimer pause_;                           ///< lets a series of edits pass
    bool isActive_ = false;
    Subject subject_;
    std::vector<Method> methods_;
    std::vector<Entry> entries_;
    Worker<ComparedPiece> worker_;
};

}  // namespace toile::app
