// The debug adapter, driven by the client that VS Code's own adapters are tested with.
//   node debug_test.mjs ISOGLOSS SOURCE
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";

const require = createRequire(import.meta.url);
const { DebugClient } = require("@vscode/debugadapter-testsupport");
const isogloss = process.argv[2];
const folder = mkdtempSync(path.join(tmpdir(), "isogloss-"));

const programs = [
  ["fanuc.nc", "fanuc", "%\nO1\nG21 G90 G94 G17\nG00 X0 Y0 Z50.\n#1=4.\nM98 P2\nG01 X#1 F300\nM30\nO2\nG81 X1. Y1. Z-9. R2. F90\nG80\nM99\n%\n",
    { call: 6, called: 10, condition: "Z < -5" }],
  ["siemens.mpf", "siemens", "G90 G94 G17 G71\nG0 X0 Y0 Z50\nR1=4\nTEIL\nG1 X=R1 F300\nM30\n", { call: 4, called: 2, condition: "X > 3" }],
  ["klartext.h", "heidenhain", "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+0 Y+0 Z+50 R0 FMAX\n3 CALL LBL 1\n4 L X+4 R0 F300\n5 M30\n6 LBL 1\n7 L Z-9 F90\n8 LBL 0\n9 END PGM A MM\n",
    { call: 4, called: 8, condition: "Z < -5" }],
];
writeFileSync(path.join(folder, "TEIL.SPF"), "PROC TEIL\nG1 Z-9 F90\nRET\n");

async function debug(name, dialect, text, { call, called, condition }) {
  const program = path.join(folder, name);
  writeFileSync(program, text);
  const client = new DebugClient(isogloss, "dap", "isogloss");
  client.defaultTimeout = 30000;
  await client.start();
  try {
    const able = await client.initializeRequest();
    assert.ok(able.body.supportsStepBack && able.body.supportsFunctionBreakpoints);
    const initialized = client.waitForEvent("initialized");
    await client.launchRequest({ program, dialect });
    await initialized;
    const set = await client.setBreakpointsRequest({ source: { path: program }, breakpoints: [{ line: call }, { line: 1000 }] });
    assert.deepEqual(set.body.breakpoints.map((b) => b.verified), [true, false]);
    const logic = await client.setFunctionBreakpointsRequest({ breakpoints: [{ name: condition }] });
    assert.equal(logic.body.breakpoints[0].verified, true, logic.body.breakpoints[0].message);
    await Promise.all([client.configurationDoneRequest(), client.assertStoppedLocation("breakpoint", { line: call })]);
    // Into the called program: the stack shows both.
    await Promise.all([client.stepInRequest({ threadId: 1 }), client.waitForEvent("stopped")]);
    const stack = (await client.stackTraceRequest({ threadId: 1 })).body.stackFrames;
    assert.equal(stack.length, 2, name);
    assert.equal(stack[1].line, call);
    await Promise.all([client.continueRequest({ threadId: 1 }), client.assertStoppedLocation("function breakpoint", {})]);
    const scopes = (await client.scopesRequest({ frameId: 1 })).body.scopes;
    const state = scopes.find((s) => s.name === "Modal state");
    assert.ok((await client.variablesRequest({ variablesReference: state.variablesReference })).body.variables.length > 5);
    const z = await client.evaluateRequest({ expression: "has(Z) and line > 0", context: "watch" });
    assert.equal(z.body.result, "true");
    // Back to the call, and forth to the end.
    await Promise.all([client.reverseContinueRequest({ threadId: 1 }), client.assertStoppedLocation("breakpoint", { line: call })]);
    await client.setFunctionBreakpointsRequest({ breakpoints: [] });
    await Promise.all([client.continueRequest({ threadId: 1 }), client.waitForEvent("terminated")]);
    console.log(`  ${dialect}: called program at line ${called} and back`);
  } finally {
    await client.stop();
  }
}

try {
  for (const [name, dialect, text, places] of programs) await debug(name, dialect, text, places);
} finally {
  rmSync(folder, { recursive: true });
}
