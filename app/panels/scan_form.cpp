// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/scan_form.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/session/workspace.h"
#include "app/text/error_text.h"
#include "core/prepare/scan_fields.h"

namespace toile::app {

namespace {

constexpr int kSoon = 400;           // ms after the last change
constexpr double kShortestEdge = 1;  // mm, of a new mesh
constexpr double kUsualEdge = 10;    // mm, shown while the step is off
constexpr int kTextWidth = 340, kLinesOfEffect = 6;

/// What reading did, and could not do, with the files: a line for each step.
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
      fields_(
          *this, [this] { return gesture_; },
          [this](const SettingChange& change) {
              setSteps(fields_.changed(kScanStepFields, steps_, change));
              soon_.start();
          }),
      effect_(new QLabel(this)) {
    setObjectName("scanForm");
    setWindowTitle(tr("Prepare the scan"));
    usual_.edgeLength = kUsualEdge;
    fields_.make<ScanSteps>(kScanStepFields, "scan");
    fields_.setRange("edgeLength", kShortestEdge, kMaxPreparedLength);
    makeLayout();
    soon_.setSingleShot(true);
    soon_.setInterval(kSoon);
    connect(&soon_, &QTimer::timeout, this, &ScanForm::tryNow);
    Document& document = workspace_.document();
    connect(&document, &Document::opened, this, &ScanForm::leave);
    connect(&document, &Document::changed, this, &ScanForm::showEffect);
    connect(&document.history(), &QUndoStack::indexChanged, this, [this] {
        if (!isTrying_) {
            leave();
        }
    });
    setSteps(before_.inputs.loading.preparing.scan);
    workspace_.holdFlattening(true);
    tryNow();
}

void ScanForm::makeLayout() {
    auto* grid = new QGridLayout;
    int row = 0;
    for (const char* path : {"dropDebris", "largestHole", "smoothing", "edgeLength"}) {
        fields_.addRow(*grid, path, row++);
    }
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
                setSteps({});
                tryNow();
            });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(effect_, 1);
    layout->addWidget(buttons);
}

void ScanForm::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isEnter) {  // Enter only commits a field; it must not accept the form
        QDialog::keyPressEvent(event);
    }
}

void ScanForm::setSteps(const ScanSteps& steps) {
    steps_ = steps;
    for (double ScanSteps::*length :
         {&ScanSteps::largestHole, &ScanSteps::smoothing, &ScanSteps::edgeLength}) {
        usual_.*length = steps.*length > 0 ? steps.*length : usual_.*length;
    }
    fields_.show(kScanStepFields, steps_, usual_);
    fields_.at("largestHole").setEnabled(steps_.largestHole > 0);
    fields_.at("smoothing").setEnabled(steps_.smoothing > 0);
    fields_.at("edgeLength").setEnabled(steps_.edgeLength > 0);
}

void ScanForm::tryNow() {
    soon_.stop();
    Preparation preparing = workspace_.loading().preparing;
    preparing.as = FileKind::Scan;
    preparing.scan = steps_;
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
        document.edit(windowTitle(), before_, gesture_);  // merged with the attempts: no step
    }
    leave();
}

}  // namespace toile::app
