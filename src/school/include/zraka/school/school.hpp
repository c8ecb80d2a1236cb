// SPDX-License-Identifier: Apache-2.0
// The whole public API of the school: the lab's mistakes, marks, questions.
#pragma once

#include <zraka/school/grade.hpp>
#include <zraka/school/mistakes.hpp>
#include <zraka/school/quiz.hpp>
#include <zraka/zraka.hpp>
