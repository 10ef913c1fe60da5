// SPDX-License-Identifier: Apache-2.0
#include "bake/study/kernel_report.h"

#include <fmt/format.h>

namespace boxlight {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json triple(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Json recordToJson(const KernelStudy& study) {
  const auto& r = study.plan.record;
  return {{"index", study.record},
          {"texel", {study.query.texel.x, study.query.texel.y}},
          {"side", study.query.back ? "back" : "front"},
          {"position", triple(r.position)},
          {"normal", triple(r.normal)},
          {"roughness", r.roughness},
          {"split", study.plan.isSplit()},
          {"cells", study.plan.hasCells()}};
}

Json boxToJson(const Box& box) {
  return {{"u0", box.u0}, {"v0", box.v0}, {"du", box.du}, {"dv", box.dv}, {"energy", triple(box.energy)}};
}

Json boxToJson(const CosineBox& cosine) {
  const Box& box = cosine.box;
  return {{"u0", box.u0}, {"v0", box.v0}, {"du", box.du}, {"dv", box.dv}, {"amplitude", cosine.amplitude}};
}

Rgb energyOf(const KernelStudy& study) {
  Rgb sum(0.0f);
  for (const Deposit& deposit : study.deposits) sum += deposit.throughput;
  return study.traced ? sum / float(study.traced) : sum;
}

}  // namespace

Json kernelToJson(const KernelStudy& study) {
  Json json{{"record", recordToJson(study)}, {"view", nullptr}};
  if (study.query.view)
    json["view"] = {{"index", *study.query.view}, {"direction", triple(study.viewDirection)}};
  json["paths"] = study.traced;
  json["deposits"] = study.deposits.size();
  json["energy"] = triple(energyOf(study));
  json["emission"] = triple(study.emission);
  if (study.hiddenPart) json["hiddenPart"] = *study.hiddenPart;
  for (const CosineBox& box : study.cosineBoxes) json["cosineBoxes"].push_back(boxToJson(box));
  json["boxes"] = Json::array();
  for (const Box& box : study.boxes) json["boxes"].push_back(boxToJson(box));
  json["probes"] = Json::array();
  for (const ProbeAnswer& a : probeKernel(study))
    json["probes"].push_back(
        {{"light", a.light}, {"paths", triple(a.paths)}, {"boxes", triple(a.boxes)}, {"error", a.error()}});
  return json;
}

std::string kernelToText(const KernelStudy& study) {
  const auto& r = study.plan.record;
  const auto& [texel, back, view] = study.query;
  const Rgb energy = energyOf(study);
  std::string text = fmt::format(
      "texel {},{} {}: record {} at ({:.4g}, {:.4g}, {:.4g}), normal ({:.3f}, {:.3f}, {:.3f}), roughness "
      "{:.3f}{}\n",
      texel.x, texel.y, back ? "back" : "front", study.record, r.position[0], r.position[1], r.position[2],
      r.normal[0], r.normal[1], r.normal[2], r.roughness, study.plan.isSplit() ? ", split lobes" : "");
  const vec3 d = study.viewDirection;
  text += view ? fmt::format("{} {} ({:.3f}, {:.3f}, {:.3f})", study.plan.hasCells() ? "cell" : "view", *view,
                             d.x, d.y, d.z)
               : "Lambert kernel";
  text += fmt::format(": {} paths, {} deposits, energy {:.4f} {:.4f} {:.4f}", study.traced,
                      study.deposits.size(), energy.r, energy.g, energy.b);
  if (study.hiddenPart) text += fmt::format(", hidden part {:.4f}", *study.hiddenPart);
  if (!study.cosineBoxes.empty())
    text += fmt::format("\n\n{:>9}{:>9}{:>9}{:>9}  {:>9}", "u0", "v0", "du", "dv", "amplitude");
  for (const auto& [b, amplitude] : study.cosineBoxes)
    text += fmt::format("\n{:9.5f}{:9.5f}{:9.5f}{:9.5f}  {:9.5f}", b.u0, b.v0, b.du, b.dv, amplitude);
  text += fmt::format("\n\n{:>9}{:>9}{:>9}{:>9}  {:>9}{:>9}{:>9}\n", "u0", "v0", "du", "dv", "energy R", "G",
                      "B");
  for (const Box& b : study.boxes)
    text += fmt::format("{:9.5f}{:9.5f}{:9.5f}{:9.5f}  {:9.5f}{:9.5f}{:9.5f}\n", b.u0, b.v0, b.du, b.dv,
                        b.energy.r, b.energy.g, b.energy.b);
  text += fmt::format("\n{:<14}{:>30}{:>30}{:>9}\n", "probe light", "paths R G B", "boxes R G B", "error");
  for (const ProbeAnswer& a : probeKernel(study))
    text += fmt::format("{:<14}{:10.5f}{:10.5f}{:10.5f}{:10.5f}{:10.5f}{:10.5f}{:9.4f}\n", a.light, a.paths.x,
                        a.paths.y, a.paths.z, a.boxes.x, a.boxes.y, a.boxes.z, a.error());
  return text;
}

}  // namespace boxlight
