// The page of `isogloss view` beside the text. The page is self-contained; nothing is loaded from anywhere.
import { randomBytes } from "node:crypto";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import * as path from "node:path";
import * as vscode from "vscode";
import { activeProgram, call, programOptions, run, tellFailure } from "./command";

const panels = new Map<string, vscode.WebviewPanel>();

/** Scripts and styles of the page itself may run, and nothing else. */
function withPolicy(page: string): string {
  const policy =
    "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval' blob:; worker-src blob:; " +
    "style-src 'unsafe-inline'; img-src data: blob:; font-src data:";
  const tag = `<meta http-equiv="Content-Security-Policy" content="${policy}">`;
  return /<head[^>]*>/i.test(page) ? page.replace(/<head[^>]*>/i, (head) => head + tag) : tag + page;
}

async function makePage(file: vscode.Uri): Promise<string | undefined> {
  const folder = await mkdtemp(path.join(tmpdir(), "isogloss-"));
  const page = path.join(folder, `${randomBytes(8).toString("hex")}.html`);
  try {
    const what = call("view", file.fsPath, "-o", page, ...programOptions(file));
    const result = await run(what, path.dirname(file.fsPath));
    // Errors of the program are shown in the page itself.
    if (result.status !== 0 && result.status !== 1) {
      tellFailure("the view", result);
      return undefined;
    }
    return withPolicy(await readFile(page, "utf8"));
  } catch (fault) {
    void vscode.window.showErrorMessage(`Isogloss: the view failed: ${String(fault)}`);
    return undefined;
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

async function show(file: vscode.Uri): Promise<void> {
  const page = await vscode.window.withProgress(
    { location: vscode.ProgressLocation.Window, title: "Isogloss: tool path" },
    () => makePage(file),
  );
  if (page === undefined) return;
  const key = file.toString();
  let panel = panels.get(key);
  if (!panel) {
    panel = vscode.window.createWebviewPanel(
      "isogloss.view",
      `Path of ${path.basename(file.fsPath)}`,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    panels.set(key, panel);
    panel.onDidDispose(() => panels.delete(key));
  }
  panel.webview.html = page;
}

export function registerView(context: vscode.ExtensionContext): void {
  context.subscriptions.push(
    vscode.commands.registerCommand("isogloss.view", async () => {
      const editor = await activeProgram();
      if (editor) await show(editor.document.uri);
    }),
    // A view that is open follows its program.
    vscode.workspace.onDidSaveTextDocument(async (document) => {
      if (panels.has(document.uri.toString())) await show(document.uri);
    }),
  );
}
