// SPDX-License-Identifier: Apache-2.0
// The language of the formula texts in WGSL, which has other declarations, no overloads, no conditional operator and no
// statement without braces. The texts are small and known, so anything else in them is an internal error.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/glsl/glsl_tokens.h"
#include "core/glsl/shader_function.h"

namespace etak {
namespace {

// An expression in WGSL and its type.
struct Expression {
  std::string text, type;
};

const std::map<std::string, std::string, std::less<>> type_names{{"real", "f32"},   {"float", "f32"},
                                                                 {"vec2", "vec2f"}, {"vec3", "vec3f"},
                                                                 {"bool", "bool"},  {"int", "i32"}};

// Words that WGSL keeps for itself; names of the texts that are among them get a `_` behind.
std::string kept_apart(std::string_view name) {
  static const std::set<std::string_view> reserved{"final", "filter", "common", "ref", "target",
                                                   "self",  "set",    "mod",    "of"};
  return std::string(name) + (reserved.contains(name) ? "_" : "");
}

// A place in a text that goes on from token to token.
class Tokens {
 public:
  explicit Tokens(std::string_view text) {
    for_each_token(text, [&](std::string_view token, std::string_view) {
      if (token != " ") tokens_.push_back(token);
    });
  }

 protected:
  std::string_view peek(std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : std::string_view();
  }
  std::string_view take() { return tokens_[at_++]; }
  // Passes over line ends and comments: an expression may stand in several lines.
  void skip() {
    while (peek() == "\n" || is_comment(peek())) ++at_;
  }
  bool took(std::string_view token) {
    skip();
    if (peek() != token) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view token) {
    if (!took(token))
      throw Error::at("WGSL", "\"" + std::string(peek()) + '"', '"' + std::string(token) + '"');
  }
  std::string word() {
    skip();
    return std::string(take());
  }
  std::string type() {
    const std::string word_read = word();
    const auto found = type_names.find(word_read);
    return found == type_names.end() ? word_read : found->second;
  }

  // Whether the rest of the function assigns to the variable or to a member of it.
  bool is_set_later(std::string_view name) const {
    for (std::size_t i = at_, depth = 1; i + 2 < tokens_.size() && depth > 0; ++i) {
      if (tokens_[i] == "{") ++depth;
      if (tokens_[i] == "}") --depth;
      if (tokens_[i] != name || tokens_[i - 1] == ".") continue;
      const std::size_t sign = tokens_[i + 1] == "." ? i + 3 : i + 1;
      const bool compound = std::string_view("+-*/").find(tokens_[sign]) != std::string_view::npos;
      const std::size_t equals = compound ? sign + 1 : sign;
      if (tokens_[equals] == "=" && tokens_[equals + 1] != "=") return true;
    }
    return false;
  }

  std::vector<std::string_view> tokens_;
  std::size_t at_ = 0;
};

// The expressions of a text, and the names that they may hold.
class Expressions : protected Tokens {
 protected:
  using Tokens::Tokens;

  struct Function {
    std::string name, returns;
    std::vector<std::string> parameters;
  };

  const Function& overload(const std::string& name, const std::vector<std::string>& types) const {
    if (const auto found = functions_.find(name); found != functions_.end())
      for (const Function& each : found->second)
        if (each.parameters == types) return each;
    throw Error::at("WGSL", "a call of " + name + " that fits no function");
  }

  // Expressions are taken apart by the rank of their operators.
  Expression expression() {
    Expression test = binary(0);
    if (!took("?")) return test;
    const Expression yes = expression();
    expect(":");
    const Expression no = expression();
    return {"select(" + no.text + ", " + yes.text + ", " + test.text + ')', yes.type};
  }

  // The operator at this place if it has the rank, else none. Two characters may make one operator.
  std::string operator_of(int rank) {
    static const std::vector<std::string> ranks[] = {
        {"||"}, {"&&"}, {"==", "!="}, {"<=", ">=", "<", ">"}, {"+", "-"}, {"*", "/"}};
    skip();
    for (const std::string& each : ranks[rank])
      if (peek() == each.substr(0, 1) && (each.size() == 1 || peek(1) == each.substr(1))) return each;
    return {};
  }

  Expression binary(int rank) {
    if (rank > 5) return unary();
    Expression left = binary(rank + 1);
    for (std::string sign = operator_of(rank); !sign.empty(); sign = operator_of(rank)) {
      at_ += sign.size();
      const Expression right = binary(rank + 1);
      left.text += ' ' + sign + ' ' + right.text;
      if (rank < 4)
        left.type = "bool";
      else if (left.type == "f32")
        left.type = right.type;
    }
    return left;
  }

  Expression unary() {
    for (const char* sign : {"-", "!"})
      if (took(sign)) {
        Expression of = unary();
        return {sign + of.text, of.type};
      }
    return postfix();
  }

  Expression postfix() {
    Expression out = primary();
    while (took(".")) {
      const std::string member = word();
      const auto found = structs_.find(out.type);
      out.type = found != structs_.end() ? found->second.at(member)
                 : member.size() == 1    ? "f32"
                                         : "vec" + std::to_string(member.size()) + "f";
      out.text += '.' + kept_apart(member);
    }
    return out;
  }

  Expression primary() {
    if (took("(")) {
      Expression inner = expression();
      expect(")");
      return {'(' + inner.text + ')', inner.type};
    }
    const std::string token = word();
    if (is_digit(token[0]) || token[0] == '.') return {token, "f32"};
    if (token == "true" || token == "false") return {token, "bool"};
    if (took("(")) return call(token);
    for (const auto* names : {&locals_, &globals_})
      if (const auto found = names->find(token); found != names->end())
        return {kept_apart(token), found->second};
    throw Error::at("WGSL", "an unknown name " + token);
  }

  Expression call(const std::string& name) {
    std::string arguments;
    std::vector<std::string> types;
    while (!took(")")) {
      took(",");
      const Expression argument = expression();
      arguments += (arguments.empty() ? "" : ", ") + argument.text;
      types.push_back(argument.type);
    }
    if (const auto found = type_names.find(name); found != type_names.end()) {
      const bool literal = found->second == "f32" &&
                           arguments.find_first_not_of("0123456789.e-") == std::string::npos &&
                           is_digit(arguments[0]);
      return {literal ? arguments : found->second + '(' + arguments + ')', found->second};
    }
    if (functions_.contains(name)) {
      const Function& function = overload(name, types);
      return {function.name + '(' + arguments + ')', function.returns};
    }
    static const std::set<std::string_view> to_number{"dot", "length"};
    static const std::map<std::string_view, std::string_view> others{{"inversesqrt", "inverseSqrt"}};
    const auto other = others.find(name);
    return {(other == others.end() ? name : std::string(other->second)) + '(' + arguments + ')',
            to_number.contains(name) ? "f32" : types.at(0)};
  }

  std::map<std::string, std::map<std::string, std::string>, std::less<>>
      structs_;  // the members and their types
  std::map<std::string, std::vector<Function>> functions_;
  std::map<std::string, std::string> globals_, locals_;
};

class Wgsl : private Expressions {
 public:
  explicit Wgsl(std::string_view text) : Expressions(text) { find_functions(); }

  std::string translated() {
    while (at_ < tokens_.size()) {
      if (peek() == "\n" || is_comment(peek()))
        out_ += take();
      else
        definition();
    }
    return std::move(out_);
  }

 private:
  bool is_type(std::string_view token) const {
    return type_names.contains(token) || structs_.contains(token);
  }

  // ---- definitions

  // Names every function, the later ones of one name by their types. A heading of a function stands in one line.
  void find_functions() {
    int depth = 0;
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      depth += peek() == "{" ? 1 : peek() == "}" ? -1 : 0;
      if (peek() == "struct" && depth == 0) structs_[std::string(peek(1))];
      if (depth > 0 || peek(2) != "(" || !is_type(peek()) || peek() == "struct") continue;
      const std::size_t begin = at_;
      Function function;
      function.returns = type();
      const std::string name = word();
      expect("(");
      while (!took(")")) {
        took(",");
        function.parameters.push_back(type());
        word();
      }
      std::vector<Function>& same = functions_[name];
      const bool colors = std::ranges::find(function.parameters, "vec3f") != function.parameters.end();
      function.name = kept_apart(name) + (same.empty()                 ? ""
                                          : colors && same.size() == 1 ? "_rgb"
                                                                       : "_" + std::to_string(same.size()));
      same.push_back(std::move(function));
      at_ = begin;
    }
    at_ = 0;
  }

  void definition() {
    if (took("struct")) return structure();
    if (took("const")) {
      const std::string of = type(), name = word();
      expect("=");
      globals_[name] = of;
      out_ += "const " + kept_apart(name) + ": " + of + " = " + expression().text + ";";
      return expect(";");
    }
    function();
  }

  void structure() {
    const std::string name = word();
    expect("{");
    out_ += "struct " + name + " {\n";
    while (!took("}")) {
      const std::string of = type(), member = word();
      expect(";");
      structs_[name][member] = of;
      out_ += "  " + kept_apart(member) + ": " + of + ",\n";
    }
    expect(";");
    out_ += "}";
  }

  void function() {
    locals_.clear();
    const std::string returns = type(), name = word();
    std::vector<std::string> types;
    std::string parameters;
    expect("(");
    while (!took(")")) {
      took(",");
      types.push_back(type());
      const std::string parameter = word();
      locals_[parameter] = types.back();
      parameters += (parameters.empty() ? "" : ", ") + kept_apart(parameter) + ": " + types.back();
    }
    out_ += "fn " + overload(name, types).name + '(' + parameters + ") -> " + returns + " {";
    expect("{");
    block(1);
    out_ += "}";
  }

  // ---- statements

  // The statements up to the closing brace, with the line ends and comments between them.
  void block(std::size_t depth) {
    const std::string indent(2 * depth, ' ');
    while (peek() != "}") {
      if (peek() == "\n") {
        out_ += take();
      } else if (is_comment(peek())) {
        out_ += (out_.ends_with('\n') ? indent : " ") + std::string(take());
      } else {
        out_ += indent;
        statement(depth);
      }
    }
    expect("}");
  }

  void statement(std::size_t depth) {
    if (took("return")) {
      out_ += "return " + expression().text + ';';
      return expect(";");
    }
    if (took("if")) return condition(depth);
    if (is_type(peek()) && !peek().empty() && peek(1) != "(") return declaration();
    const std::string target = postfix().text;
    std::string by;
    while (peek() != "=") by += take();
    expect("=");
    out_ += target + ' ' + by + "= " + expression().text + ';';
    expect(";");
  }

  void condition(std::size_t depth) {
    expect("(");
    out_ += "if (" + expression().text + ") {\n" + std::string(2 * depth + 2, ' ');
    expect(")");
    skip();
    if (took("{"))
      block(depth + 1);
    else
      statement(depth + 1);
    out_ += '\n' + std::string(2 * depth, ' ') + '}';
  }

  void declaration() {
    const std::string of = type(), name = word();
    locals_[name] = of;
    if (took(";")) {
      out_ += "var " + kept_apart(name) + ": " + of + ';';
      return;
    }
    expect("=");
    const std::string value = expression().text;
    expect(";");
    out_ += (is_set_later(name) ? "var " : "let ") + kept_apart(name) + ": " + of + " = " + value + ';';
  }

  std::string out_;
};

}  // namespace

std::string to_wgsl(std::string_view text) {
  return Wgsl(text).translated();
}

}  // namespace etak
