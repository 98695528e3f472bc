// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/scan_form.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"

namespace toile::app {

namespace {

constexpr int kSoon = 400;           // ms after the last change
constexpr double kShortestEdge = 1;  // mm, of triangles made anew
constexpr double kUsualEdge = 10;    // mm, where nothing was said of them
constexpr int kScanFieldWidth = 110, kTextWidth = 340, kLinesOfEffect = 6;

/// What reading has done and could not do with the files, a line for each step.
QString effectOf(const Garment& garment) {
    QStringList lines;
    for (const auto& file : garment.files) {
        if (garment.files.size() > 1) {
            lines << textOf(file->path.filename());
        }
        for (const Error& problem : file->problems) {
            if (problem.code == ErrorCode::ReadAs || problem.code == ErrorCode::CannotReadAs) {
                lines << wordingText(problem.detail).split("; ");
            }
        }
    }
    return lines.join('\n');
}

}  // namespace

ScanForm::ScanForm(Workspace& workspace, QWidget* parent)
    : QDialog(parent),
      workspace_(workspace),
      before_(workspace.document().state()),
      step_(workspace.document().history().index()),
      gesture_(workspace.document().newGesture()),
      debris_(new QCheckBox(tr("Drop &debris"), this)),
      effect_(new QLabel(this)) {
    setObjectName("scanForm");
    setWindowTitle(tr("Prepare the scan"));
    debris_->setObjectName("scanDebris");
    debris_->setToolTip(
        tr("Leave out fragments that are too small for a piece; what comes as "
           "several of a kind, such as buttons, stays"));
    auto* grid = new QGridLayout;
    grid->addWidget(debris_, 0, 0);
    holes_ = addStep(*grid, "scanHoles", tr("Close &holes of a perimeter up to"),
                     tr("Patches go on as the cloth around them does; neck, sleeves and hem stay "
                        "open however short they are"));
    smoothing_ = addStep(*grid, "scanSmoothing", tr("&Smooth noise by at most"),
                         tr("No point moves farther; folds and hems stay"));
    triangles_ = addStep(*grid, "scanTriangles", tr("Make &triangles anew, with edges of"),
                         tr("All about as large; names and UV map of the file go"));
    triangles_.field->setMinimum(kShortestEdge);
    grid->setColumnStretch(0, 1);

    effect_->setObjectName("scanEffect");
    effect_->setTextFormat(Qt::PlainText);
    effect_->setWordWrap(true);
    effect_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    effect_->setMinimumSize(kTextWidth, kLinesOfEffect * fontMetrics().lineSpacing());

    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    buttons->button(QDialogButtonBox::Ok)->setObjectName("scanDone");
    buttons->button(QDialogButtonBox::Cancel)->setObjectName("scanCancel");
    connect(buttons, &QDialogButtonBox::accepted, this, &ScanForm::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ScanForm::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] {
                showSteps({});
                tryNow();
            });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(effect_, 1);
    layout->addWidget(buttons);

    soon_.setSingleShot(true);
    soon_.setInterval(kSoon);
    connect(&soon_, &QTimer::timeout, this, &ScanForm::tryNow);
    connect(debris_, &QCheckBox::toggled, &soon_, qOverload<>(&QTimer::start));
    Document& document = workspace_.document();
    connect(&document, &Document::changed, this, [this](DocumentChanges what) {
        what.testFlag(DocumentChange::Opened) ? leave() : showEffect();
    });
    connect(&document.history(), &QUndoStack::indexChanged, this, [this] {
        if (!isTrying_) {
            leave();
        }
    });
    showSteps(before_.inputs.loading.preparing.scan);
    workspace_.holdFlattening(true);
    tryNow();
}

void ScanForm::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isEnter) {  // which has taken what was typed, and is to do no more
        QDialog::keyPressEvent(event);
    }
}

ScanForm::Step ScanForm::addStep(QGridLayout& grid, const char* name, const QString& text,
                                 const QString& tip) {
    const Step step{new QCheckBox(text, this), new LengthEdit(this)};
    const QString title = QString(text).remove('&');
    step.box->setObjectName(name);
    step.box->setToolTip(tip);
    step.field->setObjectName(QString(name) + "Length");
    step.field->setAccessibleName(title);
    step.field->setToolTip(tip);
    step.field->setMinimumWidth(kScanFieldWidth);
    step.field->setMaximum(kMaxPreparedLength);
    const int row = grid.rowCount();
    grid.addWidget(step.box, row, 0);
    grid.addWidget(step.field, row, 1);
    connect(step.box, &QCheckBox::toggled, step.field, &QWidget::setEnabled);
    connect(step.box, &QCheckBox::toggled, &soon_, qOverload<>(&QTimer::start));
    connect(step.field, &LengthEdit::valueChanged, &soon_, qOverload<>(&QTimer::start));
    return step;
}

ScanSteps ScanForm::said() const {
    const auto lengthOf = [](const Step& step) {
        return step.box->isChecked() ? step.field->value() : 0;
    };
    return {debris_->isChecked(), lengthOf(holes_), lengthOf(smoothing_), lengthOf(triangles_)};
}

void ScanForm::showSteps(const ScanSteps& steps) {
    const auto put = [](const Step& step, double length, double usual) {
        const QSignalBlocker quietBox(step.box), quietField(step.field);
        step.box->setChecked(length > 0);
        step.field->setEnabled(length > 0);
        step.field->setValue(length > 0 ? length : usual);
    };
    const QSignalBlocker quiet(debris_);
    debris_->setChecked(steps.dropDebris);
    put(holes_, steps.largestHole, ScanSteps{}.largestHole);
    put(smoothing_, steps.smoothing, ScanSteps{}.smoothing);
    put(triangles_, steps.edgeLength, kUsualEdge);
}

void ScanForm::tryNow() {
    soon_.stop();
    Preparation preparing = workspace_.loading().preparing;
    preparing.as = FileKind::Scan;
    preparing.scan = said();
    const QScopedValueRollback trying(isTrying_, true);
    workspace_.tryPreparing(preparing, gesture_);
    showEffect();
}

void ScanForm::showEffect() {
    const Document& document = workspace_.document();
    const bool isThere = document.garment() && document.isCurrent();
    effect_->setText(isThere ? effectOf(*document.garment()) : tr("Reading…"));
    effect_->setEnabled(isThere);
}

void ScanForm::leave() {
    if (!std::exchange(isLeft_, true)) {
        soon_.stop();
        done(Accepted);
        workspace_.holdFlattening(false);
    }
}

void ScanForm::accept() {
    if (soon_.isActive()) {
        tryNow();
    }
    leave();
}

void ScanForm::reject() {
    Document& document = workspace_.document();
    if (!isLeft_ && document.history().index() != step_) {
        const QScopedValueRollback trying(isTrying_, true);
        document.edit(windowTitle(), before_, gesture_);  // one with those before, and so none
    }
    leave();
}

}  // namespace toile::app
