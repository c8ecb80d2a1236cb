// SPDX-License-Identifier: Apache-2.0
// libqpdf finds the objects; what unpacks is bounded before it sees them, since it bounds nothing.
#include "school/grade/pdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "core/phrase.hpp"
#include "core/unpack.hpp"
#include "school/grade/archived.hpp"
#include "school/late/qpdf.hpp"

namespace zraka {
namespace {

constexpr int kMostPages = 2000, kMostKeys = 1000, kDeepestForm = 4;
/// Smaller ones are rules and logos.
constexpr int kLeastPicture = 16;

/// Does anything in the file unpack to more than a picture may, once or again?
bool unpacks_to_too_much(std::string_view bytes) {
  std::uint64_t all = 0;
  for (std::size_t at = bytes.find("stream"); at != std::string_view::npos;
       at = bytes.find("stream", at + 6)) {
    if (at >= 3 && bytes.substr(at - 3, 3) == "end") continue;
    std::size_t from = at + 6;
    if (from < bytes.size() && bytes[from] == '\r') ++from;
    if (from < bytes.size() && bytes[from] == '\n') ++from;
    const std::uint64_t one = inflated_size(bytes.substr(from), kMostBytes);
    all += one;
    if (one > kMostBytes || all > kMostBytesInAll) return true;
    // Several compressions, one over the other, are no program's that writes reports.
    const std::size_t begin = at > 400 ? at - 400 : 0;
    const std::string_view before = bytes.substr(begin, at - begin);
    const std::size_t object = before.rfind(" obj");
    const std::string_view dictionary =
        object == std::string_view::npos ? before : before.substr(object);
    const std::size_t first = dictionary.find("/FlateDecode");
    if (first != std::string_view::npos &&
        dictionary.find("/FlateDecode", first + 1) != std::string_view::npos)
      return true;
  }
  return false;
}

/// A PDF that libqpdf has opened.
class Pdf {
 public:
  Pdf(const std::string& within, std::vector<SubmittedPicture>& pictures)
      : within_(within), pictures_(pictures), data_(qpdf_init()) {
    qpdf_set_suppress_warnings(data_, 1);
    qpdf_silence_errors(data_);
  }
  ~Pdf() {
    // What has gone wrong was told in our words.
    if (qpdf_has_error(data_) != 0) qpdf_get_error(data_);
    qpdf_cleanup(&data_);
  }
  Pdf(const Pdf&) = delete;
  Pdf& operator=(const Pdf&) = delete;

  Result<void> take_all(const std::string& bytes);

 private:
  qpdf_oh key(qpdf_oh dictionary, const char* name) const {
    return qpdf_oh_get_key(data_, dictionary, name);
  }
  bool is(qpdf_oh object, const char* name) const {
    return qpdf_oh_is_name_and_equals(data_, object, name) != 0;
  }
  int number(qpdf_oh object, int otherwise) const {
    return qpdf_oh_is_integer(data_, object) != 0 ? qpdf_oh_get_int_value_as_int(data_, object)
                                                  : otherwise;
  }
  std::optional<std::string> stream(qpdf_oh object, bool unpacked) const;
  qpdf_oh resources_of(qpdf_oh page) const;
  Result<void> take_from(qpdf_oh resources, int depth);
  Result<void> take(qpdf_oh picture);
  std::optional<std::string> file_of(qpdf_oh picture) const;
  std::optional<std::string> colors_of(qpdf_oh space) const;

  const std::string& within_;
  std::vector<SubmittedPicture>& pictures_;
  qpdf_data data_;
  std::set<int> seen_;
  int count_ = 0;
};

std::optional<std::string> Pdf::stream(qpdf_oh object, bool unpacked) const {
  unsigned char* buffer = nullptr;
  std::size_t size = 0;
  QPDF_BOOL filtered = 0;
  const QPDF_ERROR_CODE code = qpdf_oh_get_stream_data(
      data_, object, unpacked ? qpdf_dl_generalized : qpdf_dl_none, &filtered, &buffer, &size);
  std::optional<std::string> bytes;
  if (code == QPDF_SUCCESS && buffer != nullptr && (!unpacked || filtered != 0))
    bytes.emplace(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  return bytes;
}

/// A page may have those of the pages around it.
qpdf_oh Pdf::resources_of(qpdf_oh page) const {
  for (int i = 0; i < 32; ++i) {
    const qpdf_oh own = key(page, "/Resources");
    if (qpdf_oh_is_dictionary(data_, own) != 0) return own;
    page = key(page, "/Parent");
    if (qpdf_oh_is_dictionary(data_, page) == 0) break;
  }
  return key(page, "/Resources");
}

Result<void> Pdf::take_all(const std::string& bytes) {
  const auto failed = [&] {
    return failure(within_, phrase(Word::grade_pdf), phrase(Word::grade_pdf_beside));
  };
  if ((qpdf_read_memory(data_, "", bytes.data(), bytes.size(), nullptr) & QPDF_ERRORS) != 0)
    return failed();
  const int pages = qpdf_get_num_pages(data_);
  if (pages <= 0) return failed();
  for (int i = 0; i < std::min(pages, kMostPages); ++i)
    if (Result<void> good =
            take_from(resources_of(qpdf_get_page_n(data_, static_cast<std::size_t>(i))), 0);
        !good)
      return good;
  return {};
}

/// Pictures by the numbers of their objects, in which programs write them; those of forms, too.
Result<void> Pdf::take_from(qpdf_oh resources, int depth) {
  if (qpdf_oh_is_dictionary(data_, resources) == 0) return {};
  const qpdf_oh objects = key(resources, "/XObject");
  if (qpdf_oh_is_dictionary(data_, objects) == 0) return {};
  std::vector<std::string> names;
  qpdf_oh_begin_dict_key_iter(data_, objects);
  while (qpdf_oh_dict_more_keys(data_) != 0 && names.size() < kMostKeys)
    names.emplace_back(qpdf_oh_dict_next_key(data_));
  std::map<int, qpdf_oh> sorted;
  for (const std::string& name : names) {
    const qpdf_oh object = key(objects, name.c_str());
    if (qpdf_oh_is_stream(data_, object) != 0)
      sorted.emplace(qpdf_oh_get_object_id(data_, object), object);
  }
  for (const auto& [id, object] : sorted) {
    if (!seen_.insert(id).second) continue;
    const qpdf_oh dictionary = qpdf_oh_get_dict(data_, object);
    Result<void> good;
    if (is(key(dictionary, "/Subtype"), "/Image"))
      good = take(object);
    else if (is(key(dictionary, "/Subtype"), "/Form") && depth < kDeepestForm)
      good = take_from(key(dictionary, "/Resources"), depth + 1);
    if (!good) return good;
  }
  return {};
}

Result<void> Pdf::take(qpdf_oh picture) {
  const qpdf_oh dictionary = qpdf_oh_get_dict(data_, picture);
  if (number(key(dictionary, "/Width"), 0) < kLeastPicture ||
      number(key(dictionary, "/Height"), 0) < kLeastPicture)
    return {};
  if (pictures_.size() == kMostPictures) return too_many_pictures(within_);
  SubmittedPicture taken{.file = fmt::format("{}/{}", within_, ++count_), .document = true};
  if (std::optional<std::string> file = file_of(picture))
    taken.bytes = std::move(*file);
  else
    taken.problems =
        failure(taken.file, phrase(Word::grade_damaged_there), phrase(Word::grade_pdf_beside))
            .value();
  pictures_.push_back(std::move(taken));
  return {};
}

/// A colour space's bytes of an index: "1" and "3" for grey and colours without one, nothing for
/// what reports do not have.
std::optional<std::string> Pdf::colors_of(qpdf_oh space) const {
  if (is(space, "/DeviceRGB")) return "3";
  if (is(space, "/DeviceGray")) return "1";
  if (qpdf_oh_is_array(data_, space) == 0) return std::nullopt;
  const auto item = [&](int i) { return qpdf_oh_get_array_item(data_, space, i); };
  if (is(item(0), "/CalRGB")) return "3";
  if (is(item(0), "/CalGray")) return "1";
  if (is(item(0), "/ICCBased") && qpdf_oh_is_stream(data_, item(1)) != 0) {
    const int channels = number(key(qpdf_oh_get_dict(data_, item(1)), "/N"), 0);
    if (channels == 3) return "3";
    if (channels == 1) return "1";
  }
  if (!is(item(0), "/Indexed") || colors_of(item(1)) != "3") return std::nullopt;
  if (qpdf_oh_is_stream(data_, item(3)) != 0) return stream(item(3), true);
  if (qpdf_oh_is_string(data_, item(3)) == 0) return std::nullopt;
  std::size_t size = 0;
  const char* colors = qpdf_oh_get_binary_string_value(data_, item(3), &size);
  return std::string(colors, size);
}

/// As a file that can be read: a JPEG as it is, all else as a PPM.
std::optional<std::string> Pdf::file_of(qpdf_oh picture) const {
  const qpdf_oh dictionary = qpdf_oh_get_dict(data_, picture);
  qpdf_oh filter = key(dictionary, "/Filter");
  if (qpdf_oh_is_array(data_, filter) != 0 && qpdf_oh_get_array_n_items(data_, filter) == 1)
    filter = qpdf_oh_get_array_item(data_, filter, 0);
  if (is(filter, "/DCTDecode")) return stream(picture, false);
  const std::optional<std::string> colors = colors_of(key(dictionary, "/ColorSpace"));
  const int width = number(key(dictionary, "/Width"), 0),
            height = number(key(dictionary, "/Height"), 0),
            bits = number(key(dictionary, "/BitsPerComponent"), 8);
  if (!colors || bits < 1 || bits > 8 || 8 % bits != 0) return std::nullopt;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (pixels * 3 > kMostBytes) return std::nullopt;
  const std::optional<std::string> packed = stream(picture, true);
  if (!packed) return std::nullopt;
  const std::size_t channels = *colors == "3" ? 3 : 1,
                    row = (static_cast<std::size_t>(width) * channels *
                               static_cast<std::size_t>(bits) +
                           7) /
                          8;
  if (packed->size() < row * static_cast<std::size_t>(height)) return std::nullopt;
  std::string file = fmt::format("P6\n{} {}\n255\n", width, height);
  file.reserve(file.size() + 3 * pixels);
  const unsigned most = (1U << bits) - 1;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t bit = (x * channels + c % channels) * static_cast<std::size_t>(bits);
        const auto byte = static_cast<unsigned char>((*packed)[y * row + bit / 8]);
        const unsigned value =
            (byte >> (8U - static_cast<unsigned>(bits) - static_cast<unsigned>(bit % 8))) & most;
        if (colors->size() == 1)
          file += static_cast<char>(value * 255 / most);
        else
          file += 3 * value + c < colors->size() ? (*colors)[3 * value + c] : '\0';
      }
  return file;
}

}  // namespace

Result<void> take_from_pdf(const std::string& bytes, const std::string& within,
                           std::vector<SubmittedPicture>& pictures) {
  if (Result<void> loaded = kLibqpdf.load(); !loaded) return loaded;
  if (unpacks_to_too_much(bytes))
    return failure(within, phrase(Word::grade_unpacks_all, kMostBytesInAll >> 20));
  return Pdf(within, pictures).take_all(bytes);
}

}  // namespace zraka
