"""A headless Chromium, driven by chromedriver over the WebDriver protocol (W3C): HTTP and JSON, nothing else."""

import base64
import json
import socket
import subprocess
import time
import urllib.error
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key under which the protocol hands out elements


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Browser:
    """One window. `downloads` is where files go that the page hands over;"""

    def __init__(self, chromium, chromedriver, downloads, size=(1500, 1100)):
        port = free_port()
        self.base = f"http://127.0.0.1:{port}"
        self.driver = subprocess.Popen(
            [chromedriver, f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.session = None
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--hide-scrollbars", f"--window-size={size[0]},{size[1]}"]
        options = {
            "binary": chromium,
            "args": arguments,
            "prefs": {"download.default_directory": str(downloads), "download.prompt_for_download": False},
        }
        wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
        try:
            self.wait(self._driver_answers, "chromedriver does not answer")
            answer = self._send("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
            self.session = answer["sessionId"]
        except BaseException:
            self.close()
            raise

    def _driver_answers(self):
        try:
            return self._send("GET", "/status")["ready"]
        except OSError:
            return False

    def _send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(f"{method} {path}: {error.read().decode()}") from error

    def _ask(self, method, path, body=None):
        return self._send(method, f"/session/{self.session}{path}", body)

    def close(self):
        if self.session:
            self._ask("DELETE", "")
        self.driver.terminate()
        self.driver.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    @staticmethod
    def wait(holds, complaint, seconds=30):
        """Waits until holds() is true and returns what it returned."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = holds()
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError(complaint)

    def open(self, address):
        self._ask("POST", "/url", {"url": address})

    def run(self, script, *arguments):
        """The value of a JavaScript function body."""
        return self._ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def log(self, kind="browser"):
        """Messages that the page wrote since the last call."""
        return self._ask("POST", "/se/log", {"type": kind})

    def emulate(self, feature, value, medium=""):
        """A media feature such as prefers-color-scheme; `medium`: print, as on paper."""
        parameters = {"media": medium, "features": [{"name": feature, "value": value}]}
        self._ask("POST", "/goog/cdp/execute", {"cmd": "Emulation.setEmulatedMedia", "params": parameters})

    def resize(self, width, height, ratio=1):
        """The size of the page itself, as a phone has it; `ratio`: pixels of the screen to one of the page."""
        parameters = {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False}
        self._ask("POST", "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride", "params": parameters})

    def screenshot_text(self):
        """Picture of the window, a PNG in base64."""
        return self._ask("GET", "/screenshot")

    def screenshot(self, path):
        """Picture of the window."""
        path.write_bytes(base64.b64decode(self.screenshot_text()))

    def usual_size(self):
        self._ask("POST", "/goog/cdp/execute", {"cmd": "Emulation.clearDeviceMetricsOverride", "params": {}})

    def whole_screenshot(self, path):
        """The page from top to bottom."""
        answer = self._ask("POST", "/goog/cdp/execute", {
            "cmd": "Page.captureScreenshot", "params": {"format": "png", "captureBeyondViewport": True}})
        path.write_bytes(base64.b64decode(answer["data"]))

    def mouse(self, *actions):
        """actions: ("move", x, y), ("down",), ("up",), in pixels of the window."""
        steps = {"move": lambda x, y: {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
                 "down": lambda: {"type": "pointerDown", "button": 0}, "up": lambda: {"type": "pointerUp", "button": 0}}
        sequence = [steps[name](*rest) for name, *rest in actions]
        source = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": sequence}
        self._ask("POST", "/actions", {"actions": [source]})

    def click_at(self, x, y):
        self.mouse(("move", x, y), ("down",), ("up",))

    def element(self, selector):
        return self._ask("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector):
        self._ask("POST", f"/element/{self.element(selector)}/click", {})

    def press(self, selector, keys):
        self._ask("POST", f"/element/{self.element(selector)}/value", {"text": keys})

    def choose(self, selector, value):
        """An option of a select element, as a reader would choose it."""
        self.click(f'{selector} option[value="{value}"]')
        chosen = "return document.querySelector(arguments[0]).value === arguments[1]"
        self.wait(lambda: self.run(chosen, selector, value), f"{selector} does not become {value}")
