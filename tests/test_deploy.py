"""The files in deploy/ fit the repository and the programs that read them."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from webapp.cli.main import _parser

ROOT = Path(__file__).resolve().parents[1]
DEPLOY = ROOT / "deploy"


def test_the_settings_in_them_are_documented():
    table = (ROOT / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
    used = set(re.findall(r"MOTIONSCAPE_\w+", "".join(path.read_text("utf-8") for path in DEPLOY.iterdir())))
    assert used and {name for name in used if f"`{name}`" not in table} == set()


def test_the_image_is_built_from_files_that_are_there():
    lines = (DEPLOY / "Dockerfile").read_text(encoding="utf-8").splitlines()
    copied = [name for line in lines if line.startswith("COPY ") for name in line.split()[1:-1]]
    assert copied and [name for name in copied if not (ROOT / name).exists()] == []


def test_the_page_names_every_file():
    page = (ROOT / "docs" / "deploy.md").read_text(encoding="utf-8")
    named = {"motionscape*.service" if path.suffix == ".service" else path.name for path in DEPLOY.iterdir()}
    assert {name for name in named if f"deploy/{name}" not in page} == set()


def test_the_commands_of_the_units_start_what_exists():
    server = (DEPLOY / "motionscape.service").read_text(encoding="utf-8")
    words = re.search(r"^ExecStart=\S+/motionscape (.*)$", server, re.MULTILINE)[1].split()
    assert _parser(words).parse_args(words).port == 8050
    worker = (DEPLOY / "motionscape-worker@.service").read_text(encoding="utf-8")
    module = re.search(r"--app (\S+)", worker)[1]
    assert (ROOT / (module.replace(".", "/") + ".py")).is_file()


@pytest.mark.skipif(not (shutil.which("nginx") and shutil.which("openssl")), reason="nginx or openssl is not installed")
def test_nginx_reads_its_file(tmp_path):
    key, certificate = tmp_path / "key", tmp_path / "certificate"
    make = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
    subprocess.run([*make, "-subj", "/CN=x", "-keyout", key, "-out", certificate], check=True, capture_output=True)
    text = (DEPLOY / "nginx.conf").read_text(encoding="utf-8")
    text = text.replace("/etc/ssl/certs/motionscape.pem", str(certificate))
    text = text.replace("/etc/ssl/private/motionscape.key", str(key)).replace("listen 443", "listen 127.0.0.1:44399")
    whole = tmp_path / "nginx.conf"
    whole.write_text(f"pid {tmp_path}/pid;\nerror_log stderr;\nevents {{}}\nhttp {{\naccess_log off;\n{text}\n}}\n")
    tried = subprocess.run(["nginx", "-t", "-p", tmp_path, "-c", whole], capture_output=True, text=True)
    assert tried.returncode == 0, tried.stderr
