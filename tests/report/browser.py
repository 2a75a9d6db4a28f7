"""Headless Chromium by its debugging protocol, over a pipe: no package but the standard library's is needed."""
import base64
import json
import os
import subprocess
import time


class Browser:
    def __init__(self, profile, width=1280, height=1000):
        to_read, self.write_end = os.pipe()
        self.read_end, to_write = os.pipe()
        self.number, self.session, self.buffer, self.errors = 0, None, b"", []
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", f"--user-data-dir={profile}",
                   "--host-resolver-rules=MAP * ~NOTFOUND", f"--window-size={width},{height}", "--hide-scrollbars",
                   "--remote-debugging-pipe", "about:blank"]

        # The protocol's descriptors are 3 and 4; the pipes may have these numbers themselves.
        script = f'exec "$@" 3<&{to_read} 4>&{to_write}' if to_read > 4 and to_write > 4 else \
            f'exec 8<&{to_read} 9>&{to_write}; exec "$@" 3<&8 4>&9'
        self.process = subprocess.Popen(["bash", "-c", script, "bash", *command], pass_fds=[to_read, to_write],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        page = next(each for each in self.call("Target.getTargets")["targetInfos"] if each["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log"]:
            self.call(domain + ".enable")

    def call(self, method, **parameters):
        """What the browser answers; what it tells in between is kept if it is an error of the page."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.write_end, data):]
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.note(answer)

    def receive(self):
        while b"\0" not in self.buffer:
            more = os.read(self.read_end, 1 << 20)
            if not more:
                raise RuntimeError("the browser ended")
            self.buffer += more
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def note(self, event):
        what, how = event.get("method"), event.get("params", {})
        if what == "Runtime.exceptionThrown":
            details = how["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        elif what == "Runtime.consoleAPICalled" and how["type"] in ("error", "warning", "assert"):
            self.errors.append(" ".join(str(each.get("value", each.get("description"))) for each in how["args"]))
        elif what == "Log.entryAdded" and how["entry"]["level"] in ("error", "warning"):
            self.errors.append(how["entry"]["text"])

    def ask(self, expression):
        """The value of a JavaScript expression, awaited; an exception is an error of the page."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            self.errors.append(answer["exceptionDetails"].get("exception", {}).get("description", expression))
        return answer["result"].get("value")

    def open(self, file):
        """Seconds until the page has drawn itself."""
        begin = time.monotonic()
        self.call("Page.navigate", url=file.resolve().as_uri())
        while not self.ask("document.documentElement?.dataset.ready && document.readyState === 'complete' && location.href !== 'about:blank'"):
            if time.monotonic() - begin > 120:
                raise RuntimeError("the page does not come to its end")
            time.sleep(0.02)
        self.settle()
        return time.monotonic() - begin

    def settle(self):
        self.ask("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")

    def box(self, selector):
        return self.ask(f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: 'center'}}); "
                        "const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, selector, dx=None, dy=None):
        """A click on the middle of an element, or at a place within."""
        x, y, width, height = self.box(selector)
        x, y = x + (width / 2 if dx is None else dx), y + (height / 2 if dy is None else dy)
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)
        self.settle()

    def hover(self, selector):
        x, y, width, height = self.box(selector)
        self.mouse("mouseMoved", x + width / 2 - 3, y + height / 2)
        self.mouse("mouseMoved", x + width / 2, y + height / 2)
        self.settle()

    def wheel(self, selector, delta):
        x, y, width, height = self.box(selector)
        self.mouse("mouseWheel", x + width / 2, y + height / 2, deltaX=0, deltaY=delta)
        time.sleep(0.2)
        self.settle()

    def keys(self, *names):
        codes = {"Enter": 13, "Tab": 9, "ArrowDown": 40, "ArrowUp": 38, "ArrowLeft": 37, "ArrowRight": 39, "Home": 36}
        for name in names:
            text = {"Enter": "\r"}.get(name, name if len(name) == 1 else "")
            how = {"key": name, "windowsVirtualKeyCode": codes.get(name, ord(name[0].upper()))}
            self.call("Input.dispatchKeyEvent", type="keyDown", text=text, **how)
            self.call("Input.dispatchKeyEvent", type="keyUp", **how)
        self.settle()

    def dark(self, on):
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if on else "light"}])
        self.settle()

    def screenshot(self, file):
        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def pdf(self):
        return base64.b64decode(self.call("Page.printToPDF", printBackground=False)["data"])

    def close(self):
        self.session = None
        try:
            self.call("Browser.close")
        except RuntimeError:
            pass
        self.process.wait(30)
