// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/compared_column.h"

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

/// Tighter than the box of a box where the piece is turned.
Eigen::AlignedBox2d outlineBox(const Scene& scene, const Placement& placement) {
    Eigen::AlignedBox2d box;
    const VertexRun run = scene.patternLines.outlines.front();
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        const auto& vertex = scene.lineVertices[i];
        const Eigen::Vector2d flat = Eigen::Map<const Eigen::Vector2f>(vertex.flat).cast<double>();
        box.extend(placement.applied(flat));
    }
    return box;
}

}  // namespace

ComparedColumn::ComparedColumn(LinkedCamera* camera, int number, QWidget* parent)
    : QWidget(parent),
      name_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      message_(new QLabel(this)),
      use_(new QPushButton(this)) {
    name_->setObjectName(QString("compareName%1").arg(number));
    name_->setAlignment(Qt::AlignCenter);
    name_->setWordWrap(true);
    QFont bold = name_->font();
    bold.setBold(true);
    name_->setFont(bold);
    name_->setMinimumHeight(2 * name_->fontMetrics().lineSpacing());  // all pictures at one height
    message_->setObjectName(QString("compareMessage%1").arg(number));
    message_->setAlignment(Qt::AlignCenter);
    message_->setWordWrap(true);
    message_->setContentsMargins(12, 12, 12, 12);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    pages_->addWidget(message_);
    if (camera) {
        picture_ = new ComparedPicture(*camera, number == 0, pages_);
        picture_->setObjectName(QString("comparePicture%1").arg(number));
        pages_->addWidget(picture_);
    }
    use_->setObjectName(QString("compareUse%1").arg(number));
    use_->setAutoDefault(false);
    use_->setText(tr("Use this method"));
    use_->setMinimumWidth(use_->sizeHint().width());  // the same when it says less
    connect(use_, &QPushButton::clicked, this, [this] { emit used(method_); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(name_);
    layout->addWidget(pages_, 1);
    layout->addWidget(use_, 0, Qt::AlignHCenter);
}

void ComparedColumn::show(const MethodComparison::Entry& entry, const ComparisonGround& ground) {
    method_ = entry.method;
    const bool inUse = method_ == ground.inUse;
    name_->setText(methodName(method_));
    use_->setEnabled(!inUse);
    use_->setText(inUse ? tr("In use") : tr("Use this method"));
    use_->setToolTip(inUse ? tr("The garment is flattened by this method")
                           : tr("Flatten the garment by this method from now on"));
    use_->setAccessibleName(QString("%1: %2").arg(use_->text(), name_->text()));
    message_->setText(message(entry, ground.isStopped));

    const std::shared_ptr<const Scene>& scene = entry.made.scene;
    const SheetPlace place = scene ? placeOver(entry.made.result, ground) : SheetPlace{};
    box_ = scene ? outlineBox(*scene, place.placement) : Eigen::AlignedBox2d();
    if (picture_) {
        picture_->setPiece(scene, place, ground.look);
        picture_->setAccessibleName(tr("%1, the flat piece").arg(name_->text()));
        pages_->setCurrentIndex(scene ? 1 : 0);
    }
}

SheetPlace ComparedColumn::placeOver(const std::shared_ptr<const PieceResult>& result,
                                     const ComparisonGround& ground) {
    if (result != result_ || ground.reference != reference_) {
        result_ = result;
        reference_ = ground.reference;
        motion_ = flatMotions({reference_}, {result_}).front();
    }
    PieceSettings settings = ground.settings;
    settings.anchors.clear();
    settings.placement = settings.placement.value_or(Placement{});
    if (motion_) {
        settings = movedSettings(std::move(settings), motion_->oldOfNew, motion_->radius);
    }
    return placesOf({settings}).front();
}

QString ComparedColumn::message(const MethodComparison::Entry& entry, bool isStopped) {
    switch (entry.stage) {
        case MethodComparison::Stage::Waiting:
            return isStopped ? tr("Cancelled.") : tr("Waiting…");
        case MethodComparison::Stage::Working:
            return tr("Flattening…");
        case MethodComparison::Stage::Failed:
            return entry.problem;
        case MethodComparison::Stage::Done:
            break;
    }
    const PieceResult& result = *entry.made.result;
    return result.error ? errorText(*result.error) : QString();
}

}  // namespace toile::app
