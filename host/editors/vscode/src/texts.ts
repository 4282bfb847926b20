// Answers of the command as texts beside the program: the explanation of a line, and plain blocks.
import * as path from "node:path";
import * as vscode from "vscode";
import { activeProgram, call, programOptions, run, tellFailure } from "./command";

const scheme = "isogloss";

class Texts implements vscode.TextDocumentContentProvider {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly texts = new Map<string, string>();
  readonly onDidChange = this.changed.event;

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.texts.get(uri.toString()) ?? "";
  }

  async show(name: string, text: string, language: string): Promise<void> {
    const uri = vscode.Uri.from({ scheme, path: `/${name}` });
    this.texts.set(uri.toString(), text);
    this.changed.fire(uri);
    const document = await vscode.workspace.openTextDocument(uri);
    await vscode.languages.setTextDocumentLanguage(document, language);
    await vscode.window.showTextDocument(document, {
      viewColumn: vscode.ViewColumn.Beside,
      preserveFocus: true,
      preview: true,
    });
  }

  forget(document: vscode.TextDocument): void {
    if (document.uri.scheme === scheme) this.texts.delete(document.uri.toString());
  }
}

export function registerTexts(context: vscode.ExtensionContext): void {
  const texts = new Texts();

  async function explain(): Promise<void> {
    const editor = await activeProgram();
    if (!editor) return;
    const file = editor.document.uri;
    const line = editor.selection.active.line + 1;
    const what = call("explain", `${file.fsPath}:${line}`, ...programOptions(file));
    const result = await run(what, path.dirname(file.fsPath));
    if (result.out === "") return tellFailure("the explanation", result);
    await texts.show(`${path.basename(file.fsPath)} line ${line}.txt`, result.out, "plaintext");
  }

  async function canonical(): Promise<void> {
    const editor = await activeProgram();
    if (!editor) return;
    const file = editor.document.uri;
    const what = call("run", file.fsPath, "--emit", "canonical", ...programOptions(file));
    const result = await run(what, path.dirname(file.fsPath));
    if (result.out === "") return tellFailure("writing plain blocks", result);
    await texts.show(`${path.basename(file.fsPath)} plain blocks`, result.out, editor.document.languageId);
  }

  context.subscriptions.push(
    vscode.workspace.registerTextDocumentContentProvider(scheme, texts),
    vscode.workspace.onDidCloseTextDocument((document) => texts.forget(document)),
    vscode.commands.registerCommand("isogloss.explain", explain),
    vscode.commands.registerCommand("isogloss.canonical", canonical),
  );
}
