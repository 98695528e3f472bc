// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/lay_reference.h"

#include <utility>

#include "app/document/document.h"
#include "app/render/reference_lines.h"
#include "core/formats/read_pattern.h"
#include "core/pattern/pattern.h"

namespace toile::app {

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

}  // namespace toile::app
