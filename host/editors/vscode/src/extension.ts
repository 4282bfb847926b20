import * as vscode from "vscode";
import { startClient, stopClient } from "./client";
import { registerDebugger } from "./debug";
import { registerTexts } from "./texts";
import { registerView } from "./view";

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  registerDebugger(context);
  registerTexts(context);
  registerView(context);
  const restart = async () => {
    await stopClient();
    await startClient();
  };
  context.subscriptions.push(
    vscode.commands.registerCommand("isogloss.restart", restart),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      const names = ["command", "arguments", "languageServer"];
      if (names.some((name) => change.affectsConfiguration(`isogloss.${name}`))) await restart();
    }),
  );
  await startClient();
}

export async function deactivate(): Promise<void> {
  await stopClient();
}
