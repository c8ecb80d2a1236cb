// SPDX-License-Identifier: Apache-2.0
// libarchive, loaded when an archive is read or written.
#pragma once

#include <archive.h>
#include <archive_entry.h>

#include "school/late/late_function.hpp"

namespace zraka {

inline constexpr LateLibrary kLibarchive(ZRAKA_LIBARCHIVE);

ZRAKA_LATE(kLibarchive, archive_entry_filetype)
ZRAKA_LATE(kLibarchive, archive_entry_free)
ZRAKA_LATE(kLibarchive, archive_entry_new)
ZRAKA_LATE(kLibarchive, archive_entry_pathname)
ZRAKA_LATE(kLibarchive, archive_entry_set_filetype)
ZRAKA_LATE(kLibarchive, archive_entry_set_pathname)
ZRAKA_LATE(kLibarchive, archive_entry_set_perm)
ZRAKA_LATE(kLibarchive, archive_entry_set_size)
ZRAKA_LATE(kLibarchive, archive_error_string)
ZRAKA_LATE(kLibarchive, archive_read_data)
ZRAKA_LATE(kLibarchive, archive_read_free)
ZRAKA_LATE(kLibarchive, archive_read_new)
ZRAKA_LATE(kLibarchive, archive_read_next_header)
ZRAKA_LATE(kLibarchive, archive_read_open_filename)
ZRAKA_LATE(kLibarchive, archive_read_open_memory)
ZRAKA_LATE(kLibarchive, archive_read_support_format_zip)
ZRAKA_LATE(kLibarchive, archive_write_close)
ZRAKA_LATE(kLibarchive, archive_write_data)
ZRAKA_LATE(kLibarchive, archive_write_free)
ZRAKA_LATE(kLibarchive, archive_write_header)
ZRAKA_LATE(kLibarchive, archive_write_new)
ZRAKA_LATE(kLibarchive, archive_write_open)
ZRAKA_LATE(kLibarchive, archive_write_set_bytes_in_last_block)
ZRAKA_LATE(kLibarchive, archive_write_set_format_zip)
}  // namespace zraka
