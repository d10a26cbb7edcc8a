#!/bin/sh
# A browser for the browser tests: a Chromium that is here, else Debian's (as root), else Playwright's own.
python="$1"
if command -v chromium >/dev/null 2>&1 || command -v google-chrome >/dev/null 2>&1; then exit 0; fi
if command -v apt-get >/dev/null 2>&1 && [ "$(id -u)" = 0 ]; then
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium >/dev/null && exit 0
    echo "apt-get could not install chromium; trying Playwright's own browser." >&2
fi
"$python" -m playwright install chromium && exit 0
cat >&2 <<'END'
No browser for the browser tests. What is missing: Chromium.
Install it by hand (Debian or Ubuntu: sudo apt-get install chromium), then run make test again.
END
exit 1
