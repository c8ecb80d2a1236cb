// SPDX-License-Identifier: Apache-2.0
#include "tachyon_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <zraka/render.hpp>

#include "core/text.hpp"

namespace zraka::app {

const char* const kTachyonHelp =
    "zraka-tachyon SCENE [OPTIONS]: draws a Tachyon scene, called as Tachyon is called\n"
    "\n"
    "  -o FILE                  the picture (default outfile.tga)\n"
    "  -format NAME             TARGA (default), BMP, PPM, PPM48, PNG or JPEG\n"
    "  -res WIDTH HEIGHT        the picture's size, in place of the scene's\n"
    "  -aasamples N             N samples of a pixel besides the first\n"
    "  -raydepth N              levels of rays, those from the eye among them\n"
    "  -numthreads N            how many threads; 0 is all that there are\n"
    "  -fullshade -mediumshade -lowshade -lowestshade\n"
    "  -rescale_lights X        multiplies all lights\n"
    "  -auto_skylight X         ambient occlusion as bright as X, and lights by 1 - X\n"
    "  -add_skylight X          ambient occlusion as bright as X\n"
    "  -skylight_samples N      its rays from each point\n"
    "  -shade_phong -shade_blinn -shade_blinn_fast -shade_nullphong\n"
    "  -trans_vmd -trans_orig   whether what is transparent shines less by itself\n"
    "  -shadow_filter_on -shadow_filter_off\n"
    "  -fog_vmd -fog_radial\n"
    "  -clamp -normalize -gamma X\n"
    "  -nosave                  draws and writes nothing\n"
    "  +V -V                    tells times, or does not\n"
    "  -help -version\n"
    "\n"
    "Understood, and of no effect here: -nobounding, -boundthresh, -normalfixup, -trans_raster3d,\n"
    "-trans_max_surfaces. Exit codes: 0 done, 1 bad input or failed output, 2 wrong usage.\n";

namespace {

struct Reader {
  const std::vector<std::string>& arguments;
  std::size_t at = 0;
  std::string problem{};

  const std::string& value(const std::string& option) {
    static const std::string kNone;
    if (at < arguments.size()) return arguments[at++];
    if (problem.empty()) problem = fmt::format("{} needs a value", option);
    return kNone;
  }
  double number(const std::string& option, double least, double most) {
    const std::string& text = value(option);
    if (!problem.empty()) return least;
    const std::optional<double> number = parse_number(text);
    if (number && *number >= least && *number <= most) return *number;
    problem =
        fmt::format("{}: '{}' is not a number from {} to {}", option, shown(text), least, most);
    return least;
  }
  int integer(const std::string& option, int least, int most) {
    const double read = number(option, least, most);
    if (problem.empty() && read != std::floor(read))
      problem = fmt::format("{}: {} is not a whole number", option, read);
    return static_cast<int>(read);
  }
};

std::string in_capitals(std::string word) {
  for (char& c : word) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return word;
}

}  // namespace

std::string TachyonArguments::read(const std::vector<std::string>& all) {
  Reader in{all};
  while (in.problem.empty() && in.at < all.size()) {
    const std::string word = all[in.at++];
    if (word.size() < 2 || (word[0] != '-' && word[0] != '+')) {
      if (!scene.empty())
        return fmt::format("one scene at a time: '{}' and '{}'", shown(scene), shown(word));
      scene = word;
    } else if (word == "-o") {
      output = in.value(word);
    } else if (word == "-format") {
      format = in_capitals(in.value(word));
      if (in.problem.empty() && format != "TARGA" && format != "BMP" && format != "PPM" &&
          format != "PPM48" && format != "PNG" && format != "JPEG")
        return fmt::format(
            "-format {} is not written here: there are TARGA, BMP, PPM, PPM48, PNG and "
            "JPEG",
            shown(format));
    } else if (word == "-res") {
      width = static_cast<std::uint32_t>(in.integer(word, 1, 1 << 20));
      height = static_cast<std::uint32_t>(in.integer(word, 1, 1 << 20));
    } else if (word == "-aasamples") {
      samples = in.integer(word, 0, kMaxSamples - 1);
    } else if (word == "-raydepth") {
      depth = in.integer(word, 0, 1 << 20);
    } else if (word == "-numthreads") {
      threads = in.integer(word, 0, kMaxThreads);
    } else if (word == "-fullshade") {
      settings.mode = TachyonMode::full;
    } else if (word == "-mediumshade") {
      settings.mode = TachyonMode::medium;
    } else if (word == "-lowshade") {
      settings.mode = TachyonMode::low;
    } else if (word == "-lowestshade") {
      settings.mode = TachyonMode::lowest;
    } else if (word == "-rescale_lights") {
      settings.light_scale *= in.number(word, 0, 1e6);
    } else if (word == "-auto_skylight") {
      settings.skylight = in.number(word, 0, 1e6);
      settings.light_scale *= std::fmax(0.0, 1 - *settings.skylight);
    } else if (word == "-add_skylight") {
      settings.skylight = in.number(word, 0, 1e6);
    } else if (word == "-skylight_samples") {
      settings.skylight_samples = in.integer(word, 0, kMaxSamples);
    } else if (word == "-shade_phong") {
      settings.highlight = Highlight::phong;
    } else if (word == "-shade_blinn" || word == "-shade_blinn_fast") {
      settings.highlight = Highlight::blinn;
    } else if (word == "-shade_nullphong") {
      settings.no_highlight = true;
    } else if (word == "-trans_vmd") {
      settings.trans_vmd = true;
    } else if (word == "-trans_orig") {
      settings.trans_vmd = false;
    } else if (word == "-shadow_filter_on" || word == "-shadow_filter_off") {
      settings.shadow_filter = word == "-shadow_filter_on";
    } else if (word == "-fog_vmd" || word == "-fog_radial") {
      settings.fog_vmd = word == "-fog_vmd";
    } else if (word == "-clamp") {
      normalize = false;
    } else if (word == "-normalize") {
      normalize = true;
    } else if (word == "-gamma") {
      gamma = in.number(word, 0.01, 100);
    } else if (word == "-nosave") {
      save = false;
    } else if (word == "+V" || word == "-V") {
      verbose = word == "+V";
    } else if (word == "-trans_max_surfaces" || word == "-boundthresh" || word == "-normalfixup") {
      in.value(word);
      ignored.push_back(word);
    } else if (word == "-nobounding" || word == "-trans_raster3d") {
      ignored.push_back(word);
    } else if (word == "-help" || word == "--help" || word == "-h") {
      help = true;
    } else if (word == "-version" || word == "-banner" || word == "--version") {
      version = true;
    } else if (word == "-camfile" || word == "-spaceball" || word == "-spaceballport") {
      return fmt::format("{} is not done here: one picture of one camera", word);
    } else {
      return fmt::format("there is no option {}", shown(word));
    }
  }
  if (!in.problem.empty()) return in.problem;
  if (scene.empty() && !help && !version) return "a scene is needed: zraka-tachyon SCENE [OPTIONS]";
  return "";
}

}  // namespace zraka::app
