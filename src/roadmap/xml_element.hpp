// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace lanefuse {

/// One element of an XML file that was read whole. What it hands out is checked, and every refusal is an
/// input error that names file, line and element. Lives no longer than its XmlFile.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement& element, const std::string& file)
      : element_(&element), file_(&file) {}

  [[nodiscard]] std::string name() const;
  /// "a99.xml, line 120, <lanelet id=47625>/<leftBound>"
  [[nodiscard]] std::string place() const;
  [[nodiscard]] Error error(const std::string& problem, const std::string& mend = {}) const;

  /// The first child of that name; throws where there is none.
  [[nodiscard]] XmlElement child(const char* name) const;
  [[nodiscard]] std::optional<XmlElement> find(const char* name) const;
  [[nodiscard]] std::vector<XmlElement> children(const char* name) const;
  [[nodiscard]] std::vector<XmlElement> children() const;

  /// The attribute as it stands; throws where there is none.
  [[nodiscard]] std::string text(const char* attribute) const;
  [[nodiscard]] std::optional<std::string> find_text(const char* attribute) const;
  /// The attribute as a finite number of at most 1e12; throws where there is none.
  [[nodiscard]] double number(const char* attribute) const;
  /// As number(), but `otherwise` where there is no such attribute.
  [[nodiscard]] double number(const char* attribute, double otherwise) const;
  [[nodiscard]] std::int64_t integer(const char* attribute) const;

  /// The element's own text without the blanks around it.
  [[nodiscard]] std::string content() const;
  [[nodiscard]] double content_number() const;

 private:
  [[nodiscard]] std::string label() const;
  [[nodiscard]] double parse_number(const std::string& text, const std::string& what) const;

  const tinyxml2::XMLElement* element_;
  const std::string* file_;
};

/// An XML file in memory. Refuses, before it is parsed, what could take more than the few hundred megabytes
/// that any file may.
class XmlFile {
 public:
  explicit XmlFile(const std::filesystem::path& path);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] XmlElement root() const;

 private:
  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

/// `text` without blanks around it.
std::string trimmed(const std::string& text);

/// The whole of `text` as a number, blanks around it and a leading + allowed; nothing if it is none or not
/// finite.
std::optional<double> parse_finite(const std::string& text);

}  // namespace lanefuse
