"""Where a request comes from: a trusted proxy, an encrypted connection, a page of this app or of another site."""

from __future__ import annotations

import ipaddress
import os
from urllib.parse import urlsplit

from flask import request

PROXIES = "MOTIONSCAPE_TRUSTED_PROXIES"
SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})


def from_trusted_proxy() -> bool:
    """Whether the request comes from one of the addresses in MOTIONSCAPE_TRUSTED_PROXIES (or networks, 10.0.0.0/8)."""
    try:
        address = ipaddress.ip_address(request.remote_addr or "")
    except ValueError:
        return False
    return any(address in network for network in _networks(os.environ.get(PROXIES, "")))


def client_address() -> str:
    """Where the browser is: the address that a trusted proxy names last, else the one that the request comes from."""
    named = request.headers.get("X-Forwarded-For", "").rpartition(",")[2].strip()
    return named[:60] if named and from_trusted_proxy() else request.remote_addr or ""


def is_encrypted() -> bool:
    """Whether the browser's connection is encrypted, as far as the server or a trusted proxy knows."""
    return request.is_secure or (from_trusted_proxy() and request.headers.get("X-Forwarded-Proto", "") == "https")


def is_foreign(hosts: frozenset[str]) -> bool:
    """Whether the request could change something and was made by a page of another site. hosts: our own names."""
    if request.method in SAFE_METHODS:
        return False
    site = request.headers.get("Sec-Fetch-Site", "")
    if site:
        return site not in ("same-origin", "none")
    origin = request.headers.get("Origin")
    if origin is None:  # no browser: those send one of the two with every request that is not safe
        return False
    own = urlsplit(f"//{request.host}")
    theirs = urlsplit(origin)
    same = (theirs.hostname, theirs.port or _port(theirs.scheme)) == (own.hostname, own.port or _port(theirs.scheme))
    return not same and (theirs.hostname or "") not in hosts


def _port(scheme: str) -> int:
    return 443 if scheme == "https" else 80


def _networks(text: str) -> list[ipaddress.IPv4Network | ipaddress.IPv6Network]:
    networks = []
    for part in filter(None, (part.strip() for part in text.split(","))):
        try:
            networks.append(ipaddress.ip_network(part, strict=False))
        except ValueError:
            continue
    return networks
