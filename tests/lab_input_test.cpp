// SPDX-License-Identifier: Apache-2.0
// The course's input.txt: what it means, and the exact answer to each way of getting it wrong.
#include <gtest/gtest.h>

#include <string>
#include <zraka/formats.hpp>

namespace zraka {
namespace {

const std::string kHead = "0,0,2:2:400:0,2,-2:";
const std::string kSphere = "1,2,-3:0.5:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,0.8,0.9:10:1.5";

/// All problems of a text, or its warnings, as a person sees them.
std::string answer(const std::string& text) {
  const Result<ReadScene> read = parse_scene(text, "f.txt");
  std::string all;
  for (const Diagnostic& d : read ? read->warnings : read.error()) all += to_string(d);
  return all;
}
Scene scene(const std::string& text) {
  const Result<ReadScene> read = parse_scene(text, "f.txt");
  if (!read) ADD_FAILURE() << to_string(read.error().front());
  return read ? read->scene : Scene{};
}

TEST(LabInput, HasItsValuesInOrder) {
  const Scene s = scene("1,2,3:4:500:6,7,8:1:" + kSphere + ":");
  EXPECT_EQ(s.camera.eye, (Vec3{1, 2, 3}));
  EXPECT_EQ(s.camera.window_center, (Vec3{0, 0, 0}));
  EXPECT_EQ(s.camera.window_right, (Vec3{4, 0, 0}));
  EXPECT_EQ(s.camera.window_up, (Vec3{0, 4, 0}));
  EXPECT_EQ(s.resolution.width, 500u);
  EXPECT_EQ(s.resolution.height, 500u);
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(s.lights[0].position, (Vec3{6, 7, 8}));
  EXPECT_EQ(s.lights[0].color, (Color{1, 1, 1}));
  EXPECT_EQ(s.ambient_light, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(s.background, Color{});
  EXPECT_EQ(s.defaults.profile, ProfileName::lab);
  ASSERT_EQ(s.spheres.size(), 1u);
  EXPECT_EQ(s.spheres[0].shape.center, (Vec3{1, 2, -3}));
  EXPECT_EQ(s.spheres[0].shape.radius, 0.5);
  const Material want{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}, 10, 0.6, 0.8, 1.5};
  EXPECT_EQ(s.materials.at(s.spheres[0].material), want);
}

TEST(LabInput, IsReadAsTheCourseReadsIt) {
  const auto same = [](const std::string& text) {
    EXPECT_EQ(answer(text), "") << text;
    const Scene s = scene(text);
    EXPECT_EQ(s.resolution.width, 400u) << text;
    EXPECT_EQ(s.spheres.size(), 1u) << text;
  };
  same(kHead + "1:" + kSphere);                // no last separator
  same(kHead + "1:" + kSphere + ":\r\n");      // one, and CRLF
  same("0:0:2,2,4<x>00,0:2:-2,1," + kSphere);  // , and : are the same; 4<x>00 is 400
  same("<a, b: 1 < 2 => 0,0,2:2\n : <resolution =>\n400:0,2,-2:1:" + kSphere);
  same(kHead + "1:" + kSphere + ": and whatever else, 4 you like > <");
  same("\xEF\xBB\xBF" + kHead + "1:" + kSphere);  // a byte order mark
  same("<\xE8\xE6 Latin-2>" + kHead + "1:" + kSphere);
  same("<čć UTF-8>" + kHead + "1:" + kSphere);
}

TEST(LabInput, WithoutSpheresIsAScene) {
  EXPECT_EQ(scene(kHead + "0:").spheres.size(), 0u);
  EXPECT_EQ(scene(kHead + "0").spheres.size(), 0u);
}

TEST(LabInput, NamesTheValueThatIsNoNumber) {
  EXPECT_EQ(answer(kHead + "1:\n1,2,-3:wide:" + kSphere.substr(11)),
            "f.txt:2:8: error: 'wide' is not a number: expected radius of sphere 1\n"
            "  1,2,-3:wide:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7…\n"
            "         ^\n");
  EXPECT_EQ(answer("a,0,2:2:400:0,2,-2:0"),
            "f.txt:1:1: error: 'a' is not a number: expected x of the eye\n"
            "  a,0,2:2:400:0,2,-2:0\n"
            "  ^\n");
}

TEST(LabInput, NamesTheValueThatHasASpaceInIt) {
  EXPECT_EQ(
      answer("0,0,2:2:4 00:0,2,-2:0"),
      "f.txt:1:9: error: '4 00' has more after the number: expected resolution of the window\n"
      "  0,0,2:2:4 00:0,2,-2:0\n"
      "          ^\n"
      "  only ',' or ':' ends a value; a space or a new line does not\n");
}

TEST(LabInput, NamesTheValueThatIsMissing) {
  EXPECT_EQ(answer("0,,2:2:400:0,2,-2:0"),
            "f.txt:1:3: error: nothing stands before the separator: expected y of the eye\n"
            "  0,,2:2:400:0,2,-2:0\n"
            "    ^\n");
}

TEST(LabInput, RefusesWhatIsNotFinite) {
  EXPECT_EQ(answer("0,NaN,2:2:400:0,-Infinity,1e999:0"),
            "f.txt:1:3: error: 'NaN' is not finite: expected y of the eye\n"
            "  0,NaN,2:2:400:0,-Infinity,1e999:0\n"
            "    ^\n"
            "f.txt:1:17: error: '-Infinity' is not finite: expected y of the light\n"
            "  0,NaN,2:2:400:0,-Infinity,1e999:0\n"
            "                  ^\n"
            "f.txt:1:27: error: '1e999' is too large: expected z of the light\n"
            "  0,NaN,2:2:400:0,-Infinity,1e999:0\n"
            "                            ^\n");
}

TEST(LabInput, RefusesStrayBrackets) {
  EXPECT_EQ(answer("0,0,2>:2:400:0,2,-2:0"),
            "f.txt:1:6: error: stray '>' at z of the eye: no '<' is open\n"
            "  0,0,2>:2:400:0,2,-2:0\n"
            "       ^\n");
  EXPECT_EQ(
      answer("0,0,2:2:<resolution 400:0,2,-2:0"),
      "f.txt:1:9: error: '<' is never closed: expected '>' and then resolution of the window\n"
      "  0,0,2:2:<resolution 400:0,2,-2:0\n"
      "          ^\n");
}

TEST(LabInput, RefusesCountsThatAreNone) {
  EXPECT_EQ(
      answer("0,0,2:2:-400:0,2,-2:0"),
      "f.txt:1:9: error: resolution of the window is -400: expected a whole number, 1 or more\n"
      "  0,0,2:2:-400:0,2,-2:0\n"
      "          ^\n");
  EXPECT_EQ(
      answer("0,0,2:2:400.5:0,2,-2:-4"),
      "f.txt:1:9: error: resolution of the window is 400.5: expected a whole number, 1 or more\n"
      "  0,0,2:2:400.5:0,2,-2:-4\n"
      "          ^\n"
      "f.txt:1:22: error: number of spheres is -4: expected a whole number, 0 or more\n"
      "  0,0,2:2:400.5:0,2,-2:-4\n"
      "                       ^\n");
  EXPECT_EQ(answer(kHead + "1.5:" + kSphere),
            "f.txt:1:20: error: number of spheres is 1.5: expected a whole number, 0 or more\n"
            "  0,0,2:2:400:0,2,-2:1.5:1,2,-3:0.5:0.6:0.8:0.1,0.2,0.3:0.4,0…\n"
            "                     ^\n");
}

TEST(LabInput, RefusesSizesOfNothing) {
  EXPECT_EQ(answer("0,0,2:0:400:0,2,-2:1:1,2,-3:0:" + kSphere.substr(11)),
            "f.txt:1:7: error: size of the window is 0: expected a number greater than 0\n"
            "  0,0,2:0:400:0,2,-2:1:1,2,-3:0:0.6:0.8:0.1,0.2,…\n"
            "        ^\n"
            "f.txt:1:29: error: radius of sphere 1 is 0: expected a number greater than 0\n"
            "  0,0,2:0:400:0,2,-2:1:1,2,-3:0:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,0.…\n"
            "                              ^\n");
  EXPECT_EQ(answer(kHead + "1:1,2,-3:-1:" + kSphere.substr(11)),
            "f.txt:1:29: error: radius of sphere 1 is -1: expected a number greater than 0\n"
            "  0,0,2:2:400:0,2,-2:1:1,2,-3:-1:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,0…\n"
            "                              ^\n");
}

TEST(LabInput, NamesTheFirstValueThatIsNotThere) {
  EXPECT_EQ(answer(kHead + "2:" + kSphere + ":\n4,5,6:"),
            "f.txt:2:7: error: the file ends: expected radius of sphere 2\n"
            "  4,5,6:\n"
            "        ^\n"
            "  1 of 2 spheres are complete, and 3 of the 17 values of sphere 2 are there\n");
  EXPECT_EQ(answer("0,0,2:2"),
            "f.txt:1:8: error: the file ends: expected resolution of the window\n"
            "  0,0,2:2\n"
            "         ^\n");
}

TEST(LabInput, SaysAllTheProblemsAtOnce) {
  const std::string text =
      answer("0,x,2:2:400:0,2,-2:2:1,2,-3:0:a:" + kSphere.substr(15) + ":" + kSphere);
  EXPECT_NE(text.find("'x' is not a number: expected y of the eye"), std::string::npos) << text;
  EXPECT_NE(text.find("radius of sphere 1 is 0"), std::string::npos) << text;
  EXPECT_NE(text.find("'a' is not a number: expected k1 (share of the reflected ray) of sphere 1"),
            std::string::npos)
      << text;
}

TEST(LabInput, KnowsADecimalCommaByItsLabel) {
  const std::string labelled =
      "<eye> 0,0,2: <size> 2: <resolution> 400: <light> 0,2,-2: <N> 1:\n"
      "<position> 1,2,-3:\n<radius> 0,5: <k1> 0.6: <k2> 0.8: <ka> 0.1,0.2,0.3: <kd> 0.4,0.5,0.6:\n"
      "<ks> 0.7,0.8,0.9: <n> 10: <ni> 1.5:\n";
  EXPECT_EQ(
      answer(labelled),
      "f.txt:3:10: note: 2 values stand here, where radius of sphere 1 has 1\n"
      "  <radius> 0,5: <k1> 0.6: <k2> 0.8: <ka> 0.1,0.2,0.…\n"
      "           ^\n"
      "  ',' and ':' end a value, so a decimal comma (0,6) makes two values of one: write 0.6\n"
      "f.txt:3:10: error: radius of sphere 1 is 0: expected a number greater than 0\n"
      "  <radius> 0,5: <k1> 0.6: <k2> 0.8: <ka> 0.1,0.2,0.…\n"
      "           ^\n"
      "f.txt:4:32: error: 1 value is left over after the last of 1 sphere\n"
      "  <ks> 0.7,0.8,0.9: <n> 10: <ni> 1.5:\n"
      "                                 ^\n"
      "  a value too many stands before\n");
}

TEST(LabInput, KnowsAMissingValueByItsLabel) {
  const std::string text = answer("<eye> 0,0,2: <size> 2: <resolution> 400: <light> 0,2: <N> 0:\n");
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "f.txt:1:50: note: 2 values stand here, where x of the light has 3");
}

TEST(LabInput, WarnsOfValuesThatAreLeftOver) {
  EXPECT_EQ(answer(kHead + "1:" + kSphere + ":\n7:8"),
            "f.txt:2:1: warning: 2 values are left over after the last of 1 sphere\n"
            "  7:8\n"
            "  ^\n"
            "  is the number of spheres right? ',' and ':' end a value, so a decimal comma (0,6) "
            "makes two "
            "values of one: write 0.6\n");
}

TEST(LabInput, WarnsOfCoefficientsThatTheSheetDoesNotHave) {
  EXPECT_EQ(answer(kHead + "1:1,2,-3:0.5:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,\n1.8,0.9:10:1.5"),
            "f.txt:2:1: warning: green of ks of sphere 1 is 1.8: the sheet has 0 to 1\n"
            "  1.8,0.9:10:1.5\n"
            "  ^\n");
  EXPECT_EQ(
      answer(kHead + "1:1,2,-3:0.5:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,0.8,0.9:-1:\n0"),
      "f.txt:2:1: warning: ni (refraction factor) of sphere 1 is 0: no ray is refracted by that\n"
      "  0\n"
      "  ^\n"
      "f.txt:2:1: warning: n (shininess) of sphere 1 is -1: a highlight needs 0 or more\n"
      "  0\n"
      "  ^\n");
}

TEST(LabInput, SaysItInCroatian) {
  const auto croatian = [](const std::string& text) {
    const Result<ReadScene> read = parse_scene(text, "f.txt");
    std::string all;
    for (const Diagnostic& d : read ? read->warnings : read.error())
      all += to_string(d, Language::croatian);
    return all;
  };
  EXPECT_EQ(croatian(kHead + "1:\n1,2,-3:wide:" + kSphere.substr(11)),
            "f.txt:2:8: pogreška: 'wide' nije broj: ovdje dolazi polumjer, kugla 1\n"
            "  1,2,-3:wide:0.6:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7…\n"
            "         ^\n");
  EXPECT_EQ(croatian(kHead + "2:" + kSphere + ":\n4,5,6:"),
            "f.txt:2:7: pogreška: datoteka prerano završava: nedostaje polumjer, kugla 2\n"
            "  4,5,6:\n"
            "        ^\n"
            "  potpunih je kugala 1 od 2, a kugla 2 ima 3 od 17 vrijednosti\n");
  EXPECT_EQ(croatian(kHead + "1:" + kSphere + ":\n7:8"),
            "f.txt:2:1: upozorenje: preostalih vrijednosti iza posljednje kugle: 2 (broj kugala je "
            "1)\n"
            "  7:8\n"
            "  ^\n"
            "  je li broj kugala točan? vrijednost završava znakom ',' ili ':', pa decimalni zarez "
            "(0,6) od jedne vrijednosti čini dvije: pišite 0.6\n");
}

TEST(LabInput, RefusesMoreThanThereIsRoomFor) {
  EXPECT_EQ(answer(kHead + "1000000000:" + kSphere),
            "f.txt:1:20: error: number of spheres is 1000000000, but the rest of the file has room "
            "for 1 at "
            "most\n"
            "  0,0,2:2:400:0,2,-2:1000000000:1,2,-3:0.5:0.6:0.8:0.1,0.2,0.…\n"
            "                     ^\n");
  EXPECT_EQ(answer("0,0,2:2:1000000000:0,2,-2:0"),
            "f.txt:1:9: error: resolution of the window is 1000000000: expected 11585 at most\n"
            "  0,0,2:2:1000000000:0,2,-2:0\n"
            "          ^\n"
            "  larger pictures do not fit\n");
}

TEST(LabInput, KnowsWhatIsNoTextAtAll) {
  EXPECT_EQ(answer(""), "f.txt: error: the file is empty: expected x of the eye\n");
  EXPECT_EQ(answer(std::string("0,0,2\0:", 7)),
            "f.txt: error: the file is not text: byte 6 is 0x00\n"
            "  expected the course's input.txt format\n");
  EXPECT_EQ(answer(std::string("\xFF\xFE"
                               "0\0",
                               4)),
            "f.txt: error: the file is not text: byte 4 is 0x00\n"
            "  it looks like UTF-16: save it as UTF-8\n");
  EXPECT_EQ(answer("\x1F\x8B\x08\n"),
            "f.txt: error: the file is not text: byte 1 is 0x1f\n"
            "  it looks like a file packed by gzip: unpack it first\n");
  EXPECT_EQ(answer("  \n <only a label> \n"),
            "f.txt:3:1: error: the file ends: expected x of the eye\n"
            "  \n"
            "  ^\n");
}

TEST(LabInput, StopsAtTooManyProblems) {
  std::string text = kHead + "5000:";
  for (int i = 0; i < 5000 * 17; ++i) text += "x:";
  const Result<ReadScene> read = parse_scene(text, "f.txt");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().size(), 101u);
  EXPECT_EQ(read.error().back().message, "too many problems; the rest of the file is not read");
}

TEST(LabInput, SaysOnlySoMuch) {
  const Result<ReadScene> brackets = parse_scene(std::string(100000, '>'), "f.txt");
  ASSERT_FALSE(brackets);
  EXPECT_LE(brackets.error().size(), 102u);
  std::string text = kHead + "2000:";
  for (int i = 0; i < 2000; ++i)
    text += "1,2,-3:0.5:7:0.8:0.1,0.2,0.3:0.4,0.5,0.6:0.7,0.8,0.9:10:1.5:";
  EXPECT_EQ(parse_scene(text, "f.txt").value().warnings.size(), 101u);
}

TEST(LabInput, ComesBackAsItWasWritten) {
  const Scene s = scene("0.1,0.2,3:4:500:6,7,8:1:" + kSphere);
  const std::string text = write_lab_input(s).value();
  const Scene back = scene(text);
  EXPECT_EQ(back.camera.eye, s.camera.eye);
  EXPECT_EQ(back.camera.window_right, s.camera.window_right);
  EXPECT_EQ(back.resolution.width, s.resolution.width);
  EXPECT_EQ(back.lights[0].position, s.lights[0].position);
  EXPECT_EQ(back.spheres[0].shape.center, s.spheres[0].shape.center);
  EXPECT_EQ(back.materials, s.materials);
}

TEST(LabInput, IsNotWrittenForWhatItCannotSay) {
  Scene s = scene(kHead + "0");
  s.lights.push_back({});
  EXPECT_EQ(write_lab_input(s).error().front().message,
            "the course's input.txt format cannot say these lights: it knows one white light");
  s.lights.pop_back();
  s.resolution.height = 7;
  EXPECT_FALSE(write_lab_input(s));
}

}  // namespace
}  // namespace zraka
