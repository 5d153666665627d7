// Documents on disk: loaded into self-contained documents, and saved for programs that have MuJoCo but not libmimo.
#pragma once

#include <pugixml.hpp>
#include <set>
#include <string>

#include "base/log.h"
#include "document/budget.h"
#include "document/library.h"
#include "document/xml.h"

namespace mimo::document {

// Loads one MJCF source into a self-contained document: includes expanded, asset files found, what newer versions of
// MuJoCo have brought translated.

class Loader {
 public:
  explicit Loader(const Library& library, const Limits& limits = {}, const LogSink& log = {})
      : library_(library), limits_(limits), log_(log) {}

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
    int depth = 0;         // of includes in includes
  };

  pugi::xml_document load(const std::string& text, const std::string& name, const Origin& origin);
  void translate(pugi::xml_node root) const;
  void expand_includes(pugi::xml_node root, const Origin& origin, bool host_in_radians);
  void insert(pugi::xml_node include, const Origin& origin, bool host_in_radians);
  bool names_built_in(const std::string& path) const;
  void locate_assets(pugi::xml_node root, const Origin& origin) const;
  pugi::xml_document parsed(const std::string& text, const std::string& name, const Origin& origin, Root root) const;
  bool foreign(const Origin& origin) const { return !origin.library || !library_.built_in(); }
  // A file named by an element, which is outside where it must not be.
  void require_inside(pugi::xml_node node, const std::string& path, const Origin& origin) const;

  const Library& library_;
  Limits limits_;
  LogSink log_;
  std::set<std::string> included_;
};

// A scene on disk, for users who have MuJoCo without libmimo.

// A document and all that it refers to: "assets/floor.png".
struct Package {
  std::string document;
  Files files;

  std::size_t bytes() const;
};
// Files are those of the limits, if they hold any, else on disk. Throws Status::kNotFound for one that cannot be read.
Package package(const pugi::xml_document& document, const Limits& limits);

// Writes FOLDER/scene.xml and copies of all files that it refers to, FOLDER/assets/..., under plain names. Makes the
// folder where it is not there. Throws Status::kFile for a file that is there with other content, or that cannot be
// written; nothing has been written then. A process that is killed leaves
// whole files, scene.xml last.
void save(const Package& package, const std::string& folder);

}  // namespace mimo::document
