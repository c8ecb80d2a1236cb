// SPDX-License-Identifier: Apache-2.0
// What the shared library shows of itself: all else in it is hidden.
#pragma once

#define ZRAKA_API __attribute__((visibility("default")))
