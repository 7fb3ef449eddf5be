# SPDX-License-Identifier: Apache-2.0
# awk -f match_lines.awk EXPECTED FOUND: fails with a message unless the lines of FOUND match those of
# EXPECTED, whose patterns run_case.sh describes.
BEGIN {
  wanted_file = ARGV[1]
  found_file = ARGV[2]
  while ((getline line < wanted_file) > 0) wanted[++wanted_count] = line
  while ((getline line < found_file) > 0) found[++found_count] = line
  skipping = 0
  at = 1
  for (i = 1; i <= wanted_count; ++i) {
    if (wanted[i] == "...") {
      skipping = 1
      continue
    }
    while (skipping && at <= found_count && !fits(wanted[i], found[at])) ++at
    if (at > found_count || !fits(wanted[i], found[at])) {
      print "line " at " does not fit line " i " of the expected: " wanted[i]
      exit 1
    }
    ++at
    skipping = 0
  }
  if (!skipping && at <= found_count) {
    print "more than expected from line " at ": " found[at]
    exit 1
  }
}
function fits(pattern, text) {
  if (substr(pattern, 1, 2) == "~ ") return text ~ ("^(" substr(pattern, 3) ")$")
  return pattern == text
}
