// The debug adapter: one process for each session.
import * as path from "node:path";
import * as vscode from "vscode";
import { call, languages } from "./command";

class Adapters implements vscode.DebugAdapterDescriptorFactory {
  createDebugAdapterDescriptor(session: vscode.DebugSession): vscode.DebugAdapterDescriptor {
    const adapter = call("dap");
    const program = session.configuration.program as string | undefined;
    return new vscode.DebugAdapterExecutable(adapter.command, adapter.arguments, {
      cwd: program ? path.dirname(program) : session.workspaceFolder?.uri.fsPath,
    });
  }
}

/** Fills in what the launch leaves out: the program in the editor, and the settings of its folder. */
class Configurations implements vscode.DebugConfigurationProvider {
  resolveDebugConfiguration(
    _folder: vscode.WorkspaceFolder | undefined,
    given: vscode.DebugConfiguration,
  ): vscode.DebugConfiguration | undefined {
    if (given.type) return given;
    const editor = vscode.window.activeTextEditor;
    if (!editor || !languages.includes(editor.document.languageId)) return undefined;
    return { type: "isogloss", request: "launch", name: "Debug this part program", program: "${file}", stopOnEntry: true };
  }

  resolveDebugConfigurationWithSubstitutedVariables(
    _folder: vscode.WorkspaceFolder | undefined,
    given: vscode.DebugConfiguration,
  ): vscode.DebugConfiguration {
    const file = typeof given.program === "string" ? vscode.Uri.file(given.program) : undefined;
    const settings = vscode.workspace.getConfiguration("isogloss", file);
    const out: vscode.DebugConfiguration = { ...given };
    if (!out.dialect && !out.machine) {
      const machine = settings.get<string>("machine");
      if (machine) out.machine = machine;
      else if (settings.get<string>("dialect")) out.dialect = settings.get<string>("dialect");
    }
    for (const name of ["offsets", "tools", "variables"])
      if (!out[name] && settings.get<string>(name)) out[name] = settings.get<string>(name);
    for (const name of ["subprograms", "set"])
      if (!out[name] && settings.get<string[]>(name)?.length) out[name] = settings.get<string[]>(name);
    return out;
  }
}

export function registerDebugger(context: vscode.ExtensionContext): void {
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("isogloss", new Adapters()),
    vscode.debug.registerDebugConfigurationProvider("isogloss", new Configurations()),
  );
}
