"""One Chromium for the session, one context a test; a page may log no error and ask no other host."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Error, Page, expect, sync_playwright

from tests.browser.start import running, start_chromium

__all__ = ["running"]
WAIT = 30_000  # milliseconds that a page may take for anything: a busy machine is slow, and what is there does not wait
expect.set_options(timeout=WAIT)


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
    """What went wrong in a page: errors logged, requests that failed, requests to any other host.

    ``expected``: parts of messages that a test provokes on purpose.
    """

    def __init__(self, host: str):
        self.host = host
        self.expected: list[str] = []
        self.seen: list[str] = []

    def attach(self, page: Page) -> None:
        page.on("console", lambda m: self.seen.append(f"console: {m.text}") if m.type == "error" else None)
        page.on("pageerror", lambda error: self.seen.append(f"exception: {error}"))
        page.on("requestfailed", self._failed)
        page.on("request", self._request)

    def _failed(self, request) -> None:
        if "ERR_ABORTED" not in (request.failure or ""):
            self.seen.append(f"request failed: {request.url} {request.failure}")

    def _request(self, request) -> None:
        address = urlsplit(request.url)
        if address.scheme not in ("data", "blob") and address.netloc != self.host:
            self.seen.append(f"request to another host: {request.url}")

    def problems(self) -> list[str]:
        return [text for text in self.seen if not any(part in text for part in self.expected)]


@pytest.fixture
def open_page(chromium: Browser) -> Iterator[Callable[..., Page]]:
    """``open_page(address, **context options)`` gives a page in a context of its own; ``page.watch`` is its Watch.

    The test fails at its end where the page had problems.
    """
    contexts, watches = [], []

    def open_one(address: str, **options) -> Page:
        context = chromium.new_context(**{"viewport": {"width": 1000, "height": 700}, **options})
        contexts.append(context)
        page = context.new_page()
        page.watch = Watch(urlsplit(address).netloc)
        page.watch.attach(page)
        watches.append(page.watch)
        page.goto(address)
        return page

    yield open_one
    for context in contexts:
        context.close()
    problems = [problem for watch in watches for problem in watch.problems()]
    assert not problems, "\n".join(problems)
