"""Properties of clips are kept with their data set: versions, rights, bundles."""

from __future__ import annotations

import pytest

from core.bundles import take_bundle, write_bundle
from core.demo import make_demo
from core.mocap.properties import Properties
from core.workspace import AccessRefused, Person, Workspace, acting_as


@pytest.fixture(scope="module")
def demo():
    return make_demo(0.5)


def test_properties_stay_with_their_dataset(workspace, demo):
    workspace.add_dataset("demo", demo)
    info, clip = workspace.info("demo"), demo.names[0]
    assert workspace.properties.of(info.id) == Properties()
    first = Properties().with_values({clip: {"subject": "Ana"}})
    before = workspace.properties.put(info.id, first, author="Ana")
    workspace.rename("demo", "other")
    assert workspace.properties.of(workspace.info("other").id) == first
    second = workspace.properties.put(info.id, first.with_values({clip: {"subject": "Ben"}}))
    workspace.properties.restore(info.id, second)
    assert workspace.properties.of(info.id) == first
    workspace.properties.restore(info.id, before)
    assert workspace.properties.of(info.id) == Properties()
    assert [change.author for change in workspace.properties.history(info.id)][-2] == "Ana"
    workspace.trash("other")
    workspace.empty_trash()
    assert workspace.properties.state(info.id) == 0


def test_viewers_do_not_change_properties(workspace, demo):
    workspace.add_dataset("demo", demo)
    info = workspace.info("demo")
    with acting_as(Person("eve", "viewer")), pytest.raises(AccessRefused):
        workspace.properties.put(info.id, Properties().with_values({demo.names[0]: {"a": "b"}}))
    with acting_as(Person("eve", "viewer", {info.id: "editor"})):
        workspace.properties.put(info.id, Properties().with_values({demo.names[0]: {"a": "b"}}))


def test_properties_travel_in_a_bundle(workspace, demo, tmp_path_factory):
    workspace.add_dataset("demo", demo)
    id, clip = workspace.info("demo").id, demo.names[0]
    made = Properties().with_values({clip: {"subject": "007", "age": "3"}}).with_kind("subject", "text")
    workspace.properties.put(id, made)
    folder = tmp_path_factory.mktemp("bundle")
    write_bundle(workspace, "demo", folder / "demo.zip")
    other = Workspace(folder / "other")
    take_bundle(other, folder / "demo.zip")
    assert other.properties.of(other.info("demo").id) == made
    take_bundle(other, folder / "demo.zip")
    assert len(other.properties.history(other.info("demo").id)) == 2
    other.close()
