// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace boxlight::gpu {
namespace {

constexpr auto kFlying = KeyMode::flying, kOrbiting = KeyMode::orbiting, kAlways = KeyMode::always;

constexpr std::array kTable = {
    KeyBinding{"left drag", "orbit around the target", kOrbiting},
    KeyBinding{"left drag", "look around", kFlying},
    KeyBinding{"right drag, middle drag, Shift + left drag", "pan"},
    KeyBinding{"wheel", "zoom", kOrbiting},
    KeyBinding{"wheel", "speed of flight", kFlying},
    KeyBinding{"Ctrl + left drag", "rotate the light about the vertical axis"},
    KeyBinding{"drop a file", "open it: a .ptb asset, or an HDR image as the light"},
    KeyBinding{"G", "fly mode on or off", kAlways, Action::toggleFly, GLFW_KEY_G},
    KeyBinding{"W", "forward", kFlying, Action::flyForward, GLFW_KEY_W},
    KeyBinding{"S", "back", kFlying, Action::flyBack, GLFW_KEY_S},
    KeyBinding{"A", "left", kFlying, Action::flyLeft, GLFW_KEY_A},
    KeyBinding{"D", "right", kFlying, Action::flyRight, GLFW_KEY_D},
    KeyBinding{"E", "up", kFlying, Action::flyUp, GLFW_KEY_E},
    KeyBinding{"Q", "down (Shift with any of these: four times as fast)", kFlying, Action::flyDown,
               GLFW_KEY_Q},
    KeyBinding{"F", "fit the object into the window", kAlways, Action::fit, GLFW_KEY_F},
    KeyBinding{"R", "reset the camera to where it started", kAlways, Action::reset, GLFW_KEY_R},
    KeyBinding{"E", "exposure up by a quarter EV", kOrbiting, Action::brighter, GLFW_KEY_E},
    KeyBinding{"Shift+E", "exposure down by a quarter EV", kOrbiting, Action::darker, GLFW_KEY_E, true},
    KeyBinding{"M", "next tone map: none, Reinhard, ACES-like, Khronos PBR Neutral", kAlways,
               Action::nextToneMap, GLFW_KEY_M},
    KeyBinding{"B", "environment behind the object on or off", kAlways, Action::background, GLFW_KEY_B},
    KeyBinding{"]", "one more box of each kernel", kAlways, Action::moreBoxes, GLFW_KEY_RIGHT_BRACKET},
    KeyBinding{"[", "one box less", kAlways, Action::fewerBoxes, GLFW_KEY_LEFT_BRACKET},
    KeyBinding{"T", "split screen with the path-traced truth; its line is dragged", kAlways, Action::truth,
               GLFW_KEY_T},
    KeyBinding{"O", "open an asset or a light by its path", kAlways, Action::open, GLFW_KEY_O},
    KeyBinding{"P", "screenshot, with the settings that make it again", kAlways, Action::screenshot,
               GLFW_KEY_P},
    KeyBinding{"Ctrl+S", "save camera and settings", kAlways, Action::saveSettings, GLFW_KEY_S, false, true},
    KeyBinding{"V", "record a turntable", kAlways, Action::turntable, GLFW_KEY_V},
    KeyBinding{"C", "add this camera to the path", kAlways, Action::addPathCamera, GLFW_KEY_C},
    KeyBinding{"Shift+C", "forget the path", kAlways, Action::clearPath, GLFW_KEY_C, true},
    KeyBinding{"Shift+V", "record a flight along the path", kAlways, Action::recordPath, GLFW_KEY_V, true},
    KeyBinding{"H", "this help", kAlways, Action::help, GLFW_KEY_H},
    KeyBinding{"Tab", "panel on or off", kAlways, Action::panel, GLFW_KEY_TAB},
    KeyBinding{"Esc", "stop a recording, close a dialogue or this help, leave fly mode", kAlways,
               Action::cancel, GLFW_KEY_ESCAPE},
    KeyBinding{"Ctrl+Q", "quit", kAlways, Action::quit, GLFW_KEY_Q, false, true},
};

const char* nameOf(KeyMode mode) {
  return mode == KeyMode::flying ? "flying" : mode == KeyMode::orbiting ? "orbiting" : "";
}

}  // namespace

std::span<const KeyBinding> keyTable() { return kTable; }

bool isHeld(Action action) { return action >= Action::flyForward && action <= Action::flyDown; }

std::optional<Action> actionOf(int key, bool shift, bool control, bool flying) {
  for (const KeyBinding& row : kTable) {
    if (row.key == 0 || row.key != key || row.control != control) continue;
    if (row.mode == (flying ? KeyMode::orbiting : KeyMode::flying)) continue;
    if (row.shift == shift || isHeld(row.action)) return row.action;
  }
  return {};
}

std::string keysAsMarkdown() {
  std::string text = "| keys | when | what |\n|---|---|---|\n";
  for (const KeyBinding& row : kTable)
    text += fmt::format("| {} | {} | {} |\n", row.keys, nameOf(row.mode), row.what);
  return text;
}

std::string keysAsText() {
  std::string text;
  for (const KeyBinding& row : kTable)
    text += fmt::format("{:<44}{:<10}{}\n", row.keys, nameOf(row.mode), row.what);
  return text;
}

}  // namespace boxlight::gpu
