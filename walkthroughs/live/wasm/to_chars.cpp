// The shortest text of a double, which <charconv> declares. That of the library would bring tables of 100 KB, a tenth of the program.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace {

/// |x| = 0.d₁d₂d₃… · 10^(exponent+1)
struct Shortest {
  std::string digits;
  int exponent;
};

/// "1.9e5" becomes "2.0e5". Requires: not all digits are 9.
void count_up(char* text) {
  char* last = std::strchr(text, 'e') - 1;
  for (; last > text && (*last == '9' || *last == '.'); --last)
    if (*last == '9') *last = '0';
  ++*last;
}

/// A decimal of up to 15 digits is found again in any double near it; of longer ones the nearest of 16 digits is enough, or 17 are.
/// The least doubles have fewer digits. Below a power of two doubles lie closer together than above it: there the next decimal of 16
/// digits may be found again where the nearest is not.
Shortest shortest(double x) {
  char text[32];
  for (int digits = x < __DBL_MIN__ ? 1 : 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
    if (std::strtod(text, nullptr) == x) break;
    if (digits < 16) continue;
    count_up(text);
    if (std::strtod(text, nullptr) == x) break;
  }
  const char* e = std::strchr(text, 'e');
  std::string digits(text, static_cast<std::size_t>(e - text));
  if (digits.size() > 1) digits.erase(1, 1);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.empty()) digits = "0";
  return {digits, std::atoi(e + 1)};
}

std::string scientific(const Shortest& number) {
  char exponent[16];
  std::snprintf(exponent, sizeof exponent, "e%+03d", number.exponent);
  return number.digits.substr(0, 1) + (number.digits.size() > 1 ? "." + number.digits.substr(1) : "") + exponent;
}

std::string fixed(const Shortest& number, double x) {
  const int size = static_cast<int>(number.digits.size()), point = number.exponent + 1;
  if (point <= 0) return "0." + std::string(static_cast<std::size_t>(-point), '0') + number.digits;
  if (point < size) return std::string(number.digits).insert(static_cast<std::size_t>(point), ".");
  std::string whole(static_cast<std::size_t>(point) + 2, '\0');  // all its digits, also those that need not be told
  whole.resize(static_cast<std::size_t>(std::snprintf(whole.data(), whole.size(), "%.0f", x)));
  return whole;
}

std::to_chars_result put(char* first, char* last, const std::string& text) {
  if (last - first < static_cast<std::ptrdiff_t>(text.size())) return {last, std::errc::value_too_large};
  std::memcpy(first, text.data(), text.size());
  return {first + text.size(), std::errc()};
}

std::string not_finite(double x) { return x != x ? "nan" : "inf"; }

}  // namespace

namespace std {
inline namespace __2 {

/// The shorter one of both ways to write it.
to_chars_result to_chars(char* first, char* last, double x) {
  const std::string sign = __builtin_signbit(x) ? "-" : "";
  const double size = __builtin_fabs(x);
  if (!(size < __builtin_inf())) return put(first, last, sign + not_finite(size));
  const Shortest number = shortest(size);
  const bool is_long = number.exponent > 30 || number.exponent < -30;
  const std::string with_exponent = scientific(number), plain = is_long ? "" : fixed(number, size);
  return put(first, last, sign + (is_long || with_exponent.size() < plain.size() ? with_exponent : plain));
}

to_chars_result to_chars(char* first, char* last, double x, chars_format) {
  return put(first, last, (__builtin_signbit(x) ? "-" : "") + scientific(shortest(__builtin_fabs(x))));
}

}  // namespace __2
}  // namespace std
