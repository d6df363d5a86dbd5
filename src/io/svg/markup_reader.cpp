#include "io/svg/markup_reader.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "io/file/file_type_sniffer.h"

namespace planish {

namespace {

constexpr std::size_t k_deepest = 1000;

bool is_xml_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool ends_name(char c) {
  return is_xml_blank(c) || c == '=' || c == '>' || c == '/' || c == '<' || c == '"' || c == '\'';
}

/// The character of an entity, '?' for any beyond ASCII; nothing for unknown entities.
std::optional<char> meaning_of(std::string_view entity) {
  constexpr std::pair<std::string_view, char> known[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (const auto& [name, letter] : known) {
    if (entity == name) return letter;
  }
  if (!entity.starts_with('#')) return std::nullopt;
  const bool is_hex = entity.starts_with("#x");
  const std::string_view digits = entity.substr(is_hex ? 2 : 1);
  std::uint32_t code = 0;
  const char* const end = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data(), end, code, is_hex ? 16 : 10);
  if (digits.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return code < 0x80 ? static_cast<char>(code) : '?';
}

std::string decoded(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t sign = std::min(text.find('&'), text.size());
    out += text.substr(0, sign);
    text.remove_prefix(sign);
    if (text.empty()) break;
    const std::size_t end = text.substr(0, 12).find(';');
    const auto letter =
        end == std::string_view::npos ? std::nullopt : meaning_of(text.substr(1, end - 1));
    out += letter ? *letter : '&';
    text.remove_prefix(letter ? end + 1 : 1);
  }
  return out;
}

}  // namespace

std::string MarkupTag::attribute(std::string_view wanted) const {
  for (const auto& [known, value] : attributes) {
    if (known == wanted) return decoded(value);
  }
  return {};
}

MarkupReader::MarkupReader(std::string_view bytes, std::string_view name)
    : bytes_(bytes), name_(name) {
  if (const std::string_view encoding = wide_encoding(bytes); !encoding.empty()) {
    fail(ErrorCode::malformed_file,
         "the text is encoded in " + std::string(encoding) + "; save it as UTF-8", 1);
  }
}

void MarkupReader::fail(ErrorCode code, const std::string& message, std::size_t line) const {
  throw Error(code, message, {.path = std::string(name_), .line = line});
}

void MarkupReader::go_to(std::size_t offset) {
  const auto passed = bytes_.substr(offset_, offset - offset_);
  line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
  offset_ = offset;
}

void MarkupReader::skip_past(std::string_view end, const char* what) {
  const std::size_t found = bytes_.find(end, offset_);
  if (found == std::string_view::npos) {
    fail(ErrorCode::truncated_file, "the file ends inside " + std::string(what), line_);
  }
  go_to(found + end.size());
}

/// <!DOCTYPE ...>, which may declare entities in square brackets. They are not used.
void MarkupReader::skip_declaration() {
  const std::size_t close = bytes_.find('>', offset_);
  const std::string_view head = bytes_.substr(offset_, close - offset_);
  if (head.find('[') != std::string_view::npos) skip_past("]", "a declaration");
  skip_past(">", "a declaration");
}

void MarkupReader::skip_blanks() {
  std::size_t at = offset_;
  while (at < bytes_.size() && is_xml_blank(bytes_[at]))
    ++at;
  go_to(at);
}

std::string_view MarkupReader::word(const char* what) {
  std::size_t end = offset_;
  while (end < bytes_.size() && !ends_name(bytes_[end]))
    ++end;
  if (end == bytes_.size()) {
    fail(ErrorCode::truncated_file, "the file ends inside a tag", line_);
  }
  if (end == offset_) {
    fail(ErrorCode::malformed_file,
         "a tag has " + in_quotes(bytes_.substr(offset_, 1)) + " where " + what + " should be",
         line_);
  }
  const std::string_view found = bytes_.substr(offset_, end - offset_);
  offset_ = end;
  return found;
}

std::string_view MarkupReader::quoted_value() {
  skip_blanks();
  if (!at("=")) fail(ErrorCode::malformed_file, "an attribute has no value", line_);
  ++offset_;
  skip_blanks();
  if (!at("\"") && !at("'")) {
    fail(ErrorCode::malformed_file, "the value of an attribute is not in quotes", line_);
  }
  const std::string_view quote = bytes_.substr(offset_++, 1);
  const std::size_t begin = offset_;
  skip_past(quote, "the value of an attribute");
  return bytes_.substr(begin, offset_ - 1 - begin);
}

MarkupTag MarkupReader::start_tag() {
  MarkupTag tag{MarkupTag::Kind::start, {}, line_};
  ++offset_;
  tag.name = word("the name of an element");
  for (;;) {
    skip_blanks();
    if (at("/>") || at(">")) break;
    const std::string_view name = word("the name of an attribute");
    tag.attributes.emplace_back(name, quoted_value());
  }
  is_empty_ = at("/>");
  offset_ += is_empty_ ? 2 : 1;
  open_.push_back(tag.name);
  if (open_.size() > k_deepest) {
    fail(ErrorCode::too_large,
         "elements are nested more than " + std::to_string(k_deepest) + " deep", tag.line);
  }
  return tag;
}

MarkupTag MarkupReader::end_tag() {
  MarkupTag tag{MarkupTag::Kind::end, {}, line_};
  offset_ += 2;
  tag.name = word("the name of an element");
  skip_blanks();
  if (!at(">")) fail(ErrorCode::malformed_file, "an end of an element has no \">\"", line_);
  ++offset_;
  if (open_.empty() || open_.back() != tag.name) {
    fail(ErrorCode::malformed_file,
         "element " + in_quotes(tag.name) + " ends here, but " +
             (open_.empty() ? "none is open" : in_quotes(open_.back()) + " is open"),
         tag.line);
  }
  open_.pop_back();
  return tag;
}

MarkupTag MarkupReader::next() {
  if (is_empty_) {
    is_empty_ = false;
    MarkupTag tag{MarkupTag::Kind::end, open_.back(), line_};
    open_.pop_back();
    return tag;
  }
  for (;;) {
    go_to(std::min(bytes_.find('<', offset_), bytes_.size()));
    if (offset_ == bytes_.size()) break;
    if (at("<!--")) {
      skip_past("-->", "a comment");
    } else if (at("<![CDATA[")) {
      skip_past("]]>", "a section of text");
    } else if (at("<?")) {
      skip_past("?>", "an instruction");
    } else if (at("<!")) {
      skip_declaration();
    } else {
      return at("</") ? end_tag() : start_tag();
    }
  }
  if (!open_.empty()) {
    fail(ErrorCode::truncated_file, "the file ends inside element " + in_quotes(open_.back()),
         line_);
  }
  return {};
}

}  // namespace planish
