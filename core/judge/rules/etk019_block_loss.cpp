// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk019_block_loss{
    .id = "ETK019",
    .slug = "block-loss",
    .title = "Compression has changed a texture by more than shading forgives",
    .severity = Severity::warning,
    .needs = {Need::sources},
    .parameters = {{"colour", 5, 2, "CIEDE2000",
                    "the most by which 99 % of the texels may change, of colours and F0"},
                   {"exponent", 50, 20, "%", "the same of the exponent of gloss or roughness"},
                   {"degrees", 5, 3, "degrees", "the same of normals"}},
    .source =
        "15 textures of a helmet (etak): an ordinary BC7 leaves 2.3 dE at most, 36 % of the exponent and 4.2 degrees, BC5 2.7 degrees, BC1 4.1 dE, 108 % and 9.5 degrees; etak pack keeps to 1 dE and 10 %",
    .what =
        "A DDS or KTX2 file in blocks lies beside a picture of the same name, role and size, and more than 1 % of its texels differ by more than the parameters say. Of more than a million texels a sample of rows is "
        "compared, of gloss what both files have. Not compared are the pages of an atlas, of which etak pack reports what it has changed material by material, normals in BC3, whose x may be in alpha, colours in floats, and those under alpha 0.",
    .why =
        "The renderer reads the blocks: what the picture beside them has right is drawn with other colours, highlights of another width, or relief that is not there.",
    .example = "Roughness in BC1; a DDS file of a picture that was painted over since.",
    .fix =
        "Compress it again from the picture beside it, as BC7 or ASTC 4x4, normals as BC5, and roughness alone as BC4 or with a weight of its own.",
    .check = [](RuleCheck& check) {
      struct Part {
        const std::optional<double>& p99;
        std::string_view parameter, of, unit;
      };
      for (const BlockLoss& loss : check.evidence.losses)
        for (const Part& part : {Part{loss.colour, "colour", "colours", " dE"},
                                 Part{loss.exponent, "exponent", "the exponent of highlights", " %"},
                                 Part{loss.degrees, "degrees", "normals", " degrees"}}) {
          const double most = check.parameter(part.parameter);
          if (part.p99.value_or(0) <= most) continue;
          Finding& finding = check.report();
          finding.file = loss.label;
          finding.value = number(*part.p99, 3) + std::string(part.unit);
          finding.limit = number(most, 3) + std::string(part.unit);
          finding.message = loss.blocks + " differs from " + loss.source +
                            " beside it: " + std::string(part.of) + " by up to " + finding.value +
                            " on 99 % of the texels, and by more on the others";
        }
    }};

}  // namespace etak
