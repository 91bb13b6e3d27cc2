// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/xml_element.hpp"

#include <charconv>
#include <cmath>
#include <tinyxml2.h>

#include <fmt/format.h>

#include "roadmap/map_text.hpp"

namespace lanefuse {
namespace {

/// Elements and attributes take about 120 bytes each once parsed.
constexpr std::int64_t kMostMarks = 3'000'000;
constexpr double kLargestNumber = 1e12;  // beyond it nothing on a road lies

void check_marks(const std::string& text, const std::string& file) {
  std::int64_t marks = 0;
  for (const char c : text) marks += c == '<' || c == '=' ? 1 : 0;
  if (marks > kMostMarks) {
    throw input_error(file, fmt::format("has more than {} elements and attributes", kMostMarks),
                      "cut the map into smaller ones");
  }
}

const char* what_is_wrong(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element that is begun is not ended, or the other way round; the file may be cut off";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not NAME=\"VALUE\", or is cut off";
    case tinyxml2::XML_ERROR_PARSING:
      return "an element is not ended, or has stray characters; the file may be cut off";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "there is no element in it";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "its elements are nested too deep";
    default:
      return tinyxml2::XMLDocument::ErrorIDToName(error);
  }
}

}  // namespace

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r\n";
  const std::size_t from = text.find_first_not_of(blanks);
  if (from == std::string::npos) return {};
  return text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

std::optional<double> parse_finite(const std::string& text) {
  std::string digits = trimmed(text);
  if (!digits.empty() && digits.front() == '+') digits.erase(0, 1);
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, failed] = std::from_chars(digits.data(), end, value);
  if (failed != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string XmlElement::name() const { return element_->Name(); }

std::string XmlElement::label() const {
  const char* id = element_->Attribute("id");
  return id ? fmt::format("<{} id={}>", name(), id) : fmt::format("<{}>", name());
}

std::string XmlElement::place() const {
  std::string path = label();
  const tinyxml2::XMLElement* at = element_;
  while (!at->Attribute("id") && at->Parent() && at->Parent()->ToElement()) {
    at = at->Parent()->ToElement();
    if (!at->Parent()->ToElement()) break;  // the root says nothing
    path = fmt::format("{}/{}", XmlElement(*at, *file_).label(), path);
  }
  return fmt::format("{}, line {}, {}", *file_, element_->GetLineNum(), path);
}

Error XmlElement::error(const std::string& problem, const std::string& mend) const {
  return input_error(place(), problem, mend);
}

XmlElement XmlElement::child(const char* name) const {
  const std::optional<XmlElement> found = find(name);
  if (!found) throw error(fmt::format("has no <{}>", name));
  return *found;
}

std::optional<XmlElement> XmlElement::find(const char* name) const {
  const tinyxml2::XMLElement* found = element_->FirstChildElement(name);
  return found ? std::optional(XmlElement(*found, *file_)) : std::nullopt;
}

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> found;
  for (auto* at = element_->FirstChildElement(name); at; at = at->NextSiblingElement(name)) {
    found.emplace_back(*at, *file_);
  }
  return found;
}

std::vector<XmlElement> XmlElement::children() const { return children(nullptr); }

std::string XmlElement::text(const char* attribute) const {
  const char* found = element_->Attribute(attribute);
  if (!found) throw error(fmt::format("has no attribute '{}'", attribute));
  return found;
}

std::optional<std::string> XmlElement::find_text(const char* attribute) const {
  const char* found = element_->Attribute(attribute);
  return found ? std::optional<std::string>(found) : std::nullopt;
}

double XmlElement::parse_number(const std::string& text, const std::string& what) const {
  const std::optional<double> value = parse_finite(text);
  if (!value) throw error(fmt::format("{} is '{}', which is no finite number", what, text.substr(0, 40)));
  if (std::abs(*value) > kLargestNumber) throw error(fmt::format("{} is {}, beyond any road", what, *value));
  return *value;
}

double XmlElement::number(const char* attribute) const {
  return parse_number(text(attribute), fmt::format("attribute '{}'", attribute));
}

double XmlElement::number(const char* attribute, double otherwise) const {
  return element_->Attribute(attribute) ? number(attribute) : otherwise;
}

std::int64_t XmlElement::integer(const char* attribute) const {
  const std::string digits = trimmed(text(attribute));
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, failed] = std::from_chars(digits.data(), end, value);
  if (failed != std::errc() || stop != end) {
    throw error(
        fmt::format("attribute '{}' is '{}', which is no whole number", attribute, digits.substr(0, 40)));
  }
  return value;
}

std::string XmlElement::content() const {
  const char* text = element_->GetText();
  return text ? trimmed(text) : std::string();
}

double XmlElement::content_number() const { return parse_number(content(), "its value"); }

XmlFile::XmlFile(const std::filesystem::path& path)
    : file_(path.string()), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  const std::string text = read_map_text(path);
  check_marks(text, file_);
  if (document_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw input_error(fmt::format("{}, line {}", file_, document_->ErrorLineNum()),
                      fmt::format("is no sound XML: {}", what_is_wrong(document_->ErrorID())));
  }
  if (!document_->RootElement()) throw input_error(fmt::format("{}, line 1", file_), "holds no XML element");
}

XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const { return {*document_->RootElement(), file_}; }

}  // namespace lanefuse
