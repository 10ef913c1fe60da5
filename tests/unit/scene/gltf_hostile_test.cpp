// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "bake/scene/gltf_load.h"
#include "common/base/error.h"
#include "gltf_builder.h"

namespace boxlight::test {
namespace {

constexpr auto kInvalid = ExitCode::invalidInput;
constexpr auto kUnsupported = ExitCode::unsupported;

// Loading must fail with the code, and the message must name the file and the place.
void expectError(const std::filesystem::path& path, ExitCode code, const std::string& place) {
  try {
    loadGltf(path);
    ADD_FAILURE() << "was loaded; expected an error at " << place;
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), code) << message;
    EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
    EXPECT_NE(message.find(place), std::string::npos) << message;
  }
}

struct Damage {
  const char* name;
  ExitCode code;
  const char* place;
  std::function<void(GltfBuilder&)> apply;  // to a square with a material, a texture and TEXCOORD_0
};
void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }

Json& accessor(GltfBuilder& b, const char* attribute) {
  return b.json["accessors"][b.primitive()["attributes"][attribute].get<size_t>()];
}
// Overwrites bytes of an attribute's data.
template <class T>
void poke(GltfBuilder& b, const Json& accessor, size_t index, T value) {
  const Json& view = b.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  std::memcpy(b.binary.data() + view["byteOffset"].get<size_t>() + index * sizeof(T), &value, sizeof value);
}
Json sparse(GltfBuilder& b, const Bytes& indices) {
  const int index = b.addView(indices), value = b.addView(Bytes(12 * indices.size()));
  return {{"count", indices.size()},
          {"indices", {{"bufferView", index}, {"componentType", 5121}}},
          {"values", {{"bufferView", value}}}};
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr uint64_t kHuge = uint64_t(1) << 63;

const Damage kDamages[] = {
    {"no_asset", kInvalid, "asset.version", [](auto& b) { b.json.erase("asset"); }},
    {"version_1", kUnsupported, "asset.version", [](auto& b) { b.json["asset"]["version"] = "1.0"; }},
    {"version_3", kUnsupported, "asset.version", [](auto& b) { b.json["asset"]["minVersion"] = "3.0"; }},
    {"required_extensions", kUnsupported, "KHR_draco_mesh_compression, EXT_foo",
     [](auto& b) {
       b.json["extensionsRequired"] = {"KHR_draco_mesh_compression", "KHR_materials_specular", "EXT_foo"};
     }},
    {"required_not_array", kInvalid, "extensionsRequired",
     [](auto& b) { b.json["extensionsRequired"] = "EXT_foo"; }},

    {"scene_range", kInvalid, "scene: index 1", [](auto& b) { b.json["scene"] = 1; }},
    {"scene_negative", kInvalid, "scene:", [](auto& b) { b.json["scene"] = -1; }},
    {"scene_text", kInvalid, "scene:", [](auto& b) { b.json["scene"] = "0"; }},
    {"scene_node_range", kInvalid, "scenes[0].nodes[0]: index 9",
     [](auto& b) { b.json["scenes"][0]["nodes"] = {9}; }},
    {"scenes_not_array", kInvalid, "scenes", [](auto& b) { b.json["scenes"] = 3; }},
    {"child_range", kInvalid, "nodes[0].children[0]", [](auto& b) { b.json["nodes"][0]["children"] = {7}; }},
    {"cycle_self", kInvalid, "nodes[0]: reached twice",
     [](auto& b) { b.json["nodes"][0]["children"] = {0}; }},
    {"cycle_two", kInvalid, "nodes[0]: reached twice",
     [](auto& b) {
       b.json["nodes"][0]["children"] = {1};
       b.add("nodes", {{"children", {0}}});
     }},
    {"cycle_no_scene", kInvalid, "nodes: every node",
     [](auto& b) {
       b.json["nodes"][0]["children"] = {0};
       b.json.erase("scenes");
       b.json.erase("scene");
     }},
    {"two_parents", kInvalid, "nodes[1]: reached twice",
     [](auto& b) {
       b.json["nodes"][0]["children"] = {1, 1};
       b.add("nodes", Json::object());
     }},
    {"mesh_range", kInvalid, "nodes[0].mesh: index 1", [](auto& b) { b.json["nodes"][0]["mesh"] = 1; }},
    {"matrix_short", kInvalid, "nodes[0].matrix",
     [](auto& b) {
       b.json["nodes"][0]["matrix"] = {1, 2, 3};
     }},
    {"matrix_projective", kInvalid, "nodes[0].matrix",
     [](auto& b) { b.json["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }},
    {"matrix_and_scale", kInvalid, "nodes[0]: has a matrix",
     [](auto& b) {
       b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
       b.json["nodes"][0]["scale"] = {1, 1, 1};
     }},
    {"rotation_zero", kInvalid, "nodes[0].rotation",
     [](auto& b) {
       b.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
     }},
    {"scale_text", kInvalid, "nodes[0].scale",
     [](auto& b) {
       b.json["nodes"][0]["scale"] = {1, "2", 3};
     }},
    {"far_away", kInvalid, "nodes[0] puts it beyond",
     [](auto& b) {
       b.json["nodes"][0]["translation"] = {1e30, 0, 0};
     }},
    {"nothing_shown", kInvalid, "scene: shows no triangle",
     [](auto& b) { b.json["scenes"][0]["nodes"] = Json::array(); }},
    {"flattened", kInvalid, "scene: shows no triangle",
     [](auto& b) {
       b.json["nodes"][0]["scale"] = {0, 0, 0};
     }},

    {"no_primitives", kInvalid, "meshes[0]: 'primitives'", [](auto& b) { b.json["meshes"][0].erase("primitives"); }},
    {"stride_huge", kInvalid, "bufferViews[0].byteStride", [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 256; }},
    {"uv_huge", kInvalid, "attributes.TEXCOORD_0: element 0", [](auto& b) { poke(b, accessor(b, "TEXCOORD_0"), 0, 2e38f); }},
    {"no_attributes", kInvalid, "meshes[0].primitives[0]: 'attributes'",
     [](auto& b) { b.primitive().erase("attributes"); }},
    {"attribute_range", kInvalid, "meshes[0].primitives[0].attributes.POSITION",
     [](auto& b) { b.primitive()["attributes"]["POSITION"] = 99; }},
    {"attribute_negative", kInvalid, "meshes[0].primitives[0].attributes.NORMAL",
     [](auto& b) { b.primitive()["attributes"]["NORMAL"] = -1; }},
    {"indices_range", kInvalid, "meshes[0].primitives[0].indices",
     [](auto& b) { b.primitive()["indices"] = 99; }},
    {"material_range", kInvalid, "meshes[0].primitives[0].material",
     [](auto& b) { b.primitive()["material"] = 5; }},
    {"mode_range", kInvalid, "meshes[0].primitives[0].mode", [](auto& b) { b.primitive()["mode"] = 7; }},
    {"vertex_index_range", kInvalid, "meshes[0].primitives[0].indices: index 4 at 1",
     [](auto& b) {
       poke(b, b.json["accessors"][b.primitive()["indices"].template get<size_t>()], 1, uint8_t(4));
     }},
    {"indices_float", kInvalid, "meshes[0].primitives[0].indices",
     [](auto& b) { b.primitive()["indices"] = 0; }},
    {"indices_signed", kInvalid, "meshes[0].primitives[0].indices",
     [](auto& b) {
       b.json["accessors"][b.primitive()["indices"].template get<size_t>()]["componentType"] = 5120;
     }},
    {"indices_not_three", kInvalid, "meshes[0].primitives[0]",
     [](auto& b) { b.json["accessors"][b.primitive()["indices"].template get<size_t>()]["count"] = 5; }},
    {"indices_no_view", kInvalid, "accessors[3]",
     [](auto& b) { b.json["accessors"][3].erase("bufferView"); }},
    {"position_vec2", kInvalid, "attributes.POSITION",
     [](auto& b) { accessor(b, "POSITION")["type"] = "VEC2"; }},
    {"position_mat4", kInvalid, "attributes.POSITION",
     [](auto& b) { accessor(b, "POSITION")["type"] = "MAT4"; }},
    {"position_short", kInvalid, "attributes.POSITION",
     [](auto& b) { accessor(b, "POSITION")["componentType"] = 5122; }},
    {"uv_not_normalized", kInvalid, "attributes.TEXCOORD_0",
     [](auto& b) { accessor(b, "TEXCOORD_0")["componentType"] = 5123; }},
    {"position_nan", kInvalid, "attributes.POSITION: element 2",
     [](auto& b) { poke(b, accessor(b, "POSITION"), 7, kNan); }},
    {"position_inf", kInvalid, "attributes.POSITION: element 0",
     [](auto& b) { poke(b, accessor(b, "POSITION"), 0, kInf); }},
    {"normal_nan", kInvalid, "attributes.NORMAL: element 3",
     [](auto& b) { poke(b, accessor(b, "NORMAL"), 11, kNan); }},
    {"uv_inf", kInvalid, "attributes.TEXCOORD_0: element 1",
     [](auto& b) { poke(b, accessor(b, "TEXCOORD_0"), 2, -kInf); }},
    {"counts_differ", kInvalid, "attributes.NORMAL: has 3",
     [](auto& b) { accessor(b, "NORMAL")["count"] = 3; }},

    {"count_zero", kInvalid, "accessors[0].count", [](auto& b) { b.json["accessors"][0]["count"] = 0; }},
    {"count_negative", kInvalid, "accessors[0].count", [](auto& b) { b.json["accessors"][0]["count"] = -3; }},
    {"count_missing", kInvalid, "accessors[0]: 'count'",
     [](auto& b) { b.json["accessors"][0].erase("count"); }},
    {"count_fraction", kInvalid, "accessors[0].count",
     [](auto& b) { b.json["accessors"][0]["count"] = 3.5; }},
    {"count_past_view", kInvalid, "attributes.POSITION: 5 elements",
     [](auto& b) { b.json["accessors"][0]["count"] = 5; }},
    {"count_huge", kUnsupported, "attributes.POSITION",
     [](auto& b) { b.json["accessors"][0]["count"] = uint64_t(1) << 40; }},
    {"count_overflow", kInvalid, "accessors[0].count",
     [](auto& b) { b.json["accessors"][0]["count"] = kHuge; }},
    {"zeros_without_end", kInvalid, "attributes.POSITION",
     [](auto& b) {
       b.json["accessors"][0]["count"] = 4000000000u;
       b.json["accessors"][0].erase("bufferView");
     }},
    {"offset_past_view", kInvalid, "attributes.POSITION",
     [](auto& b) { b.json["accessors"][0]["byteOffset"] = 4; }},
    {"offset_huge", kInvalid, "attributes.POSITION",
     [](auto& b) { b.json["accessors"][0]["byteOffset"] = uint64_t(1) << 52; }},
    {"offset_negative", kInvalid, "accessors[0].byteOffset",
     [](auto& b) { b.json["accessors"][0]["byteOffset"] = -4; }},
    {"accessor_view_range", kInvalid, "accessors[0].bufferView",
     [](auto& b) { b.json["accessors"][0]["bufferView"] = 50; }},
    {"component_type", kInvalid, "accessors[0].componentType",
     [](auto& b) { b.json["accessors"][0]["componentType"] = 5130; }},
    {"accessor_type", kInvalid, "accessors[0].type",
     [](auto& b) { b.json["accessors"][0]["type"] = "VEC5"; }},
    {"accessor_not_object", kInvalid, "accessors[0]", [](auto& b) { b.json["accessors"][0] = 1; }},
    {"normalized_number", kInvalid, "accessors[0].normalized",
     [](auto& b) { b.json["accessors"][0]["normalized"] = 1; }},
    {"stride_small", kInvalid, "attributes.POSITION: byteStride 8",
     [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 8; }},
    {"stride_odd", kInvalid, "byteStride", [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 13; }},
    {"stride_past_view", kInvalid, "attributes.POSITION",
     [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 16; }},
    {"sparse_index_range", kInvalid, "attributes.POSITION: sparse index 4",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 4});
     }},
    {"sparse_unsorted", kInvalid, "attributes.POSITION: sparse indices",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {2, 1});
     }},
    {"sparse_too_many", kInvalid, "attributes.POSITION: sparse.count 5",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 1, 2, 3, 4});
     }},
    {"sparse_past_view", kInvalid, "attributes.POSITION",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 1});
       b.json["accessors"][0]["sparse"]["values"]["byteOffset"] = 4;
     }},
    {"sparse_no_indices", kInvalid, "accessors[0].sparse: 'indices'",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 1});
       b.json["accessors"][0]["sparse"].erase("indices");
     }},
    {"sparse_index_type", kInvalid, "accessors[0].sparse.indices.componentType",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 1});
       b.json["accessors"][0]["sparse"]["indices"]["componentType"] = 5126;
     }},
    {"sparse_offset_int", kInvalid, "accessors[0].sparse.values.byteOffset",
     [](auto& b) {
       b.json["accessors"][0]["sparse"] = sparse(b, {0, 1});
       b.json["accessors"][0]["sparse"]["values"]["byteOffset"] = (uint64_t(1) << 32) + 4;
     }},
    {"view_buffer_range", kInvalid, "bufferViews[0].buffer",
     [](auto& b) { b.json["bufferViews"][0]["buffer"] = 1; }},
    {"view_past_buffer", kInvalid, "bufferViews[0]: bytes",
     [](auto& b) { b.json["bufferViews"][0]["byteLength"] = 1 << 20; }},
    {"view_offset_past_buffer", kInvalid, "bufferViews[0]: bytes",
     [](auto& b) { b.json["bufferViews"][0]["byteOffset"] = uint64_t(1) << 53; }},
    {"buffer_past_chunk", kInvalid,
     "buffers[0]:", [](auto& b) { b.json["buffers"][0]["byteLength"] = 1 << 20; }},
    {"buffer_missing", kInvalid, "buffers[0].uri: there is no file",
     [](auto& b) { b.json["buffers"][0]["uri"] = "missing.bin"; }},
    {"buffer_second_embedded", kInvalid, "buffers[1].uri",
     [](auto& b) {
       b.add("buffers", {{"byteLength", 4}});
     }},
    {"buffer_url", kInvalid, "buffers[0].uri",
     [](auto& b) { b.json["buffers"][0]["uri"] = "https://example.com/a.bin"; }},
    {"buffer_folder", kInvalid, "buffers[0].uri", [](auto& b) { b.json["buffers"][0]["uri"] = "."; }},
    {"buffer_data_type", kUnsupported, "buffers[0].uri",
     [](auto& b) { b.json["buffers"][0]["uri"] = "data:model/x;base64,AAAA"; }},
    {"buffer_data_short", kInvalid, "buffers[0]:",
     [](auto& b) { b.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA"; }},

    {"image_missing", kInvalid, "images[0].uri: there is no file",
     [](auto& b) {
       b.json["images"][0] = {{"uri", "missing.png"}};
     }},
    {"image_view_range", kInvalid, "images[0].bufferView",
     [](auto& b) { b.json["images"][0]["bufferView"] = 77; }},
    {"image_neither", kInvalid, "images[0]: must have",
     [](auto& b) { b.json["images"][0] = Json::object(); }},
    {"image_both", kInvalid, "images[0]: must have", [](auto& b) { b.json["images"][0]["uri"] = "a.png"; }},
    {"image_garbage", kInvalid, "images[0]: cannot be decoded",
     [](auto& b) { b.json["images"][0]["bufferView"] = 0; }},
    {"image_empty_data", kInvalid, "images[0].uri",
     [](auto& b) {
       b.json["images"][0] = {{"uri", "data:image/png;base64,"}};
     }},
    {"texture_source_range", kInvalid, "textures[0].source",
     [](auto& b) { b.json["textures"][0]["source"] = 1; }},
    {"texture_no_source", kUnsupported, "baseColorTexture: textures[0]",
     [](auto& b) { b.json["textures"][0].erase("source"); }},
    {"texture_sampler_range", kInvalid, "textures[0].sampler",
     [](auto& b) { b.json["textures"][0]["sampler"] = 0; }},
    {"sampler_wrap", kInvalid, "samplers[0].wrapS",
     [](auto& b) {
       b.json["samplers"] = {{{"wrapS", 1}}};
     }},
    {"material_texture_range", kInvalid, "materials[0].pbrMetallicRoughness.baseColorTexture.index",
     [](auto& b) { b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 3; }},
    {"material_no_index", kInvalid, "materials[0].normalTexture: 'index'",
     [](auto& b) { b.json["materials"][0]["normalTexture"] = Json::object(); }},
    {"specular_texture_range", kInvalid,
     "materials[0].extensions.KHR_materials_specular.specularTexture.index",
     [](auto& b) {
       b.json["materials"][0]["extensions"]["KHR_materials_specular"]["specularTexture"]["index"] = 8;
     }},
    {"specular_color_short", kInvalid, "materials[0].extensions.KHR_materials_specular.specularColorFactor",
     [](auto& b) {
       b.json["materials"][0]["extensions"]["KHR_materials_specular"]["specularColorFactor"] = {1};
     }},
    {"base_color_short", kInvalid, "materials[0].pbrMetallicRoughness.baseColorFactor",
     [](auto& b) { b.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1}; }},
    {"alpha_mode", kInvalid, "materials[0].alphaMode",
     [](auto& b) { b.json["materials"][0]["alphaMode"] = "GLASS"; }},
    {"texcoord_2", kUnsupported, "materials[0] \"wood\".pbrMetallicRoughness.baseColorTexture.texCoord",
     [](auto& b) {
       b.json["materials"][0]["name"] = "wood";
       b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 2;
     }},
    {"texcoord_missing", kInvalid, "meshes[0].primitives[0].attributes.TEXCOORD_0: missing",
     [](auto& b) { b.primitive()["attributes"].erase("TEXCOORD_0"); }},
};

class HostileGltf : public testing::TestWithParam<Damage> {};

TEST_P(HostileGltf, EndsInAnErrorThatNamesThePlace) {
  const Damage& damage = GetParam();
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.addTexture(png(1, 1, {1, 2, 3, 4}));
  ASSERT_EQ(builder.load().triangles.size(), 2u) << "the undamaged file must load";
  damage.apply(builder);
  const TemporaryFolder folder;
  builder.writeGlb(folder / "bad.glb");
  expectError(folder / "bad.glb", damage.code, damage.place);
}

INSTANTIATE_TEST_SUITE_P(All, HostileGltf, testing::ValuesIn(kDamages),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(HostileFile, Missing) {
  const TemporaryFolder folder;
  expectError(folder / "missing.glb", ExitCode::io, "");
}

void expectTextError(const std::string& text, const std::string& place) {
  const TemporaryFolder folder;
  writeBytes(folder / "bad.gltf", Bytes(text.begin(), text.end()));
  expectError(folder / "bad.gltf", kInvalid, place);
}

TEST(HostileFile, Json) {
  expectTextError("", "JSON");
  expectTextError("{", "JSON");
  expectTextError("[]", "JSON");
  expectTextError("{}", "asset.version");
  expectTextError("{\"asset\": 3}", "asset.version");
  expectTextError("{\"a\": 1e999}", "JSON");
  expectTextError("{\"a\": \"\xff\"}", "JSON");
  expectTextError("{\"a\": " + std::string(1000000, '['), "JSON: nested");
  std::string nested = "{\"a\": ";
  for (int i = 0; i < 100000; ++i) nested += "{\"[\\\"\":";
  expectTextError(nested, "JSON: nested");
}

// A .glb that is cut off anywhere, or has one byte of its frame changed, ends in an Error or loads; it never
// crashes.
TEST(HostileFile, CutOrChangedGlb) {
  const TemporaryFolder folder;
  const Bytes whole = oneTriangle().glb();
  const auto tryLoad = [&](const Bytes& bytes) {
    writeBytes(folder / "a.glb", bytes);
    try {
      loadGltf(folder / "a.glb");
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  for (size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_FALSE(tryLoad(Bytes(whole.begin(), whole.begin() + ptrdiff_t(size)))) << size;
  }
  const size_t jsonSize = size_t(whole[12]) | size_t(whole[13]) << 8;
  for (const size_t at : {4, 8, 9, 10, 11, 12, 13, 14, 15, 16, 20}) {
    Bytes changed = whole;
    changed[at] ^= 0xFF;
    EXPECT_FALSE(tryLoad(changed)) << at;
  }
  for (size_t i = 0; i < 8; ++i) {
    Bytes changed = whole;
    changed[20 + jsonSize + i] ^= 0xFF;  // header of the BIN chunk
    EXPECT_FALSE(tryLoad(changed)) << i;
  }
  EXPECT_TRUE(tryLoad(whole));
}

}  // namespace
}  // namespace boxlight::test
