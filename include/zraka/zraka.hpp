// SPDX-License-Identifier: Apache-2.0
// The whole public API of the library; the school's is <zraka/school/school.hpp>.
#pragma once

#include <zraka/bulk.hpp>
#include <zraka/compare.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/explain.hpp>
#include <zraka/formats.hpp>
#include <zraka/image.hpp>
#include <zraka/influence.hpp>
#include <zraka/layers.hpp>
#include <zraka/render.hpp>
#include <zraka/renderer.hpp>
#include <zraka/scene.hpp>
#include <zraka/write_image.hpp>
