// Loads one MJCF source into a self-contained document: includes expanded, asset files found.
#pragma once

#include <pugixml.hpp>
#include <set>
#include <string>

#include "scene/library.h"

namespace mimo::scene {

class Loader {
 public:
  explicit Loader(const Library& library) : library_(library) {}

  // A built-in document, "mitten.xml". Throws Status::kNotFound.
  pugi::xml_document built_in(const std::string& path);
  // A user's file; throws Status::kNotFound when it cannot be read.
  pugi::xml_document file(const std::string& path);
  // A user's text; relative paths start from the working directory.
  pugi::xml_document text(const std::string& xml);

 private:
  struct Origin {
    bool library = false;  // a built-in file: paths are relative to the models' root
    std::string folder;    // else: relative to this folder, "" or with a slash at its end
  };

  pugi::xml_document load(const std::string& text, const std::string& name, const Origin& origin);
  void expand_includes(pugi::xml_node root, const Origin& origin, bool host_in_radians);
  void insert(pugi::xml_node include, const Origin& origin, bool host_in_radians);
  bool names_built_in(const std::string& path) const;
  void locate_assets(pugi::xml_node root, const Origin& origin) const;

  const Library& library_;
  std::set<std::string> included_;
};

}  // namespace mimo::scene
