"""The command doctor: a line for each problem, exit code 2 while one is left."""

from core.workspace import Workspace
from webapp.cli import main


def test_the_command_says_what_it_found_and_did(tmp_path, capsys):
    workspace = Workspace(tmp_path / "space")
    workspace.results.put("ab" * 8, {"format": "x"})
    workspace.close()
    (result,) = (path for path in workspace.path.glob("results/*/*") if path.is_file())

    def run(*more):
        code = main.main(["doctor", str(workspace.path), *more])
        return code, *capsys.readouterr()

    assert run() == (0, f"{workspace.path}: everything is whole.\n", "")
    result.write_bytes(b"{")
    code, out, err = run()
    assert code == 2 and "is damaged" in out and "1 of 1 problems are left" in err
    code, out, err = run("--repair")
    assert code == 0 and "Repaired: it was removed" in out and err == ""
    assert run()[0] == 0
    assert main.main(["doctor", str(workspace.path / "nowhere")]) == 2
