#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tachyon.sh PROGRAM: zraka-tachyon, called as VMD and others call Tachyon, from outside.
. "$(dirname "$0")/helpers.sh"
ln -s "$zraka" "$folder/zraka-tachyon"
tachyon=$folder/zraka-tachyon
cat >"$folder/one.dat" <<'EOF'
Begin_Scene
Resolution 8 6
Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 50
 Center 0 0 -5 Viewdir 0 0 1 Updir 0 1 0 End_Camera
Background 0 0 1
Directional_Light Direction 0 0 1 Color 1 1 1
Sphere Center 0 0 0 Rad 9
Texture Ambient 1 Diffuse 0 Specular 0 Opacity 1 Phong Plastic 0 Phong_size 40 Color 1 0 0 TexFunc 0
End_Scene
EOF
sed 's/Rad 9/Rad 0.1/' "$folder/one.dat" >"$folder/two.dat"

# Every command knows the profile that such a scene brings along.
for language in en hr; do
  "$zraka" explain "$folder/two.dat" 4 3 --lang $language >"$folder/text" || fail "explain in $language"
done
grep -q "profil programa Tachyon" "$folder/text" || fail "the profile in Croatian: $(head -n 2 "$folder/text")"
"$zraka" explain "$folder/two.dat" 4 3 -o "$folder/pixel.html" || fail "the page of explain"
grep -q "Tachyon's profile\|Tachyon&#39;s profile" "$folder/pixel.html" || fail "the profile in the page"
"$zraka" explain "$folder/two.dat" 4 3 --format json | grep -q '"tachyon"' || fail "the profile in JSON"

# VMD's own lines.
"$tachyon" -aasamples 4 -trans_vmd -mediumshade "$folder/one.dat" -format TARGA -o "$folder/a.tga" || fail "VMD's command"
[ "$(stat -c %s "$folder/a.tga")" = $((18 + 3 * 8 * 6)) ] || fail "the Targa's size"
# Header, then blue, green, red: the eye is inside of a red sphere.
[ "$(od -An -tx1 -N21 "$folder/a.tga" | tr -d ' \n')" = 000002000000000000000000080006001800''0000ff ] ||
  fail "the Targa's bytes: $(od -An -tx1 -N21 "$folder/a.tga")"
"$tachyon" "$folder/two.dat" -res 4 2 -format BMP -o "$folder/a.bmp" || fail "BMP"
[ "$(od -An -tx1 -j54 -N3 "$folder/a.bmp" | tr -d ' \n')" = ff0000 ] || fail "the BMP's first pixel"
"$tachyon" "$folder/two.dat" -format PPM48 -o "$folder/a.ppm" || fail "PPM48"
[ "$(head -c 12 "$folder/a.ppm" | tr '\n' ' ')" = "P6 8 6 65535" ] || fail "PPM48's header"
for format in PNG JPEG PPM; do
  "$tachyon" "$folder/two.dat" -format $format -o "$folder/a" +V >"$folder/words" || fail "$format"
  contains "$folder/words" "s in all"
done
"$tachyon" "$folder/one.dat" -nosave -o "$folder/none" || fail "-nosave"
[ -e "$folder/none" ] && fail "-nosave has written"

# What is wrong is told, ends with 1 or 2, and nothing is written.
sed 's/Rad 9/Radius 9/' "$folder/one.dat" >"$folder/bad.dat"
expect 1 "bad.dat:7:21: error: 'Radius' does not belong here: expected RAD of SPHERE" "$tachyon" "$folder/bad.dat" -o "$folder/none"
expect 1 "cannot be read: No such file" "$tachyon" "$folder/missing.dat" -o "$folder/none"
[ -e "$folder/none" ] && fail "a picture of a wrong scene"
expect 2 "there is no option -fast" "$tachyon" "$folder/one.dat" -fast
expect 2 "-res needs a value" "$tachyon" "$folder/one.dat" -res 4
expect 2 "-format RGB is not written here" "$tachyon" "$folder/one.dat" -format RGB
expect 2 "-camfile is not done here" "$tachyon" "$folder/one.dat" -camfile a.cam
expect 2 "a scene is needed" "$tachyon"
expect 0 "-aasamples N" "$tachyon" -help
finish
