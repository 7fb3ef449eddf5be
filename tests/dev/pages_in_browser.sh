#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pages_in_browser.sh ETAK DEMO_SCENE START_PAGE SCRATCH: makes the demo's pages (of few materials) and opens them in
# a real browser, at three widths in both schemes: nothing stands out of the page at its side, the colours of the
# page follow the scheme, nothing needs a script to be read, and the start page's click copies values.
set -eu
etak=$1 demo_scene=$2 start_page=$3 scratch=$4
browser=
for name in chromium chromium-browser google-chrome; do
  if command -v $name >/dev/null; then browser=$name && break; fi
done
[ -n "$browser" ] || { echo "no chromium here"; exit 77; }
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
export HOME="$scratch" XDG_CONFIG_HOME="$scratch/config" XDG_CACHE_HOME="$scratch/cache"

pages='index f0 findings atlas scene-atlas report sources'

fault() { echo "$*" | tee -a faults; }

"$demo_scene" scene mistakes
"$etak" pack scene/manifest.json -o atlas --no-validate --report none --page-report atlas.html
"$etak" pack scene/scene.gltf --islands -o scene-atlas --no-validate --report none --page-report scene-atlas.html
"$etak" report --family transfer,quantisation -o report -q
cp report/report.html report.html
"$etak" f0 gold silicon water cardboard --format html -q -o f0.html
"$etak" validate mistakes scene atlas --no-config --format html --exit-zero -q -o findings.html
mkdir figures
"$etak" render gold --sweep gloss=0:1:7 --size 220 -q -o figures/gloss.png
"$start_page" --figures | grep -q '^gloss gold --sweep gloss=0:1:7 --size 220$' || fault "the figure of gloss is another one"
"$start_page" .
[ "$(wc -c <index.html)" -lt 8000000 ] || fault "index.html is larger than 8 MB"
if grep -oE 'src="https?:[^"]*"|<link [^>]*>|@import|url\([^#)][^)]*\)' index.html; then fault "index.html loads something"; fi

see() { # DARK OPTIONS...: what the browser makes of a page
  dark=$1
  shift
  timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$scratch/profile" --window-size=2700,1200 \
    --blink-settings=preferredColorScheme=$dark "$@" 2>/dev/null
}

# A page inside of a frame has the width of the frame; browsers do not make windows as narrow as a telephone.
for page in $pages; do
  sed 's|</body>|<script>addEventListener("load", () => {\
    const root = document.documentElement, balls = document.querySelector(".balls.copies");\
    const out = [...document.querySelectorAll("main > *, header > *, article, h2, h3, p, figure, table:not(.scroll *)")]\
      .filter((each) => !each.closest(".scroll") \&\& each.getBoundingClientRect().right > root.clientWidth + 1)\
      .map((each) => each.tagName + "." + each.className).slice(0, 3).join(" ");\
    if (balls) balls.click();\
    setTimeout(() => parent.postMessage([innerWidth, Math.max(0, root.scrollWidth - root.clientWidth), out,\
      getComputedStyle(document.body).backgroundColor,\
      (document.querySelector(".copied") \|\| {textContent: ""}).textContent.replace(/\\n/g, " ")].join("\|"), "*"), 400);\
  })</script></body>|' "$page.html" >"measured_$page.html"
done
for width in 360 1400 2560; do
  cat >frames.html <<EOF
<!DOCTYPE html><html><body><script>addEventListener("message", (event) => {
  const line = document.createElement("p");
  line.textContent = "measured " + event.data;
  document.body.append(line);
})</script>
EOF
  for page in $pages; do
    echo "<iframe width=\"$width\" height=\"900\" style=\"border:0\" src=\"measured_$page.html\"></iframe>" >>frames.html
  done
  for dark in 0 1; do
    see $dark --virtual-time-budget=8000 --dump-dom "file://$scratch/frames.html" |
      grep -o '<p>measured [^<]*' | sed 's/^<p>//' >told || true
    [ "$(wc -l <told)" -eq 7 ] || { fault "at $width: $(wc -l <told) of 7 pages answered"; cat told; }
    while IFS='|' read -r seen over out color copied; do
      [ "$seen" = "measured $width" ] || fault "wanted $width, $seen"
      [ "$over" = 0 ] || fault "at $width: a page is $over pixels too wide: $out"
      case $dark:$color in
        0:'rgb(22, 22, 22)' | 1:'rgb(242, 242, 242)') ;;
        *) fault "scheme $dark at $width: background $color" ;;
      esac
      case $copied in '' | 'copied: '*'Base Color'*) ;; *) fault "copied $copied" ;; esac
      [ -z "$copied" ] || echo told >>copied
    done <told
  done
done
[ -s copied ] || fault "a click on the spheres copied nothing"

# The same text and the same pictures are there without the scripts. (Browsers with scripts turned off
# print no page.)
sed '/^<script>/,/<\/script>/d' index.html >still.html
grep -q '<script' still.html && fault "a script stands where the test does not look for it"
see 1 --dump-dom "file://$scratch/still.html" >without_scripts
for text in 'Measured, and as programs compute it' 'Fused silica' 'Base Color' 'Where materials are' 'What exactness costs' 'Before' 'After' \
  'What cannot be real' 'F0 of the library'; do
  grep -qF "$text" without_scripts || fault "without scripts there is no \"$text\""
done
[ "$(grep -o '<img ' without_scripts | wc -l)" -ge 72 ] || fault "without scripts there are fewer than 72 spheres"
[ ! -s faults ]
