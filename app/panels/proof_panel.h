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

/// What sewing the pattern back together has shown: how it is done, in one sentence what came of
/// it, piece by piece, and what does not fit. A click on a row asks to go there.
class ProofPanel : public QWidget {
    Q_OBJECT

public:
    /// @param save  saves a report. All must outlive the panel.
    ProofPanel(Document& document, PatternProof& proof, QAction& prove, QAction& save,
               QWidget* parent = nullptr);

    /// Where the keyboard goes.
    QWidget& firstField() const;
    ProofForm& form() { return *form_; }

signals:
    /// The largest gap of this piece is to be shown.
    void pieceWanted(int piece);
    /// These are to be shown, of something that does not fit. @param seam  -1: none
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
    /// Whether what is listed is of the garment that is open.
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
    QStackedWidget* pages_;                    ///< what to do first, or the result
    std::shared_ptr<const ShownProof> shown_;  ///< the last whole one
    std::vector<Misfit> listed_;
};

}  // namespace toile::app
