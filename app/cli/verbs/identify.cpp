// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/inputs/colors.h"
#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/color/srgb.h"
#include "core/image/load.h"
#include "core/judge/engine.h"
#include "core/pages/lists/identify.h"

namespace etak::cli {
namespace {

struct IdentifyArguments {
  std::vector<std::string> color;
  std::string image, f82, prior, film, measured, stack;
  std::vector<std::string> classes, without, oxides;
  bool linear = false;
  F0Settings compute;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
};

// The colours that are asked for: the one of the line, or a line each of standard input.
std::vector<std::string> asked_colors(const IdentifyArguments& arguments) {
  const std::string& typed = one_color(arguments.color);
  if (typed != "-") return {typed};
  std::vector<std::string> out;
  for (const std::string& line : ListedNames(accept_input(typed)).take())
    if (!line.empty()) out.push_back(line);
  if (out.empty()) throw Error::at("<stdin>", "holds no colour", "a colour a line");
  return out;
}

/// A colour that is asked about.
///   share   of a picture's texels
struct Question {
  std::string input;
  AskedColour color;
  std::optional<double> share = {};
};

Question question(const std::string& typed, IdentifyArguments& arguments, const F0Solver& solver) {
  AskedColour out;
  if (!arguments.linear && !is_color(typed, arguments.library)) {
    out.f0 = color_of(typed, "", arguments.library, arguments.compute, solver, arguments.output);
  } else {
    const TypedColor color = typed_color(typed, arguments.linear, solver.options());
    out.eight_bit = std::holds_alternative<Srgb8>(color);
    out.f0 = linear_of(color);
  }
  if (!arguments.f82.empty())
    out.f82 = linear_of(typed_color(arguments.f82, arguments.linear, solver.options()));
  check_asked(out, printable(typed));
  return {typed, out};
}

// The colours of a picture's plateaus.
std::vector<Question> questions_of(const std::string& image, const IdentifyArguments& arguments) {
  if (!arguments.color.empty() || !arguments.f82.empty())
    throw Error::at("--image", "beside a colour", "one of them");
  const auto transfer = arguments.linear ? TextureTransfer::linear : TextureTransfer::srgb;
  std::vector<Question> out;
  for (const FlatColor& each :
       flat_colors(open_picture(image, picture_door()), transfer, thread_count(arguments.threads))) {
    const LinearRgb color = to_rgb(each.linear);
    const AskedColour asked{color, {}, true};
    check_asked(asked, image);
    out.push_back({image + " " + hex(srgb_u8(color)), asked, each.share});
  }
  if (out.empty()) throw Error::at(image, "no flat region", "a picture of F0 with regions of one colour");
  return out;
}

std::vector<Question> questions(IdentifyArguments& arguments, const F0Solver& solver) {
  if (!arguments.image.empty()) return questions_of(arguments.image, arguments);
  std::vector<Question> out;
  for (const std::string& typed : asked_colors(arguments)) out.push_back(question(typed, arguments, solver));
  return out;
}

int identify_colors(IdentifyArguments& arguments, const F0Solver& solver) {
  const std::vector<Question> asked = questions(arguments, solver);
  const MaterialLibrary& library = arguments.library.get();
  const Prior prior =
      arguments.prior.empty() ? Prior{} : parse_prior(read_file(arguments.prior), arguments.prior, library);
  Identifier identifier(library, solver, arguments.classes, thread_count(arguments.threads));
  for (auto& [id, material] : materials_without(library, arguments.without))
    identifier.replace(id, std::move(material), solver);
  std::vector<IdentifiedColor> answers;
  for (const Question& each : asked)
    answers.push_back({each.input, identifier.identify(each.color, prior), each.share});
  write_output(arguments.output, arguments.output.format == "json"
                                     ? identify_json(answers)
                                     : identify_text(answers, use_color(arguments.output)));
  return exit_ok;
}

int identify_films(IdentifyArguments& arguments, const F0Solver& solver) {
  const MaterialLibrary& library = arguments.library.get();
  std::vector<IdentifiedFilm> answers;
  for (const Question& each : questions(arguments, solver))
    answers.push_back({each.input, films_of_color({arguments.film, arguments.oxides}, each.color, library,
                                                  solver, thread_count(arguments.threads))});
  write_output(arguments.output,
               arguments.output.format == "json" ? identify_json(answers) : identify_text(answers));
  return exit_ok;
}

int identify_thickness(IdentifyArguments& arguments, const F0Solver& solver) {
  if (!arguments.color.empty() || !arguments.image.empty())
    throw Error::at("--measured", "beside a colour", "a spectrum and --stack alone");
  const IdentifiedThickness answer =
      identified_thickness(arguments.measured, arguments.stack, arguments.library.get(), solver);
  write_output(arguments.output,
               arguments.output.format == "json" ? identify_json(answer) : identify_text(answer));
  return exit_ok;
}

int run(IdentifyArguments& arguments) {
  F0Options options = f0_options(arguments.compute, arguments.library);
  options.f82 = !arguments.f82.empty();
  const F0Solver solver{std::move(options)};
  if (!arguments.measured.empty()) return identify_thickness(arguments, solver);
  if (!arguments.stack.empty()) throw Error::at("--stack", "without --measured", "the spectrum of the stack");
  if (arguments.color.empty() && arguments.image.empty())
    throw Error::at("etak identify", "no colour", color_forms);
  if (!arguments.film.empty()) return identify_films(arguments, solver);
  if (!arguments.oxides.empty()) throw Error::at("--oxide", "without --film", "--film METAL");
  return identify_colors(arguments, solver);
}

}  // namespace

void add_identify(CommandLine& line) {
  const auto arguments = std::make_shared<IdentifyArguments>();
  Command verb = line.verb("identify", "which material a colour could be, or how thick a film is");
  verb.option("COLOUR", arguments->color, std::string(color_forms) + ", or - for a list, one a line")
      .value_name("");
  verb.flag("--linear", arguments->linear, "COLOUR is linear, in --space");
  verb.option("--f82", arguments->f82, "reflectance at 82 degrees, a colour in the form of COLOUR")
      .value_name("COLOUR");
  verb.option("--image", arguments->image, "a picture of F0, whose flat regions are asked about")
      .reads_file()
      .value_name("FILE");
  add_class_option(verb, arguments->classes, "only this class; may be repeated");
  verb.option(
          "--prior", arguments->prior,
          "CSV of id and weight: how much more likely materials are than those that it does not name (weight 1)")
      .reads_file()
      .value_name("FILE");
  add_without_option(verb, arguments->without);
  verb.option("--film", arguments->film, "the metal under a film whose thickness gives the colour")
      .value_name("METAL");
  verb.option("--oxide", arguments->oxides,
              "a film to try, with --film; may be repeated (default: " + joined(usual_films()) + ")")
      .one_at_a_time()
      .value_name("MATERIAL");
  verb.option("--measured", arguments->measured,
              "table of wavelength and reflectance R of a stack with one unknown thickness")
      .reads_file()
      .value_name("FILE");
  verb.option("--stack", arguments->stack, "that stack: polystyrene:?nm/silicon").value_name("STACK");
  add_compute_options(verb, arguments->compute);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "json"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "p is the probability among the materials of the library, dE is CIEDE2000, and \"of band\" is dE over the\n"
      "distance within which nine of ten new publications of the material would lie.\n"
      "Example:\n  etak identify '#f5c65a'");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
