// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <utility>
#include <vector>

#include "core/base/json/node_json.h"
#include "core/base/memory.h"

namespace etak {
namespace {

// Builds the document while it is parsed, and refuses equal keys and depth without end as they come. (The
// parser's own callback would look through a whole array after each object in it.)
class StrictReader : public nlohmann::json_sax<Json> {
 public:
  StrictReader(std::string_view file, int most_depth, std::string_view what)
      : file_(file), most_depth_(most_depth), what_(what) {}

  StrictReader(const StrictReader&) = delete;
  StrictReader& operator=(const StrictReader&) = delete;
  ~StrictReader() override { take_apart(document_); }

  JsonDocument take() { return JsonDocument(std::move(document_)); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& value) override { return add(std::move(value)); }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool key(string_t& key) override {
    const auto [member, is_new] = open_.back()->emplace(key, nullptr);
    if (!is_new) throw Error::at(file_, "key " + in_quotes(key) + " twice in one object", "each key once");
    member_ = &*member;
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t, const std::string&, const Json::exception& e) override {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..." without the library's own tag.
    std::string_view found = e.what();
    if (const auto tag = found.find("] "); tag != found.npos) found.remove_prefix(tag + 2);
    throw Error::at(file_, printable(found, 200), "a JSON document");
  }

 private:
  // The value's place: the document, the next element of the open array, or the member whose key has just
  // been read. Places stay where they are as long as a pointer to them is kept: nothing is added to an outer
  // array or object while an inner one is open.
  template <class Value>
  Json* place(Value&& value) {
    if (open_.empty()) {
      document_ = std::forward<Value>(value);
      return &document_;
    }
    if (open_.back()->is_array()) return &open_.back()->emplace_back(std::forward<Value>(value));
    *member_ = std::forward<Value>(value);
    return member_;
  }
  template <class Value>
  bool add(Value&& value) {
    if (depth() > most_depth_) fail_depth();
    place(std::forward<Value>(value));
    return true;
  }
  bool open(Json empty) {
    if (depth() > most_depth_) fail_depth();
    open_.push_back(place(std::move(empty)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  int depth() const { return static_cast<int>(open_.size()); }
  [[noreturn]] void fail_depth() const {
    throw Error::at(file_, "nesting deeper than " + std::to_string(most_depth_), what_);
  }

  std::string_view file_;
  int most_depth_;
  std::string_view what_;
  Json document_;
  std::vector<Json*> open_;  // arrays and objects that have begun, outermost first
  Json* member_ = nullptr;
};

}  // namespace

void take_apart(Json& value) noexcept {
  // The recursion is as deep as the document, and the reader has bounded that depth.
  if (value.is_array()) {
    auto& items = value.get_ref<Json::array_t&>();
    while (!items.empty()) {
      take_apart(items.back());
      items.pop_back();
    }
  } else if (value.is_object()) {
    auto& members = value.get_ref<Json::object_t&>();
    while (!members.empty()) {
      take_apart(members.begin()->second);
      members.erase(members.begin());
    }
  }
}

JsonDocument parse_json_strictly(std::string_view text, std::string_view file, int most_depth,
                                 std::string_view what) {
  return with_memory_for(
      file, [&] { return mebibytes(text.size()) + " of JSON"; },
      [&] {
        StrictReader reader(file, most_depth, what);
        Json::sax_parse(text.begin(), text.end(), &reader);
        return reader.take();
      });
}

}  // namespace etak
