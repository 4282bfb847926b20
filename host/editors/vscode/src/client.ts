// The language server, started once for all programs.
import * as vscode from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions } from "vscode-languageclient/node";
import { call, languages } from "./command";

let client: LanguageClient | undefined;

export async function startClient(): Promise<void> {
  const settings = vscode.workspace.getConfiguration("isogloss");
  if (client || !settings.get<boolean>("languageServer", true)) return;
  const server = call("lsp");
  const serverOptions: ServerOptions = { command: server.command, args: server.arguments };
  const clientOptions: LanguageClientOptions = {
    documentSelector: [
      ...languages.map((language) => ({ scheme: "file", language })),
      { scheme: "file", language: "xml", pattern: "**/{dialects,machines}/**/*.xml" },
    ],
    initializationOptions: settings,
    synchronize: { configurationSection: "isogloss" },
  };
  client = new LanguageClient("isogloss", "Isogloss", serverOptions, clientOptions);
  try {
    await client.start();
  } catch (fault) {
    client = undefined;
    void vscode.window.showErrorMessage(
      `Isogloss: '${server.command}' could not be started as a language server. ` +
        `Set "isogloss.command" to the path of the command. (${String(fault)})`,
    );
  }
}

export async function stopClient(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.stop();
}
