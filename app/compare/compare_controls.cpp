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

#include "app/compare/method_comparison.h"
#include "app/document/document.h"
#include "app/document/names.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

constexpr int kSteps = 1000;  // of the progress bar

/// What stands beside the present method at first; the present one being among them, the last.
constexpr Method kFirst[] = {Method::Curvature, Method::Wang2005, Method::Lscm, Method::Isometric};

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

}  // namespace toile::app
