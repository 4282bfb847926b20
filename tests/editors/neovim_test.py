#!/usr/bin/env python3
"""neovim is a client of the language server that nobody here has written: it shows, asks and edits without a screen."""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77

PROGRAM = """%
O0001
G21 G17 G90 G54
#101=50.
G1 X#101 Y30. F600 E7
G1X60.
M30
%
"""

# Each answer is written as JSON to the last line: what vim.lsp made of it.
SCRIPT = r"""
local out = {}
vim.lsp.set_log_level('error')
vim.lsp.handlers['textDocument/publishDiagnostics'] = vim.lsp.with(vim.lsp.diagnostic.on_publish_diagnostics, {})
local id = vim.lsp.start_client({name = 'isogloss', cmd = {ISOGLOSS, 'lsp', '--stdio'},
  init_options = {dialect = 'fanuc'}, handlers = vim.lsp.handlers})
vim.cmd('edit ' .. FILE)
local buffer = vim.api.nvim_get_current_buf()
vim.lsp.buf_attach_client(buffer, id)
local function wait(what) if not vim.wait(SECONDS * 1000, what, 20) then out.failed = debug.traceback() end end
wait(function() return #vim.diagnostic.get(buffer) > 0 end)
out.diagnostics = vim.tbl_map(function(d) return {d.lnum, d.code, d.col} end, vim.diagnostic.get(buffer))
local function ask(method, line, character, more)
  local params = vim.tbl_extend('force', {textDocument = {uri = vim.uri_from_bufnr(buffer)},
    position = {line = line, character = character}}, more or {})
  local all = vim.lsp.buf_request_sync(buffer, method, params, SECONDS * 1000) or {}
  return (all[id] or {}).result
end
out.hover = ask('textDocument/hover', 4, 1).contents.value
out.definition = ask('textDocument/definition', 4, 6)[1].range.start.line
out.completion = #ask('textDocument/completion', 4, 0).items
out.symbols = #ask('textDocument/documentSymbol', 0, 0)
vim.api.nvim_buf_set_text(buffer, 4, 18, 4, 21, {''})
wait(function() return #vim.diagnostic.get(buffer) == 0 end)
out.after = #vim.diagnostic.get(buffer)
vim.api.nvim_win_set_cursor(0, {5, 5})
local edit = ask('textDocument/rename', 4, 6, {newName = '#102'})
vim.lsp.util.apply_workspace_edit(edit, 'utf-16')
vim.lsp.util.apply_text_edits(ask('textDocument/formatting', 0, 0, {options = {tabSize = 2, insertSpaces = true}}), buffer, 'utf-16')
out.text = vim.api.nvim_buf_get_lines(buffer, 0, -1, false)
vim.lsp.stop_client(id)
wait(function() return vim.lsp.client_is_stopped(id) end)
io.open(RESULT, 'w'):write(vim.json.encode(out))
vim.cmd('qall!')
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--seconds", type=int, default=20)
    options = parser.parse_args()
    neovim = shutil.which("nvim")
    if neovim is None:
        print("skipped: neovim is not installed")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        program, script, result = (pathlib.Path(folder, name) for name in ("part.nc", "script.lua", "result.json"))
        program.write_text(PROGRAM)
        values = {"ISOGLOSS": options.isogloss, "FILE": str(program), "RESULT": str(result), "SECONDS": options.seconds}
        script.write_text("".join(f"local {name} = {json.dumps(value)}\n" for name, value in values.items()) + SCRIPT)
        done = subprocess.run([neovim, "--headless", "-u", "NONE", "-i", "NONE", "-n", "-S", str(script), "-c", "qall!"],
                              timeout=options.seconds * 8, capture_output=True, text=True, cwd=folder,
                              env={"HOME": folder, "PATH": "/usr/bin:/bin", "XDG_CACHE_HOME": folder})
        if not result.is_file():
            sys.exit("neovim wrote nothing:\n" + done.stdout + done.stderr)
        out = json.loads(result.read_text())
    print(json.dumps(out, indent=1))
    assert "failed" not in out, out["failed"]
    assert [4, "ISO-0285", 19] in out["diagnostics"], out["diagnostics"]
    assert "**G01**" in out["hover"] and "Machine:" in out["hover"], out["hover"]
    assert out["definition"] == 3 and out["completion"] > 50 and out["symbols"] >= 1
    assert out["after"] == 0
    wanted = PROGRAM.replace("#101", "#102").replace(" E7", "").replace("G1X60.", "G1 X60.").splitlines()
    assert out["text"] == wanted, out["text"]


main()
