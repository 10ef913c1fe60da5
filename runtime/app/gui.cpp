// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/gui.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace boxlight::gpu {
namespace {

constexpr float kFontSize = 13.0f, kPanelWidth = 330.0f;
constexpr std::array<uint32_t, 6> kLightWidths = {64, 128, 256, 512, 1024, 2048};

template <size_t N, class Enum>
void combo(const char* label, const std::array<const char*, N>& names, Enum& value) {
  int index = int(value);
  if (ImGui::Combo(label, &index, names.data(), int(N))) value = Enum(index);
}

void drawPictureSettings(ViewSettings& s) {
  ImGui::SliderFloat("exposure", &s.exposure, -10.0f, 10.0f, "%.2f EV");
  combo("tone map", kToneMapNames, s.toneMap);
  ImGui::SliderFloat("light turned", &s.environmentDegrees, -180.0f, 180.0f, "%.0f degrees");
  ImGui::SliderFloat("light pitched", &s.environmentTilt.pitch, -90.0f, 90.0f, "%.0f degrees");
  ImGui::SliderFloat("light rolled", &s.environmentTilt.roll, -180.0f, 180.0f, "%.0f degrees");
  ImGui::SliderFloat("light times", &s.environmentIntensity, 0.01f, 100.0f, "%.2f",
                     ImGuiSliderFlags_Logarithmic);
  ImGui::Checkbox("background", &s.background);
  ImGui::SliderFloat("field of view", &s.camera.fovDegrees, 5.0f, 120.0f, "%.0f degrees");
}

void drawLightSize(std::optional<uvec2>& chosen, uvec2 now) {
  const uvec2 size = chosen.value_or(now);
  int index = 0;
  while (index + 1 < int(kLightWidths.size()) && kLightWidths[size_t(index)] < size.x) ++index;
  const std::string label = fmt::format("{}x{}{}", size.x, size.y, chosen ? "" : ", by the asset");
  if (ImGui::SliderInt("SAT", &index, 0, int(kLightWidths.size()) - 1, label.c_str()))
    chosen = {kLightWidths[size_t(index)], kLightWidths[size_t(index)] / 2};
}

/// Of the picture at hand, against the same with all boxes.
void drawBoxError(const ViewSettings& s, const Viewer& viewer) {
  if (s.boxes == 0)
    ImGui::TextUnformatted("error against all boxes: none");
  else if (viewer.boxError())
    ImGui::Text("error against all boxes: %.2f %%\n%.2f steps of 8-bit sRGB",
                100 * viewer.boxError()->relative, viewer.boxError()->rmse8);
  else
    ImGui::TextUnformatted("error against all boxes: ...");
}

void drawQuality(ViewSettings& s, const Viewer& viewer) {
  const int most = int(viewer.mostBoxes());
  int boxes = s.boxes == 0 ? most : std::min(int(s.boxes), most);
  const std::string label = boxes == most ? fmt::format("all {}", most) : std::to_string(boxes);
  if (ImGui::SliderInt("boxes", &boxes, 1, most, label.c_str()))
    s.boxes = boxes == most ? 0 : uint32_t(boxes);
  drawLightSize(s.lightSize, viewer.lightSize());
  static constexpr std::array kSums = {"compact", "exact"};
  combo("SAT sums", kSums, s.satScheme);
  static constexpr std::array kInterpolations = {"energy", "weight"};
  combo("interpolation", kInterpolations, s.interpolation);
  int samples = int(s.samples);
  const std::string grid = fmt::format("{0} x {0}", s.samples);
  if (ImGui::SliderInt("samples", &samples, 1, 8, grid.c_str())) s.samples = uint32_t(samples);
  drawBoxError(s, viewer);
}

void drawTimes(const PassHistory& history, float scale) {
  for (const PassHistory::Row& row : history.rows()) {
    const std::vector<float> values(row.milliseconds.begin(), row.milliseconds.end());
    const std::string label = fmt::format("{:.1f} ms", values.back());
    ImGui::PlotLines(row.pass.c_str(), values.data(), int(values.size()), 0, label.c_str(), 0.0f,
                     1.1f * *std::max_element(values.begin(), values.end()) + 1e-3f, {0, 26 * scale});
  }
}

void drawRecording(Session& session, const std::function<void(Action)>& act) {
  ImGui::SliderInt("frames", &session.recording.frames, 2, 600);
  static constexpr std::array kFormats = {"PNG", "EXR"};
  combo("format", kFormats, session.recording.exr);
  if (ImGui::Button("turntable")) act(Action::turntable);
  ImGui::SameLine();
  if (ImGui::Button("add camera")) act(Action::addPathCamera);
  ImGui::SameLine();
  if (ImGui::Button("fly the path")) act(Action::recordPath);
  ImGui::Text("%zu cameras on the path", session.path.size());
}

void drawFacts(const GuiState& state) {
  const FrameCounts& counts = state.viewer.counts();
  ImGui::Text("%s", state.device.c_str());
  ImGui::Text("shown: %ux%u", state.viewer.shownSize().x, state.viewer.shownSize().y);
  ImGui::Text("%llu texels, %llu boxes, %llu pages, %.1f MiB,\n%.1f ms waited for pages",
              static_cast<unsigned long long>(counts.visibleRecords),
              static_cast<unsigned long long>(counts.boxes), static_cast<unsigned long long>(counts.pages),
              double(counts.pageBytes) / (1 << 20), counts.pageMilliseconds);
}

void drawHelp(bool& open) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (ImGui::Begin("Help", &open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing))
    ImGui::TextUnformatted(keysAsText().c_str());
  ImGui::End();
}

void drawMessage(const std::string& text) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y - 10}, ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted(text.c_str());
  ImGui::End();
}

}  // namespace

void PassHistory::add(const std::vector<PassTime>& times) {
  for (const PassTime& time : times)
    if (std::none_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.pass == time.name; }))
      rows_.push_back({time.name, {}});
  for (Row& row : rows_) {
    const auto time =
        std::find_if(times.begin(), times.end(), [&](const PassTime& t) { return t.name == row.pass; });
    row.milliseconds.push_back(time == times.end() ? 0.0f : float(time->milliseconds));
    if (row.milliseconds.size() > kLength) row.milliseconds.pop_front();
  }
}

Gui::Gui(float scale) : scale_(scale) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // leaves no files where it is started
  ImFontConfig font;
  font.SizePixels = std::floor(kFontSize * scale);
  io.Fonts->AddFontDefault(&font);
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
}

Gui::~Gui() { ImGui::DestroyContext(); }

void Gui::drawPanel(Session& session, const GuiState& state, const std::function<void(Action)>& act) {
  const auto open = ImGuiTreeNodeFlags_DefaultOpen;
  ImGui::SetNextWindowPos({10 * scale_, 10 * scale_}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({kPanelWidth * scale_, 0}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("ptview", &session.panel, ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::PushItemWidth(-110 * scale_);
    drawFacts(state);
    ImGui::ProgressBar(float(state.viewer.fraction()), {-1, 4 * scale_}, "");
    if (ImGui::CollapsingHeader("picture", open)) drawPictureSettings(session.settings());
    if (ImGui::CollapsingHeader("speed and accuracy", open)) drawQuality(session.settings(), state.viewer);
    if (ImGui::CollapsingHeader("times of the passes", open)) drawTimes(state.history, scale_);
    if (ImGui::CollapsingHeader("recording")) drawRecording(session, act);
    if (ImGui::Button("open (O)")) act(Action::open);
    ImGui::SameLine();
    if (ImGui::Button("screenshot (P)")) act(Action::screenshot);
    ImGui::SameLine();
    if (ImGui::Button("help (H)")) act(Action::help);
    ImGui::PopItemWidth();
  }
  ImGui::End();
}

void Gui::drawDialog(Session& session, const std::function<void(const std::string&)>& open) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 3}, ImGuiCond_Always, {0.5f, 0.5f});
  if (ImGui::Begin("open an asset (.ptb) or a light", &session.openDialog,
                   ImGuiWindowFlags_AlwaysAutoResize)) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(480 * scale_);
    if (ImGui::InputText("path", &path_, ImGuiInputTextFlags_EnterReturnsTrue)) {
      session.openDialog = false;
      ImGui::SetWindowFocus(nullptr);  // keys are commands again
      open(path_);
    }
  }
  ImGui::End();
}

void Gui::draw(Session& session, const GuiState& state, const std::function<void(Action)>& act,
               const std::function<void(const std::string&)>& open) {
  ImGui::NewFrame();
  if (session.panel) drawPanel(session, state, act);
  if (session.help) drawHelp(session.help);
  if (session.openDialog) drawDialog(session, open);
  const std::string& message = state.progress.empty() ? session.message : state.progress;
  if (!message.empty()) drawMessage(message);
  ImGui::Render();
}

}  // namespace boxlight::gpu
