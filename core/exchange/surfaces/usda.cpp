// SPDX-License-Identifier: Apache-2.0
// USD layers in text form: the shaders of materials, and nothing else of them is kept.
// Based on: OpenUSD, "USD File Format" (text grammar), UsdPreviewSurface Specification 2.6.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/exchange/surfaces/document.h"
#include "core/exchange/surfaces/models.h"

namespace etak {
namespace {

constexpr int most_depth = 64;

// Shaders beside surfaces, which give them values.
constexpr std::array other_shaders{"UsdUVTexture", "UsdTransform2d", "UsdPrimvarReader_"};

struct Token {
  enum class Kind { end, mark, word, number, text, asset, path };
  Kind kind = Kind::end;
  std::string_view text;  // without quotes, @ or <>
  std::size_t line = 1;
  bool is(std::string_view mark) const { return (kind == Kind::mark || kind == Kind::word) && text == mark; }
};

// The tokens of a layer, one ahead.
class Tokens {
 public:
  Tokens(std::string_view text, const std::string& file) : rest_(text), file_(file) { advance(); }

  const Token& now() const { return now_; }
  Token take() {
    const Token out = now_;
    advance();
    return out;
  }
  bool take_if(std::string_view mark) {
    if (!now_.is(mark)) return false;
    advance();
    return true;
  }
  void expect(std::string_view mark) {
    if (!take_if(mark)) fail("\"" + std::string(mark) + "\"");
  }
  std::string_view expect_kind(Token::Kind kind, std::string_view expected) {
    if (now_.kind != kind) fail(expected);
    return take().text;
  }
  std::string place(std::size_t line) const { return file_ + ":" + std::to_string(line); }
  [[noreturn]] void fail(std::string_view expected) const {
    throw Error::at_line(file_, now_.line,
                         now_.kind == Token::Kind::end ? "the end of the file" : in_quotes(now_.text),
                         expected);
  }

 private:
  void skip_blanks() {
    while (!rest_.empty()) {
      if (rest_[0] == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (is_space(rest_[0])) {
        line_ += rest_[0] == '\n';
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  // What stands between two equal marks.
  std::string_view between(std::string_view mark, bool escapes) {
    std::size_t end = mark.size();
    while (end < rest_.size() && rest_.substr(end, mark.size()) != mark) {
      line_ += rest_[end] == '\n';
      end += escapes && rest_[end] == '\\' ? 2 : 1;
    }
    if (end >= rest_.size())
      throw Error::at_line(file_, line_, "a text without its end", "\"" + std::string(mark) + "\"");
    const std::string_view out = rest_.substr(mark.size(), end - mark.size());
    rest_.remove_prefix(end + mark.size());
    return out;
  }

  static bool is_of_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == ':' || c == '.'; }

  void advance() {
    skip_blanks();
    now_ = {Token::Kind::end, {}, line_};
    if (rest_.empty()) return;
    const char c = rest_[0];
    if (c == '"' || c == '\'') {
      const std::string_view three = c == '"' ? "\"\"\"" : "'''";
      now_.kind = Token::Kind::text;
      now_.text = between(rest_.starts_with(three) ? three : three.substr(0, 1), true);
    } else if (c == '@') {
      now_.kind = Token::Kind::asset;
      now_.text = between(rest_.starts_with("@@@") ? "@@@" : "@", false);
    } else if (c == '<') {
      const std::size_t end = rest_.find('>');
      if (end == rest_.npos) throw Error::at_line(file_, line_, "a path without its end", "\">\"");
      now_.kind = Token::Kind::path;
      now_.text = rest_.substr(1, end - 1);
      rest_.remove_prefix(end + 1);
    } else if (is_letter(c) || c == '_' || is_digit(c) || c == '-' || c == '+' || c == '.') {
      std::size_t end = 1;
      while (end < rest_.size() && (is_of_word(rest_[end]) || ((rest_[end] == '-' || rest_[end] == '+') &&
                                                               lower_case(rest_[end - 1]) == 'e' &&
                                                               (is_digit(c) || c == '-' || c == '.'))))
        ++end;
      now_.kind = is_letter(c) || c == '_' ? Token::Kind::word : Token::Kind::number;
      now_.text = rest_.substr(0, end);
      rest_.remove_prefix(end);
    } else if (std::string_view("()[]{}=,;&").find(c) != std::string_view::npos) {
      now_.kind = Token::Kind::mark;
      now_.text = rest_.substr(0, 1);
      rest_.remove_prefix(1);
    } else {
      throw Error::at_line(file_, line_, in_quotes(rest_.substr(0, 1)), "the text form of USD");
    }
  }

  std::string_view rest_;
  const std::string& file_;
  std::size_t line_ = 1;
  Token now_;
};

// A value as far as it is needed: its numbers, or its text or path.
struct UsdValue {
  std::vector<double> numbers;
  std::string text;
  bool other = false;  // it holds words, texts or more brackets
};

struct Attribute {
  std::string name, type;
  std::size_t line = 1;
  UsdValue value;
  std::string source;  // the path that it is connected to, without the property
  std::string color_space;
};

struct Prim {
  std::string path, name, parent_name;
  std::size_t line = 1;
  std::vector<Attribute> attributes = {};
};

// The prims of a layer in the order of the file, and where each path is among them.
struct Prims {
  std::vector<Prim> all;
  std::map<std::string, std::size_t, std::less<>> by_path;
};

// From text to prims.
class Layer {
 public:
  Layer(std::string_view text, const std::string& file) : tokens_(text, file), file_(file) {}

  Prims read() {
    if (tokens_.now().is("(")) skip_group();
    prims_in("", "", 0);
    if (tokens_.now().kind != Token::Kind::end) tokens_.fail("a prim");
    return std::move(prims_);
  }

 private:
  void check_depth(int depth) const {
    if (depth > most_depth) tokens_.fail("a depth of at most 64");
  }
  void check_asset(const Token& token) const {
    if (token.kind == Token::Kind::asset) require_inside(token.text, tokens_.place(token.line));
  }

  // ( ... ), [ ... ] or { ... } with all that stands in it; names of files are looked at.
  void skip_group() {
    std::string open;
    std::string_view key;  // the word before the last "="
    do {
      const Token token = tokens_.take();
      check_asset(token);
      if (token.kind == Token::Kind::end) tokens_.fail("\")\", \"]\" or \"}\"");
      if (token.kind == Token::Kind::word && tokens_.now().is("=")) key = token.text;
      if (token.kind == Token::Kind::asset && (key == "subLayers" || key == "references" || key == "payload"))
        throw Error::at_line(file_, token.line, "another layer, " + in_quotes(token.text, 80),
                             "a layer that stands alone, as usdcat writes it when it flattens");
      if (token.kind != Token::Kind::mark) continue;
      constexpr std::string_view opens = "([{", closes = ")]}";
      if (const std::size_t at = opens.find(token.text); at != opens.npos) open += closes[at];
      if (closes.find(token.text) != closes.npos) {
        if (open.back() != token.text[0])
          throw Error::at_line(file_, token.line, in_quotes(token.text), std::string(1, open.back()));
        open.pop_back();
      }
    } while (!open.empty());
  }

  // The colour space that the metadata of an attribute state.
  std::string metadata() {
    std::string out;
    tokens_.expect("(");
    while (!tokens_.take_if(")")) {
      if (tokens_.now().kind == Token::Kind::end) tokens_.fail("\")\"");
      const bool space = tokens_.now().is("colorSpace");
      if (tokens_.now().is("(") || tokens_.now().is("[") || tokens_.now().is("{")) {
        skip_group();
        continue;
      }
      check_asset(tokens_.take());
      if (space && tokens_.take_if("="))
        out = tokens_.expect_kind(Token::Kind::text, "the name of a colour space");
    }
    return out;
  }

  UsdValue value(int depth) {
    check_depth(depth);
    UsdValue out;
    const Token& now = tokens_.now();
    if (now.is("(") || now.is("[")) {
      const std::string_view close = now.is("(") ? ")" : "]";
      tokens_.take();
      while (!tokens_.take_if(close)) {
        const UsdValue part = value(depth + 1);
        out.numbers.insert(out.numbers.end(), part.numbers.begin(), part.numbers.end());
        out.other = out.other || part.other || part.numbers.size() > 1;
        if (!part.text.empty()) out.text = part.text;
        if (!tokens_.take_if(",") && !tokens_.now().is(close))
          tokens_.fail("\",\" or \"" + std::string(close) + "\"");
      }
      return out;
    }
    if (now.is("{")) {
      skip_group();
      out.other = true;
      return out;
    }
    const Token token = tokens_.take();
    check_asset(token);
    double number = 0;
    if (token.kind == Token::Kind::number) {
      if (!parse_number(token.text, number))
        throw Error::at_line(file_, token.line, in_quotes(token.text), "a number");
      out.numbers = {number};
    } else if (token.kind == Token::Kind::mark || token.kind == Token::Kind::end) {
      throw Error::at_line(file_, token.line, in_quotes(token.text), "a value");
    } else {
      out.text = token.text;
      out.other = true;
    }
    return out;
  }

  // "token outputs:surface.connect = </a/b.outputs:surface>"
  void attribute(Prim& prim) {
    Attribute out;
    while (tokens_.now().is("custom") || tokens_.now().is("uniform") || tokens_.now().is("varying") ||
           tokens_.now().is("prepend") || tokens_.now().is("append") || tokens_.now().is("delete") ||
           tokens_.now().is("add"))
      tokens_.take();
    out.line = tokens_.now().line;
    out.type = tokens_.expect_kind(Token::Kind::word, "the type of an attribute");
    if (tokens_.take_if("[")) {
      tokens_.expect("]");
      out.type += "[]";
    }
    out.name = tokens_.expect_kind(Token::Kind::word, "the name of an attribute");
    const bool connected = out.name.ends_with(".connect");
    if (tokens_.take_if("=")) {
      const bool path = tokens_.now().kind == Token::Kind::path;
      out.value = value(0);
      if (connected && path) {
        out.name.resize(out.name.size() - std::string_view(".connect").size());
        out.source = out.value.text.substr(0, out.value.text.find('.'));
        out.value = {};
      }
    }
    // Values over time are not judged.
    if (const std::size_t dot = out.name.find('.'); dot != out.name.npos) {
      out.name.resize(dot);
      out.value.other = true;
    }
    if (tokens_.now().is("(")) out.color_space = metadata();
    tokens_.take_if(";");
    prim.attributes.push_back(std::move(out));
  }

  void prims_in(const std::string& path, const std::string& name, int depth) {
    check_depth(depth);
    const std::size_t self = prims_.all.size() - 1;
    while (tokens_.now().kind != Token::Kind::end && !tokens_.now().is("}")) {
      if (tokens_.now().is("def") || tokens_.now().is("over") || tokens_.now().is("class")) {
        prim(path, name, depth);
      } else if (tokens_.now().is("variantSet")) {
        tokens_.take();
        tokens_.expect_kind(Token::Kind::text, "the name of a variant set");
        tokens_.expect("=");
        if (!tokens_.now().is("{")) tokens_.fail("\"{\"");
        skip_group();
      } else if (depth == 0) {
        tokens_.fail("def, over or class");
      } else if (tokens_.take_if("reorder")) {
        tokens_.take();
        tokens_.expect("=");
        (void)value(0);
      } else {
        attribute(prims_.all[self]);
      }
    }
  }

  void prim(const std::string& parent, const std::string& parent_name, int depth) {
    tokens_.take();
    if (tokens_.now().kind == Token::Kind::word) tokens_.take();  // its type
    Prim out;
    out.line = tokens_.now().line;
    out.name = tokens_.expect_kind(Token::Kind::text, "the name of a prim");
    out.path = parent + "/" + out.name;
    out.parent_name = parent_name;
    const std::string path = out.path, name = out.name;
    if (!prims_.by_path.emplace(path, prims_.all.size()).second)
      throw Error::at_line(file_, out.line, "a second prim " + in_quotes(path), "each prim once");
    prims_.all.push_back(std::move(out));
    if (tokens_.now().is("(")) skip_group();
    tokens_.expect("{");
    prims_in(path, name, depth + 1);
    tokens_.expect("}");
  }

  Tokens tokens_;
  const std::string& file_;
  Prims prims_;
};

// From prims to the surfaces that their shaders are.
class Shaders {
 public:
  Shaders(Prims prims, const std::string& file) : prims_(std::move(prims)), file_(file) {}

  std::vector<DocumentSurface> surfaces() const {
    check_connections();
    std::vector<DocumentSurface> out;
    for (const Prim& prim : prims_.all) {
      const std::string model = model_of(prim);
      if (!model.empty()) out.push_back(surface_of(prim, model));
    }
    return out;
  }

 private:
  static bool is_number_type(std::string_view type) {
    return type.starts_with("float") || type.starts_with("double") || type.starts_with("half") ||
           type.starts_with("int") || type.starts_with("color");
  }

  static const Attribute* attribute_of(const Prim& prim, std::string_view name) {
    for (const Attribute& each : prim.attributes)
      if (each.name == name) return &each;
    return nullptr;
  }

  // The model of a shader; empty for other prims and for shaders that give values.
  std::string model_of(const Prim& prim) const {
    const Attribute* id = attribute_of(prim, "info:id");
    if (id == nullptr) return {};
    std::string_view name = id->value.text;
    if (name == "UsdPreviewSurface") return std::string(name);
    constexpr std::string_view begin = "ND_", end = "_surfaceshader";
    if (name.starts_with(begin)) {
      name.remove_prefix(begin.size());
      if (name.ends_with(end)) name.remove_suffix(end.size());
      return is_surface_model(name) ? std::string(name) : std::string();
    }
    for (const std::string_view other : other_shaders)
      if (name.starts_with(other)) return {};
    throw Error::at_line(
        file_, id->line, "a shader of the unknown id " + in_quotes(id->value.text),
        "UsdPreviewSurface, UsdUVTexture, UsdPrimvarReader, UsdTransform2d, or a node of MaterialX (ND_...)");
  }

  void check_connections() const {
    std::vector<NodeLinks> nodes;
    for (const Prim& prim : prims_.all) {
      NodeLinks& node = nodes.emplace_back(NodeLinks{prim.path, "line " + std::to_string(prim.line), {}});
      for (const Attribute& each : prim.attributes) {
        if (each.source.empty()) continue;
        const auto source = prims_.by_path.find(each.source);
        if (source != prims_.by_path.end()) {
          // The outputs of a material come from the shaders in it, which may read the material's own inputs.
          if (!each.name.starts_with("outputs:")) node.reads.push_back(source->second);
        } else {
          throw Error::at_line(
              file_, each.line,
              each.name + " is connected to " + in_quotes(each.source) + ", which is not there",
              "the path of a prim");
        }
      }
    }
    require_no_loop(nodes, file_);
  }

  DocumentSurface surface_of(const Prim& prim, const std::string& model) const {
    constexpr std::string_view inputs = "inputs:";
    DocumentSurface out{prim.parent_name.empty() ? prim.name : prim.parent_name, model,
                        "line " + std::to_string(prim.line)};
    for (const Attribute& each : prim.attributes) {
      if (!each.name.starts_with(inputs)) continue;
      const std::string name = each.name.substr(inputs.size());
      if (is_number_type(each.type) && each.source.empty() && !each.value.text.empty() &&
          each.value.text != "None")
        throw Error::at_line(file_, each.line, each.name + ": " + in_quotes(each.value.text), "a number");
      // A value and a connection of one input: the connection counts.
      const auto same = std::find_if(out.inputs.begin(), out.inputs.end(),
                                     [&](const SurfaceInput& other) { return other.name == name; });
      const bool again = same != out.inputs.end();
      if (again && each.source.empty()) continue;
      if (!again) out.inputs.push_back({name, "line " + std::to_string(each.line), {}});
      SurfaceInput& input = again ? *same : out.inputs.back();
      input.values = each.source.empty() && !each.value.other ? each.value.numbers : std::vector<double>();
      if (each.source.empty() && each.type.starts_with("color") && input.values.size() == 3)
        take_color_space(input, each.color_space);
    }
    return out;
  }

  Prims prims_;
  const std::string& file_;
};

}  // namespace

std::vector<DocumentSurface> surfaces_of_usda(std::string_view text, const std::string& file) {
  constexpr std::string_view expected = "the text form (.usda), which usdcat writes";
  if (text.starts_with("PXR-USDC")) throw Error::at(file, "the binary form of USD (crate)", expected);
  if (text.starts_with("PK")) throw Error::at(file, "a package of USD (.usdz)", expected);
  if (!text.starts_with("#usda ")) throw Error::at(file, "no \"#usda\" at the beginning", expected);
  if (text.size() > most_document_bytes) throw Error::at(file, "more than 64 MiB", "a USD layer");
  return Shaders(Layer(text, file).read(), file).surfaces();
}

}  // namespace etak
