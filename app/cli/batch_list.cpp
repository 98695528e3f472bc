// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_list.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/typed_words.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/base/version.h"

namespace toile::app {
namespace {

constexpr std::size_t kLongestStem = 60;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::vector<std::string> divided(const std::string& line, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(line);
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

std::string joinedWords(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += word + '\t';
    }
    return text;
}

/// The hash of a file's bytes, or of those of several; empty where one cannot be read.
std::string hashOfFiles(const std::vector<std::filesystem::path>& files) {
    std::string hashes;
    for (const std::filesystem::path& file : files) {
        const auto bytes = readFile(file);
        if (!bytes) {
            return {};
        }
        hashes += hashText(contentHash(*bytes));
    }
    return files.size() == 1 ? hashes : hashText(contentHash(hashes));
}

/// The first option with a value, of a line's own, that all have already; null where none is.
const std::string* saidForAll(const std::vector<std::string>& ofAll,
                              const std::vector<std::string>& own) {
    const auto isAgain = [&ofAll](const std::string& word) {
        const auto said = std::ranges::find(ofAll, word.substr(0, word.find('=')));
        return word.starts_with("--") && said != ofAll.end() && std::next(said) != ofAll.end() &&
               !std::next(said)->starts_with("--");
    };
    const auto again = std::ranges::find_if(own, isAgain);
    return again == own.end() ? nullptr : &*again;
}

/// The file's stem as far as any file system takes it.
std::string plainStem(const std::string& path) {
    std::string stem = slug(pathText(std::filesystem::path(path).stem()));
    stem.resize(std::min(stem.size(), kLongestStem));
    return stem;
}

}  // namespace

Result<BatchLines> readBatchList(const std::filesystem::path& list) {
    std::string text;
    if (list == "-") {
        text.assign(std::istreambuf_iterator<char>(std::cin), {});
    } else {
        auto bytes = readFile(list);
        if (!bytes) {
            return bytes.error();
        }
        text = std::move(*bytes);
    }
    BatchLines lines;
    text.erase(0, text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
    for (std::string line : divided(text, '\n')) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        if (trimmed(line).empty() || trimmed(line).front() == '#') {
            continue;
        }
        std::vector<std::string> words = divided(line, '\t');
        std::erase_if(words, [](const std::string& word) { return trimmed(word).empty(); });
        const std::string path = words.front();
        words.erase(words.begin());
        lines.emplace_back(path, std::move(words));
    }
    return lines;
}

bool isNoBatchList(const std::filesystem::path& list, const BatchLines& lines) {
    return looksLikeGarment(list) ||
           (!lines.empty() && std::ranges::none_of(lines, [](const auto& line) {
               std::error_code ignored;
               return looksLikeGarment(line.first) ||
                      std::filesystem::is_regular_file(line.first, ignored);
           }));
}

BatchEntry batchEntry(const BatchArguments& batch, const std::string& path,
                      const std::vector<std::string>& ownWords) {
    BatchEntry entry{.path = path, .words = batch.words};
    entry.words.insert(entry.words.end(), ownWords.begin(), ownWords.end());
    entry.arguments = typedWords("flatten", {path}, entry.words,
                                 kInputFiles | kReading | kFlattening | kExporting);
    if (const std::string* again = saidForAll(batch.words, ownWords)) {
        entry.arguments = {};
        entry.arguments.command = Arguments::Command::Message;
        entry.arguments.message = *again + " is already set for all garments; leave it out here";
    }
    entry.arguments.threads = batch.threads;
    return entry;
}

std::string hashOfContent(const BatchEntry& entry) {
    std::ostringstream notes;  // who flattens it says them
    const Arguments arguments = withProject(entry.arguments, notes);
    std::vector<std::filesystem::path> files = arguments.inputs;
    if (files.empty() || arguments.project) {  // whose inputs are its meshes
        files.insert(files.begin(), entry.path);
    }
    if (!arguments.seams.empty()) {
        files.push_back(arguments.seams);
    }
    return hashOfFiles(files);
}

void identify(BatchEntry& entry, const BatchArguments& batch, const std::string& hash) {
    entry.inputHash = hash;
    // What cannot be read has its path for its content.
    const std::string content =
        (hash.empty() ? entry.path : hash) + '\n' + joinedWords(entry.words);
    entry.name = plainStem(entry.path) + '-' + hashText(contentHash(content)).substr(6);
    entry.key = hashText(
        contentHash(content + '\n' + joinedWords(batch.formats) + '\n' + std::string(version())));
}

}  // namespace toile::app
