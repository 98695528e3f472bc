// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/compare_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "app/compare/compared_column.h"
#include "app/compare/figure_table.h"
#include "app/document/document.h"
#include "app/document/names.h"
#include "app/render/gl_support.h"
#include "app/render/overlay_values.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/colour_bar.h"

namespace toile::app {
namespace {

constexpr int kSteps = 1000;  // of the progress bar

/// What stands beside the present method at first; the present one being among them, the last.
constexpr Method kFirst[] = {Method::Curvature, Method::Wang2005, Method::Lscm, Method::Isometric};

/// Shows all that any of them shows.
OverlayScale united(const OverlayScale& one, const OverlayScale& other) {
    OverlayScale both = one;
    both.low = std::min(one.low, other.low);
    both.high = std::max(one.high, other.high);
    both.below = (one.below && one.low == both.low) || (other.below && other.low == both.low);
    both.above = (one.above && one.high == both.high) || (other.above && other.high == both.high);
    return both;
}

}  // namespace

CompareControls::CompareControls(const Document& document, MethodComparison& comparison,
                                 QWidget* parent)
    : QWidget(parent),
      document_(document),
      comparison_(comparison),
      piece_(new QComboBox(this)),
      work_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      button_(new QPushButton(this)) {
    makeLayout();
    connect(piece_, &QComboBox::activated, &comparison_, &MethodComparison::setPiece);
    connect(button_, &QPushButton::clicked, this, [this] {
        if (comparison_.isStopped()) {
            comparison_.goOn();
        } else {
            comparison_.stop();
        }
    });
    connect(&comparison_, &MethodComparison::changed, this, &CompareControls::refresh);
    connect(&comparison_, &MethodComparison::progressed, this, &CompareControls::showWork);
    refresh();
}

void CompareControls::makeLayout() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 8, 0);
    auto* pieceLabel = new QLabel(tr("&Piece"), this);
    pieceLabel->setBuddy(piece_);
    piece_->setObjectName("comparePiece");
    piece_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    piece_->setToolTip(tr("Follows what is selected in the main window"));
    layout->addWidget(pieceLabel);
    layout->addWidget(piece_);
    layout->addSpacing(10);
    layout->addWidget(new QLabel(tr("Methods, up to four"), this));
    for (const MethodTraits& known : allMethods()) {
        auto* box = new QCheckBox(methodName(known.method), this);
        box->setObjectName("compare_" + QString::fromUtf8(known.name));
        connect(box, &QCheckBox::clicked, this, [this] {
            isChosen_ = true;
            comparison_.setMethods(ticked());
        });
        boxes_.emplace(known.method, box);
        layout->addWidget(box);
    }
    layout->addStretch(1);
    work_->setObjectName("compareWork");
    work_->setWordWrap(true);
    progress_->setObjectName("compareProgress");
    progress_->setRange(0, kSteps);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress"));
    button_->setObjectName("compareCancel");
    button_->setAutoDefault(false);
    layout->addWidget(work_);
    layout->addWidget(progress_);
    layout->addWidget(button_, 0, Qt::AlignLeft);
}

void CompareControls::propose() {
    if (!isChosen_) {
        std::vector<Method> methods{document_.options().method};
        for (const Method method : kFirst) {
            if (methods.size() < kMaxCompared &&
                std::ranges::find(methods, method) == methods.end()) {
                methods.push_back(method);
            }
        }
        for (const auto& [method, box] : boxes_) {
            box->setChecked(std::ranges::find(methods, method) != methods.end());
        }
    }
    int piece = 0;
    for (int i = document_.pieceCount() - 1; i >= 0; --i) {
        const PieceResult* result = document_.result(i);
        piece = result && result->flat ? i : piece;
    }
    comparison_.setMethods(ticked());
    comparison_.setPiece(document_.selection().empty() ? piece : *document_.selection().begin());
}

/// In the order of `allMethods`.
std::vector<Method> CompareControls::ticked() const {
    std::vector<Method> methods;
    for (const MethodTraits& known : allMethods()) {
        if (boxes_.at(known.method)->isChecked()) {
            methods.push_back(known.method);
        }
    }
    return methods;
}

void CompareControls::refresh() {
    showPieces();
    limitMethods();
    showWork();
}

void CompareControls::showPieces() {
    QStringList names, shown;
    if (document_.garment()) {
        for (int i = 0; i < document_.pieceCount(); ++i) {
            names << pieceName(document_, i);
        }
    }
    for (int i = 0; i < piece_->count(); ++i) {
        shown << piece_->itemText(i);
    }
    const QSignalBlocker quiet(piece_);
    if (shown != names) {
        piece_->clear();
        piece_->addItems(names);
    }
    piece_->setCurrentIndex(comparison_.piece());
}

void CompareControls::limitMethods() {
    const bool full = ticked().size() >= kMaxCompared;
    for (const auto& [method, box] : boxes_) {
        box->setEnabled(box->isChecked() || !full);
        box->setToolTip(box->isEnabled() ? QString()
                                         : tr("Four are compared already: take one away first"));
    }
}

void CompareControls::showWork() {
    const bool busy = comparison_.isBusy(), stopped = comparison_.isStopped();
    work_->setText(busy ? tr("Comparing…") : stopped ? tr("Cancelled.") : QString());
    progress_->setVisible(busy);
    progress_->setValue(static_cast<int>(comparison_.fraction() * kSteps));
    button_->setVisible(busy || stopped);
    button_->setText(stopped ? tr("Go on") : tr("Cancel"));
}

CompareWindow::CompareWindow(Document& document, const JobRunner& ordinary, QWidget* parent)
    : QDialog(parent),
      document_(document),
      comparison_(document, ordinary),
      controls_(new CompareControls(document, comparison_, this)),
      pictures_(new QWidget(this)),
      legend_(new ColourBar(this)),
      table_(new FigureTable(this)) {
    setObjectName("compareWindow");
    setWindowTitle(tr("Compare methods"));
    setSizeGripEnabled(true);
    makeLayout(glProblem());
    connect(&comparison_, &MethodComparison::changed, this, &CompareWindow::refresh);
    connect(&document_, &Document::changed, this, &CompareWindow::onDocumentChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &CompareWindow::refresh);
    resize(QSize(1360, 860).boundedTo(screen()->availableSize() * 0.95));
}

CompareWindow::~CompareWindow() {
    comparison_.disconnect();
}

void CompareWindow::makeLayout(const QString& glProblem) {
    auto* row = new QHBoxLayout(pictures_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        columns_[i] = new ComparedColumn(glProblem.isEmpty() ? &camera_ : nullptr,
                                         static_cast<int>(i), pictures_);
        connect(columns_[i], &ComparedColumn::used, this, &CompareWindow::methodWanted);
        row->addWidget(columns_[i], 1);
    }
    legend_->setObjectName("compareLegend");
    legend_->setVisible(glProblem.isEmpty());
    auto* problem = new QLabel(
        glProblem.isEmpty() ? QString() : tr("No pictures can be shown: %1").arg(glProblem), this);
    problem->setObjectName("compareGlProblem");
    problem->setWordWrap(true);
    problem->setVisible(!glProblem.isEmpty());
    auto* note = new QLabel(
        tr("★ best of its row. Seam Δ is that of the piece’s worst seam; the pieces sewn to it are "
           "flattened by the same method for it. Drag a picture to move all of them, turn the "
           "wheel "
           "to zoom, double click to see everything."),
        this);
    note->setObjectName("compareNote");
    note->setWordWrap(true);

    auto* layout = new QGridLayout(this);
    layout->addWidget(controls_, 0, 0, 3, 1);
    layout->addWidget(problem, 0, 1);
    layout->addWidget(pictures_, 1, 1);
    layout->addWidget(legend_, 2, 1);
    layout->addWidget(table_, 3, 0, 1, 2);
    layout->addWidget(note, 4, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(1, 1);
}

void CompareWindow::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    if (!event->spontaneous()) {
        controls_->propose();
        camera_.frameAll();
        comparison_.begin();
    }
}

void CompareWindow::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (!event->spontaneous()) {
        comparison_.end();
    }
}

bool CompareWindow::event(QEvent* event) {
    const bool done = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) {
        alignTable();
    }
    return done;
}

/// The figures stand under their pictures.
void CompareWindow::alignTable() {
    layout()->activate();
    table_->setTitleWidth(pictures_->x() - table_->x());
}

void CompareWindow::onDocumentChanged(DocumentChanges what) {
    if (!isVisible()) {
        return;
    }
    const Document::Selection& selection = document_.selection();
    if (what.testFlag(DocumentChange::Selection) && !selection.empty() &&
        !selection.contains(comparison_.piece())) {
        comparison_.setPiece(*selection.begin());
        camera_.frameAll();
    }
    if (what & (DocumentChange::View | DocumentChange::Fabric | DocumentChange::Settings |
                DocumentChange::Options | DocumentChange::Results)) {
        showPictures();
    }
}

void CompareWindow::refresh() {
    table_->setEntries(comparison_.entries());
    showPictures();
}

PictureLook CompareWindow::look() const {
    PictureLook look;
    look.view = document_.view();
    const int piece = comparison_.piece();
    look.fabric = piece >= 0 && piece < document_.pieceCount() ? document_.fabricOf(piece)
                                                               : document_.fabric();
    if (!isMeasured(look.view.overlay)) {
        look.view.overlay = Overlay::Strain;  // the flat checkerboard is the same by any method
    }
    look.view.seams = false;
    std::optional<OverlayScale> scale;
    for (const auto& entry : comparison_.entries()) {
        if (entry.made.scene) {
            const auto own = overlayScale(*entry.made.scene, look.view.overlay, look.fabric);
            scale = scale ? united(*scale, own) : own;
        }
    }
    look.scale = scale ? *scale : overlayScale(Scene{}, look.view.overlay, look.fabric);
    return look;
}

void CompareWindow::showPictures() {
    const auto& entries = comparison_.entries();
    const auto at = static_cast<std::size_t>(std::max(0, comparison_.piece()));
    ComparisonGround ground;
    ground.inUse = document_.options().method;
    ground.look = look();
    ground.isStopped = comparison_.isStopped();
    if (at < document_.settings().size()) {
        ground.settings = document_.settings()[at];
    }
    if (at < document_.results().size()) {
        ground.reference = document_.results()[at];
    }
    for (const auto& entry : entries) {  // any will do where the document's own is not there
        if ((!ground.reference || !ground.reference->flat) && entry.made.scene) {
            ground.reference = entry.made.result;
        }
    }
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        columns_[i]->setVisible(i < entries.size());
        if (i < entries.size()) {
            columns_[i]->show(entries[i], ground);
            box.extend(columns_[i]->box());
        }
    }
    camera_.setBox(box);
    legend_->show({.overlay = ground.look.view.overlay, .scale = ground.look.scale});
}

}  // namespace toile::app
