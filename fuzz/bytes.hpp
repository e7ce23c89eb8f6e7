/// \file
/// A fuzzer's input, value by value.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace map_matcher::fuzz {

/// What is left of an input. Values are taken from its front, numbers as the processor stores them; zeros follow its
/// end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  std::size_t size() const { return size_; }  ///< Bytes that are left.

  template <typename Number>
  Number take() {
    static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>, "not every byte is a bool");
    Number number{};
    const std::size_t length = std::min(sizeof(Number), size_);
    if (length > 0) {
      std::memcpy(&number, data_, length);
    }
    skip(length);
    return number;
  }

  /// A number from 0 to `most`, from one byte.
  int choose(int most) { return take<std::uint8_t>() % (most + 1); }

  /// A text of up to 31 characters, any of them, with its length before it.
  std::string text() {
    const std::size_t length = std::min<std::size_t>(static_cast<std::size_t>(choose(31)), size_);
    const std::string text(reinterpret_cast<const char*>(data_), length);
    skip(length);
    return text;
  }

 private:
  void skip(std::size_t length) {
    data_ += length;
    size_ -= length;
  }

  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace map_matcher::fuzz
