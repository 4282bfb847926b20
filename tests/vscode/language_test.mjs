// The language server, driven by the protocol library of VS Code.
//   node language_test.mjs ISOGLOSS SOURCE
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const rpc = require("vscode-jsonrpc/node");
const lsp = require("vscode-languageserver-protocol");
const isogloss = process.argv[2];

if (spawnSync(isogloss, ["lsp", "--help"]).status !== 0) {
  console.log("  this build of isogloss has no language server: nothing to drive");
  process.exit(0);
}

const server = spawn(isogloss, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
const connection = rpc.createMessageConnection(
  new rpc.StreamMessageReader(server.stdout),
  new rpc.StreamMessageWriter(server.stdin),
);
const published = new Map();
const waiting = new Map();
connection.onNotification(lsp.PublishDiagnosticsNotification.type, (p) => {
  published.set(p.uri, p.diagnostics);
  waiting.get(p.uri)?.(p.diagnostics);
});
connection.onRequest(lsp.ConfigurationRequest.type, (p) => p.items.map(() => null));
connection.onRequest(lsp.RegistrationRequest.type, () => undefined);
connection.onRequest(lsp.WorkDoneProgressCreateRequest.type, () => undefined);
connection.listen();

const limit = setTimeout(() => {
  console.error("the language server has not answered in time");
  process.exit(1);
}, 60000);

const started = await connection.sendRequest(lsp.InitializeRequest.type, {
  processId: process.pid,
  rootUri: null,
  capabilities: { textDocument: { hover: { contentFormat: ["markdown"] }, publishDiagnostics: { relatedInformation: true } } },
  initializationOptions: {},
});
assert.ok(started.capabilities.hoverProvider, "the server offers hover");
await connection.sendNotification(lsp.InitializedNotification.type, {});

const programs = {
  "file:///tmp/a.nc": ["isogloss-iso", "%\nO1\nG21 G90 G94 G17\nG00 X0 Y0 Z50.\nG01 X10. F300 E7\nM98 P2\nM30\nO2\nM99\n%\n", 4, 1],
  "file:///tmp/b.mpf": ["isogloss-siemens", "G90 G94 G17 G71\nG0 X0 Y0 Z50\nR1=4\nG1 X=R1 F300\nM30\n", 3, 1],
  "file:///tmp/c.h": ["isogloss-klartext", "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+0 Y+0 Z+50 R0 FMAX\n3 END PGM A MM\n", 2, 3],
};
for (const [uri, [languageId, text, line, character]] of Object.entries(programs)) {
  const told = new Promise((resolve) => waiting.set(uri, resolve));
  await connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId, version: 1, text },
  });
  const diagnostics = await told;
  const hover = await connection.sendRequest(lsp.HoverRequest.type, {
    textDocument: { uri },
    position: { line, character },
  });
  assert.ok(hover && JSON.stringify(hover.contents).length > 20, `${uri}: hover says something`);
  const symbols = await connection.sendRequest(lsp.DocumentSymbolRequest.type, { textDocument: { uri } });
  assert.ok(Array.isArray(symbols));
  console.log(`  ${languageId}: ${diagnostics.length} diagnostics, ${symbols.length} symbols`);
}
assert.ok(published.get("file:///tmp/a.nc").some((d) => d.message.includes("E7")), "the unused word is reported");
await connection.sendRequest(lsp.ShutdownRequest.type);
await connection.sendNotification(lsp.ExitNotification.type);
await new Promise((resolve) => server.on("exit", resolve));
clearTimeout(limit);
connection.dispose();
process.exit(0);
