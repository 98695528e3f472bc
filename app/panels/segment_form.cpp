// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/segment_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/document/mirrored_edits.h"
#include "app/text/figures.h"
#include "core/assemble/seams_file.h"
#include "core/pattern/line_fields.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

/// Limits of a typed length relative to the 3D length. Values beyond them are typing errors.
constexpr double kShortest = 0.2, kLongest = 5;
constexpr double kSameLength = 1e-5;  // mm; below the precision of the field

/// Settings in the form that are stored with a facing and with the seam.
struct BesideSegment {
    std::optional<double> facing{}, ease{};
};

constexpr auto kBesideFields = [](auto& at, auto& beside) {
    at.field(Setting{.key = "facing",
                     .title = TR("Fa&cing"),
                     .name = TR("Facing of an edge"),
                     .help = TR("Copy a strip of this width along the segment as a separate piece; "
                                "neighbouring segments share one facing"),
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

/// The notches of a seam.
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
      addPoint_(makeButton(
          "addTurnPoint", tr("Add turn point"),
          tr("Let the outline turn at the selected vertex, and end the segment there"), this)),
      removePoint_(makeButton("removeTurnPoint", tr("Remove turn point"),
                              tr("Let the outline continue smoothly at the selected vertex"),
                              this)),
      addNotch_(makeButton("segmentNotchAdd", QStringLiteral("+"),
                           tr("Add a notch in the middle of the longest part without notches"),
                           this)),
      removeNotch_(makeButton("segmentNotchRemove", QStringLiteral("−"),
                              tr("Remove the notch nearest to the middle"), this)),
      bothSides_(new QCheckBox(tr("On both sides"), this)) {
    fields_.make<SegmentSettings>(kSegmentFields, "segment");
    fields_.make<BesideSegment>(kBesideFields, "segment");
    cornerHelp_ = fields_.at("corner").toolTip();
    bothSides_->setObjectName("segmentBothSides");
    bothSides_->setToolTip(tr("Also set the allowance of the edge that is sewn to this one"));
    bothSides_->setChecked(true);
    lengths_->setWordWrap(true);
    kinks_->setWordWrap(true);
    kinks_->setToolTip(
        tr("Kink: angle between the joined lines of a sewn seam end. Turn: angle of the outline at "
           "other ends"));
    addNotch_->setAccessibleName(tr("Add notch"));
    removeNotch_->setAccessibleName(tr("Remove notch"));
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
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    int row = 0;
    const auto addLine = [&](std::initializer_list<QWidget*> widgets, int column = 0) {
        auto* line = new QHBoxLayout;
        line->setSpacing(4);
        for (QWidget* widget : widgets) {
            line->addWidget(widget);
        }
        line->addStretch(1);
        grid->addLayout(line, row++, column, 1, -1);
    };
    grid->addWidget(title_, row++, 0, 1, 3);
    grid->addWidget(lengths_, row++, 0, 1, 3);
    for (const char* path : {"length", "tolerance", "straight", "allowance"}) {
        fields_.addRow(*grid, path, row++);
    }
    addLine({bothSides_}, 1);
    row = fields_.addRemainingRows(*grid, row);
    grid->addWidget(new QLabel(tr("Notches"), this), row, 0);
    addLine({notches_, addNotch_, removeNotch_}, 1);
    grid->addWidget(kinks_, row++, 0, 1, 3);
    addLine({addPoint_, removePoint_});
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(row, 1);
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
    usual.allowance = usualAllowance();
    fields_.show(kSegmentFields, shown_.settings, usual);
    const auto& around = facts.segments[static_cast<std::size_t>(at->piece)].segments;
    const auto index = static_cast<std::size_t>(at->segment);
    fields_.at("corner").setToolTip(
        cornerHelp_ + ' ' +
        tr("The previous segment is %1.")
            .arg(segmentName(document_, around[(index + around.size() - 1) % around.size()])));
    showKinks(facts, *at);
    showTurnPoint(facts);
}

/// The segment in a pattern with allowances, unless the width or kind has changed since; or null.
const PatternSegment* SegmentForm::drawn() const {
    const auto& pattern = document_.derived().pattern;
    if (!pattern || !pattern->hasAllowance || shown_.settings.allowance) {
        return nullptr;
    }
    const auto& segments = pattern->pieces[static_cast<std::size_t>(shown_.at.piece)].segments;
    const auto found = std::ranges::find(segments, shown_.place, &PatternSegment::place);
    return found != segments.end() && found->edge == shown_.edge() ? &*found : nullptr;
}

/// The width without one of its own; in a pattern with allowances as it is limited there.
double SegmentForm::usualAllowance() const {
    if (const PatternSegment* segment = drawn()) {
        return segment->allowance;
    }
    return allowanceOf(*document_.garment(), shown_, document_.state().lines);
}

void SegmentForm::showLengths() {
    const double worn = shown_.length();
    const PieceResult* result = document_.result(shown_.at.piece);
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(shown_.at.piece)];
    const QString inSpace = lengthWithUnit(worn);
    lengths_->setText(
        result && result->flat
            ? tr("%1 in 3D, %2 in the pattern.")
                  .arg(inSpace, lengthWithUnit(flatLength(shown_.at, piece, *result->flat)))
            : tr("%1 in 3D.").arg(inSpace));
    const PatternSegment* segment = drawn();
    if (segment && segment->limit != AllowanceLimit::None) {
        const QString why = segment->limit == AllowanceLimit::Width   ? tr("the piece is narrow")
                            : segment->limit == AllowanceLimit::Curve ? tr("the edge is curved")
                                                                      : tr("the piece is small");
        lengths_->setText(lengths_->text() + ' ' +
                          tr("Allowance %1 instead of %2, because %3.")
                              .arg(lengthWithUnit(segment->allowance),
                                   lengthWithUnit(segment->usualAllowance), why));
    }
    fields_.setRange("length", std::max(kMinSegmentLength, kShortest * worn),
                     std::min(kMaxSegmentLength, kLongest * worn));
}

/// Shows the seam and the strips along the segment.
void SegmentForm::showBeside() {
    const auto& seams = document_.garment()->seams.seams;
    const Seam* seam = shown_.seam >= 0 ? &seams[static_cast<std::size_t>(shown_.seam)] : nullptr;
    const bool isFree = seam && seam->kind == SeamKind::Free, isSewn = seam && !isFree;
    seam_ = isSewn ? shown_.seam : -1;
    fields_.setEnabled("extension", shown_.place.line && isFree);
    fields_.setEnabled("edge", shown_.place.line && isFree);
    fields_.at<QComboBox>("edge").setItemText(
        0, isFree ? tr("found: %1")
                        .arg(app::tr(kEdgeKindNames[static_cast<std::size_t>(shown_.foundEdge)]))
                  : QString());
    shown_.settings.edge = isFree ? shown_.settings.edge : std::nullopt;
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
        show(*facts_);  // restore the field
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
    if (changed == "edge") {
        return withEdgeKind(std::move(lines), *facts_, alike(false), settings.edge);
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
            lines = withoutLength(std::move(lines), *partner_);  // only one side stores the length
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
                           tr("Delete notch"));
    }
}

void SegmentForm::setTurnPoint(bool turns) {
    if (vertex_) {
        vertex_->turns = turns;
        document_.setLines(withTurnPoint(document_.state().lines, *vertex_),
                           turns ? tr("Add turn point") : tr("Remove turn point"));
    }
}

}  // namespace toile::app
