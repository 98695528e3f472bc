// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::test {

using ReadFunction = Result<PolygonSoup> (*)(std::shared_ptr<const std::string>, const std::string&,
                                             Progress&);

/// Reads bytes that stand for a file named "test".
Result<PolygonSoup> read(ReadFunction reader, std::string bytes);

/// The soup of bytes that are to be read without an error; fails the test where they are not, or
/// where the soup breaks a promise.
PolygonSoup readValid(ReadFunction reader, const std::string& bytes);

/// Fails the test where the soup breaks one of the promises in its header.
void expectValid(const PolygonSoup& soup);

/// Corners of a face.
std::vector<int> face(const PolygonSoup& soup, int index);
/// The file's text of a position.
std::string_view positionText(const PolygonSoup& soup, int index);
/// Everything that two files which mean the same must agree in.
void expectSameMesh(const PolygonSoup& a, const PolygonSoup& b);

/// The detail of the one problem with this code; fails the test where there is none or another.
std::string detailOf(const Problems& problems, ErrorCode code);

/// A file with everything of the format, for tests that damage or convert it.
std::string sampleObj();
std::string sampleOff();
std::string samplePlyAscii();
std::string samplePlyBinary();
std::string sampleStlAscii();
std::string sampleStlBinary();

/// Replaces each LF.
std::string withLineEnds(std::string_view text, std::string_view lineEnd);
/// The bytes of a number, least first.
template <class T>
std::string bytesOf(T value);

}  // namespace toile::test
