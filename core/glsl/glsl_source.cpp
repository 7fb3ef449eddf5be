// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_source.h"

#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/glsl/glsl_tokens.h"

namespace etak {
namespace {

// The names that a text uses: those that it calls as functions, those behind a dot that it does not only set, and
// all of them.
struct Uses {
  std::set<std::string, std::less<>> called, named, members;

  void add(std::string_view text) {
    char before = ' ';
    for_each_token(text, [&](std::string_view token, std::string_view rest) {
      if (is_word(token[0]) && !is_digit(token[0])) {
        named.emplace(token);
        if (rest.starts_with('(')) called.emplace(token);
        if (before == '.' && !rest.starts_with(" = ")) members.emplace(token);
      }
      before = token[0];
    });
  }
};

// A function, struct, constant or uniform, with the comment above it.
struct Definition {
  std::string_view name;
  std::string text;
  bool is_function = false;
  bool needed = false;

  bool is_struct() const { return !is_function && text.find("\n};") != std::string::npos; }
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

// Marks what `root` uses, directly or through others, and nothing else. Returns all names that are used.
Uses mark_needed(std::vector<ParsedFile>& files, std::string_view root) {
  for (ParsedFile& parsed : files)
    for (Definition& each : parsed.definitions) each.needed = false;
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
  return uses;
}

// The words of a line, and whether it is one whole statement: `  real x = ...;` or `  a.x = ...;`.
struct Line {
  std::vector<std::string_view> words;
  bool whole = false;
};

Line read_line(std::string_view line) {
  Line out;
  for_each_token(line, [&](std::string_view token, std::string_view) {
    if (is_comment(token)) return;
    if (token[0] != ' ') out.words.push_back(token);
  });
  out.whole = !out.words.empty() && out.words.back() == ";";
  return out;
}

// Takes away the lines of a needed definition that compute or declare what nobody reads: members of structs that are
// only set, and variables of a function that stand in one line alone. Returns whether there were any.
bool prune(Definition& each, const Uses& uses) {
  std::string kept;
  for (std::size_t at = 0; at < each.text.size();) {
    const std::size_t end = std::min(each.text.find('\n', at), each.text.size() - 1) + 1;
    const std::string_view line = std::string_view(each.text).substr(at, end - at);
    const auto [words, whole] = read_line(line.substr(0, line.size() - 1));
    bool unread = false;
    const auto unread_member = [&](std::string_view name) {
      return name.find_first_not_of("xyzw") != name.npos && !uses.members.contains(name);
    };
    if (each.is_struct()) {
      const std::string_view told = line.substr(0, line.find("  ", 5));  // "//   name", in the comment
      unread =
          whole ? words.size() == 3 && unread_member(words[1])
                : told.starts_with("//   ") && told.find(',') == told.npos && unread_member(told.substr(5));
    } else if (whole && words.size() > 4 && words[1] == "." && words[3] == "=" && words[4] != "=") {
      unread = unread_member(words[2]);
    } else if (whole && words.size() > 4 && words[0] != "return" && is_word(words[1][0]) && words[2] == "=" &&
               words[3] != "=") {
      Uses rest;
      rest.add(std::string_view(each.text).substr(end));
      unread = !rest.named.contains(words[1]);
    }
    if (!unread) kept += line;
    at = end;
  }
  const bool shrunk = kept.size() < each.text.size();
  each.text = std::move(kept);
  return shrunk;
}

bool prune(std::vector<ParsedFile>& files, const Uses& uses) {
  bool any = false;
  for (ParsedFile& parsed : files)
    for (Definition& each : parsed.definitions)
      if (each.needed && (each.is_struct() || each.is_function) && prune(each, uses)) any = true;
  return any;
}

}  // namespace

bool glsl_reads_member(std::string_view root, std::string_view member) {
  std::vector<ParsedFile> files = parsed_files();
  return mark_needed(files, root).members.contains(member);
}

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
  for (Uses uses = mark_needed(files, root); prune(files, uses);) uses = mark_needed(files, root);
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

std::string with_bindings(std::string_view text, bool vertex) {
  std::string members, rest;
  int binding = 0, handed_over = 0;
  const std::size_t head = text.find('\n') + 1;
  for (std::size_t at = head; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, end - at);
    if (line.starts_with("uniform sampler"))
      append(rest, "layout(binding = ", std::to_string(++binding), ") ", line);
    else if (line.starts_with("uniform "))
      append(members, "  ", line.substr(8));
    else if (line.starts_with(vertex ? "out " : "in "))
      append(rest, "layout(location = ", std::to_string(handed_over++), ") ", line);
    else
      rest += line;
    at = end;
  }
  std::string out(text.substr(0, head));
  if (!members.empty())
    append(out, "layout(std140, binding = 0) uniform ", vertex ? "Placing" : "Values", " {\n", members,
           "};\n");
  const auto replace = [&](std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = rest.find(what, at)) != rest.npos; at += by.size())
      rest.replace(at, what.size(), by);
  };
  if (vertex && rest.find("gl_VertexID") != rest.npos) {
    replace("gl_VertexID", "vertex_index");
    out +=
        "#ifdef VULKAN\n#define vertex_index gl_VertexIndex\n#else\n#define vertex_index gl_VertexID\n#endif\n";
  }
  if (rest.find("gl_FragCoord.xy") != rest.npos) {
    replace("gl_FragCoord.xy", "pixel_place");
    out +=
        "#ifdef VULKAN\n#define pixel_place vec2(gl_FragCoord.x, picture_size.y - gl_FragCoord.y)\n#else\n"
        "#define pixel_place gl_FragCoord.xy\n#endif\n";
  }
  return out + rest;
}

}  // namespace etak
