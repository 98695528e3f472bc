// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/symmetry_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTreeWidget>

#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/document/piece_edits.h"
#include "app/panels/mirrored_pieces_list.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/number_edits.h"
#include "app/widgets/scrolled.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

namespace {

constexpr int kSeamOfItem = Qt::UserRole;

constexpr int kGap = 6;  // logical pixels, between the lists
/// Stretch factors of the columns.
constexpr int kSettingsShare = 4, kPiecesShare = 6, kSeamsShare = 3;

/// Keeps a number and its unit on one line.
QString unbroken(QString figure) {
    return figure.replace(' ', QChar(QChar::Nbsp));
}

}  // namespace

SymmetryPanel::SymmetryPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      mirror_(new QComboBox(this)),
      edits_(new QCheckBox(tr("Mirror &edits"), this)),
      plane_(makeNote("mirrorPlane", this)),
      drawn_(makeNote("mirrorDrawn", this)),
      pieces_(new MirroredPiecesList(this)),
      seams_(new QTreeWidget(this)) {
    makeSeamList();
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(scrolledColumn(*makeSettings(), this), kSettingsShare);
    columns->addWidget(pieces_, kPiecesShare);
    columns->addSpacing(kGap);
    columns->addWidget(seams_, kSeamsShare);
    connect(mirror_, &QComboBox::activated, this, &SymmetryPanel::setMirror);
    connect(edits_, &QCheckBox::clicked, this, [this](bool on) { setMirrorsEdits(document_, on); });
    connect(pieces_, &MirroredPiecesList::halfWanted, this, &SymmetryPanel::setHalf);
    connect(pieces_, &MirroredPiecesList::rowChosen, this, [this](int row) {
        const std::vector<int> chosen = facts_.rows[static_cast<std::size_t>(row)].pieces();
        document_.setSelection({chosen.begin(), chosen.end()});
    });
    connect(&document_, &Document::changed, this, &SymmetryPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &SymmetryPanel::refresh);
    refresh();
}

QWidget& SymmetryPanel::firstField() const {
    return *mirror_;
}

QWidget* SymmetryPanel::makeSettings() {
    auto* settings = new QWidget(this);
    mirror_->setObjectName("mirrorChoice");
    mirror_->addItem(tr("as in the file"), static_cast<int>(Mirror::None));
    mirror_->addItem(tr("equal if within 2 mm or 1 %"), static_cast<int>(Mirror::Close));
    mirror_->addItem(tr("equal: the mean of both"), static_cast<int>(Mirror::Mean));
    mirror_->addItem(tr("equal: one for both"), static_cast<int>(Mirror::First));
    mirror_->setToolTip(
        tr("How to draw mirrored pieces. Equal pieces get common lengths in mirrored seams"));
    mirror_->setFocusPolicy(Qt::StrongFocus);
    (new FieldGuard(this))->install(*mirror_);
    edits_->setObjectName("mirrorEdits");
    edits_->setToolTip(
        tr("Apply cuts and grain changes to both mirrored pieces if they are drawn equal"));
    for (QLabel* label : {plane_, drawn_}) {
        label->setWordWrap(true);
    }
    auto* label = new QLabel(tr("&Mirrored pieces"), settings);
    label->setBuddy(mirror_);
    mirror_->setAccessibleName(tr("Mirrored pieces"));
    auto* grid = new QGridLayout(settings);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->addWidget(label, 0, 0);
    grid->addWidget(mirror_, 0, 1);
    grid->addWidget(edits_, 1, 0, 1, 2);
    grid->addWidget(plane_, 2, 0, 1, 3);
    grid->addWidget(drawn_, 3, 0, 1, 3);
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(4, 1);
    return settings;
}

void SymmetryPanel::makeSeamList() {
    seams_->setObjectName("unmirroredSeamList");
    seams_->setAccessibleName(tr("Seams with no match on the other side"));
    seams_->setRootIsDecorated(false);
    dressList(*seams_);
    seams_->headerItem()->setToolTip(
        0, tr("Seams and free edges without a mirror image keep their length"));
    const auto choose = [this](const QTreeWidgetItem* item) {
        if (!fills_ && item) {
            document_.setSeam(item->data(0, kSeamOfItem).toInt());
        }
    };
    connect(seams_, &QTreeWidget::currentItemChanged, this, choose);
    connect(seams_, &QTreeWidget::itemClicked, this, choose);  // a click on the current row, too
}

void SymmetryPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isStale_) {
        refresh();
    }
}

void SymmetryPanel::onChanged(const DocumentChange& what) {
    if (what.touchesContent() || what.touches(DocumentChange::View)) {
        refresh();
    } else if (what.touches(DocumentChange::Selection)) {
        pieces_->select(document_.selection());
    }
}

void SymmetryPanel::refresh() {
    isStale_ = !isVisible();
    const Mirror mirror = document_.state().lines.mirror;
    const bool isOpen = document_.garment() != nullptr;
    mirror_->setEnabled(isOpen);
    mirror_->setCurrentIndex(mirror_->findData(static_cast<int>(mirror)));
    edits_->setEnabled(isOpen && mirror != Mirror::None);
    edits_->setChecked(mirrorsEdits(document_));
    if (!isStale_) {
        showFacts();
    }
}

void SymmetryPanel::showFacts() {
    const Symmetry* symmetry = document_.derived().symmetry.get();
    facts_ = document_.garment() && symmetry
                 ? symmetryFacts(*document_.garment(), document_.results(), *symmetry)
                 : SymmetryFacts{};
    pieces_->show(document_, facts_);
    pieces_->select(document_.selection());
    plane_->setText(planeText());
    drawn_->setText(drawnText());
    showSeams();
}

QString SymmetryPanel::planeText() const {
    if (!document_.garment()) {
        return {};
    }
    if (const Symmetry* symmetry = document_.derived().symmetry.get()) {
        return tr("Left and right differ by %1, at most %2.")
            .arg(unbroken(lengthWithUnit(symmetry->plane.deviation)),
                 unbroken(lengthWithUnit(symmetry->plane.farthest)));
    }
    if (document_.state().lines.mirror == Mirror::None) {
        return tr("Left and right are not compared. Choose how to draw mirrored pieces.");
    }
    return document_.isFlattened()
               ? tr("No mirror plane: left and right of this garment differ too much.")
               : tr("Flatten the pieces to find the mirror plane.");
}

QString SymmetryPanel::drawnText() const {
    if (facts_.equal == 0) {
        return {};
    }
    return tr("%1 of %2 are drawn equal. Seams change by at most %3. The largest strain changes "
              "from %4 to %5.")
        .arg(QString::number(facts_.equal), QString::number(facts_.pairs),
             unbroken(fineLength(facts_.lengthChange) + ' ' + lengthUnit()),
             unbroken(tr("%1 %").arg(percent(facts_.exactStrain))),
             unbroken(tr("%1 %").arg(percent(facts_.strain))));
}

void SymmetryPanel::showSeams() {
    const QScopedValueRollback fills(fills_, true);
    seams_->clear();
    seams_->setVisible(!facts_.seams.empty());
    seams_->setHeaderLabels({tr("No match on the other side (%1)").arg(facts_.seams.size())});
    for (const int seam : facts_.seams) {
        auto* item = new QTreeWidgetItem(seams_);
        item->setText(0, seamName(document_, seam));
        item->setToolTip(0, item->text(0));
        item->setData(0, kSeamOfItem, seam);
    }
}

void SymmetryPanel::setMirror(int choice) {
    LineSettings lines = document_.state().lines;
    lines.mirror = static_cast<Mirror>(mirror_->itemData(choice).toInt());
    const QString text = lines.mirror == Mirror::None ? tr("Keep mirrored pieces as in the file")
                                                      : tr("Make mirrored pieces equal");
    document_.setLines(std::move(lines), text);
}

void SymmetryPanel::setHalf(int row, bool byHalf) {
    setByHalf(document_, facts_.rows[static_cast<std::size_t>(row)].pieces(), byHalf);
}

}  // namespace toile::app
