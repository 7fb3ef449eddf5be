// SPDX-License-Identifier: Apache-2.0
// Material documents in several files, and those that are refused.
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/exchange/surfaces/document.h"
#include "tests/core/validate/surface_documents.h"

using namespace etak;
using namespace etak::test;

namespace {

// The one line that a document is refused with.
std::string refusal_of_document(const std::string& file, const std::string& text) {
  const CheckedFile checked = checked_document(file, text);
  REQUIRE(checked.findings.size() == 1);
  CHECK(checked.unreadable);
  CHECK(checked.findings[0].rule == "ETK001");
  CHECK(checked.findings[0].message.find('\n') == std::string::npos);
  return checked.findings[0].message;
}

}  // namespace

TEST_CASE("broken documents are refused in one line that names the place") {
  CHECK(contains(refusal_of_document("a.mtlx", "<!DOCTYPE x [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]>\n" +
                                                   in_material_x("")),
                 "a document type"));
  CHECK(contains(refusal_of_document("a.mtlx", "<materialx version=\"1.39\">\n<a"), "a.mtlx:2"));
  CHECK(contains(refusal_of_document("a.mtlx", "<materialx version=\"1.36\"/>"), "1.38 or 1.39"));
  CHECK(contains(refusal_of_document("a.mtlx", in_material_x("<mix_up name=\"a\" type=\"float\"/>")),
                 "a.mtlx:2: a node of the unknown kind"));
  CHECK(contains(
      refusal_of_document(
          "a.mtlx",
          in_material_x(
              "<add name=\"a\" type=\"float\"><input name=\"in1\" type=\"float\" nodename=\"b\"/></add>\n"
              "<add name=\"b\" type=\"float\"><input name=\"in1\" type=\"float\" nodename=\"a\"/></add>")),
      "reads itself"));
  CHECK(contains(
      refusal_of_document(
          "a.mtlx",
          in_material_x(
              "<nodegraph name=\"g\"><output name=\"o\" type=\"float\" nodename=\"n\"/>"
              "<add name=\"n\" type=\"float\"><input name=\"in1\" type=\"float\" nodegraph=\"g\" output=\"o\"/></add></nodegraph>")),
      "reads itself"));
  CHECK(contains(
      refusal_of_document(
          "a.mtlx",
          in_material_x(
              "<add name=\"a\" type=\"float\"><input name=\"in1\" type=\"float\" nodename=\"q\"/></add>")),
      "which is not there"));
  CHECK(contains(
      refusal_of_document(
          "a.mtlx",
          in_material_x(
              "<image name=\"a\" type=\"color3\"><input name=\"file\" type=\"filename\" value=\"../../secret.png\"/></image>")),
      "outside of the document's folder"));
  CHECK(contains(refusal_of_document("a.mtlx", in_material_x("<xi:include href=\"/etc/passwd\"/>")),
                 "an absolute path"));
  CHECK(contains(refusal_of_document("a.mtlx", in_material_x("<xi:include href=\"https://x/y.mtlx\"/>")),
                 "no file beside"));
  for (const char* value : {"1, x, 0", "1, 0", "nan, 0, 0", "", "1e999, 0, 0"})
    CHECK(contains(refusal_of_document(
                       "a.mtlx", material_x_of(open_pbr_model, {"base_color=color3:" + std::string(value)})),
                   "a.mtlx:4: input \"base_color\""));
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<nodegraph name=\"g\">";
  for (int i = 0; i < 100; ++i) deep += "</nodegraph>";
  CHECK(contains(refusal_of_document("a.mtlx", in_material_x(deep)), "depth"));

  CHECK(contains(refusal_of_document("a.usda", "PXR-USDC\x08"), "the binary form of USD"));
  CHECK(contains(refusal_of_document("a.usda", "PK\x03\x04"), "a package of USD"));
  CHECK(contains(refusal_of_document("a.usda", usda_of({"float inputs:ior = 1.x"})), "a number"));
  CHECK(contains(refusal_of_document("a.usda", usda_of({"float inputs:ior = nan"})), "a number"));
  CHECK(contains(refusal_of_document("a.usda", usda_of({"color3f inputs:diffuseColor = (0.1, inf, 0)"})),
                 "a number"));
}

TEST_CASE("included documents are judged with their names and lines, each once") {
  const TempFolder folder;
  const std::string path = folder.file("a.mtlx");
  std::filesystem::create_directory(folder.file("sub"));
  spit(path, in_material_x("<xi:include href=\"sub/b.mtlx\"/><xi:include href=\"./c.mtlx\"/>"
                           "<surfacematerial name=\"M\" type=\"material\"><input name=\"surfaceshader\" "
                           "type=\"surfaceshader\" nodename=\"s\"/></surfacematerial>"));
  spit(folder.file("c.mtlx"), in_material_x("<xi:include href=\"sub/b.mtlx\"/>"));
  spit(folder.file("sub/b.mtlx"),
       in_material_x("<xi:include href=\"d.mtlx\"/><open_pbr_surface name=\"s\" type=\"surfaceshader\">\n"
                     "<input name=\"specular_ior\" type=\"float\" nodename=\"n\"/></open_pbr_surface>"));
  spit(folder.file("sub/d.mtlx"),
       in_material_x("<constant name=\"n\" type=\"float\"><input name=\"value\" type=\"float\" value=\"15\"/>"
                     "</constant>"));
  std::vector<std::string> read;
  const std::vector<DocumentSurface> surfaces = surfaces_of_document(path, "a.mtlx", &read);
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].name == "M");
  CHECK(surfaces[0].inputs[0].values == std::vector<double>{15});
  CHECK(surfaces[0].inputs[0].place == "sub/b.mtlx, line 3");
  CHECK(read.size() == 3);

  const auto refusal = [&](const std::string& text) {
    spit(folder.file("c.mtlx"), text);
    return error_of([&] { (void)surfaces_of_document(path, "a.mtlx"); });
  };
  CHECK(contains(refusal(in_material_x("<xi:include href=\"a.mtlx\"/>")),
                 "c.mtlx:2: \"a.mtlx\" includes itself"));
  CHECK(contains(refusal(in_material_x("<xi:include href=\"c.mtlx\"/>")), "includes itself"));
  CHECK(contains(refusal(in_material_x("<xi:include href=\"nothing.mtlx\"/>")), "nothing.mtlx"));
  for (int i = 1; i <= 70; ++i)
    spit(folder.file("deep" + std::to_string(i) + ".mtlx"),
         in_material_x("<xi:include href=\"deep" + std::to_string(i + 1) + ".mtlx\"/>"));
  CHECK(contains(refusal(in_material_x("<xi:include href=\"deep1.mtlx\"/>")), "to a depth of 65"));
  CHECK(contains(refusal(in_material_x("<xi:include href=\"../x.mtlx\"/>")),
                 "outside of the document's folder"));
  CHECK(
      contains(refusal(in_material_x("<nodegraph name=\"g\"><xi:include href=\"sub/d.mtlx\"/></nodegraph>")),
               "inside of a graph"));
  CHECK(contains(refusal("<a/>"), "c.mtlx: no element materialx"));
  CHECK(contains(error_of([] {
                   (void)surfaces_of_material_x(
                       "<materialx version=\"1.39\"><xi:include href=\"b\"/></materialx>", "x");
                 }),
                 "whose folder holds it"));
  for (const char* const arc :
       {"subLayers = [@b.usda@]", "prepend references = @b.usda@</x>", "payload = [@b.usda@]"}) {
    const std::string layer = std::string("#usda 1.0\ndef \"a\" (\n") + arc + "\n) {}\n";
    CHECK(contains(refusal_of_document("a.usda", layer), "a.usda:3: another layer, \"b.usda\""));
  }
  CHECK(surfaces_of_usda("#usda 1.0\ndef \"a\" ( assetInfo = { asset identifier = @b.usda@ } ) {}\n", "x")
            .empty());
}

TEST_CASE("broken USD layers and tables are refused in one line that names the place") {
  CHECK(contains(refusal_of_document("a.usda", "#usda 1.0\ndef Material \"a\"\n{\n"), "the end of the file"));
  CHECK(contains(refusal_of_document("a.usda", "#usda 1.0\n( subLayers = [@../b.usda@] )\n"),
                 "outside of the document's folder"));
  CHECK(contains(
      refusal_of_document("a.usda", "#usda 1.0\ndef Shader \"s\" { uniform token info:id = \"MyShader\" }\n"),
      "unknown id"));
  CHECK(contains(refusal_of_document(
                     "a.usda", "#usda 1.0\ndef Shader \"s\" { float inputs:a.connect = </t.outputs:x> }\n"),
                 "which is not there"));
  CHECK(
      contains(refusal_of_document("a.usda",
                                   "#usda 1.0\ndef Shader \"s\" { float inputs:a.connect = </t.outputs:x> }\n"
                                   "def Shader \"t\" { float inputs:a.connect = </s.outputs:x> }\n"),
               "reads itself"));
  CHECK(contains(refusal_of_document("a.usda", "#usda 1.0\ndef \"a\" { string s = \"open\n }\n"),
                 "without its end"));
  std::string deep = "#usda 1.0\n";
  for (int i = 0; i < 100; ++i) deep += "def \"a\" {\n";
  CHECK(contains(refusal_of_document("a.usda", deep), "depth"));

  CHECK(contains(refusal_of_document("a.csv", value_table_of({"openpbr,base_metalness,1,one,,"})),
                 "a.csv:2: value1 \"one\""));
  CHECK(
      contains(refusal_of_document("a.csv", value_table_of({"nothing,a,1,1,,"})), "the target \"nothing\""));
  CHECK(contains(refusal_of_document("a.csv", "id,dataset,target,field,text,value1,value2,value3\na,b\n"),
                 "2 fields"));
}
