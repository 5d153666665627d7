#include "document/saving.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <vector>

#include "base/fail.h"
#include "base/new_file.h"
#include "document/composition.h"
#include "document/files.h"
#include "document/names.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

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
    fail(Status::kFile, "folder: {} is there with other content, and is not overwritten; give a new folder",
         file.path.string());
  }
  if (missing.empty()) return;
  write(missing, folder);
}

}  // namespace mimo::document
