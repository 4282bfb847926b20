"""A client of the language server that sends what it is told to, right or wrong, and waits for what comes back."""
import itertools
import json
import pathlib
import queue
import subprocess
import threading


def frame(message):
    body = message if isinstance(message, bytes) else json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n%s" % (len(body), body)


def uri_of(path):
    return pathlib.Path(path).absolute().as_uri()


class Failed(Exception):
    def __init__(self, error):
        super().__init__(error["message"])
        self.code, self.message = error["code"], error["message"]


class Client:
    """One server. `seconds` is how long an answer may take before the test fails."""

    def __init__(self, command, seconds=30, cwd=None, env=None):
        self.seconds = seconds
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        cwd=cwd, env=env)
        self.arrived, self.other, self.notifications = queue.Queue(), {}, []
        self.errors = b""
        self.ids = itertools.count(1)
        threading.Thread(target=self._read, daemon=True).start()
        threading.Thread(target=self._read_errors, daemon=True).start()

    def _read_errors(self):
        for line in self.process.stderr:
            self.errors += line

    def _read(self):
        stream = self.process.stdout
        while True:
            size = None
            while line := stream.readline().strip():
                name, value = line.split(b":")
                if name.lower() == b"content-length":
                    size = int(value)
            if size is None:
                self.arrived.put(None)
                return
            self.arrived.put(json.loads(stream.read(size)))

    def send(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def notify(self, method, params=None):
        self.send(frame({"jsonrpc": "2.0", "method": method, "params": params if params is not None else {}}))

    def start(self, method, params=None):
        number = next(self.ids)
        self.send(frame({"jsonrpc": "2.0", "id": number, "method": method, "params": params if params is not None else {}}))
        return number

    def next_message(self):
        message = self.arrived.get(timeout=self.seconds)
        if message is None:
            raise EOFError(f"the server is gone, status {self.process.wait(5)}: {self.errors.decode()[-2000:]}")
        return message

    def response(self, number):
        """The whole response to the request of this number, errors included."""
        while number not in self.other:
            message = self.next_message()
            if "method" in message:
                self.notifications.append(message)
            else:
                self.other[message.get("id")] = message
        return self.other.pop(number)

    def result_of(self, number):
        answer = self.response(number)
        if "error" in answer:
            raise Failed(answer["error"])
        return answer["result"]

    def request(self, method, params=None):
        return self.result_of(self.start(method, params))

    def initialize(self, options=None, encodings=None, **capabilities):
        general = {"general": {"positionEncodings": encodings}} if encodings else {}
        result = self.request("initialize", {"processId": None, "rootUri": None, "initializationOptions": options or {},
                                             "capabilities": {**general, **capabilities}})
        self.notify("initialized")
        return result

    def open(self, uri, text, language="nc", version=1):
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": language, "version": version,
                                                              "text": text}})

    def change(self, uri, version, *changes):
        self.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": version},
                                               "contentChanges": list(changes)})

    def diagnostics(self, uri, version=None):
        """What is published about the document, of this version where one is given."""
        while True:
            for i, message in enumerate(self.notifications):
                params = message.get("params") or {}
                if message["method"] == "textDocument/publishDiagnostics" and params["uri"] == uri and (
                        version is None or params.get("version") == version):
                    del self.notifications[i]
                    return params["diagnostics"]
            message = self.next_message()
            if "method" in message:
                self.notifications.append(message)
            else:
                self.other[message.get("id")] = message

    def at(self, method, uri, line, character, **more):
        return self.request("textDocument/" + method, {"textDocument": {"uri": uri},
                                                       "position": {"line": line, "character": character}, **more})

    def about(self, method, uri, **more):
        return self.request("textDocument/" + method, {"textDocument": {"uri": uri}, **more})

    def end(self):
        """Shuts the server down as the protocol says; its status."""
        self.request("shutdown")
        self.notify("exit")
        return self.process.wait(self.seconds)

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


def place(text, what, occurrence=0, inside=0):
    """Line and character (UTF-16) of the n-th occurrence of `what`."""
    offset = -1
    for _ in range(occurrence + 1):
        offset = text.index(what, offset + 1)
    offset += inside
    before = text[:offset]
    line = before.count("\n")
    rest = before[before.rfind("\n") + 1:]
    return line, len(rest.encode("utf-16-le")) // 2


def applied(text, edits):
    """The text after edits of the protocol (UTF-16)."""
    lines = text.split("\n")
    begins = list(itertools.accumulate([0] + [len(line) + 1 for line in lines]))

    def offset(position):
        line = lines[position["line"]]
        units = line.encode("utf-16-le")[:2 * position["character"]].decode("utf-16-le")
        return begins[position["line"]] + len(units)

    for edit in sorted(edits, key=lambda e: offset(e["range"]["start"]), reverse=True):
        text = text[:offset(edit["range"]["start"])] + edit["newText"] + text[offset(edit["range"]["end"]):]
    return text
