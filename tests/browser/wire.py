"""What a tab sends and receives, counted from Chromium's own network events; for tests and benchmarks."""

from __future__ import annotations

from playwright.sync_api import Page

POLL = 100  # milliseconds


class Wire:
    """Counts of a tab from now on.

    addresses: of the requests that went to the server, in order; what the browser had kept is not among them.
    received: bytes that came, compressed as they were and with headers. under_way: ids of requests not yet answered.
    """

    def __init__(self, page: Page):
        self.sent: dict[str, str] = {}
        self.under_way: set[str] = set()
        self.received = 0
        session = page.context.new_cdp_session(page)
        session.send("Network.enable")
        session.on("Network.requestWillBeSent", self._will_be_sent)
        session.on("Network.requestServedFromCache", self._served_from_cache)
        session.on("Network.responseReceived", self._response)
        session.on("Network.loadingFinished", self._finished)
        session.on("Network.loadingFailed", lambda event: self.under_way.discard(event["requestId"]))

    @property
    def addresses(self) -> list[str]:
        return list(self.sent.values())

    def wait_until_quiet(self, page: Page, quiet: int = 500, patience: int = 60_000) -> None:
        """Until no request has been under way for ``quiet`` milliseconds, at most ``patience`` milliseconds."""
        still = 0
        for _ in range(patience // POLL):
            page.wait_for_timeout(POLL)
            still = 0 if self.under_way else still + POLL
            if still >= quiet:
                return

    def _will_be_sent(self, event: dict) -> None:
        if event["request"]["url"].startswith("http"):
            self.under_way.add(event["requestId"])
            self.sent[event["requestId"]] = event["request"]["url"]

    def _served_from_cache(self, event: dict) -> None:
        self.under_way.discard(event["requestId"])
        self.sent.pop(event["requestId"], None)

    def _response(self, event: dict) -> None:
        if event["response"].get("fromDiskCache"):
            self._served_from_cache(event)

    def _finished(self, event: dict) -> None:
        self.under_way.discard(event["requestId"])
        if event["requestId"] in self.sent:
            self.received += int(event["encodedDataLength"])
