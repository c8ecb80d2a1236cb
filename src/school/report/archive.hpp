// SPDX-License-Identifier: Apache-2.0
// The archive that the course asks for, and what follows from a student's name.
#pragma once

#include <string>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka {

struct NamedBytes {
  std::string name;  ///< in ASCII, without folders
  std::string bytes;
};

/// A zip file, deflated and without dates, so that equal files make equal archives.
Result<std::string> zip_of(const std::vector<NamedBytes>& files);

/// "OVO-V3-Rezultati-AnaŠarić.zip" for "Ana Šarić" (sheet, section 7): Latin letters stay, as
/// UTF-8, each word with a capital; all else, whatever a path could be made of, is left out. ""
/// where no letter is left or the name is no UTF-8.
std::string archive_name(const std::string& author);

/// The letter that the last of the names begins with; in Croatian Dž, Lj and Nj are one. "" where
/// it begins with none.
std::string initial_of(const std::string& author);

}  // namespace zraka
