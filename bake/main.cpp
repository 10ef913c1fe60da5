// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_bake.h"
#include "bake/commands/cmd_compare.h"
#include "bake/commands/cmd_inspect.h"
#include "bake/commands/cmd_render.h"
#include "bake/commands/cmd_validate.h"
#include "common/base/cli.h"

int main(int argc, char** argv) {
  using namespace boxlight;
  CLI::App app("Bake light transport into box kernels, and measure it against the truth", "ptbake");
  app.require_subcommand(1);
  CommonOptions common;
  addBakeCommand(app, common);
  addRenderCommand(app, common);
  addCompareCommand(app, common);
  addInspectCommand(app, common);
  addValidateCommand(app, common);
  catchInterrupts();
  return runMain(app, argc, argv, common, [] {});
}
