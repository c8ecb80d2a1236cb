// SPDX-License-Identifier: Apache-2.0
// Particles from files of all formats: what is read, and what is said of files that are wrong.
#include "particles/particles.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <zraka/formats.hpp>

#include "core/unpack.hpp"
#include "particles/elements.hpp"

namespace zraka {
namespace {

Particles read(std::string_view text, const ParticleOptions& options = {}) {
  Result<Particles> particles = parse_particles(text, "p", options);
  if (!particles) ADD_FAILURE() << to_string(particles.error().front());
  return particles ? std::move(*particles) : Particles{};
}

std::string told(std::string_view text, const ParticleOptions& options = {}) {
  const Result<Particles> particles = parse_particles(text, "p", options);
  std::string all;
  if (!particles)
    for (const Diagnostic& d : particles.error()) all += to_string(d);
  return all;
}
/// Its first line.
std::string first_told(std::string_view text, const ParticleOptions& options = {}) {
  const std::string all = told(text, options);
  return all.substr(0, all.find('\n'));
}

/// "C 1 2 3 r" of a particle.
std::string text_of(const Particles& particles, std::size_t i) {
  const Object<Sphere>& s = particles.spheres.at(i);
  return fmt::format("{} {} {} {} {}", particles.species.at(s.material), s.shape.center.x,
                     s.shape.center.y, s.shape.center.z, s.shape.radius);
}

ParticleColor color(double red, double green, double blue) {
  return {stored_color(red), stored_color(green), stored_color(blue)};
}

const std::string kWater = "3\nwater\nO 0 0 0.1\nH 0 0.75 -0.5\nH 0 -0.75 -.5 9 9\n";

TEST(Xyz, HasElementsAndPlaces) {
  for (const char* const end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : kWater) c == '\n' ? text += end : text += c;
    const Particles particles = read(text);
    ASSERT_EQ(particles.spheres.size(), 3u);
    EXPECT_EQ(text_of(particles, 0), "O 0 0 0.1 0");
    EXPECT_EQ(text_of(particles, 2), "H 0 -0.75 -0.5 0");
    EXPECT_TRUE(particles.in_angstrom);
    EXPECT_FALSE(particles.has_more);
  }
  EXPECT_EQ(text_of(read("\xEF\xBB\xBF"
                         "1\n\n8 1 2 3"),
                    0),
            "O 1 2 3 0")
      << "by atomic numbers";
}

TEST(Xyz, HasFrames) {
  const std::string two = kWater + "1\nanother\nC 1 2 3\n\n";
  EXPECT_TRUE(read(two).has_more);
  const Particles second = read(two, {.frame = 2});
  EXPECT_EQ(second.spheres.size(), 1u);
  EXPECT_EQ(text_of(second, 0), "C 1 2 3 0");
  EXPECT_EQ(first_told(two, {.frame = 3}), "p:7:1: error: there is no frame 3: the last one is 2");
}

TEST(Xyz, HasPropertiesAndALattice) {
  const Particles particles = read(
      "2\nLattice=\"1 0 0 0 2 0 0.5 0 3\" Properties=id:I:1:species:S:1:pos:R:3:radius:R:1:"
      "color:R:3:e:R:1 pbc=\"T T T\"\n"
      "1 Fe 1 2 3 0.5 1 0 0.25 7\n2 Ni 4 5 6 1.5 0 1 0 -8\n",
      {.column = "e"});
  EXPECT_EQ(text_of(particles, 1), "Ni 4 5 6 1.5");
  EXPECT_EQ(particles.colors[0], color(1, 0, 0.25));
  EXPECT_EQ(particles.values, (std::vector<float>{7, -8}));
  ASSERT_TRUE(particles.cell);
  EXPECT_EQ(particles.cell->c, (Vec3{0.5, 0, 3}));
}

TEST(Xyz, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told("2\n\nH 0 nan 0\nH 1 0\n"),
            "p:3:5: error: 'nan' is not a finite number: expected y\n  H 0 nan 0\n      ^\n"
            "p:4:6: error: the line ends: expected z\n  H 1 0\n       ^\n");
  EXPECT_EQ(first_told("2\n\nH 0 0 0\n"), "p:4:1: error: the file ends after 1 of 2 particles");
  EXPECT_EQ(first_told("3000\n\nH 0 0 0\n"),
            "p:1:1: error: there cannot be 3000 atoms in the 9 bytes that follow");
  EXPECT_EQ(first_told("1\n\nH 1e200 0 0\n"),
            "p:3:1: error: the particle is farther than 1e+100 from the origin");
  EXPECT_EQ(first_told("1\nProperties=species:S:1:pos:R:3:radius:R:1\nH 0 0 0 -1\n"),
            "p:3:1: error: the particle's radius is -1: expected more than 0");
  EXPECT_EQ(
      first_told("1\nProperties=species:S:1:pos:R:x\nH 0 0 0\n"),
      "p:2:12: error: Properties has 'pos:R:x': expected name:type:count, the type S, R, I or "
      "L");
  EXPECT_EQ(first_told("1\nProperties=species:S:1\nH\n"),
            "p:2:1: error: the frame has no column x: there are species");
  EXPECT_EQ(first_told(kWater, {.column = "charge"}),
            "p:2:1: error: the frame has no column 'charge': there are element, x, y, z");
  EXPECT_EQ(first_told("1\nLattice=\"1 0 0\"\nH 0 0 0\n"),
            "p:2:10: error: Lattice is '1 0 0': expected nine numbers");
  const std::string long_name(10000000, 'H');
  EXPECT_EQ(first_told("1\nProperties=species:S:1:pos:R:3\n" + long_name + " 0 0 0\n"),
            "p:3:1: error: 'HHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHHH…' is no "
            "name of an element or a type: expected at most 64 characters");
}

TEST(Particles, OfUtf16AreNamed) {
  EXPECT_EQ(
      told(std::string_view("\xFF\xFE"
                            "3\0\n\0",
                            6)),
      "p: error: is of no format of particles that can be read\n  formats: PDB, mmCIF, LAMMPS "
      "dump, NumPy .npy, NumPy .npz, XYZ, CSV\n");
  const Result<Particles> named = parse_particles(std::string_view("\xFF\xFE"
                                                                   "3\0\n\0",
                                                                   6),
                                                  "p.xyz");
  EXPECT_EQ(to_string(named.error().front()),
            "p.xyz: error: is text of UTF-16, of which nothing is read\n  save it as UTF-8, or as "
            "plain text\n");
}

TEST(Particles, AreReadByManyThreadsInTheirOrder) {
  std::string text = "50000\n\n";
  constexpr const char* kElements[] = {"C", "N", "O"};
  for (int i = 0; i < 50000; ++i)
    text += fmt::format("{} {} {} 0\n", kElements[(i / 20000) % 3], i, -i * 0.5);
  const Particles particles = read(text);
  ASSERT_EQ(particles.spheres.size(), 50000u);
  for (std::size_t i = 0; i < 50000; ++i) {
    const Object<Sphere>& s = particles.spheres[i];
    ASSERT_EQ(s.shape.center.x, static_cast<double>(i));
    ASSERT_EQ(s.material, i / 20000);
  }
  EXPECT_EQ(particles.species, (std::vector<std::string>{"C", "N", "O"}));
}

const std::string kAtom =
    "ATOM      1  CA  ALA A   1       1.000   2.000  -3.500  0.50 20.00           C  \n";

TEST(Pdb, HasAtoms) {
  const Particles particles = read(
      "HEADER    TEST\n"
      "CRYST1   10.000   20.000   30.000  90.00  90.00  90.00 P 1           1\n" +
          kAtom +
          "HETATM    2 CA    CA A   2      11.000   2.000   3.000\n"
          "ATOM      3 HG21 VAL A   3       0.000   0.000   0.000\n"
          "ATOM  A0000  N  AALA B   4       4.000   0.000   0.000  0.60 30.00           N  \n"
          "ATOM  A0001  N  BALA B   4       5.000   0.000   0.000  0.40 30.00           N  \n"
          "CONECT    1    2A0000\nCONECTA0000    1\nEND\n",
      {.column = "b_factor"});
  ASSERT_EQ(particles.spheres.size(), 4u) << "one of two alternate locations";
  EXPECT_EQ(text_of(particles, 0), "C 1 2 -3.5 0");
  EXPECT_EQ(text_of(particles, 1), "Ca 11 2 3 0") << "by the columns of its name";
  EXPECT_EQ(text_of(particles, 2), "H 0 0 0 0");
  EXPECT_EQ(text_of(particles, 3), "N 4 0 0 0");
  EXPECT_EQ(particles.values, (std::vector<float>{20, 0, 0, 30}));
  EXPECT_EQ(particles.bonds, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {0, 3}}));
  ASSERT_TRUE(particles.cell);
  EXPECT_NEAR(particles.cell->b.y, 20, 1e-12);
}

TEST(Pdb, HasModels) {
  const std::string two = "MODEL        1\n" + kAtom + "ENDMDL\nMODEL        2\n" + kAtom + kAtom;
  EXPECT_EQ(read(two).spheres.size(), 1u);
  EXPECT_TRUE(read(two).has_more);
  EXPECT_EQ(read(two, {.frame = 2}).spheres.size(), 2u);
  EXPECT_EQ(first_told(two, {.frame = 3}), "p:1:1: error: there is no model 3: there are 2");
}

TEST(Pdb, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told("ATOM      1  CA  ALA A   1       1.000   2.0x0  -3.500\n"),
            "p:1:39: error: columns 39 to 46 are '2.0x0': expected y, in ångström\n"
            "  ATOM      1  CA  ALA A   1       1.000   2.0x0  -3.500\n"
            "                                        ^\n");
  EXPECT_EQ(first_told("ATOM      1  CA  ALA A   1       1.000\n"),
            "p:1:39: error: the line ends: expected x, y and z in columns 31 to 54");
  EXPECT_EQ(first_told("HEADER    X\n"),
            "p:1:1: error: has no atoms: no line begins with ATOM or HETATM");
  EXPECT_EQ(
      first_told(kAtom, {.column = "no"}),
      "p:1:1: error: has no column 'no': there are b_factor, occupancy, residue, chain, x, y, "
      "z");
}

const std::string kLoop =
    "loop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.auth_asym_id\n"
    "_atom_site.pdbx_PDB_model_num\n";

TEST(Mmcif, HasAtoms) {
  const Particles particles =
      read("# a comment\ndata_X\n_entry.id X\n_note.text\n;loop_\n_atom_site.no\n;\n" + kLoop +
               "C \"C5'\" . 1 2 3 A 1\nFE 'FE' . 4 5\n6 A 1\nO O A 7 8 9 B 1 O O B 7 8 9.5 B 1\n"
               "H H . 0 0 0 A 2\n#\nloop_\n_x.y\n1\n",
           {.column = "chain"});
  ASSERT_EQ(particles.spheres.size(), 3u);
  EXPECT_EQ(text_of(particles, 0), "C 1 2 3 0");
  EXPECT_EQ(text_of(particles, 1), "Fe 4 5 6 0");
  EXPECT_EQ(text_of(particles, 2), "O 7 8 9 0");
  EXPECT_EQ(particles.values, (std::vector<float>{0, 0, 1}));
  EXPECT_TRUE(particles.has_more);
}

TEST(Mmcif, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(first_told("data_X\n" + kLoop + "C C . 1 ? 3 A 1\n"),
            "p:11:9: error: '?' is not a finite number: expected Cartn_y");
  EXPECT_EQ(first_told("data_X\n" + kLoop + "C C . 1 2 3 A 1\nC C\n"),
            "p:12:1: error: the last atom has 2 values: expected 8");
  EXPECT_EQ(first_told("data_X\n_a 1\n"),
            "p:1:1: error: has no atoms: there is no loop of _atom_site");
  EXPECT_EQ(first_told("data_X\nloop_\n_atom_site_label\n_atom_site_fract_x\nC1 0.5\n"),
            "p:1:1: error: has the atoms of a crystal in parts of its cell, which are not read");
  EXPECT_EQ(first_told("data_X\nloop_\n_atom_site.id\n1\n"),
            "p:3:1: error: _atom_site has no Cartn_x");
}

std::string dump(const std::string& box, const std::string& columns, const std::string& rows) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS" + box + "\nITEM: ATOMS " +
         columns + "\n" + rows;
}

TEST(Lammps, HasAtomsInBoxesThatLean) {
  const std::string plain =
      dump(" pp pp pp\n0 10\n0 10\n-5 5", "id type x y z c_pe", "1 1 1 2 3 .5\n7 2 4 5 6 1.5 \n");
  const Particles first = read(plain + plain, {.column = "c_pe"});
  EXPECT_EQ(text_of(first, 1), "type 2 4 5 6 0");
  EXPECT_EQ(first.values, (std::vector<float>{0.5, 1.5}));
  EXPECT_TRUE(first.has_more);
  EXPECT_EQ(read(plain + plain, {.frame = 2}).spheres.size(), 2u);
  EXPECT_EQ(first_told(plain, {.frame = 2}),
            "p:1:1: error: there is no frame 2: the last one is 1");

  // Edges (10, 0, 0), (2, 10, 0), (-1, 3, 10) from (1, 0, 0): bounds of x are 1 - 1 and 11 + 2.
  const Particles leaning =
      read(dump(" xy xz yz pp pp pp\n0 13 2\n0 13 -1\n0 10 3", "id element type xs ys zs radius",
                "1 Cu 1 0 0 0 1\n2 Zr 2 1 0.5 0.5 2\n"));
  EXPECT_EQ(text_of(leaning, 0), "Cu 1 0 0 1");
  EXPECT_EQ(text_of(leaning, 1), "Zr 11.5 6.5 5 2");
  EXPECT_TRUE(leaning.in_angstrom);
}

TEST(Lammps, HasEllipsoids) {
  const Particles particles =
      read(dump("\n0 1\n0 1\n0 1", "id type x y z shapex shapey shapez quatw quati quatj quatk",
                "1 1 0 0 0 1 2 3 1 0 0 0\n2 1 1 1 1 2 2 4 0 1 0 0\n"));
  ASSERT_EQ(particles.shapes.size(), 2u);
  EXPECT_EQ(particles.shapes[0].radii, (std::array<float, 3>{0.5f, 1, 1.5f}));
  EXPECT_EQ(particles.shapes[1].turn, (std::array<float, 4>{0, 1, 0, 0}));
}

TEST(Lammps, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(first_told("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n-1\n"),
            "p:4:1: error: '-1' is no number of atoms: expected a whole number up to 2147483648");
  EXPECT_EQ(first_told("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n99999999\nITEM: ATOMS x y z\n"),
            "p:4:1: error: there cannot be 99999999 atoms in the 18 bytes that follow");
  EXPECT_EQ(first_told("ITEM: TIMESTEP\n0\n"),
            "p:1:1: error: has no atoms: there is no ITEM: ATOMS");
  EXPECT_EQ(first_told(dump("\n0 1\n0 inf\n0 1", "x y z", "")),
            "p:7:3: error: 'inf' is not a finite number: expected one of the box");
  EXPECT_EQ(first_told(dump("\n0 1\n0 1\n0 1", "id type vx", "1 1 1\n2 1 1\n")),
            "p:9:1: error: ITEM: ATOMS has no column x: there are id, type, vx");
}

TEST(Csv, HasColumnsByName) {
  const Particles particles = read(
      "# made by a program\n# x ,Y,\"z\",Radius,kind,r,g,b\n1,2,3,0.5,\"a,b\",255,0,10\n"
      " 4 , 5,6,1,c,0,0,0\r\n\n",
      {.column = "Radius"});
  ASSERT_EQ(particles.spheres.size(), 2u);
  EXPECT_EQ(text_of(particles, 1), " 4 5 6 1");
  EXPECT_EQ(particles.colors[0], color(255, 0, 10));
  EXPECT_EQ(particles.values, (std::vector<float>{0.5, 1}));
  EXPECT_EQ(text_of(read("element;x;y;z\nC;1;2;3\n"), 0), "C 1 2 3 0");
  EXPECT_EQ(text_of(read("type\tx\ty\tz\n5\t1\t2\t3"), 0), "type 5 1 2 3 0");
  EXPECT_EQ(text_of(read("x y z\n1 2 3\n"), 0), " 1 2 3 0");
}

TEST(Csv, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told("x,y,z\n1,2,3\n1,,3\n1,2\n1,2 4,3\n"),
            "p:3:3: error: has nothing for y\n  1,,3\n    ^\n"
            "p:4:4: error: the line ends: expected z\n  1,2\n     ^\n"
            "p:5:5: error: '4,3' does not belong behind y\n  1,2 4,3\n      ^\n");
  EXPECT_EQ(first_told("x,y,z\n"),
            "p:2:1: error: there are no particles below the names of the columns");
}

/// A .npy of version 1 with these bytes behind its header.
std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                bool by_columns = false) {
  std::string header = fmt::format("{{'descr': {}, 'fortran_order': {}, 'shape': {}, }}", type,
                                   by_columns ? "True" : "False", shape);
  header += std::string(63 - (header.size() + 10) % 64, ' ') + "\n";
  std::string file = "\x93NUMPY\x01";
  file += '\0';
  file += static_cast<char>(header.size() & 255);
  file += static_cast<char>(header.size() >> 8);
  return file + header + data;
}
template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

TEST(Npy, HasRowsOfPlacesRadiiAndColors) {
  const Particles seven = read(npy("'<f4'", "(2, 7)",
                                   bytes_of<float>({1, 2, 3, .5f, 1, 0, 0,  //
                                                    4, 5, 6, 1.5f, 0, 1, 0})));
  EXPECT_EQ(text_of(seven, 1), " 4 5 6 1.5");
  EXPECT_EQ(seven.colors[0], color(1, 0, 0));
  const Particles columns =
      read(npy("'<f8'", "(2, 3)", bytes_of<double>({1, 4, 2, 5, 3, 6}), true), {.column = "z"});
  EXPECT_EQ(text_of(columns, 1), " 4 5 6 0");
  EXPECT_EQ(columns.values, (std::vector<float>{3, 6}));
  const Particles swapped = read(npy("'>i2'", "(1, 3)", std::string("\0\1\0\2\377\377", 6)));
  EXPECT_EQ(text_of(swapped, 0), " 1 2 -1 0");
  const Particles half = read(npy("'<f2'", "(1, 3)", std::string("\0\x3C\0\xC0\1\0", 6)));
  EXPECT_EQ(text_of(half, 0), fmt::format(" 1 -2 {} 0", std::ldexp(1, -24)));
}

TEST(Npy, HasFieldsWithNames) {
  const Particles particles =
      read(npy("[('pos', '<f4', (3,)), ('type', '|u1'), ('name', '<U2'), ('rgb', '|u1', (3,))]",
               "(1,)", bytes_of<float>({1, 2, 3}) + "\5" + std::string(8, '\0') + "\xFF\x80\1"));
  EXPECT_EQ(text_of(particles, 0), "type 5 1 2 3 0");
  EXPECT_EQ(particles.colors[0], color(255, 128, 1));
}

TEST(Npy, SaysWhatIsWrong) {
  EXPECT_EQ(
      first_told(npy("'<f4'", "(1000000, 3)", "abc")),
      "p: error: is cut off: 1000000 rows of 12 bytes do not fit in the 3 that follow upon the "
      "header");
  EXPECT_EQ(
      told(npy("'<f4'", "(1, 5)", std::string(20, '\0'))),
      "p: error: is no array of particles\n  expected rows of x, y, z, then a radius, or red, "
      "green and blue, or all four; or fields with names\n");
  EXPECT_EQ(first_told(npy("'<f4'", "(2, 3)", bytes_of<float>({0, 0, 0, 1, NAN, 0}))),
            "p: error: particle 2 is at (1, nan, 0): expected finite numbers");
  EXPECT_EQ(first_told("\x93NUMPY\x01"), "p: error: is cut off within its header");
  EXPECT_EQ(first_told(npy("'<c8'", "(2, 3)", std::string(48, '\0'))),
            "p: error: is no array of particles");
}

/// A ZIP archive of members that are stored as they are.
std::string zip(const std::vector<std::pair<std::string, std::string>>& members) {
  const auto number = [](std::uint64_t value, int bytes) {
    std::string all;
    for (int i = 0; i < bytes; ++i) all += static_cast<char>(value >> (8 * i) & 255);
    return all;
  };
  std::string file, directory;
  for (const auto& [name, data] : members) {
    const std::string about = number(0, 12) + number(data.size(), 4) + number(data.size(), 4) +
                              number(name.size(), 2) + number(0, 2);
    directory += "PK\1\2" + number(0, 4) + about + number(0, 10) + number(0, 0) +
                 number(file.size(), 4) + name;
    file += "PK\3\4" + number(0, 2) + about + name + data;
  }
  return file + directory + "PK\5\6" + number(0, 6) + number(members.size(), 2) +
         number(directory.size(), 4) + number(file.size(), 4) + number(0, 2);
}

TEST(Npz, HasArraysByName) {
  const std::string positions = npy("'<f4'", "(2, 3)", bytes_of<float>({1, 2, 3, 4, 5, 6}));
  const std::string file =
      zip({{"positions.npy", positions},
           {"radii.npy", npy("'<f8'", "(2,)", bytes_of<double>({1, 2}))},
           {"numbers.npy", npy("'<i8'", "(2,)", bytes_of<std::int64_t>({6, 79}))},
           {"cell.npy", npy("'<f8'", "(3, 3)", std::string(72, '\0'))},
           {"e.npy", npy("'<f4'", "(2,)", bytes_of<float>({7, 8}))}});
  const Particles particles = read(file, {.column = "e"});
  EXPECT_EQ(text_of(particles, 0), "C 1 2 3 1");
  EXPECT_EQ(text_of(particles, 1), "Au 4 5 6 2");
  EXPECT_EQ(particles.values, (std::vector<float>{7, 8}));
  EXPECT_EQ(first_told(file.substr(0, file.size() - 30)),
            "p: error: is a damaged archive: it has no directory");
  EXPECT_EQ(first_told(file, {.column = "f"}),
            "p: error: has no column 'f': there are x, y, z, radius, numbers, e");
}

TEST(Packed, IsReadThroughAndBounded) {
  // What gzip makes of "x,y,z\n1,2,3\n".
  const std::string gzip(
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xab\xd0\xa9\xd4\xa9\xe2\x32\xd4\x31\xd2\x31\xe6\x02"
      "\x00\x0b\x34\xb0\x96\x0c\x00\x00\x00",
      32);
  EXPECT_TRUE(is_packed(gzip));
  const Result<std::string> text = unpacked(gzip, "p");
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "x,y,z\n1,2,3\n");
  const Result<std::string> cut = unpacked(gzip.substr(0, 20), "p");
  ASSERT_FALSE(cut);
  EXPECT_EQ(to_string(cut.error().front()),
            "p: error: is damaged or cut off: gzip cannot unpack it\n");
  EXPECT_FALSE(
      unpacked("\x28\xB5\x2F\xFD"
               "abc",
               "p"));
}

TEST(Elements, AreFoundByTheirLabels) {
  const auto label = [](std::string_view text) {
    const Element* const element = element_of_label(text);
    return element != nullptr ? std::string(element->symbol) : "none";
  };
  EXPECT_EQ(label("CA"), "C");
  EXPECT_EQ(label("Ca2+"), "Ca");
  EXPECT_EQ(label("H12"), "H");
  EXPECT_EQ(label("MG1"), "Mg");
  EXPECT_EQ(label("D"), "H");
  EXPECT_EQ(label("7"), "none");
  EXPECT_EQ(element_of_symbol("CL"), element_of_number(17));
  EXPECT_EQ(element_of_symbol("Xx"), nullptr);
  EXPECT_EQ(element_of_number(0), nullptr);
  EXPECT_EQ(element_of_number(109)->symbol, "Mt");
}

}  // namespace
}  // namespace zraka
