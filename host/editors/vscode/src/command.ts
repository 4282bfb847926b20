// The command `isogloss`: where it is, how it is called, and what it answers.
import { execFile } from "node:child_process";
import * as vscode from "vscode";

export const languages = ["isogloss-iso", "isogloss-siemens", "isogloss-klartext"];

export interface Call {
  command: string;
  arguments: string[];
}

/** A call of a subcommand with the user's path and further arguments. */
export function call(subcommand: string, ...rest: string[]): Call {
  const settings = vscode.workspace.getConfiguration("isogloss");
  const command = settings.get<string>("command") || "isogloss";
  return { command, arguments: [subcommand, ...rest, ...(settings.get<string[]>("arguments") ?? [])] };
}

/** Dialect, machine and tables as the settings of this file have them, as options of the command. */
export function programOptions(file: vscode.Uri): string[] {
  const settings = vscode.workspace.getConfiguration("isogloss", file);
  const out: string[] = [];
  const machine = settings.get<string>("machine") ?? "";
  const dialect = settings.get<string>("dialect") ?? "";
  if (machine) out.push("-m", machine);
  else if (dialect) out.push("-d", dialect);
  for (const option of ["offsets", "tools", "variables"]) {
    const value = settings.get<string>(option) ?? "";
    if (value) out.push(`--${option}`, value);
  }
  for (const option of ["subprograms", "set"])
    for (const value of settings.get<string[]>(option) ?? []) out.push(`--${option}`, value);
  return out;
}

export interface Result {
  status: number;
  out: string;
  error: string;
}

const largestAnswer = 256 * 1024 * 1024;

/** Runs the command and waits for it. Never rejects: a command that cannot start has the status -1. */
export function run(what: Call, cwd: string | undefined): Promise<Result> {
  return new Promise((resolve) => {
    execFile(what.command, what.arguments, { cwd, maxBuffer: largestAnswer }, (fault, out, error) => {
      const status = !fault ? 0 : typeof fault.code === "number" ? fault.code : -1;
      resolve({ status, out, error: status === -1 && fault ? `${fault.message}\n${error}` : error });
    });
  });
}

/** The program of the active editor, saved; undefined, and told, where there is none. */
export async function activeProgram(): Promise<vscode.TextEditor | undefined> {
  const editor = vscode.window.activeTextEditor;
  if (!editor || !languages.includes(editor.document.languageId) || editor.document.uri.scheme !== "file") {
    void vscode.window.showWarningMessage("Isogloss: open a part program that is a file first.");
    return undefined;
  }
  if (editor.document.isDirty && !(await editor.document.save())) return undefined;
  return editor;
}

export function tellFailure(what: string, result: Result): void {
  const reason = result.error.trim().split("\n").slice(0, 3).join(" ") || `status ${result.status}`;
  void vscode.window.showErrorMessage(`Isogloss: ${what} failed: ${reason}`);
}
