#include "document/storage.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "base/new_file.h"
#include "document/compiler.h"
#include "document/composition.h"
#include "document/files.h"
#include "document/names.h"
#include "document/other_versions.h"
#include "document/report.h"
#include "document/xml.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

constexpr const char* kLibraryPrefix = "mimo/";
constexpr int kDeepestIncludes = 100;

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

std::string join(const std::string& folder, const std::string& path) {
  if (folder.empty() || begins_with(path, "/")) return path;
  return folder.back() == '/' ? folder + path : folder + "/" + path;
}

// A path on disk, which must not read as the name of a built-in file.
std::string on_disk(const std::string& path) { return begins_with(path, kLibraryPrefix) ? "./" + path : path; }

// Attributes that name files, and the compiler attribute that names their folder.
struct FileAttribute {
  const char* element;
  const char* attribute;
  const char* folder;
};
constexpr std::array<FileAttribute, 10> kFiles = {{{"mesh", "file", "meshdir"},
                                                   {"hfield", "file", "meshdir"},
                                                   {"skin", "file", "meshdir"},
                                                   {"texture", "file", "texturedir"},
                                                   {"texture", "fileright", "texturedir"},
                                                   {"texture", "fileleft", "texturedir"},
                                                   {"texture", "fileup", "texturedir"},
                                                   {"texture", "filedown", "texturedir"},
                                                   {"texture", "filefront", "texturedir"},
                                                   {"texture", "fileback", "texturedir"}}};

// One folder for all assets is what newer versions of MuJoCo have besides.
void name_folders(pugi::xml_node root) {
  for (pugi::xml_node compiler : root.children("compiler")) {
    const std::string folder = compiler.attribute("assetdir").value();
    for (const char* own : {"meshdir", "texturedir"}) {
      if (!folder.empty() && !compiler.attribute(own)) set(compiler, own, folder);
    }
    compiler.remove_attribute("assetdir");
  }
}

namespace fs = std::filesystem;

struct File {
  fs::path path;
  std::string bytes;
};

constexpr std::uint64_t kAnySize = UINT64_MAX;

std::string content(const std::string& source, const Limits& limits) {
  const auto built_in = built_in_asset(source);
  if (!built_in.empty()) return {built_in.begin(), built_in.end()};
  Limits any = limits;  // what was read once may be copied
  any.file_bytes = kAnySize;
  auto bytes = read_file(source, any);
  if (!bytes) fail(Status::kNotFound, "file {} cannot be read", source);
  return std::move(*bytes);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The last part of a path in characters that every file system takes, in small letters: some do not tell them apart.
std::string plain_name(const std::string& source) {
  std::string name = source.substr(source.find_last_of('/') + 1);
  for (char& c : name) {
    c = lower(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    if (!plain) c = '_';
  }
  constexpr std::size_t kLongest = 100;
  return name.size() > kLongest ? name.substr(name.size() - kLongest) : name;
}

// Names for files by where they come from; each another one.
class Names {
 public:
  const std::string& of(const std::string& source) {
    std::string& name = names_[source];
    if (!name.empty()) return name;
    const std::string plain = plain_name(source);
    name = plain;
    for (int number = 2; !taken_.insert(name).second; ++number) name = std::to_string(number) + "_" + plain;
    return name;
  }

 private:
  std::map<std::string, std::string> names_;  // references stay good
  std::set<std::string> taken_;
};

[[noreturn]] void fail_to_write(const File& file, const std::error_code& why) {
  fail(Status::kFile, "folder: file {} cannot be written: {}", file.path.string(), why.message());
}

// What is made goes again, unless all of it could be made.
class Made {
 public:
  Made() = default;
  ~Made() {
    std::error_code ignored;
    while (!paths_.empty()) {
      fs::remove(paths_.back(), ignored);  // of folders only empty ones
      paths_.pop_back();
    }
  }
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;

  void folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return;
    if (folder.has_parent_path() && folder.parent_path() != folder) this->folder(folder.parent_path());
    if (fs::create_directory(folder, error)) paths_.push_back(folder);
    if (error) fail(Status::kFile, "folder: {} cannot be made: {}", folder.string(), error.message());
  }
  // Beside its place; returns where.
  fs::path write(const File& file) {
    paths_.push_back(beside(file.path));
    std::ofstream stream(paths_.back(), std::ios::binary);
    stream.write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
    stream.close();
    if (!stream) fail_to_write(file, {errno, std::generic_category()});
    return paths_.back();
  }
  void name(const fs::path& written, const File& file) {
    fs::path name = file.path;
    paths_.reserve(paths_.size() + 1);  // as there is no way back from a name
    const std::error_code error = move_to_free(written, name);
    if (error) fail_to_write(file, error);
    paths_.push_back(std::move(name));
  }
  void keep() { paths_.clear(); }

 private:
  std::vector<fs::path> paths_;
};

// The document comes last, so that where there is one, all that it refers to is there as well.
void write(const std::vector<File>& files, const fs::path& folder) {
  Made made;
  made.folder(folder / "assets");
  std::vector<fs::path> written;
  for (const File& file : files) written.push_back(made.write(file));
  for (std::size_t i = 0; i < files.size(); ++i) made.name(written[i], files[i]);
  made.keep();
}

}  // namespace

pugi::xml_document Loader::built_in(const std::string& path) {
  const auto content = library_.text(path);
  if (!content) {
    fail(Status::kNotFound, "no built-in model {}{}", path,
         library_.built_in() ? "" : " in model_dir " + library_.folder());
  }
  return load(*content, path, {true, ""});
}

pugi::xml_document Loader::file(const std::string& path) {
  const auto content = read_file(path, limits_);
  if (!content) fail(Status::kNotFound, "file {} cannot be read", path);
  return load(*content, path, {false, folder_of(path)});
}

pugi::xml_document Loader::text(const std::string& xml) { return load(xml, "xml text", {false, ""}); }

pugi::xml_document Loader::load(const std::string& text, const std::string& name, const Origin& origin) {
  pugi::xml_document document = parsed(text, name, origin, Root::kMujoco);
  const pugi::xml_node root = document.document_element();
  expand_includes(root, origin, in_radians(root));
  require_shallow(document, name);
  if (foreign(origin)) translate(root);
  require_shallow(document, name);
  locate_assets(root, origin);
  return document;
}

// Into words of the MuJoCo that runs.
void Loader::translate(pugi::xml_node root) const {
  name_folders(root);
  Report report;
  engine::is_mujoco_2() ? translate_newer(root, report) : upgrade_older(root, limits_, report);
  report.write(log_);
}

pugi::xml_document Loader::parsed(const std::string& text, const std::string& name, const Origin& origin,
                                  Root root) const {
  pugi::xml_document document = parse(text, name, root);
  if (foreign(origin)) note_lines(document, text, name);
  return document;
}

void Loader::require_inside(pugi::xml_node node, const std::string& path, const Origin& origin) const {
  if (!limits_.confined || origin.library || lies_in(path, origin.folder)) return;
  fail(Status::kModel, "{}: file {} lies outside the document's folder", where(node), path);
}

void Loader::expand_includes(pugi::xml_node root, const Origin& origin, bool host_in_radians) {
  std::vector<pugi::xml_node> includes;  // collected first: inserting changes what is being walked over
  walk(root, [&](pugi::xml_node node) {
    if (std::string(node.name()) == "include") includes.push_back(node);
  });
  for (const pugi::xml_node include : includes) insert(include, origin, host_in_radians);
}

// A document's own folder may be called mimo as well: what the library does not have is looked for there.
bool Loader::names_built_in(const std::string& path) const {
  const std::string prefix = kLibraryPrefix;
  return begins_with(path, prefix) && library_.has(path.substr(prefix.size()));
}

// Puts the content of an included file in place of the include element.
void Loader::insert(pugi::xml_node include, const Origin& origin, bool host_in_radians) {
  std::string path = include.attribute("file").value();
  if (path.empty()) fail(Status::kModel, "{}: an include element has no file", where(include));
  Origin from = origin;
  if (!from.library && names_built_in(path)) {
    from = {true, "", origin.depth};
    path = path.substr(std::string(kLibraryPrefix).size());
  }
  const std::string key = from.library ? kLibraryPrefix + path : on_disk(join(from.folder, path));
  if (!included_.insert(key).second) fail(Status::kModel, "{}: file {} is included twice", where(include), key);
  if (++from.depth > kDeepestIncludes) {
    fail(Status::kModel, "{}: files are included more than {} deep", where(include), kDeepestIncludes);
  }
  require_inside(include, key, from);

  const auto content = from.library ? library_.text(path) : read_file(key, limits_);
  if (!content) fail(Status::kNotFound, "{}: included file {} cannot be read", where(include), key);
  const pugi::xml_document document = parsed(*content, key, from, Root::kAny);
  const pugi::xml_node root = document.document_element();
  const bool crosses = from.library && !origin.library;
  expand_includes(root, from, host_in_radians);
  if (crosses) {
    // A built-in file in a user's document: the user's compiler settings stay, the file adapts to them.
    locate_assets(root, from);
    while (root.child("compiler")) pugi::xml_node(root).remove_child("compiler");
    if (host_in_radians) convert_to_radians(root);
  }
  pugi::xml_node parent = include.parent();
  for (pugi::xml_node child : root.children()) copy_before(include, child);
  parent.remove_child(include);
}

// Gives every asset file its full path, so that documents from different folders can be put together. Built-in files
// are named "mimo/..."; the builder hands them to MuJoCo in memory.
void Loader::locate_assets(pugi::xml_node root, const Origin& origin) const {
  const std::string base = origin.library ? (library_.built_in() ? kLibraryPrefix : library_.folder()) : origin.folder;
  const bool inside = origin.library && library_.built_in();
  const bool strip = compiler_setting(root, "strippath") == "true";
  walk(root, [&](pugi::xml_node node) {
    for (const FileAttribute& entry : kFiles) {
      if (std::string(node.name()) != entry.element) continue;
      std::string path = node.attribute(entry.attribute).value();
      if (path.empty() || (begins_with(path, kLibraryPrefix) && !built_in_asset(path).empty())) continue;
      if (strip) path = path.substr(path.find_last_of("/\\") + 1);
      path = join(join(base, compiler_setting(root, entry.folder)), path);
      if (!inside) require_inside(node, path, origin);
      set(node, entry.attribute, inside ? path : on_disk(path));
    }
  });
  for (pugi::xml_node compiler : root.children("compiler")) {
    for (const char* attribute : {"meshdir", "texturedir", "strippath"}) compiler.remove_attribute(attribute);
  }
}

std::size_t Package::bytes() const {
  std::size_t all = document.size();
  for (const auto& [name, bytes] : files) all += bytes.size();
  return all;
}

Package package(const pugi::xml_document& document, const Limits& limits) {
  const pugi::xml_document changed = copy(document);
  Package all;
  Names names;
  for (const auto& [node, attribute] : asset_files(changed.document_element())) {
    const std::string source = attribute.value();
    if (source.empty()) continue;
    name_after_file(node);  // before the file gets another name
    const std::string name = "assets/" + names.of(source);
    set(node, attribute.name(), name);
    if (all.files.count(name) == 0) all.files.emplace(name, content(source, limits));
  }
  all.document = print(changed);
  return all;
}

void save(const Package& package, const std::string& folder) {
  std::vector<File> files;
  for (const auto& [name, bytes] : package.files) files.push_back({fs::path(folder) / name, bytes});
  files.push_back({fs::path(folder) / "scene.xml", package.document});
  std::vector<File> missing;
  for (File& file : files) {
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(file.path, unknown))) {
      missing.push_back(std::move(file));
      continue;
    }
    if (read_from_disk(file.path.string(), kAnySize) == file.bytes) continue;
    fail(Status::kFile, "folder: {} already exists with other content and is not overwritten; give a new folder",
         file.path.string());
  }
  if (missing.empty()) return;
  write(missing, folder);
}

}  // namespace mimo::document
