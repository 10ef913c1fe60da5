// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_container.h"

#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "bake/scene/gltf_error.h"
#include "common/base/file.h"

namespace boxlight {
namespace {

using Bytes = std::span<const std::byte>;

constexpr uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr uint32_t kBinChunk = 0x004E4942;   // "BIN\0"
constexpr int kMaxDepth = 256;

uint32_t word(Bytes bytes, size_t offset) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// Parsers that call themselves run out of stack on deep nesting: refuse it before any of them sees the text.
void checkDepth(const std::filesystem::path& path, std::string_view text) {
  int depth = 0;
  bool inString = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) {
        failAt(ExitCode::invalidInput, path, "JSON", "nested more than {} deep at byte {}", kMaxDepth, i);
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

nlohmann::json parseJson(const std::filesystem::path& path, Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  checkDepth(path, text);
  try {
    nlohmann::json json = nlohmann::json::parse(text);
    if (json.is_object()) return json;
  } catch (const nlohmann::json::exception& e) {
    failAt(ExitCode::invalidInput, path, "JSON", "{}; export the file again", e.what());
  }
  failAt(ExitCode::invalidInput, path, "JSON", "not a glTF document (the root must be an object)");
}

// The chunk at `offset`, which moves behind it; nothing at the end of the file.
struct Chunk {
  uint32_t type;
  Bytes data;
};
std::optional<Chunk> nextChunk(const std::filesystem::path& path, Bytes file, size_t& offset) {
  if (offset == file.size()) return std::nullopt;
  if (file.size() - offset < 8) {
    failAt(ExitCode::invalidInput, path, "GLB", "chunk header cut off at byte {}; copy the file again",
           offset);
  }
  const uint32_t length = word(file, offset), type = word(file, offset + 4);
  offset += 8;
  if (file.size() - offset < length) {
    failAt(ExitCode::invalidInput, path, "GLB",
           "chunk of {} bytes at byte {} passes the end of the file; copy the file again", length, offset);
  }
  const Chunk chunk{type, file.subspan(offset, length)};
  offset += length;
  return chunk;
}

GltfContainer readGlb(const std::filesystem::path& path, Bytes bytes) {
  if (bytes.size() < 12) failAt(ExitCode::invalidInput, path, "GLB", "header cut off; copy the file again");
  const uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2) {
    failAt(ExitCode::unsupported, path, "GLB", "container version {}; export the file as glTF 2.0", version);
  }
  if (length > bytes.size() || length < 12) {
    failAt(ExitCode::invalidInput, path, "GLB", "header says {} bytes, the file has {}; copy the file again",
           length, bytes.size());
  }
  const Bytes file = bytes.first(length);
  size_t offset = 12;
  const auto json = nextChunk(path, file, offset);
  if (!json || json->type != kJsonChunk)
    failAt(ExitCode::invalidInput, path, "GLB", "the first chunk must be JSON");
  const auto binary = nextChunk(path, file, offset);
  GltfContainer container{parseJson(path, json->data), {}};
  if (binary && binary->type == kBinChunk) container.binary.assign(binary->data.begin(), binary->data.end());
  return container;
}

}  // namespace

GltfContainer readContainer(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = readFile(path);
  if (bytes.size() >= 4 && word(bytes, 0) == kGlbMagic) return readGlb(path, bytes);
  return {parseJson(path, bytes), {}};
}

std::vector<unsigned char> packGlb(const std::filesystem::path& path, const nlohmann::json& json,
                                   std::span<const std::byte> binary) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const uint64_t binarySize = (uint64_t(binary.size()) + 3) / 4 * 4;
  const uint64_t size = 12 + 8 + text.size() + (binarySize ? 8 + binarySize : 0);
  if (size > uint64_t(std::numeric_limits<int32_t>::max())) {
    failAt(ExitCode::unsupported, path, "JSON",
           "document and BIN chunk pass 2 GiB; put the buffers into .bin files");
  }
  std::vector<unsigned char> glb(size, 0);
  size_t end = 0;
  const auto put = [&](const void* data, size_t count) {
    if (count) std::memcpy(glb.data() + end, data, count);
    end += count;
  };
  const uint32_t head[5] = {kGlbMagic, 2, uint32_t(size), uint32_t(text.size()), kJsonChunk};
  put(head, sizeof head);
  put(text.data(), text.size());
  if (binarySize) {
    const uint32_t chunk[2] = {uint32_t(binarySize), kBinChunk};
    put(chunk, sizeof chunk);
    put(binary.data(), binary.size());
  }
  return glb;
}

}  // namespace boxlight
