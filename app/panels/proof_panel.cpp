// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/proof_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "app/panels/proof_form.h"
#include "app/panels/proof_model.h"
#include "app/session/pattern_proof.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/scrolled.h"
#include "app/widgets/setting_fields.h"
#include "core/project/piece_names.h"

namespace toile::app {

namespace {

constexpr int kSettingsPart = 3, kPiecesPart = 7, kMisfitsPart = 4;
/// Sides of a seam fit if they differ by less, mm.
constexpr double kWorthSlip = 0.5;
constexpr int kProofSteps = 1000;

QString largeFirst(QString text) {
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

/// The button triggers the action and follows its enabled state, with its own text.
void standsFor(QAbstractButton& button, QAction& action) {
    QObject::connect(&button, &QAbstractButton::clicked, &action, &QAction::trigger);
    const auto follow = [&button, &action] { button.setEnabled(action.isEnabled()); };
    QObject::connect(&action, &QAction::changed, &button, follow);
    follow();
}

}  // namespace

ProofPanel::ProofPanel(Document& document, PatternProof& proof, QAction& prove, QAction& save,
                       QWidget* parent)
    : QWidget(parent),
      document_(document),
      proof_(proof),
      form_(new ProofForm(document, proof, this)),
      model_(new ProofModel(document, this)),
      table_(new QTreeView(this)),
      misfits_(new QTreeWidget(this)),
      sentence_(makeHeading({}, this)),
      particulars_(makeNote("proofParticulars", this)),
      outdated_(makeHeading({}, this)),
      empty_(new QLabel(this)),
      prove_(new QPushButton(this)),
      stop_(makeButton("stopProof", tr("Stop"), {}, this)),
      progress_(new QProgressBar(this)),
      pages_(new QStackedWidget(this)) {
    setAccessibleName(tr("Proof"));
    auto* settings = new QWidget(this);
    auto* rows = new QVBoxLayout(settings);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(form_);
    rows->addStretch(1);
    empty_->setObjectName("proofEmpty");
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setContentsMargins(24, 8, 24, 8);
    pages_->addWidget(empty_);
    pages_->addWidget(makeResult());
    auto* result = new QWidget(this);
    auto* column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHead(prove, save));
    column->addWidget(pages_, 1);
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(scrolledColumn(*settings, this), kSettingsPart);
    columns->addWidget(result, kPiecesPart + kMisfitsPart);
    connect(&document_, &Document::changed, this, &ProofPanel::onChanged);
    connect(&proof_, &PatternProof::changed, this, &ProofPanel::showRun);
    connect(&proof_.runner(), &JobRunner::progressed, progress_, [this](double fraction) {
        progress_->setValue(static_cast<int>(std::lround(fraction * kProofSteps)));
    });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &ProofPanel::refresh);
    refresh();
}

QWidget& ProofPanel::firstField() const {
    return *prove_;
}

QWidget* ProofPanel::makeHead(QAction& prove, QAction& save) {
    auto* head = new QWidget(this);
    sentence_->setObjectName("proofSentence");
    sentence_->setWordWrap(true);
    sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    particulars_->setWordWrap(true);
    outdated_->setObjectName("proofOutdated");
    prove_->setObjectName("proveButton");
    prove_->setToolTip(prove.toolTip());
    standsFor(*prove_, prove);
    connect(stop_, &QToolButton::clicked, this, [this] { proof_.cancel(); });
    progress_->setObjectName("proofProgress");
    progress_->setRange(0, kProofSteps);
    progress_->setTextVisible(false);
    progress_->setMaximumWidth(160);
    auto* report = makeButton("saveProofButton", tr("Save report…"), save.toolTip(), head);
    report->setAutoRaise(true);
    standsFor(*report, save);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(prove_);
    row->addWidget(progress_);
    row->addWidget(stop_);
    row->addWidget(outdated_);
    row->addWidget(sentence_, 1);
    row->addWidget(report, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(8, 5, 8, 3);
    column->setSpacing(2);
    column->addLayout(row);
    column->addWidget(particulars_);
    return head;
}

QWidget* ProofPanel::makeResult() {
    auto* sorted = new QSortFilterProxyModel(this);
    sorted->setSourceModel(model_);
    sorted->setSortRole(ProofModel::SortRole);
    table_->setObjectName("proofTable");
    table_->setAccessibleName(tr("Sewn pieces"));
    table_->setModel(sorted);
    table_->setRootIsDecorated(false);
    table_->setSortingEnabled(true);
    table_->sortByColumn(ProofModel::Mean, Qt::DescendingOrder);
    dressList(*table_);
    table_->header()->setStretchLastSection(false);
    const auto go = [this](const QModelIndex& index) {
        if (index.isValid() && isOfThis()) {
            emit pieceWanted(index.data(ProofModel::PieceRole).toInt());
        }
    };
    connect(table_, &QTreeView::clicked, this, go);
    onEnter(*table_, [this, go] { go(table_->currentIndex()); });
    misfits_->setObjectName("misfitList");
    misfits_->setAccessibleName(tr("Misfits"));
    misfits_->setRootIsDecorated(false);
    misfits_->setColumnCount(2);
    dressList(*misfits_);
    const auto goMisfit = [this](QTreeWidgetItem* item) {
        const int at = item ? misfits_->indexOfTopLevelItem(item) : -1;
        if (at >= 0 && at < static_cast<int>(listed_.size()) && isOfThis()) {
            const Misfit& misfit = listed_[static_cast<std::size_t>(at)];
            emit placeWanted(misfit.pieces, misfit.seam);
        }
    };
    connect(misfits_, &QTreeWidget::itemClicked, this, goMisfit);
    onEnter(*misfits_, [this, goMisfit] { goMisfit(misfits_->currentItem()); });
    auto* result = new QWidget(this);
    auto* row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(table_, kPiecesPart);
    row->addWidget(misfits_, kMisfitsPart);
    return result;
}

void ProofPanel::onChanged(const DocumentChange& what) {
    const bool isOnItsWay = document_.sewing() && document_.proof() == shown_;
    if (what.touchesContent() || (what.touches(DocumentChange::Proof) && !isOnItsWay)) {
        refresh();
    }
}

bool ProofPanel::isOfThis() const {
    return shown_ && shown_->ground.garment == document_.garment();
}

void ProofPanel::refresh() {
    const auto before = shown_;
    shown_ = document_.proof();
    if (shown_ != before) {
        model_->show(shown_);
        table_->resizeColumnToContents(ProofModel::Name);
        for (int column = ProofModel::Mean; column < ProofModel::ColumnCount; ++column) {
            table_->resizeColumnToContents(column);
            table_->setColumnWidth(column, table_->columnWidth(column) + 10);
        }
        table_->setColumnWidth(ProofModel::Name, table_->columnWidth(ProofModel::Name) + 24);
    } else {
        model_->writeAgain();
    }
    pages_->setCurrentIndex(shown_ ? 1 : 0);
    if (shown_) {
        const Garment& garment = *shown_->ground.garment;
        const Garment called = isOfThis() ? named(garment, document_.state().labels) : garment;
        sentence_->setText(largeFirst(wordingText(sentence(*shown_->proof, called))) + '.');
    } else {
        sentence_->clear();
    }
    particulars_->setText(shown_ ? particulars() : QString());
    particulars_->setVisible(shown_ != nullptr);
    showMisfits();
    showRun();
}

QString ProofPanel::particulars() const {
    const Proof& proof = *shown_->proof;
    const QLocale locale;
    QStringList said{
        tr("Gap %1 on average, 95 % %2, at most %3 %4")
            .arg(fineLength(proof.gap.mean), fineLength(proof.gap.most95),
                 fineLength(proof.gap.max), lengthUnit()),
        tr("%1 % hangs free").arg(locale.toString(100 * proof.freeShare, 'f', 0)),
        wordingText(proof.source),
        wordingText(howHeld(proof)),
        proof.edge > 0 ? tr("%1 triangles with edges of %2")
                             .arg(locale.toString(proof.triangles), lengthWithUnit(proof.edge))
                       : tr("%1 triangles").arg(locale.toString(proof.triangles)),
        proof.hasSettled
            ? tr("settled after %1 steps, %2 s")
                  .arg(locale.toString(proof.iterations), locale.toString(proof.seconds, 'f', 1))
            : tr("not settled after %1 steps: figures are approximate")
                  .arg(locale.toString(proof.iterations))};
    said.removeAll(QString());
    return said.join(QStringLiteral(" · "));
}

std::vector<ProofPanel::Misfit> ProofPanel::misfits() const {
    std::vector<Misfit> found;
    if (!shown_) {
        return found;
    }
    const Garment& garment = *shown_->ground.garment;
    const auto seamText = [&](int seam) -> QString {
        return isOfThis() ? seamName(document_, seam) : tr("seam %1").arg(seam + 1);
    };
    for (const Finding& fault : shown_->proof->faults) {
        QStringList names;
        for (const int piece : fault.pieces) {
            names << (isOfThis() ? pieceName(document_, piece)
                                 : QString::fromStdString(
                                       garment.pieces[static_cast<std::size_t>(piece)]->name));
        }
        found.push_back({largeFirst(wordingText(fault.reason)),
                         fault.seam >= 0 ? seamText(fault.seam) : names.join(", "),
                         QList<int>(fault.pieces.begin(), fault.pieces.end()), fault.seam});
    }
    for (const ProvenSeam& seam : shown_->proof->seams) {
        const bool isTold =
            std::ranges::any_of(shown_->proof->faults,
                                [&seam](const Finding& fault) { return fault.seam == seam.seam; });
        if (!isTold && std::abs(seam.slip) >= kWorthSlip) {
            found.push_back({tr("Sides differ by %1").arg(lengthWithUnit(std::abs(seam.slip))),
                             seamText(seam.seam),
                             {},
                             seam.seam});
        }
    }
    return found;
}

void ProofPanel::showMisfits() {
    listed_ = misfits();
    misfits_->clear();
    misfits_->setHeaderLabels({tr("Does not fit (%1)").arg(listed_.size()), tr("Where")});
    for (const Misfit& misfit : listed_) {
        auto* item = new QTreeWidgetItem(misfits_, {misfit.what, misfit.where});
        item->setToolTip(0, misfit.what);
        item->setToolTip(1, misfit.where);
    }
    if (listed_.empty() && shown_) {
        auto* item = new QTreeWidgetItem(misfits_, {tr("Every seam and piece fits")});
        item->setDisabled(true);
        item->setFirstColumnSpanned(true);
    }
    misfits_->resizeColumnToContents(0);
    constexpr int kWidestWhat = 260;
    misfits_->setColumnWidth(0, std::min(misfits_->columnWidth(0) + 12, kWidestWhat));
}

void ProofPanel::showRun() {
    const bool isRunning = proof_.isRunning();
    const bool isOld = shown_ && !document_.isProofCurrent();
    const bool isOfOtherPlan = shown_ && shown_->plan != proof_.plan();
    prove_->setText(shown_ ? tr("Prove again") : tr("Prove by sewing"));
    prove_->setVisible(!isRunning);
    stop_->setVisible(isRunning);
    progress_->setVisible(isRunning);
    if (!isRunning) {
        progress_->setValue(0);
    }
    outdated_->setVisible((isOld || isOfOtherPlan) && !isRunning);
    outdated_->setText(isOld ? tr("Pattern has changed") : tr("Settings have changed"));
    outdated_->setToolTip(
        isOld ? tr("The pattern, fabric or seams have changed since this proof. Prove again")
              : tr("The settings have changed since this proof. Prove again"));
    sentence_->setEnabled(!isOld);
    table_->setEnabled(!isOld || isOfThis());
    empty_->setText(isRunning ? tr("Sewing the pattern. The garment view shows the progress.")
                    : proof_.canProve()
                        ? tr("Sew the exported pattern together over the design, and measure the "
                             "difference: gaps, pulling cloth and seams that do not fit.")
                        : tr("No flat pieces to sew yet."));
}

}  // namespace toile::app
