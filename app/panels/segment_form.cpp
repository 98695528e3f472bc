// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/segment_form.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/document/mirrored_edits.h"
#include "app/text/figures.h"
#include "core/assemble/seams_file.h"
#include "core/pattern/line_fields.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

/// Limits of a typed length as parts of the length in 3D: what is beyond is a typing error.
constexpr double kShortest = 0.2, kLongest = 5;
constexpr double kSameLength = 1e-5;  // mm: less than the field's digits

/// Settings in the form that are stored with a facing and with the seam.
struct BesideSegment {
    std::optional<double> facing{}, ease{};
};

constexpr auto kBesideFields = [](auto& at, auto& beside) {
    at.field(
        Setting{.key = "facing",
                .title = TR("Fa&cing"),
                .name = TR("Facing of an edge"),
                .help = TR("Copy a strip of this width along the segment as a piece of its "
                           "own, a facing or a lining; neighbouring segments share one facing"),
                .none = TR("none")},
        beside.facing, kMinStrip, kMaxStrip);
    at.field(Setting{"ease",
                     TR("&Ease"),
                     TR("Ease of a seam"),
                     TR("How much longer the left side of the seam is than the right side"),
                     TR("3D length"),
                     {},
                     Quantity::Percent},
             beside.ease, -0.5, 1);
};

/// The notches of a seam, by share.
std::vector<SeamNotch> notchesAlong(const Document& document, int seam) {
    std::vector<SeamNotch> notches;
    if (const auto& pattern = document.derived().pattern) {
        notches = notchesOf(*pattern);
        std::erase_if(notches, [seam](const SeamNotch& notch) { return notch.seam != seam; });
    }
    return notches;
}

QString segmentName(const Document& document, const Segment& segment) {
    const QString piece = pieceName(document, segment.at.piece);
    if (segment.seam < 0) {
        return SegmentForm::tr("%1: free edge").arg(piece);
    }
    const Seam& seam = document.garment()->seams.seams[static_cast<std::size_t>(segment.seam)];
    const QString name = seamName(document, segment.seam);
    return seam.kind == SeamKind::Free ? name : SegmentForm::tr("%1: %2").arg(piece, name);
}

}  // namespace

SegmentForm::SegmentForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fields_(
          *this, [this] { return document_.newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      title_(makeHeading({}, this)),
      lengths_(makeNote("segmentLengths", this)),
      kinks_(makeNote("segmentKinks", this)),
      notches_(new QLabel(this)),
      addPoint_(makeButton("addTurnPoint", tr("Add turn point"),
                           tr("Let the line turn at the selected vertex: a segment ends there"),
                           this)),
      removePoint_(makeButton("removeTurnPoint", tr("Remove turn point"),
                              tr("Let the line run on smoothly at the selected vertex"), this)),
      addNotch_(makeButton("segmentNotchAdd", QStringLiteral("+"),
                           tr("Add a notch in the middle of the longest part without one"), this)),
      removeNotch_(makeButton("segmentNotchRemove", QStringLiteral("−"),
                              tr("Remove the notch nearest to the middle"), this)),
      bothSides_(new QCheckBox(tr("On both sides"), this)) {
    fields_.make<SegmentSettings>(kSegmentFields, "segment");
    fields_.make<BesideSegment>(kBesideFields, "segment");
    cornerHelp_ = fields_.at("corner").toolTip();
    bothSides_->setObjectName("segmentBothSides");
    bothSides_->setToolTip(tr("Set the allowance of the edge that is sewn to the segment, too"));
    bothSides_->setChecked(true);
    kinks_->setToolTip(
        tr("A kink is the angle that two lines sewn together lack to run into each other; at other "
           "ends the angle by which the outline turns"));
    addNotch_->setAccessibleName(tr("Add a notch"));
    removeNotch_->setAccessibleName(tr("Remove a notch"));
    notches_->setObjectName("segmentNotches");
    makeLayout();
    connect(bothSides_, &QCheckBox::clicked, this, [this] { fields_.startGesture(); });
    connect(addPoint_, &QToolButton::clicked, this, [this] { setTurnPoint(true); });
    connect(removePoint_, &QToolButton::clicked, this, [this] { setTurnPoint(false); });
    connect(addNotch_, &QToolButton::clicked, this, &SegmentForm::addNotch);
    connect(removeNotch_, &QToolButton::clicked, this, &SegmentForm::removeNotch);
    clear();
}

void SegmentForm::makeLayout() {
    title_->setObjectName("segmentTitle");
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(10, 6, 10, 6);
    columns->setSpacing(12);
    auto* grid = new QGridLayout;
    auto* added = new QGridLayout;  // additions to the segment, beside its own properties
    for (QGridLayout* column : {grid, added}) {
        columns->addLayout(column);
        column->setHorizontalSpacing(8);
        column->setVerticalSpacing(4);
    }
    columns->addStretch(1);
    const auto addButtons = [](QGridLayout& to, int row, int column, int span,
                               std::initializer_list<QWidget*> buttons) {
        auto* line = new QHBoxLayout;
        line->setSpacing(4);
        for (QWidget* button : buttons) {
            line->addWidget(button);
        }
        line->addStretch(1);
        to.addLayout(line, row, column, 1, span);
    };
    grid->addWidget(title_, 0, 0, 1, 4);
    grid->addWidget(lengths_, 1, 0, 1, 4);
    int row = 2;
    for (const char* path : {"length", "tolerance", "allowance", "corner"}) {
        fields_.addRow(*grid, path, row++);
    }
    grid->addWidget(&fields_.at("straight"), 2, 3);
    grid->addWidget(bothSides_, 4, 3);
    grid->addWidget(kinks_, row++, 0, 1, 4);
    addButtons(*grid, row++, 0, 4, {addPoint_, removePoint_});
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(row, 1);
    added->setRowMinimumHeight(0, title_->sizeHint().height());
    added->setRowMinimumHeight(1, lengths_->sizeHint().height());
    row = 2;
    for (const char* path : {"extension", "facing", "ease"}) {
        fields_.addRow(*added, path, row++);
    }
    added->addWidget(new QLabel(tr("Notches"), this), row, 0);
    added->addWidget(notches_, row, 1);
    addButtons(*added, row++, 2, 1, {addNotch_, removeNotch_});
    added->setRowStretch(row, 1);
}

void SegmentForm::clear() {
    facts_ = nullptr;
    at_.reset();
    partner_.reset();
    vertex_.reset();
    seam_ = -1;
    title_->setText(tr("Segment"));
    lengths_->setText(tr("Select a seam, or double-click a part of an outline."));
    kinks_->clear();
    notches_->clear();
    fields_.setEnabled(false);
    for (QWidget* field : std::initializer_list<QWidget*>{addPoint_, removePoint_, addNotch_,
                                                          removeNotch_, bothSides_}) {
        field->setEnabled(false);
    }
    fields_.show(kSegmentFields, SegmentSettings{});
    fields_.show(kBesideFields, BesideSegment{}, {{}, 0});
}

std::optional<SegmentAt> SegmentForm::selected(const LineFacts& facts) const {
    const Garment& garment = *document_.garment();
    if (document_.mark()) {
        return segmentAt(garment, facts, *document_.mark());
    }
    const std::optional<int> seam = document_.seam();
    return seam ? segmentOfSeam(facts, garment.seams.seams[static_cast<std::size_t>(*seam)])
                : std::nullopt;
}

void SegmentForm::show(const LineFacts& facts) {
    const std::optional<SegmentAt> at = selected(facts);
    if (at != at_) {
        fields_.startGesture();
    }
    if (!at) {
        clear();
        showTurnPoint(facts);
        return;
    }
    facts_ = &facts;
    at_ = at;
    shown_ = facts.at(*at);
    partner_.reset();
    const auto partner = partnerOf(*document_.garment(), facts, *at);
    if (partner) {
        const Segment& other = facts.at(*partner);
        partner_ = other.place;
        if (!shown_.settings.length) {
            shown_.settings.length = other.settings.length;
        }
    }
    title_->setText(segmentName(document_, shown_));
    title_->setToolTip(title_->text());
    const bool isKnown = static_cast<bool>(shown_.place.line);
    fields_.setEnabled(isKnown);
    bothSides_->setEnabled(isKnown && partner);
    showLengths();
    showBeside();
    SegmentSettings usual;
    usual.length = shown_.length();
    usual.tolerance = document_.state().lines.fairing.value_or(Fairing{}).tolerance;
    usual.allowance = allowanceOf(*document_.garment(), shown_, document_.state().lines);
    fields_.show(kSegmentFields, shown_.settings, usual);
    const auto& around = facts.segments[static_cast<std::size_t>(at->piece)].segments;
    const auto index = static_cast<std::size_t>(at->segment);
    fields_.at("corner").setToolTip(
        cornerHelp_ + ' ' +
        tr("The segment before is %1.")
            .arg(segmentName(document_, around[(index + around.size() - 1) % around.size()])));
    showKinks(facts, *at);
    showTurnPoint(facts);
}

void SegmentForm::showLengths() {
    const double worn = shown_.length();
    const PieceResult* result = document_.result(shown_.at.piece);
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(shown_.at.piece)];
    const QString inSpace = lengthWithUnit(worn);
    lengths_->setText(
        result && result->flat
            ? tr("%1 in 3D, %2 in the pattern")
                  .arg(inSpace, lengthWithUnit(flatLength(shown_.at, piece, *result->flat)))
            : tr("%1 in 3D").arg(inSpace));
    fields_.setRange("length", std::max(kMinSegmentLength, kShortest * worn),
                     std::min(kMaxSegmentLength, kLongest * worn));
}

/// The seam and the strips along the segment.
void SegmentForm::showBeside() {
    const auto& seams = document_.garment()->seams.seams;
    const Seam* seam = shown_.seam >= 0 ? &seams[static_cast<std::size_t>(shown_.seam)] : nullptr;
    const bool isFree = seam && seam->kind == SeamKind::Free, isSewn = seam && !isFree;
    seam_ = isSewn ? shown_.seam : -1;
    fields_.setEnabled("extension", shown_.place.line && isFree);
    fields_.setEnabled("ease", isSewn);
    shown_.settings.extension = isFree ? shown_.settings.extension : std::nullopt;
    fields_.show(kBesideFields,
                 BesideSegment{facingOf(document_.state().lines, shown_),
                               isSewn ? seam->ease : std::nullopt},
                 {{}, isSewn ? easeOf(*seam) : 0});
    const auto count = isSewn ? notchesAlong(document_, seam_).size() : 0;
    notches_->setText(isSewn ? QString::number(count) : QString());
    addNotch_->setEnabled(isSewn && !seam->matches.empty());
    removeNotch_->setEnabled(count > 0);
}

void SegmentForm::showKinks(const LineFacts& facts, const SegmentAt& at) {
    const OutlineSegments& of = facts.segments[static_cast<std::size_t>(at.piece)];
    if (of.turnPoints.empty()) {
        kinks_->clear();
        return;
    }
    const auto textAt = [&](int point) -> QString {
        for (std::size_t k = 0; k < facts.ends.size(); ++k) {
            for (const OutlineCorner& corner : {facts.ends[k].left, facts.ends[k].right}) {
                if (corner.piece == at.piece && corner.point == point) {
                    return tr("kink %1").arg(angleWithUnit(facts.kept[k]));
                }
            }
        }
        return tr("turn %1").arg(
            angleWithUnit(of.turnPoints[static_cast<std::size_t>(point)].turn));
    };
    const auto count = static_cast<int>(of.turnPoints.size());
    kinks_->setText(tr("Ends: %1, %2").arg(textAt(at.segment), textAt((at.segment + 1) % count)));
}

void SegmentForm::showTurnPoint(const LineFacts& facts) {
    vertex_.reset();
    const TurnPoint* there = nullptr;
    if (const auto& mark = document_.mark(); mark && mark->kind == Feature::Kind::Vertex) {
        const auto at = static_cast<std::size_t>(mark->piece);
        const Piece& piece = *document_.garment()->pieces[at];
        const auto vertex = boundaryIndex(piece, mark->vertex);
        if (vertex && !facts.segments[at].segments.empty()) {
            vertex_ = turnPointAt(piece, *vertex);
            there = turnPointOf(piece, facts.segments[at], *vertex);
        }
    }
    addPoint_->setEnabled(vertex_ && !(there && there->isCorner));
    removePoint_->setEnabled(vertex_ && there && keepsTurn(*there));
}

void SegmentForm::take(const SettingChange& change) {
    if (!at_) {
        return;
    }
    if (change.path == "ease") {
        document_.setSeamEase(seam_, change.value.number, change.gesture);
        return;
    }
    const LineSettings& before = document_.state().lines;
    const LineSettings lines =
        change.path == "facing"
            ? withFacing(change.value.number)
            : withSettings(change.path, fields_.changed(kSegmentFields, shown_.settings, change));
    if (lines == before) {
        show(*facts_);  // in place of what was typed
    } else {
        document_.setLines(lines, change.text, change.gesture);
    }
}

LineSettings SegmentForm::withSettings(const std::string& changed, SegmentSettings settings) const {
    LineSettings lines = document_.state().lines;
    if (changed == "allowance") {
        return withAllowance(std::move(lines), *facts_, alike(bothSides_->isChecked()),
                             settings.allowance);
    }
    if (changed == "extension") {
        return withExtension(std::move(lines), *facts_, alike(false), settings.extension);
    }
    if (changed == "corner") {
        const Symmetry* symmetry = editSymmetry(document_);
        const auto image =
            symmetry ? mirrorOf(*document_.garment(), *facts_, *symmetry, *at_) : std::nullopt;
        return withCorner(std::move(lines), *facts_, *at_, image, settings.corner);
    }
    if (changed == "length") {
        if (partner_) {
            lines = withoutLength(std::move(lines), *partner_);  // one of both sides has it
        }
        if (settings.length && std::abs(*settings.length - shown_.length()) < kSameLength) {
            settings.length.reset();
        }
    }
    lines = withSegment(std::move(lines), settings);
    const bool needsFairing = (changed == "tolerance" && settings.tolerance) ||
                              (changed == "straight" && settings.straight);
    return needsFairing ? withFairing(std::move(lines)) : lines;
}

std::vector<SegmentAt> SegmentForm::alike(bool bothSides) const {
    return alikeSegments(*document_.garment(), *facts_, *at_, bothSides, editSymmetry(document_));
}

LineSettings SegmentForm::withFacing(std::optional<double> width) const {
    const std::vector<SegmentAt> places = alike(false);
    std::vector<std::string> names;
    for (const SegmentAt& place : places) {
        const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(place.piece)];
        const std::string& name = nameOf(document_.state().labels, piece);
        names.push_back(tr("%1, facing").arg(QString::fromStdString(name)).toStdString());
    }
    return app::withFacing(document_.state().lines, *facts_, places, width, names);
}

void SegmentForm::addNotch() {
    std::vector<double> shares{0};
    for (const SeamNotch& notch : notchesAlong(document_, seam_)) {
        shares.push_back(notch.share);
    }
    shares.push_back(1);
    std::size_t longest = 1;
    for (std::size_t k = 2; k < shares.size(); ++k) {
        if (shares[k] - shares[k - 1] > shares[longest] - shares[longest - 1] + 1e-9) {
            longest = k;
        }
    }
    document_.setView(&ViewState::notches, true);
    document_.setLines(withNotch(document_.state().lines, *document_.garment(),
                                 {seam_, 0.5 * (shares[longest] + shares[longest - 1])}),
                       tr("Notch"));
}

void SegmentForm::removeNotch() {
    const std::vector<SeamNotch> notches = notchesAlong(document_, seam_);
    const auto nearest = std::ranges::min_element(
        notches, {}, [](const SeamNotch& notch) { return std::abs(notch.share - 0.5); });
    if (nearest != notches.end()) {
        document_.setLines(withoutNotch(document_.state().lines, *document_.garment(), *nearest,
                                        document_.derived().symmetry.get()),
                           tr("Removal of a notch"));
    }
}

void SegmentForm::setTurnPoint(bool turns) {
    if (vertex_) {
        vertex_->turns = turns;
        document_.setLines(withTurnPoint(document_.state().lines, *vertex_),
                           turns ? tr("Turn point") : tr("Removal of a turn point"));
    }
}

}  // namespace toile::app
