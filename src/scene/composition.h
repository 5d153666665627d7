// A document with the files that it refers to.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "engine/model.h"

namespace mimo::scene {

// A document ready to compile, with the built-in files that it refers to.
struct Composition {
  std::string xml;
  std::vector<engine::Asset> assets;
};

Composition packed(const pugi::xml_document& document);

// For a look at what a document means; warnings are told when a world is made of it.
engine::ModelPtr compile_quietly(const pugi::xml_document& document);

// Attributes that name the file of an asset.
struct AssetFile {
  pugi::xml_node node;
  pugi::xml_attribute attribute;
};
std::vector<AssetFile> asset_files(pugi::xml_node root);

// Bytes of a built-in file that a document calls "mimo/textures/floor.png"; empty for any other name.
Span<const unsigned char> built_in_asset(const std::string& path);

}  // namespace mimo::scene
