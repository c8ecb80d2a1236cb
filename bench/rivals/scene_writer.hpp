// SPDX-License-Identifier: Apache-2.0
// What the programs that translate scenes for rivals share: arguments in, a file and a word about
// it out.
#pragma once

#include <string>
#include <zraka/formats.hpp>

namespace zraka::rivals {

/// The scene of a picture with a column and a row more, whose pixels' middles are the corners of
/// this one's: rays go where ours go.
Scene with_corners_for_middles(Scene scene);

/// main() of a translator to a format that zraka writes: `program SCENE OUTPUT [WIDTH]`, after
/// `adapt` has made of the scene what is to be compared.
int translate_file(int argc, char** argv, const char* format, Scene (*adapt)(Scene scene));

}  // namespace zraka::rivals
