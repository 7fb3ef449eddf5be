// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_keep.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>

#include "core/image/files/png_chunks.h"

namespace etak {
namespace {

// They tell how codes become colours, whatever the texels are.
constexpr std::array<std::string_view, 7> colour_chunks{"gAMA", "cHRM", "sRGB", "iCCP",
                                                        "cICP", "mDCV", "cLLI"};
constexpr std::array<std::string_view, 4> chunks_of_form{"tRNS", "bKGD", "sBIT", "hIST"};
constexpr std::array<std::string_view, 3> chunks_of_animation{"acTL", "fcTL", "fdAT"};

bool is_among(const std::string& type, std::span<const std::string_view> types) {
  return std::ranges::find(types, type) != types.end();
}

bool comes_along(const std::string& type, bool same_form) {
  if (is_among(type, colour_chunks)) return true;
  if (is_among(type, chunks_of_form)) return same_form;
  if (is_among(type, chunks_of_animation)) return false;
  return std::islower(static_cast<unsigned char>(type[3])) != 0;
}

// Colour type and depth of a PNG file.
std::array<int, 2> form_of(ByteSource& file) {
  const auto ihdr = png_chunk_at(file, png_signature.size());
  if (!ihdr || ihdr->size < 13) return {-1, -1};
  const PngForm form = png_form(file.view(ihdr->data(), 13));
  return {form.colour, form.bits};
}

}  // namespace

PngWithChunks with_chunks_of(std::string_view made, ByteSource& original) {
  BytesInMemory fresh(made);
  const bool same_form = form_of(fresh) == form_of(original);
  PngWithChunks out;
  std::string before, behind;
  bool data_seen = false;
  for (auto chunk = png_chunk_at(original, png_signature.size()); chunk && chunk->type != "IEND";
       chunk = png_chunk_at(original, chunk->end())) {
    data_seen = data_seen || chunk->type == "IDAT";
    if (chunk->critical()) continue;
    if (comes_along(chunk->type, same_form))
      (data_seen ? behind : before) += original.view(chunk->start, chunk->end() - chunk->start);
    else if (std::ranges::find(out.left_out, chunk->type) == out.left_out.end())
      out.left_out.push_back(chunk->type);
  }
  out.file.reserve(made.size() + before.size() + behind.size());
  const auto header = png_chunk_at(fresh, png_signature.size());
  const std::size_t end_chunk = made.size() - png_chunk_overhead;
  out.file += made.substr(0, header->end());
  out.file += before;
  out.file += made.substr(header->end(), end_chunk - header->end());
  out.file += behind;
  out.file += made.substr(end_chunk);
  return out;
}

namespace {

// Calls see(chunk) for the chunks that texels depend on; false where the file ends before its IEND does.
template <class See>
bool each_chunk_of_texels(ByteSource& file, const See& see) {
  if (!has_png_signature(file)) return false;
  for (auto chunk = png_chunk_at(file, png_signature.size()); chunk;
       chunk = png_chunk_at(file, chunk->end())) {
    if (chunk->critical() || chunk->type == "tRNS") see(*chunk);
    if (chunk->type == "IEND") return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> texels_alone(ByteSource& file) {
  std::string out(png_signature);
  const bool whole = each_chunk_of_texels(
      file, [&](const PngChunk& chunk) { out += file.view(chunk.start, chunk.end() - chunk.start); });
  return whole ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::size_t> size_of_texels_alone(ByteSource& file) {
  std::size_t out = png_signature.size();
  const bool whole =
      each_chunk_of_texels(file, [&](const PngChunk& chunk) { out += chunk.end() - chunk.start; });
  return whole ? std::optional(out) : std::nullopt;
}

}  // namespace etak
