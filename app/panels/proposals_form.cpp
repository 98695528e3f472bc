// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/proposals_form.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyleOptionViewItem>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <vector>

#include "app/panels/cut_chart.h"
#include "app/session/cut_proposals.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"

namespace toile::app {

namespace {

enum ProposalColumn { ProposedName, ProposedLength, StrainAfter, Intake, ProposalColumnCount };

constexpr int kPollMilliseconds = 80, kTableHeight = 236, kFieldWidth = 90, kFormWidth = 430;

QString strainWord(double strain) {
    return ProposalsForm::tr("%1 %").arg(QLocale().toString(100 * strain, 'f', 1));
}

}  // namespace

ProposalsForm::ProposalsForm(CutProposals& proposals, QWidget* parent)
    : QDialog(parent),
      proposals_(proposals),
      saying_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      chart_(new CutChart(this)),
      table_(new QTreeWidget(this)),
      enough_(new QLineEdit(this)),
      swap_(new QPushButton(tr("&Swap front and back"), this)),
      make_(new QPushButton(tr("&Apply cuts"), this)) {
    setObjectName("proposalsForm");
    setWindowTitle(tr("Proposed cuts"));
    saying_->setObjectName("proposalsSaying");
    saying_->setWordWrap(true);
    saying_->setTextFormat(Qt::PlainText);
    saying_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    saying_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    progress_->setObjectName("proposalsProgress");
    progress_->setTextVisible(false);
    progress_->setRange(0, 1000);
    progress_->setMaximumHeight(6);
    table_->setObjectName("proposalTable");
    table_->setAccessibleName(tr("Proposed cuts"));
    table_->setRootIsDecorated(false);
    dressList(*table_);
    table_->setHeaderLabels({tr("Cut"), tr("Length"), tr("Strain after"), tr("Dart")});
    for (const int column : {ProposedLength, StrainAfter, Intake}) {
        table_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    table_->headerItem()->setToolTip(
        StrainAfter,
        tr("Mean strain after this cut and those above: predicted, or bold if flattened"));
    table_->headerItem()->setToolTip(Intake, tr("Intake of the dart at the edge"));
    table_->header()->setStretchLastSection(false);
    table_->header()->setSectionResizeMode(ProposedName, QHeaderView::Stretch);
    table_->setMinimumHeight(kTableHeight);
    auto* makeOne = new QAction(tr("Apply this &cut"), table_);
    makeOne->setObjectName("makeThisCut");
    table_->addAction(makeOne);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
    table_->viewport()->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(saying_);
    layout->addWidget(progress_);
    layout->addWidget(chart_);
    layout->addWidget(table_, 1);
    layout->addLayout(makeFields());
    layout->addLayout(makeButtons());

    poll_.setInterval(kPollMilliseconds);
    connect(&poll_, &QTimer::timeout, this, [this] {
        progress_->setValue(static_cast<int>(progress_->maximum() * proposals_.fraction()));
    });
    connect(makeOne, &QAction::triggered, this, &ProposalsForm::makeCurrent);
    connect(table_, &QTreeWidget::itemDoubleClicked, this, &ProposalsForm::makeCurrent);
    onEnter(*table_, [this] { makeCurrent(); });
    connect(table_, &QTreeWidget::currentItemChanged, this, [this] {
        if (!isFilling_) {
            proposals_.select(current());
        }
    });
    connect(table_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row) {
        if (!isFilling_) {
            proposals_.setTaken(static_cast<std::size_t>(table_->indexOfTopLevelItem(row)),
                                row->checkState(ProposedName) == Qt::Checked);
        }
    });
    connect(chart_, &CutChart::selected, this,
            [this](std::size_t step) { proposals_.select(step - 1); });
    connect(&proposals_, &CutProposals::changed, this, &ProposalsForm::refresh);
    connect(&proposals_, &CutProposals::selectionChanged, this, &ProposalsForm::showSelection);
    connect(&proposals_, &CutProposals::closed, this, [this] { done(Rejected); });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &ProposalsForm::refresh);
    refresh();
    resize(kFormWidth, sizeHint().height());
    table_->setFocus();
}

QLayout* ProposalsForm::makeFields() {
    auto* label = new QLabel(tr("Stop at strai&n"), this);
    label->setBuddy(enough_);
    enough_->setObjectName("proposalsEnough");
    enough_->setAccessibleName(tr("Stop at strain"));
    enough_->setMaximumWidth(kFieldWidth);
    enough_->setToolTip(
        tr("Mean strain in per cent below which no more cuts are proposed. Empty: the fabric's "
           "limit"));
    connect(enough_, &QLineEdit::editingFinished, this, [this] {
        if (!enough_->isModified()) {
            return;  // keep the exact value: the text is rounded
        }
        if (const auto entered = parsePercent(enough_->text())) {
            const auto fraction = entered->fraction;
            proposals_.stateEnough(fraction && *fraction > 0 ? fraction : std::nullopt);
        }
        enough_->setModified(false);  // refresh() shows the value that was read
        refresh();
    });
    swap_->setObjectName("proposalsSwap");
    swap_->setAutoDefault(false);
    swap_->setToolTip(
        tr("Swap the guessed front and back if names and cuts are on the wrong side"));
    connect(swap_, &QPushButton::clicked, &proposals_, &CutProposals::swapFront);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(enough_);
    row->addStretch(1);
    row->addWidget(swap_);
    return row;
}

QLayout* ProposalsForm::makeButtons() {
    make_->setObjectName("proposalsMake");
    make_->setAutoDefault(false);
    make_->setToolTip(tr("Apply the selected cuts as one undo step"));
    connect(make_, &QPushButton::clicked, &proposals_, &CutProposals::makeTaken);
    auto* close = new QPushButton(tr("&Close"), this);
    close->setObjectName("proposalsClose");
    close->setAutoDefault(false);
    connect(close, &QPushButton::clicked, this, &ProposalsForm::reject);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(make_);
    row->addWidget(close);
    return row;
}

void ProposalsForm::reject() {
    if (proposals_.isOpen()) {
        proposals_.close();  // also closes this form
    } else {
        QDialog::reject();
    }
}

bool ProposalsForm::eventFilter(QObject* object, QEvent* event) {
    if (object == table_->viewport() && event->type() == QEvent::MouseButtonDblClick) {
        const QPoint at = static_cast<const QMouseEvent*>(event)->position().toPoint();
        const QModelIndex index = table_->indexAt(at);
        QStyleOptionViewItem row;
        row.initFrom(table_);
        row.rect = table_->visualRect(index);
        row.features = QStyleOptionViewItem::HasCheckIndicator;
        // A double click on a check box only toggles it twice; it must not activate the row.
        return index.column() == ProposedName &&
               table_->style()
                   ->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &row, table_)
                   .contains(at);
    }
    return QDialog::eventFilter(object, event);
}

QString ProposalsForm::saying() const {
    const QString piece = proposals_.pieceName();
    if (!proposals_.problem().isEmpty()) {
        return proposals_.problem();
    }
    if (proposals_.state() != CutProposals::State::Known) {
        return tr("Looking for cuts in %1…").arg(piece);
    }
    const auto& cuts = proposals_.advice().cuts;
    if (cuts.empty()) {
        return tr("No cuts to propose for %1: it needs none, or Toile does not recognise its "
                  "shape. Use Piece ▸ Cut open or the cutting tools.")
            .arg(piece);
    }
    double length = 0;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        length += proposals_.isTaken(k) ? cuts[k].length : 0;
    }
    const QString counts = tr("%1: %2 of %3 cuts selected, %4 long.")
                               .arg(piece)
                               .arg(proposals_.takenCount())
                               .arg(cuts.size())
                               .arg(saidLength(length));
    return proposals_.isSolving() ? counts + ' ' + tr("Flattening the best cuts…") : counts;
}

QString ProposalsForm::strainTip(std::size_t cut) const {
    const AdvisedCut& of = proposals_.advice().cuts[cut];
    QStringList lines{QString::fromStdString(of.what.cut.name)};
    if (proposals_.isStale(cut)) {
        lines << tr("Predicted before you moved cuts: %1").arg(strainWord(of.predicted.mean));
    } else {
        lines << tr("Predicted: mean %1, maximum %2")
                     .arg(strainWord(of.predicted.mean), strainWord(of.predicted.most));
    }
    if (of.solved) {
        lines << tr("Flattened: mean %1, maximum %2")
                     .arg(strainWord(of.solved->mean), strainWord(of.solved->most));
    }
    return lines.join('\n');
}

void ProposalsForm::fill(QTreeWidgetItem& row, std::size_t cut) {
    const AdvisedCut& of = proposals_.advice().cuts[cut];
    row.setText(ProposedName, QString::fromStdString(of.what.cut.name));
    row.setToolTip(ProposedName, wordingText(of.evidence));
    row.setCheckState(ProposedName, proposals_.isTaken(cut) ? Qt::Checked : Qt::Unchecked);
    row.setText(ProposedLength, lengthWithUnit(of.length));
    row.setText(StrainAfter, strainWord(of.solved ? of.solved->mean : of.predicted.mean));
    row.setToolTip(StrainAfter, strainTip(cut));
    QFont font = table_->font();
    font.setBold(of.solved.has_value());
    row.setFont(StrainAfter, font);
    const bool isOld = proposals_.isStale(cut) && !of.solved;
    row.setForeground(StrainAfter, isOld ? palette().placeholderText() : table_->palette().text());
    row.setText(Intake, of.intake ? tr("%1, %2").arg(lengthWithUnit(of.intake->width),
                                                     angleWithUnit(of.intake->angle))
                                  : QString());
    for (const int column : {ProposedLength, StrainAfter, Intake}) {
        row.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
}

void ProposalsForm::refresh() {
    if (!proposals_.isOpen()) {
        return;
    }
    const QScopedValueRollback guard(isFilling_, true);
    const auto count = static_cast<int>(proposals_.advice().cuts.size());
    const bool isKnown = proposals_.state() == CutProposals::State::Known;
    while (table_->topLevelItemCount() > count) {
        delete table_->takeTopLevelItem(count);
    }
    while (table_->topLevelItemCount() < count) {
        new QTreeWidgetItem(table_);
    }
    bool hasDarts = false;
    for (int k = 0; k < count; ++k) {
        const auto cut = static_cast<std::size_t>(k);
        fill(*table_->topLevelItem(k), cut);
        hasDarts = hasDarts || proposals_.advice().cuts[cut].intake;
    }
    table_->setColumnHidden(Intake, !hasDarts);
    for (int column = ProposedLength; column < ProposalColumnCount; ++column) {
        table_->resizeColumnToContents(column);
    }
    table_->setEnabled(!isKnown || count > 0);  // keep the focus while waiting
    chart_->setEnabled(isKnown && count > 0);
    saying_->setText(saying());
    progress_->setVisible(proposals_.state() == CutProposals::State::Asking);
    if (progress_->isVisible() != poll_.isActive()) {
        progress_->setValue(0);
        progress_->isVisible() ? poll_.start() : poll_.stop();
    }
    make_->setEnabled(isKnown && proposals_.takenCount() > 0);
    swap_->setEnabled(isKnown && count > 0);
    if (!enough_->isModified()) {
        const auto stated = proposals_.statedEnough(), used = proposals_.enough();
        enough_->setText(stated ? strainWord(*stated) : QString());
        enough_->setPlaceholderText(used ? tr("fabric: %1").arg(strainWord(*used)) : tr("none"));
    }
    showChart();
    showSelection();
}

void ProposalsForm::showChart() {
    std::vector<CutChart::Step> steps;
    const CutAdvice& advice = proposals_.advice();
    if (!advice.cuts.empty()) {
        steps.push_back({0, advice.before.mean});
    }
    double length = 0;
    for (std::size_t k = 0; k < advice.cuts.size(); ++k) {
        const AdvisedCut& cut = advice.cuts[k];
        length += cut.length;
        steps.push_back({length, cut.predicted.mean,
                         cut.solved ? std::optional(cut.solved->mean) : std::nullopt,
                         proposals_.isStale(k), strainTip(k)});
    }
    chart_->show(std::move(steps), proposals_.enough());
}

std::optional<std::size_t> ProposalsForm::current() const {
    const int row = table_->indexOfTopLevelItem(table_->currentItem());
    return row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row));
}

void ProposalsForm::showSelection() {
    const QScopedValueRollback guard(isFilling_, true);
    const auto selected = proposals_.selected();
    auto* row = selected ? table_->topLevelItem(static_cast<int>(*selected)) : nullptr;
    if (row) {
        table_->setCurrentItem(row);
    } else {
        table_->setCurrentItem(nullptr);
        table_->clearSelection();
    }
    chart_->select(selected ? std::optional(*selected + 1) : std::nullopt);
}

void ProposalsForm::makeCurrent() {
    if (const auto cut = current()) {
        proposals_.make(*cut);
    }
}

}  // namespace toile::app
