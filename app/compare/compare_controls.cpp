// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/compare_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/text/figures.h"

namespace toile {

namespace {

constexpr int kSteps = 1000;  // of the progress bar

QString objectNameOf(Method method) {
    return "compare_" + QString::fromUtf8(name(method));
}

}  // namespace

CompareControls::CompareControls(QWidget* parent)
    : QWidget(parent),
      piece_(new QComboBox(this)),
      work_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      button_(new QPushButton(this)) {
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
        box->setObjectName(objectNameOf(known.method));
        connect(box, &QCheckBox::clicked, this, [this] {
            limitMethods();
            emit methodsChosen();
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
    connect(piece_, &QComboBox::activated, this, &CompareControls::pieceChosen);
    connect(button_, &QPushButton::clicked, this, [this] {
        if (stopped_) {
            emit goOnWanted();
        } else {
            emit stopWanted();
        }
    });
    showWork(false, false, 1);
}

void CompareControls::setPieces(const QStringList& names, int chosen) {
    QStringList shown;
    for (int i = 0; i < piece_->count(); ++i) {
        shown << piece_->itemText(i);
    }
    const QSignalBlocker quiet(piece_);
    if (shown != names) {
        piece_->clear();
        piece_->addItems(names);
    }
    piece_->setCurrentIndex(chosen);
}

void CompareControls::setMethods(const std::vector<Method>& methods) {
    for (const auto& [method, box] : boxes_) {
        box->setChecked(std::ranges::find(methods, method) != methods.end());
    }
    limitMethods();
}

std::vector<Method> CompareControls::methods() const {
    std::vector<Method> methods;
    for (const MethodTraits& known : allMethods()) {
        if (boxes_.at(known.method)->isChecked()) {
            methods.push_back(known.method);
        }
    }
    return methods;
}

void CompareControls::limitMethods() {
    const bool full = methods().size() >= kMostCompared;
    for (const auto& [method, box] : boxes_) {
        box->setEnabled(box->isChecked() || !full);
        box->setToolTip(box->isEnabled() ? QString()
                                         : tr("Four are compared already: take one away first"));
    }
}

void CompareControls::showWork(bool busy, bool stopped, double fraction) {
    stopped_ = stopped;
    work_->setText(busy ? tr("Comparing…") : stopped ? tr("Cancelled.") : QString());
    progress_->setVisible(busy);
    button_->setVisible(busy || stopped);
    button_->setText(stopped ? tr("Go on") : tr("Cancel"));
    showFraction(fraction);
}

void CompareControls::showFraction(double fraction) {
    progress_->setValue(static_cast<int>(fraction * kSteps));
}

}  // namespace toile
