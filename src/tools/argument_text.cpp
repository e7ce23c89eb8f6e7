#include "argument_text.hpp"

#include <algorithm>
#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <type_traits>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::tools {
namespace {

/// A value of one type, as one argument has it.
template <typename T>
struct Argument;

template <>
struct Argument<bool> {
  static constexpr const char* kKind = "BOOL";
  static constexpr const char* kExpected = "true or false";
  static std::optional<bool> from(const std::string& text) {
    if (text == "true" || text == "1") {
      return true;
    }
    return text == "false" || text == "0" ? std::optional<bool>(false) : std::nullopt;
  }
  static std::string text(bool value) { return value ? "true" : "false"; }
};

template <typename Whole>
struct WholeNumber {
  static constexpr const char* kKind = std::is_signed_v<Whole> ? "INT" : "UINT";
  static constexpr const char* kExpected = std::is_signed_v<Whole> ? "a whole number" : "a whole number from 0";
  static std::optional<Whole> from(const std::string& text) {
    Whole value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end ? std::optional<Whole>(value) : std::nullopt;
  }
  static std::string text(Whole value) { return std::to_string(value); }
};

template <>
struct Argument<int> : WholeNumber<int> {};
template <>
struct Argument<std::uint64_t> : WholeNumber<std::uint64_t> {};

template <>
struct Argument<double> {
  static constexpr const char* kKind = "NUMBER";
  static constexpr const char* kExpected = "a number";
  static std::optional<double> from(const std::string& text) {
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double value = 0.0;
    return in >> std::noskipws >> value && in.peek() == std::istringstream::traits_type::eof()
               ? std::optional<double>(value)
               : std::nullopt;
  }
  static std::string text(double value) { return parameters::numberText(value); }
};

template <>
struct Argument<std::string> {
  static constexpr const char* kKind = "TEXT";
  static constexpr const char* kExpected = "a text";
  static std::optional<std::string> from(const std::string& text) { return text; }
  static std::string text(const std::string& value) { return value; }
};

/// The kind of one value of a target.
template <typename T>
struct Element {
  using Type = T;
  static constexpr bool kIsList = false;
};
template <typename T>
struct Element<std::optional<T>> {
  using Type = T;
  static constexpr bool kIsList = false;
};
template <typename T>
struct Element<std::vector<T>> {
  using Type = T;
  static constexpr bool kIsList = true;
};

template <typename T>
using ArgumentOf = Argument<typename Element<T>::Type>;

template <typename T>
std::string valueText(const T& value) {
  return Argument<T>::text(value);
}
template <typename T>
std::string valueText(const std::optional<T>& value) {
  return value ? Argument<T>::text(*value) : "";
}
template <typename T>
std::string valueText(const std::vector<T>& values) {
  std::vector<std::string> texts;
  std::transform(values.begin(), values.end(), std::back_inserter(texts), Argument<T>::text);
  return joined(texts);
}

}  // namespace

bool isList(const OptionTarget& target) {
  return std::visit([](auto* value) { return Element<std::decay_t<decltype(*value)>>::kIsList; }, target);
}

std::string kindOf(const OptionTarget& target) {
  return std::visit(
      [](auto* value) -> std::string {
        using Target = std::decay_t<decltype(*value)>;
        return std::string(ArgumentOf<Target>::kKind) + (Element<Target>::kIsList ? " ..." : "");
      },
      target);
}

std::string expectedFor(const OptionTarget& target) {
  return std::visit([](auto* value) -> std::string { return ArgumentOf<std::decay_t<decltype(*value)>>::kExpected; },
                    target);
}

std::string textOf(const OptionTarget& target) {
  return std::visit([](auto* value) { return valueText(*value); }, target);
}

bool isReadable(const std::vector<std::string>& values, const OptionTarget& target) {
  return std::visit(
      [&values](auto* value) {
        using Reader = ArgumentOf<std::decay_t<decltype(*value)>>;
        return std::all_of(values.begin(), values.end(),
                           [](const std::string& text) { return Reader::from(text).has_value(); });
      },
      target);
}

void read(const std::vector<std::string>& values, const OptionTarget& target, bool replaced) {
  std::visit(
      [&values, replaced](auto* value) {
        using Target = std::decay_t<decltype(*value)>;
        if constexpr (Element<Target>::kIsList) {
          if (replaced) {
            value->clear();
          }
          for (const std::string& text : values) {
            value->push_back(*ArgumentOf<Target>::from(text));
          }
        } else {
          *value = *ArgumentOf<Target>::from(values.front());
        }
      },
      target);
}

std::string joined(const std::vector<std::string>& texts, const std::string& separator) {
  std::string all;
  for (const std::string& text : texts) {
    all += (all.empty() ? "" : separator) + text;
  }
  return all;
}

}  // namespace map_matcher::tools
