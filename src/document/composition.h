// A document with the files that it refers to, and how two such documents become one.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/log.h"
#include "document/budget.h"
#include "engine/model.h"

namespace mimo::document {

// A document with the files that it refers to.

// A document ready to compile, with the built-in files that it refers to.
struct Composition {
  std::string xml;
  std::vector<engine::Asset> assets;
  std::vector<std::string> lines;                         // where each element was written
  std::vector<std::shared_ptr<const std::string>> texts;  // assets that are others than their files
  double seconds = 0;                                     // that the compiler will work, estimated
  bool has_contacts = true;                               // which the compiler is told nothing of
};

// Says what newer versions of MuJoCo do by themselves, and not what they have no longer: "apirate" never did anything.
void settle(pugi::xml_node root);

// Throws Status::kModel for a document that does not keep within the limits.
Composition packed(const pugi::xml_document& document, const Limits& limits);

// Throws what engine::compile throws; its messages name files and lines of the user's.
engine::ModelPtr compile(const Composition& composition, const LogSink& log);

// For a look at where things are, without pictures; warnings are told when a world is made of it.
engine::ModelPtr compile_quietly(const pugi::xml_document& document, const Limits& limits);

// Attributes that name the file of an asset.
struct AssetFile {
  pugi::xml_node node;
  pugi::xml_attribute attribute;
};
std::vector<AssetFile> asset_files(pugi::xml_node root);
// Those of a document as a text, as it names them. Throws Status::kModel for what is no document.
std::vector<std::string> files_named_by(const std::string& xml);

// Bytes of a built-in file that a document calls "mimo/textures/floor.png"; empty for any other name.
Span<const unsigned char> built_in_asset(const std::string& path);

// What MuJoCo wants of a document as a whole, and what documents that are put together need not keep between them.

// Actuators that have a state of their own come after those that have none; else the order stays.
void put_stateful_last(pugi::xml_node root);

// Where sizes of user numbers are given, each becomes the largest of those given and of those used.
void fit_user_numbers(pugi::xml_node root);

}  // namespace mimo::document
