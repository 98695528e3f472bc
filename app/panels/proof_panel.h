// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

class QAction;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QToolButton;
class QTreeView;
class QTreeWidget;

namespace toile::app {

class Document;
class DocumentChange;
class PatternProof;
class ProofForm;
class ProofModel;
struct ShownProof;

/// Result of sewing the pattern back together: settings, a summary in one sentence, the pieces, and
/// whatever does not fit. A click on a row asks to show its place.
class ProofPanel : public QWidget {
    Q_OBJECT

public:
    /// @param save  the action that saves a report. All must outlive the panel.
    ProofPanel(Document& document, PatternProof& proof, QAction& prove, QAction& save,
               QWidget* parent = nullptr);

    /// The field that takes the keyboard focus.
    QWidget& firstField() const;
    ProofForm& form() { return *form_; }

signals:
    /// The user wants to see the largest gap of this piece.
    void pieceWanted(int piece);
    /// The user wants to see something that does not fit. @param seam  -1: none
    void placeWanted(const QList<int>& pieces, int seam);

private:
    /// Something that does not fit.
    struct Misfit {
        QString what, where;
        QList<int> pieces;
        int seam = -1;
    };

    QWidget* makeHead(QAction& prove, QAction& save);
    QWidget* makeResult();
    void onChanged(const DocumentChange& what);
    void refresh();
    void showRun();
    void showMisfits();
    std::vector<Misfit> misfits() const;
    QString particulars() const;
    /// True if the listed result belongs to the open garment.
    bool isOfThis() const;

    Document& document_;
    PatternProof& proof_;
    ProofForm* form_;
    ProofModel* model_;
    QTreeView* table_;
    QTreeWidget* misfits_;
    QLabel *sentence_, *particulars_, *outdated_, *empty_;
    QPushButton* prove_;
    QToolButton* stop_;
    QProgressBar* progress_;
    QStackedWidget* pages_;                    ///< instructions, or the result
    std::shared_ptr<const ShownProof> shown_;  ///< the last complete one
    std::vector<Misfit> listed_;
};

}  // namespace toile::app
