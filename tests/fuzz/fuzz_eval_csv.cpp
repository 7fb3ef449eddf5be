// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: eval's table of questions is answered with an Error or with one line per row, of which
// those that are refused say "error" and no other is anything but a finite number.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/light/functions_csv.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  std::size_t reasons = 0;
  CsvAnswers answers;
  try {
    answers = answer_csv({bytes.data(), bytes.size()}, "questions.csv", [&](std::string_view reason) {
      assert(reason.starts_with("questions.csv:"));
      ++reasons;
    });
  } catch (const Error&) {
    return 0;
  }
  assert(answers.refused == reasons && reasons <= answers.rows);
  assert(answers.text.starts_with("id,value\n") && answers.text.back() == '\n');
  // Where no id is quoted, a line is an id without commas and a value.
  if (answers.text.find('"') != std::string::npos) return 0;
  for (const char* word : {",nan\n", ",-nan\n", ",inf\n", ",-inf\n"})
    assert(answers.text.find(word) == std::string::npos);
  return 0;
}
