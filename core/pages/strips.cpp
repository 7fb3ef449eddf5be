// SPDX-License-Identifier: Apache-2.0
#include "core/base/bytes/base64.h"
#include "core/base/text/text.h"
#include "core/pages/error_time_report.h"
#include "core/pages/page_style.h"

namespace etak {

std::string_view strips_css() {
  return R"css(
.strips { margin: 1.4rem 0; }
.strips figcaption { font-size: 1.05rem; font-weight: 600; color: var(--ink); margin: 0 0 0.4rem; }
.strips > div { display: grid; grid-template-columns: minmax(9rem, max-content) 1fr; gap: 0.35rem 0.9rem; align-items: center; }
.strips img { display: block; width: 100%; height: clamp(56px, 7vw, 110px); border-radius: 4px; }
.strips b { display: block; font-weight: 600; }
.strips .about { margin: 0.4rem 0 0; }
@media (max-width: 600px) {
  .strips > div { grid-template-columns: 1fr; gap: 0.15rem; }
  .strips img { margin-bottom: 0.5rem; }
  .strips b { display: inline; margin-left: 0.6em; }
}
)css";
}

std::string strips_html(const ErrorTimeStrips& strips) {
  std::string out =
      "<figure class=\"strips\"><figcaption>" + escape_html(strips.title) + "</figcaption><div>";
  for (const ErrorTimeStrips::Row& row : strips.ways)
    append(out, "<span>", escape_html(row.title), "<b>", escape_html(row.note), "</b></span><img alt=\"",
           escape_html(strips.title + ": " + row.title + " " + row.note), "\" src=\"data:image/png;base64,",
           base64(row.png), "\">");
  return out + "</div><p class=\"about\">From left to right " + escape_html(strips.columns) +
         "; in each strip " + escape_html(strips.rows) + ".</p></figure>\n";
}

}  // namespace etak
