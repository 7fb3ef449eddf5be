// SPDX-License-Identifier: Apache-2.0
#include "core/render/glsl/glsl_source.h"

#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/base/text/ascii.h"

namespace etak {
namespace {

bool is_word(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

// The end of the token that begins at `at`: a comment up to the end of its line, a word, a number, or one
// character.
std::size_t token_end(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  const auto here = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
  if (text[at] == '/' && here(at + 1) == '/') {
    while (end < text.size() && text[end] != '\n') ++end;
  } else if (is_digit(text[at]) || (text[at] == '.' && is_digit(here(at + 1)))) {
    while (is_word(here(end)) || here(end) == '.' ||
           ((here(end) == '-' || here(end) == '+') && (here(end - 1) == 'e' || here(end - 1) == 'E')))
      ++end;
  } else if (is_word(text[at])) {
    while (is_word(here(end))) ++end;
  }
  return end;
}

template <class Visit>
void for_each_token(std::string_view text, Visit visit) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = token_end(text, at);
    visit(text.substr(at, end - at), text.substr(end));
    at = end;
  }
}

bool is_comment(std::string_view token) {
  return token.starts_with("//");
}

// The names that a text uses: those that it calls as functions, and all of them.
struct Uses {
  std::set<std::string_view> called, named;

  void add(std::string_view text) {
    for_each_token(text, [&](std::string_view token, std::string_view rest) {
      if (!is_word(token[0]) || is_digit(token[0])) return;
      named.insert(token);
      if (rest.starts_with('(')) called.insert(token);
    });
  }
};

// A function, struct, constant or uniform, with the comment above it.
struct Definition {
  std::string_view name;
  std::string_view text;
  bool is_function = false;
  bool needed = false;
};

struct ParsedFile {
  const GlslFile* file;
  std::string_view heading;  // the comment at the head of the file, without its licence line
  std::vector<Definition> definitions;
};

// Parses a definition. Its name is the last word before the first punctuation mark: `struct Angles {`,
// `const real pi = ...`, `uniform vec3 a[3];`, `real f(...)`.
Definition definition(std::string_view text) {
  Definition out;
  out.text = text;
  bool found = false;
  for_each_token(text, [&](std::string_view token, std::string_view) {
    if (found || is_comment(token)) return;
    if (is_word(token[0])) {
      out.name = token;
    } else if (token[0] != ' ' && token[0] != '\n') {
      found = true;
      out.is_function = token[0] == '(';
    }
  });
  return out;
}

// Splits a file into definitions. Each begins at the start of a line and ends with a line whose last brace or
// semicolon closes it.
ParsedFile parsed(const GlslFile& file) {
  ParsedFile out{&file, {}, {}};
  const std::string_view text = file.text;
  int depth = 0;
  bool heading = true, code = false;
  std::size_t begin = text.find('\n') + 1;  // past the licence line
  for (std::size_t at = begin; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, end - at - 1);
    if (is_comment(line)) {
      // The comment belongs to the heading of the file, or to the definition below it.
    } else if (!code && heading) {
      out.heading = text.substr(begin, at - begin);
      heading = false;
      begin = at;
    }
    if (!line.empty() && !is_comment(line)) {
      code = true;
      const std::string_view bare = line.substr(0, line.find("//"));
      for (const char c : bare) depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      const auto last = bare.find_last_not_of(' ');
      if (depth == 0 && last != std::string_view::npos && (bare[last] == '}' || bare[last] == ';')) {
        out.definitions.push_back(definition(text.substr(begin, end - begin)));
        begin = end;
        code = false;
      }
    } else if (line.empty() && !code) {
      begin = end;
    }
    at = end;
  }
  return out;
}

const std::vector<ParsedFile>& parsed_files() {
  static const std::vector<ParsedFile> files = [] {
    std::vector<ParsedFile> out;
    for (const GlslFile& file : glsl_files())
      if (file.name.ends_with(".glsl"))
        out.push_back(parsed(file));  // whole shaders (*.vert) hold no function that others call
    return out;
  }();
  return files;
}

}  // namespace

std::string_view glsl_file(std::string_view name) {
  for (const GlslFile& file : glsl_files())
    if (file.name == name) return file.text;
  throw Error::at(name, "is no shader text of this program");
}

std::string real_literals(std::string_view text) {
  std::string out;
  for_each_token(text, [&](std::string_view token, std::string_view) {
    out += token;
    if (is_digit(token[0]) && token.find_first_not_of("0123456789") == std::string_view::npos) out += ".0";
  });
  return out;
}

std::string glsl_needed_by(std::string_view root) {
  std::vector<ParsedFile> files = parsed_files();
  Uses uses;
  uses.add(root);
  for (bool grew = true; grew;) {
    grew = false;
    for (ParsedFile& parsed : files)
      for (Definition& each : parsed.definitions) {
        if (each.needed || !(each.is_function ? uses.called : uses.named).contains(each.name)) continue;
        each.needed = grew = true;
        uses.add(each.text);
      }
  }
  std::string out;
  for (const ParsedFile& parsed : files) {
    std::string part;
    for (const Definition& each : parsed.definitions) {
      if (!each.needed) continue;
      part += part.empty() ? "" : "\n";
      part += parsed.file->is_formula() ? real_literals(each.text) : std::string(each.text);
    }
    if (part.empty()) continue;
    out += "// ---- " + std::string(parsed.file->name) + '\n' + std::string(parsed.heading) +
           (part.starts_with("//") ? "\n" : "") + part + '\n';
  }
  return out;
}

}  // namespace etak
