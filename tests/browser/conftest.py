"""One Chromium for the session; its tabs are lent to one test after another; a page may log no error and no
warning, and ask no other host."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Error, Page, expect, sync_playwright

from tests.browser.start import running, start_chromium

VIEWPORT = {"width": 1000, "height": 700}
WAIT = 60_000  # milliseconds that a page may take for anything: a busy machine is slow, and what is there does not wait
expect.set_options(timeout=WAIT)
PASSED = pytest.StashKey[bool]()
# warnings that say nothing of the app: tests read pixels back; a slow machine uses late what was fetched ahead
NO_FAULTS = ("willReadFrequently", "was preloaded using link preload but not used within a few seconds")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo):
    """Notes for the fixtures below whether the test itself went well."""
    report = yield
    if report.when == "call":
        item.stash[PASSED] = report.passed
    return report


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    """The browser of all tests."""
    with sync_playwright() as playwright:
        try:
            browser = start_chromium(playwright)
        except Error as error:
            pytest.skip(f"no browser: install chromium or run `playwright install chromium` ({error.message[:200]})")
        yield browser
        browser.close()


class Watch:
    """What went wrong in a page: errors and warnings logged, requests that failed, requests to any other host.

    ``expected``: parts of messages that a test provokes on purpose.
    """

    def __init__(self, host: str):
        self.host = host
        self.expected: list[str] = []
        self.seen: list[str] = []

    def attach(self, page: Page) -> None:
        for event, listener in self._listeners():
            page.on(event, listener)

    def detach(self, page: Page) -> None:
        for event, listener in self._listeners():
            page.remove_listener(event, listener)

    def _listeners(self):
        return (
            ("console", self._console),
            ("pageerror", self._error),
            ("requestfailed", self._failed),
            ("request", self._request),
        )

    def _console(self, message) -> None:
        if message.type in ("error", "warning"):
            self.seen.append(f"console: {message.text} ({message.location.get('url', '')})")

    def _error(self, error) -> None:
        self.seen.append(f"exception: {error}")

    def _failed(self, request) -> None:
        if "ERR_ABORTED" not in (request.failure or ""):
            self.seen.append(f"request failed: {request.url} {request.failure}")

    def _request(self, request) -> None:
        address = urlsplit(request.url)
        if address.scheme not in ("data", "blob") and address.netloc != self.host:
            self.seen.append(f"request to another host: {request.url}")

    def problems(self) -> list[str]:
        return [text for text in self.seen if not any(part in text for part in (*self.expected, *NO_FAULTS))]


class Tabs:
    """Tabs of the browser, each in a context of its own, that tests borrow: what a tab has compiled once it need not
    compile again, which is most of what opening the app costs."""

    def __init__(self, browser: Browser):
        self.browser = browser
        self.free: list[Page] = []

    def borrow(self, viewport: dict, **options) -> Page:
        """A blank tab; with options other than the viewport always a new one."""
        if options or not self.free:
            page = self.browser.new_context(viewport=viewport, **options).new_page()
            page.lent = not options
            return page
        page = self.free.pop()
        page.set_viewport_size(viewport)
        return page

    def give_back(self, page: Page, well: bool) -> None:
        """Back with nothing left of the test; a tab that saw a failure is thrown away."""
        if page.is_closed():
            return
        page.watch.detach(page)
        if not (well and page.lent):
            page.context.close()
            return
        page.unroute_all()
        page.context.clear_cookies()
        page.evaluate("localStorage.clear(); sessionStorage.clear()")
        page.goto("about:blank")
        self.free.append(page)


@pytest.fixture(scope="session")
def tabs(chromium: Browser) -> Tabs:
    """The browser's tabs."""
    return Tabs(chromium)


@pytest.fixture
def open_page(tabs: Tabs, request: pytest.FixtureRequest) -> Iterator[Callable[..., Page]]:
    """``open_page(address, **context options)`` gives a page that knows nothing of others; ``page.watch`` is its Watch.

    The test fails at its end where the page had problems.
    """
    pages = []

    def open_one(address: str, **options) -> Page:
        page = tabs.borrow(**({"viewport": VIEWPORT} | options))
        pages.append(page)
        page.set_default_timeout(WAIT)
        page.watch = Watch(urlsplit(address).netloc)
        page.watch.attach(page)
        page.goto(address)
        return page

    yield open_one
    problems = [problem for page in pages for problem in page.watch.problems()]
    for page in pages:
        tabs.give_back(page, request.node.stash.get(PASSED, False) and not problems)
    assert not problems, "\n".join(problems)


class Door:
    """One address for the apps of all tests: a tab knows its scripts again only where they come from the same place."""

    application = None

    def __call__(self, environ, start_response):
        return self.application(environ, start_response)


@pytest.fixture(scope="session")
def door() -> Iterator[tuple[Door, str]]:
    """The door, which leads to ``door.application``, and its address."""
    door = Door()
    with running(door) as address:
        yield door, address
