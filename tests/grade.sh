#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# grade.sh PROGRAM: the command grade, with folders, archives that climb out of theirs, and a class of which some hand in nonsense.
. "$(dirname "$0")/helpers.sh"
scene=scenes/lab/input.txt
class=$folder/class
mkdir -p "$class/right" "$class/wrong"
for stage in 1 4 7; do
  "$zraka" render $scene --width 48 --stage $stage -o "$class/right/$stage.png" -q || fail "render"
done
cp "$class/right/1.png" "$class/right/4.png" "$class/wrong/"
"$zraka" render $scene --width 48 --mistake ratio-inverted -o "$class/wrong/refrakcija.png" -q || fail "render with a mistake"

"$zraka" grade $scene --width 48 "$class/wrong" >"$folder/out" || fail "grade ended with $?"
contains "$folder/out" "b is n2/n1 for n1/n2"
contains "$folder/out" "there is no picture of this stage"
"$zraka" grade $scene --width 48 "$class/wrong" --lang hr >"$folder/out" || fail "grade in Croatian"
contains "$folder/out" "b je n2/n1 umjesto n1/n2"
sed 's|radius => 0.95:|radius => o.5:|' $scene >"$folder/input.txt"
expect 1 "input.txt:22:13: pogreška: 'o.5' nije broj: ovdje dolazi polumjer, kugla 2" \
  "$zraka" grade "$folder/input.txt" "$class/wrong" --lang hr
expect 1 "pogreška: nema takve datoteke ni mape" "$zraka" grade $scene "$folder/nobody" --lang hr
"$zraka" grade $scene --width 48 "$class/right/7.png" --format json >"$folder/json" || fail "json"
python3 -c 'import json, sys; g = json.load(open(sys.argv[1])); assert g["score"] == g["max_score"] == 1, g; assert g["tests"][0]["verdict"] == "right", g' \
  "$folder/json" || fail "the JSON is wrong"

# Pages: the pictures that show what is wrong, and nothing from outside.
"$zraka" grade $scene --width 48 "$class/wrong" -o "$folder/wrong.html" --lang hr || fail "no page"
contains "$folder/wrong.html" "b je n2/n1 umjesto n1/n2"
contains "$folder/wrong.html" "<h1>wrong</h1>"
[ "$(grep -o '<img' "$folder/wrong.html" | wc -l)" = 6 ] || fail "a page without its pictures"
grep -q 'src="[^d]' "$folder/wrong.html" && fail "a page that needs others"

# A class with what people hand in.
(cd "$class/right" && python3 -m zipfile -c ../packed.zip 1.png 4.png 7.png)
python3 - "$class" <<'PY'
import sys, zipfile
folder = sys.argv[1]
with zipfile.ZipFile(folder + "/climbs.zip", "w") as z:
    z.writestr("../../7.png", open(folder + "/right/7.png", "rb").read())
with zipfile.ZipFile(folder + "/bomb.zip", "w", zipfile.ZIP_DEFLATED) as z:
    z.writestr("7.png", b"\0" * (65 << 20))
open(folder + "/text.png", "w").write("no picture")
header = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + (60000).to_bytes(4, "big") * 2 + b"\x08\x02\0\0\0\0\0\0\0"
open(folder + "/huge.png", "wb").write(header)
PY
"$zraka" grade $scene --width 48 "$class" --all >"$folder/out" || fail "a class ended with $?"
[ "$(wc -l <"$folder/out")" = 7 ] || { fail "not a line for each"; cat "$folder/out"; }
contains "$folder/out" "the archive has a file outside of its folder: '../../7.png'"
[ "$(grep -c ' 3/7 1+ 2- 3- 4+ 5- 6- 7+' "$folder/out")" = 2 ] || { fail "folder and archive differ"; cat "$folder/out"; }
contains "$folder/out" "bomb.zip"
mkdir "$class/one" && cp "$class/right/7.png" "$class/one/"
"$zraka" grade $scene --width 48 "$class" --all -o "$folder/class.html" || fail "no page of a class"
[ "$(grep -c '<details>' "$folder/class.html")" = 8 ] || fail "the page has not a row for each"
contains "$folder/class.html" "1 of 7 marks"
[ -e "$folder/7.png" ] && fail "an archive climbed out"

# Nine black pictures of 4096² pixels in 4 KB: decoded at once they would take 1.8 GB.
python3 - "$zraka" "$scene" "$folder/black.zip" <<'PY' || fail "black pictures take too much memory"
import resource, struct, subprocess, sys, zipfile, zlib
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
side = 4096
png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) + chunk(
    b"IDAT", zlib.compress(bytes((1 + 3 * side) * side), 9)) + chunk(b"IEND", b"")
with zipfile.ZipFile(sys.argv[3], "w", zipfile.ZIP_DEFLATED) as z:
    for i in range(9):
        z.writestr(f"{i % 7 + 1}-{i}.png", png)
subprocess.run([sys.argv[1], "grade", sys.argv[2], "--width", "48", sys.argv[3]], check=True, stdout=subprocess.DEVNULL)
sys.exit(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss > 1300000)  # KB
PY

# The pictures of a report, alone and in an archive; its program has numbered them, and a thumbnail is none of them.
"$zraka" stages $scene --width 48 -o "$folder/stages" -q || fail "stages"
python3 - "$folder" <<'PY'
import glob, struct, sys, zipfile, zlib
folder = sys.argv[1]
pictures = sorted(glob.glob(folder + "/stages/[1-7]-*.png"))
assert len(pictures) == 7, pictures
with zipfile.ZipFile(folder + "/report.docx", "w") as z:
    z.writestr("word/document.xml", "<document/>")
    z.write(pictures[6], "docProps/thumbnail.png")
    for i, picture in enumerate(pictures):
        z.write(picture, f"word/media/image{i + 3}.png")
with zipfile.ZipFile(folder + "/packed.zip", "w") as z:
    z.write(folder + "/report.docx", "OVO/report.docx")


def pdf(images):
    """A PDF with a page for each picture: (width, height, entries of its dictionary, its stream)."""
    objects = ["<</Type/Catalog/Pages 2 0 R>>",
               "<</Type/Pages/Count %d/Kids[%s]>>" % (len(images), " ".join(f"{3 + 2 * i} 0 R" for i in range(len(images))))]
    for i, (width, height, entries, data) in enumerate(images):
        objects.append(f"<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]/Resources<</XObject<</I {4 + 2 * i} 0 R>>>>>>")
        objects.append((f"<</Subtype/Image/Width {width}/Height {height}{entries}/Length {len(data)}>>\nstream\n").encode()
                       + data + b"\nendstream")
    out, places = b"%PDF-1.4\n", []
    for i, body in enumerate(objects):
        places.append(len(out))
        out += b"%d 0 obj\n" % (i + 1) + (body if isinstance(body, bytes) else body.encode()) + b"\nendobj\n"
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    return out + b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1) + table + (
        b"trailer <</Root 1 0 R/Size %d>>\nstartxref\n%d\n%%%%EOF\n" % (len(objects) + 1, len(out)))


images = []
for picture in pictures:
    bytes_, at, data = open(picture, "rb").read(), 8, b""
    while at < len(bytes_):
        length, kind = struct.unpack(">I4s", bytes_[at : at + 8])
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", bytes_[at + 8 : at + 18])
            assert (depth, color) == (8, 2), (depth, color)
        if kind == b"IDAT":
            data += bytes_[at + 8 : at + 8 + length]
        at += 12 + length
    # As LaTeX puts PNGs into a PDF.
    images.append((width, height, "/ColorSpace/DeviceRGB/BitsPerComponent 8/Filter/FlateDecode/DecodeParms<</Predictor 15"
                                  f"/Colors 3/Columns {width}>>", data))
open(folder + "/report.pdf", "wb").write(pdf(images))
with zipfile.ZipFile(folder + "/packed-pdf.zip", "w") as z:
    z.write(folder + "/report.pdf", "OVO/report.pdf")
rgb = "/ColorSpace/DeviceRGB/BitsPerComponent 8/Filter/FlateDecode"
open(folder + "/bomb.pdf", "wb").write(pdf([(99, 99, rgb, zlib.compress(bytes(80 << 20), 9))]))
open(folder + "/cut.pdf", "wb").write(pdf(images)[:900])
open(folder + "/short.pdf", "wb").write(pdf([(99, 99, rgb, zlib.compress(bytes(99)))]))
PY
for report in report.docx packed.zip report.pdf packed-pdf.zip; do
  "$zraka" grade $scene --width 48 "$folder/$report" >"$folder/out" || fail "$report ended with $?"
  contains "$folder/out" "7 of 7 marks"
done
expect 1 "the PDF is damaged or has a password" "$zraka" grade $scene "$folder/cut.pdf"
expect 1 "unpack to more than 256 MiB" "$zraka" grade $scene "$folder/bomb.pdf"
"$zraka" grade $scene "$folder/short.pdf" >"$folder/out" || fail "a picture of a PDF that is too short"
contains "$folder/out" "cannot be read"
echo "no archive" >"$folder/text.docx"
expect 1 "the archive is damaged or no zip" "$zraka" grade $scene "$folder/text.docx"

# A name that tells nothing true, and the stage that is told.
cp "$class/right/7.png" "$folder/lab3.png"
"$zraka" grade $scene --width 48 "$folder/lab3.png" --format json >"$folder/json" || fail "lab3"
python3 -c 'import json, sys; g = json.load(open(sys.argv[1])); assert g["tests"][0]["number"] == "7", g' "$folder/json" || fail "a digit decided"
"$zraka" grade $scene --width 48 "$folder/lab3.png" --stage 3 --format json >"$folder/json" || fail "--stage"
python3 -c 'import json, sys; g = json.load(open(sys.argv[1])); t = g["tests"][0]; assert t["number"] == "3" and t["verdict"] == "unknown", g' "$folder/json" || fail "--stage did not decide"

# Links at the top of a class are told, not followed; its page is no submission the next time.
mkdir "$folder/links"
cp -r "$class/one" "$folder/links/ana"
ln -s "$class/right" "$folder/links/iva"
for _ in 1 2; do
  "$zraka" grade $scene --width 48 "$folder/links" --all -o "$folder/links/marks.txt" || fail "a class with a link"
done
contains "$folder/links/marks.txt" "it is a link, which is not followed"
[ "$(wc -l <"$folder/links/marks.txt")" = 2 ] || fail "the marks are a submission"

# Wrong usage.
"$zraka" grade $scene "$folder/nobody" >"$folder/out" 2>&1
[ $? = 1 ] || fail "a missing submission does not fail"
contains "$folder/out" "there is no such file or folder"
"$zraka" grade $scene "$class" --rubric "$folder/no.json" 2>"$folder/out" && fail "a missing rubric is no error"
"$zraka" grade $scene 2>"$folder/out"
[ $? = 2 ] || fail "no submission is no wrong usage"
"$zraka" grade --list | grep -q '^feeler-unbounded .* \*$' || fail "no list"
"$zraka" grade --list --lang hr | grep -q '^filter-per-surface .* (ne ocjenjuje se)$' || fail "all are graded"
"$zraka" render $scene --mistake none -o "$folder/x.png" 2>"$folder/out"
[ $? = 2 ] || fail "a mistake that there is not"
finish
