// SPDX-License-Identifier: Apache-2.0
// libqpdf, loaded when a PDF is read.
#pragma once

#include <qpdf/qpdf-c.h>

#include "school/late/late_function.hpp"

namespace zraka {

inline constexpr LateLibrary kLibqpdf(ZRAKA_LIBQPDF);

ZRAKA_LATE(kLibqpdf, qpdf_cleanup)
ZRAKA_LATE(kLibqpdf, qpdf_get_error)
ZRAKA_LATE(kLibqpdf, qpdf_get_num_pages)
ZRAKA_LATE(kLibqpdf, qpdf_get_page_n)
ZRAKA_LATE(kLibqpdf, qpdf_has_error)
ZRAKA_LATE(kLibqpdf, qpdf_init)
ZRAKA_LATE(kLibqpdf, qpdf_oh_begin_dict_key_iter)
ZRAKA_LATE(kLibqpdf, qpdf_oh_dict_more_keys)
ZRAKA_LATE(kLibqpdf, qpdf_oh_dict_next_key)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_array_item)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_array_n_items)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_binary_string_value)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_dict)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_int_value_as_int)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_key)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_name)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_object_id)
ZRAKA_LATE(kLibqpdf, qpdf_oh_get_stream_data)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_array)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_dictionary)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_integer)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_name_and_equals)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_stream)
ZRAKA_LATE(kLibqpdf, qpdf_oh_is_string)
ZRAKA_LATE(kLibqpdf, qpdf_read_memory)
ZRAKA_LATE(kLibqpdf, qpdf_set_suppress_warnings)
ZRAKA_LATE(kLibqpdf, qpdf_silence_errors)
}  // namespace zraka
