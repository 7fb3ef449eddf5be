// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/csv.h"
#include "core/base/number.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"

namespace etak {
namespace {

// Fields by RFC 4180, rows ended by CRLF.
class Row {
 public:
  explicit Row(std::string& out) : out_(out) {}
  void add(std::string_view field) {
    if (!first_) out_ += ',';
    first_ = false;
    out_ += csv_field(field);
  }
  void end() { out_ += "\r\n"; }

 private:
  std::string& out_;
  bool first_ = true;
};

}  // namespace

std::string validation_csv(const ValidationReport& report) {
  std::string out =
      "file,tile,material,pointer,rule,slug,severity,x,y,width,height,area_px,area_share,linear_r,linear_g,linear_b,byte_r,byte_g,byte_b,Y,value,limit,nearest,message,cause,fix,source,suppressed,baseline";
  out += report.shard ? ",shard\r\n" : "\r\n";
  for (const CheckedFile& file : report.files)
    for (const Finding& f : file.findings) {
      Row row(out);
      for (const std::string* text : {&f.file, &f.tile, &f.material, &f.pointer, &f.rule, &f.slug})
        row.add(*text);
      row.add(name(f.severity));
      for (const int side : {0, 1, 2, 3}) {
        if (!f.box) {
          row.add("");
          continue;
        }
        const int sides[] = {f.box->x, f.box->y, f.box->width, f.box->height};
        row.add(std::to_string(sides[side]));
      }
      row.add(f.area_px > 0 ? std::to_string(f.area_px) : "");
      row.add(f.area_px > 0 ? number(f.area_share, 6) : "");
      for (std::size_t c = 0; c < 3; ++c) row.add(f.linear ? number((*f.linear)[c], 9) : "");
      for (std::size_t c = 0; c < 3; ++c) row.add(f.byte ? std::to_string((*f.byte)[c]) : "");
      row.add(f.luminance ? number(*f.luminance, 9) : "");
      std::string near;
      for (const NearestMaterial& material : f.nearest)
        near += (near.empty() ? "" : ";") + material.id + '/' + material.dataset + ' ' +
                number(material.bytes, 3);
      for (const auto* text : {&f.value, &f.limit, static_cast<const std::string*>(&near), &f.message,
                               &f.cause, &f.fix, &f.source})
        row.add(*text);
      row.add(f.suppressed ? (f.suppression.empty() ? "yes" : f.suppression) : "");
      row.add(f.baseline ? "yes" : "");
      if (report.shard) row.add(report.shard->shard.text());
      row.end();
    }
  return out;
}

}  // namespace etak
