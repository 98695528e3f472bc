// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/reference_finder.h"

#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/render/scene_builder.h"
#include "app/text/error_text.h"
#include "core/base/units.h"
#include "core/formats/read_pattern.h"
#include "core/pattern/pattern.h"

namespace toile::app {

namespace {

/// Maximum number of names in one sentence.
constexpr int kNamed = 4;

QString listOf(const QStringList& names) {
    return names.mid(0, kNamed).join(", ") + (names.size() > kNamed ? ", …" : "");
}

}  // namespace

Result<ReferenceFile> readReference(const std::filesystem::path& path) {
    Result<PatternFile> read = readPatternFile(path);
    if (!read) {
        return read.error();
    }
    return ReferenceFile{path, std::make_shared<const PatternFile>(std::move(read).value())};
}

std::optional<ReferenceQuestion> referenceQuestion(const Document& document) {
    ReferenceQuestion question{document.derived().pattern, document.state().reference.file};
    if (!question.pattern || !question.file) {
        return std::nullopt;
    }
    for (const auto& piece : document.garment()->pieces) {
        question.names.push_back(nameOf(document.state().labels, *piece));
    }
    return question;
}

ReferenceMatch layReference(const ReferenceQuestion& question) {
    Pattern pattern = *question.pattern;
    for (std::size_t k = 0; k < pattern.pieces.size(); ++k) {
        pattern.pieces[k].name = question.names[k];
    }
    ReferenceMatch found{question.pattern, question.file, matchPatterns(pattern, *question.file)};
    found.lines = std::make_shared<const ReferenceLines>(referenceLines(found.match));
    return found;
}

ReferenceFinder::ReferenceFinder(Document& document, QObject* parent)
    : QObject(parent),
      document_(document),
      follower_(layReference, [this](const auto& made, const auto&, bool) { take(made); }) {
    connect(&document_, &Document::changed, this, &ReferenceFinder::ask);
}

void ReferenceFinder::ask() {
    if (auto question = referenceQuestion(document_)) {
        follower_.ask(*std::move(question));
    }
}

void ReferenceFinder::take(const Attempt<ReferenceMatch>& made) {
    if (!made.answer) {
        return;  // out of memory
    }
    document_.showReference(std::make_shared<const ReferenceMatch>(*made.answer));
    const ReferenceMatch* shown = document_.reference();
    // Wait until all pieces are flat.
    if (shown && document_.isFlattened() && told_.lock() != shown->file) {
        told_ = shown->file;
        emit paired(summaryOf(*shown));
    }
}

QString ReferenceFinder::summaryOf(const ReferenceMatch& found) const {
    const auto nameOfPiece = [this](int piece) {
        const Piece& named = *document_.garment()->pieces[static_cast<std::size_t>(piece)];
        return QString::fromStdString(nameOf(document_.state().labels, named));
    };
    QStringList alone, doubtful, unlike, unused;
    for (const int piece : found.match.alone) {
        alone << nameOfPiece(piece);
    }
    for (const PieceMatch& pair : found.match.pairs) {
        if (!isSure(pair)) {
            doubtful << nameOfPiece(pair.piece);
        } else if (pair.isDoubtful()) {
            unlike << nameOfPiece(pair.piece);
        }
    }
    for (const int piece : found.match.aloneInFile) {
        unused << QString::fromStdString(found.file->pieces[static_cast<std::size_t>(piece)].name);
    }
    const auto pairs = static_cast<qsizetype>(found.match.pairs.size());
    QString text =
        tr("Reference pattern %1: %2 of %3 pieces matched")
            .arg(textOf(document_.state().reference.path.filename()),
                 QString::number(pairs - doubtful.size()), QString::number(pairs + alone.size()));
    const auto add = [&text](const QString& clause) { text += "; " + clause; };
    if (!alone.isEmpty()) {
        add(tr("no match: %1").arg(listOf(alone)));
    }
    if (!doubtful.isEmpty()) {
        add(tr("several matches: %1").arg(listOf(doubtful)));
    }
    if (!unlike.isEmpty()) {
        add(tr("uncertain, because the sizes differ: %1").arg(listOf(unlike)));
    }
    if (!unused.isEmpty()) {
        add(tr("only in the file: %1").arg(listOf(unused)));
    }
    if (found.file->unitInDoubt) {
        add(tr("unit uncertain, read as %1")
                .arg(QString::fromStdString(unitText(found.file->unit))));
    }
    for (const Wording& note : found.file->notes) {
        add(wordingText(note));
    }
    return text;
}

}  // namespace toile::app
