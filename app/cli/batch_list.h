// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/result.h"

namespace toile::app {

/// A garment of a list, with all that its result follows from.
struct BatchEntry {
    std::string path;                ///< as the list has it
    std::vector<std::string> words;  ///< options of flatten: those of the batch, then its own
    Arguments arguments{};           ///< parsed; a Message where they are wrong usage
    std::string inputHash{};         ///< `hashOfContent`
    std::string name{};  ///< of its folder: the file's stem, and a hash of content and options
    /// Of content, options, formats and version of the program: by which it is known to be
    /// finished.
    std::string key{};
};

/// Paths and own words of garments.
using BatchLines = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// The garments of a list, in its order. Blank lines and those that begin with #, after blanks or
/// not, are none, and empty fields are skipped. Errors: FileUnreadable, of the list alone.
Result<BatchLines> readBatchList(const std::filesystem::path& list);

/// Whether it is a garment that was given in place of a list: by its ending, or as none of its
/// lines is a file or looks like one. Cost: a look at the disk for each line, up to the first that
/// is one.
bool isNoBatchList(const std::filesystem::path& list, const BatchLines& lines);

/// What a line of the list asks for; nothing is read, and it has neither hash nor name yet.
BatchEntry batchEntry(const BatchArguments& batch, const std::string& path,
                      const std::vector<std::string>& ownWords);

/// Of the bytes of its files, its project's meshes and its seams, `hashText`; empty where one is
/// not read. Cost: reading them, of which nobody knows how long it takes: for a process of its own.
std::string hashOfContent(const BatchEntry& entry);

/// Gives it hash, name and key. @param hash  of its content
void identify(BatchEntry& entry, const BatchArguments& batch, const std::string& hash);

}  // namespace toile::app
