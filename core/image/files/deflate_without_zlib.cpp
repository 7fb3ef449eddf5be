// SPDX-License-Identifier: Apache-2.0
// What deflate.h declares, for builds that have neither zlib nor ISA-L (ETAK_PLAIN_DEFLATE).
#include "core/image/files/deflate.h"
#include "core/image/files/plain_deflate.h"
#include "core/image/files/plain_inflate.h"

namespace etak {

std::uint32_t crc32_of(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
  return plain_crc32(crc, bytes);
}
std::uint32_t adler32_of(std::uint32_t adler, std::span<const std::uint8_t> bytes) {
  return plain_adler32(adler, bytes);
}
std::uint32_t adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size) {
  return plain_adler32_of_both(first, second, second_size);
}

struct Deflater::State {
  PlainDeflater deflater;
};

Deflater::Deflater(PngLevel) : state_(std::make_unique<State>()) {}
Deflater::Deflater(Deflater&&) noexcept = default;
Deflater& Deflater::operator=(Deflater&&) noexcept = default;
Deflater::~Deflater() = default;

void Deflater::append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out) {
  state_->deflater.append(piece, last, out);
}

struct Inflater::State {
  PlainInflater inflater;
};

Inflater::Inflater() : state_(std::make_unique<State>()) {}
Inflater::Inflater(Inflater&&) noexcept = default;
Inflater& Inflater::operator=(Inflater&&) noexcept = default;
Inflater::~Inflater() = default;

void Inflater::feed(std::span<const std::uint8_t> input) {
  state_->inflater.feed(input);
}
Inflater::Status Inflater::read(std::span<std::uint8_t> out, std::size_t& written) {
  return state_->inflater.read(out, written);
}
std::size_t Inflater::unused() const {
  return state_->inflater.unused();
}
const char* Inflater::what() const {
  return state_->inflater.what();
}

}  // namespace etak
