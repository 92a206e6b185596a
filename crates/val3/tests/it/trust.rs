//! An untrusted cell: its files control the command only inside the cell.

use std::fs;
use std::net::TcpListener;

use serde_json::json;

use crate::dap_client::Session;
use crate::support::{CLEAN, CommandOutput, FAULTY, Folder, add_stops, copy_folder, run};

const CLIENT: &str = r#"<sio><socketClt><String name="name" value="host"/><String name="serverIp" value="10.9.8.7"/><Num name="portNumber" value="PORT"/></socketClt></sio>"#;

/// A cell in `cell`, next to a folder `home` with a secret.
fn cell(listing: &str) -> Folder {
    let folder = Folder::empty();
    let fixture = Folder::with(listing);
    add_stops(fixture.path());
    copy_folder(&fixture.path().join("usrapp"), &folder.path().join("cell/usrapp"));
    folder.write("home/secret.txt", "TOPSECRET\n");
    folder
}

#[track_caller]
fn refuses(output: &CommandOutput, words: &[&str]) {
    assert_eq!(output.code, 2, "{output:?}");
    assert!(words.iter().all(|word| output.stderr.contains(word)), "{output:?}");
    assert!(!output.stdout.contains("TOPSECRET") && !output.stderr.contains("TOPSECRET"), "{output:?}");
}

const READS: &str = r#"
num nFile
num nRead
string sText[1]
program start()
begin
  nFile=$fileOpen("X://secret.txt","r")
  nRead=$fileGet(nFile,sText,1)
  ? sText[0]
end
"#;

#[test]
fn a_root_outside_of_the_cell_needs_the_users_trust() {
    let folder = cell(READS);
    folder.write("cell/val3.toml", "roots = { X = \"../home\" }\n");
    let real = folder.path().canonicalize().unwrap().join("cell");
    for command in [["run", "cell/usrapp/main"], ["check", "cell"], ["fmt", "cell"], ["test", "cell"]] {
        let refused = folder.val3(&command);
        refuses(&refused, &["`roots.X` resolves to `../home`, outside of the cell", "cell/val3.toml:1", "val3 trust "]);
    }
    let mut by_variable = folder.command(&["run", "cell/usrapp/main"]);
    by_variable.env("VAL3_TRUST", &real);
    let output = run(by_variable);
    assert_eq!((output.code, output.stdout.as_str()), (0, "TOPSECRET\n"), "{output:?}");
    assert!(output.stderr.contains("note: `X://` is the folder `"), "{output:?}");

    assert_eq!(folder.val3(&["trust", "cell"]).code, 0);
    let listed = folder.val3(&["trust", "--list"]);
    assert_eq!((listed.code, listed.stdout.trim_end()), (0, real.to_str().unwrap()));
    assert_eq!(folder.val3(&["run", "cell/usrapp/main"]).stdout, "TOPSECRET\n");
    assert_eq!(folder.val3(&["trust", "--remove", "cell"]).code, 0);
    refuses(&folder.val3(&["run", "cell/usrapp/main"]), &["outside of the cell"]);
    refuses(&folder.val3(&["trust", "--remove", "cell"]), &["is not in your list"]);
    refuses(&folder.val3(&["trust", "missing"]), &["`missing`"]);
}

#[test]
fn each_path_of_a_settings_file_stays_in_the_cell() {
    let folder = cell(CLEAN);
    for setting in [
        "disk = \"..\"",
        "roots = { X = \"/\" }",
        "add-ons = [\"/dev/zero\"]",
        "baseline = \"../home/new.json\"",
        "arm = \"../home/arm.toml\"",
        "run.shapes.base = \"../home/base.stl\"",
        "test.replace.part = \"../home/part\"",
    ] {
        folder.write("cell/val3.toml", setting);
        refuses(&folder.val3(&["check", "cell"]), &["outside of the cell", "val3.toml:1"]);
        refuses(&folder.val3(&["check", "cell", "--write-baseline"]), &["outside of the cell"]);
    }
    assert!(!folder.path().join("home/new.json").exists());
}

#[test]
fn the_repository_around_a_settings_file_is_its_cell() {
    let folder = cell(CLEAN);
    folder.write("cell/tests/stick/note.txt", "");
    folder.write("cell/usrapp/val3.toml", "roots = { X = \"../tests/stick\" }\n");
    refuses(&folder.val3(&["check", "cell"]), &["outside of the cell"]);
    folder.write("cell/.git/HEAD", "");
    assert_eq!(folder.val3(&["check", "cell"]).code, 0);
    let mut at_home = folder.command(&["check", "cell"]);
    at_home.env(if cfg!(windows) { "USERPROFILE" } else { "HOME" }, folder.path().join("cell"));
    refuses(&run(at_home), &["outside of the cell"]);
}

#[test]
fn devices_and_machines_of_a_settings_file_need_an_argument() {
    let folder = cell(CLEAN);
    for (setting, reach, option) in [
        ("run.network = true", "lets sockets reach other machines", "--network"),
        (r"run.lines = { 'Serial\a' = 'serial:/dev/null' }", "opens the device `/dev/null`", "--line 'Serial\\a="),
        (r"run.lines = { 'Socket\a' = 'client:203.0.113.7:80' }", "connects to another machine", "--line 'Socket\\a="),
    ] {
        folder.write("cell/val3.toml", setting);
        refuses(&folder.val3(&["run", "cell"]), &[reach, "val3.toml:1", option, "val3 trust"]);
        refuses(&folder.val3(&["run", "cell", "--scene"]), &[reach]);
    }
    folder.write("cell/val3.toml", "run.network = true\n");
    let allowed = folder.val3(&["run", "cell", "--network"]);
    assert_eq!((allowed.code, allowed.stderr.as_str()), (0, "note: sockets reach other machines\n"), "{allowed:?}");
    folder.write("cell/val3.toml", r"run.lines = { 'Socket\a' = 'client:203.0.113.7:80' }");
    let allowed = folder.val3(&["run", "cell", r"--line=Socket\a=server:0"]);
    assert_eq!(
        (allowed.code, allowed.stderr.as_str()),
        (0, "note: a line has a connection: Socket\\a=server:0\n"),
        "{allowed:?}"
    );
}

#[test]
fn a_program_that_a_project_names_outside_is_neither_shown_nor_fixed() {
    let folder = cell("if true\nendIf\n");
    let unusual = folder.read("cell/usrapp/main/start.pgx").replace("if true", "IF true");
    folder.write("prod/start.pgx", &unusual);
    let manifest = folder.read("cell/usrapp/main/main.pjx");
    let prod = folder.path().join("prod/start.pgx");
    for path in ["../../../prod/start.pgx", prod.to_str().unwrap(), "../../../home/secret.txt"] {
        folder.write("cell/usrapp/main/main.pjx", &manifest.replace("start.pgx", path));
        for command in [&["check", "cell"][..], &["check", "--fix", "cell"], &["check", "--add-suppressions", "cell"]] {
            let output = folder.val3(command);
            assert!(output.stdout.contains("V0509") || output.stderr.contains("V0509"), "{output:?}");
            assert!(!output.stdout.contains("TOPSECRET"), "{output:?}");
        }
        assert_eq!(folder.read("prod/start.pgx"), unusual);
    }
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_out_of_the_cell() {
    use std::os::unix::fs::symlink;
    let folder = cell(CLEAN);
    let (secret, main) = (folder.path().join("home/secret.txt"), folder.path().join("cell/usrapp/main"));
    fs::remove_file(main.join("start.pgx")).unwrap();
    symlink(&secret, main.join("start.pgx")).unwrap();
    let output = folder.val3(&["check", "cell"]);
    assert!(output.stdout.contains("V0509") && !output.stdout.contains("TOPSECRET"), "{output:?}");
    fs::remove_file(main.join("start.pgx")).unwrap();
    symlink(&secret, folder.path().join("cell/val3.toml")).unwrap();
    refuses(&folder.val3(&["check", "cell"]), &["is not read: it is a link out of the cell"]);
    fs::remove_file(folder.path().join("cell/val3.toml")).unwrap();
    symlink(folder.path().join("home"), folder.path().join("cell/more")).unwrap();
    refuses(&folder.val3(&["check", "cell"]), &["it is a link out of the cell"]);
    refuses(&folder.val3(&["fmt", "cell"]), &["it is a link out of the cell"]);
    refuses(&folder.val3(&["diff", "cell", "home"]), &["it is a link out of the cell"]);
}

#[cfg(unix)]
#[test]
fn shapes_are_no_other_files() {
    let folder = cell(CLEAN);
    folder.write("cell/val3.toml", "run.shapes.base = \"base.stl\"\n");
    std::os::unix::fs::symlink("../home/secret.txt", folder.path().join("cell/base.stl")).unwrap();
    refuses(
        &folder.val3(&["run", "cell", "--scene"]),
        &["`run.shapes.base` resolves to `base.stl`, outside of the cell"],
    );
    fs::remove_file(folder.path().join("cell/base.stl")).unwrap();
    folder.write("cell/base.stl", "TOPSECRET");
    refuses(&folder.val3(&["run", "cell", "--scene"]), &["base.stl` is no STL file"]);
}

#[test]
fn programs_cannot_use_names_that_steer_tools() {
    for name in ["Disk://.git/config", "Disk://VAL3.toml", "./val3.toml", "Disk://sub/.envrc", "cell.toml"] {
        let folder = cell(&format!("program start()\nbegin\n{}\nend\n", accesses(name)));
        folder.write("cell/usrapp/.git/config", "[core]\n");
        folder.write("cell/usrapp/note.txt", "");
        fs::create_dir(folder.path().join("cell/usrapp/sub")).unwrap();
        let output = folder.val3(&["run", "cell/usrapp/main"]);
        assert_eq!(output.stdout, "-1\n-1\nfalse\nfalse\nfalse\nfalse\nfalse\ntrue\n", "{name}: {output:?}");
        assert_eq!(folder.read("cell/usrapp/.git/config"), "[core]\n");
        assert!(!folder.path().join("cell/usrapp/stolen.txt").exists());
    }
    let folder =
        cell("program start()\nbegin\n  ? $delete(\"Disk://sub\")\n  ? $rename(\"Disk://sub\",\"Disk://new\")\nend\n");
    folder.write("cell/usrapp/sub/deep/.git/config", "[core]\n");
    assert_eq!(folder.val3(&["run", "cell/usrapp/main"]).stdout, "false\nfalse\n");
    assert_eq!(folder.read("cell/usrapp/sub/deep/.git/config"), "[core]\n");
}

/// Code that accesses a file in every way.
fn accesses(name: &str) -> String {
    [
        format!("  ? $fileOpen(\"{name}\",\"w\")"),
        format!("  ? $fileOpen(\"{name}\",\"r\")"),
        format!("  ? $fileExists(\"{name}\")"),
        format!("  ? $delete(\"{name}\")"),
        format!("  ? $copy(\"Disk://note.txt\",\"{name}\")"),
        format!("  ? $copy(\"{name}\",\"Disk://stolen.txt\")"),
        format!("  ? $rename(\"Disk://note.txt\",\"{name}\")"),
        format!("  ? libDelete(\"{name}\")!=0"),
    ]
    .join("\n")
}

/// Application data with a line.
const HOST: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
  </Datas>
</Database>"#;

/// A cell whose program connects to `port` of this machine, because of `sio.cfx`.
fn calling(port: u16, program: &str) -> Folder {
    let code = "  sioCtrl(siHost,\"timeout\",0.1)\n  siHost=\"hello\"";
    let folder = Folder::with(&format!("program {program}()\nbegin\n{code}\nend\n{HOST}"));
    add_stops(folder.path());
    folder.write("configs/sio.cfx", &CLIENT.replace("PORT", &port.to_string()));
    folder
}

fn listener() -> (TcpListener, u16) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    listener.set_nonblocking(true).unwrap();
    let port = listener.local_addr().unwrap().port();
    (listener, port)
}

#[test]
fn a_port_that_only_the_cell_names_is_not_called_unseen() {
    let (listener, port) = listener();
    let folder = calling(port, "start");
    let arguments = ["run", "usrapp/main", "--until", "1", "--until-ok"];
    let output = folder.val3(&arguments);
    let note = format!("note: `Socket\\host` is not connected to port {port} of this machine");
    assert_eq!(output.stderr.matches(&note).count(), 1, "{output:?}");
    assert!(listener.accept().is_err());
    let line = format!(r"--line=Socket\host=client:127.0.0.1:{port}");
    for option in [line.as_str(), "--network"] {
        let output = folder.val3(&[&arguments[..], &[option]].concat());
        assert!(!output.stderr.contains("is not connected"), "{output:?}");
    }
    assert!(listener.accept().is_ok(), "the line of the argument was connected");
}

#[test]
fn tests_connect_no_sockets_unless_told() {
    let (listener, port) = listener();
    let folder = calling(port, "testSends");
    fs::rename(folder.path().join("usrapp/main/main.pjx"), folder.path().join("usrapp/main/mainTest.pjx")).unwrap();
    fs::rename(folder.path().join("usrapp/main"), folder.path().join("usrapp/mainTest")).unwrap();
    let output = folder.val3(&["test", "usrapp", "--limit", "1"]);
    assert_eq!(
        output.stderr.matches("note: sockets are not connected in tests: `Socket\\host`").count(),
        1,
        "{output:?}"
    );
    assert!(output.stderr.contains("--line 'Socket\\host="), "{output:?}");
    assert!(listener.accept().is_err());
    let line = format!(r"--line=Socket\host=client:127.0.0.1:{port}");
    let output = folder.val3(&["test", "usrapp", "--limit", "1", &line]);
    assert!(!output.stderr.contains("not connected"), "{output:?}");
    assert!(listener.accept().is_ok());
}

#[test]
fn what_a_run_gets_outside_is_named() {
    let folder = cell(CLEAN);
    let output = folder.val3(&["run", "cell", "--root", "X=home", "--network"]);
    assert_eq!(
        (output.code, output.stderr.as_str()),
        (0, "note: `X://` is the folder `home`, outside of the cell\nnote: sockets reach other machines\n"),
        "{output:?}"
    );
}

#[test]
fn fixes_change_only_what_the_command_names() {
    let folder = cell(FAULTY);
    let before = folder.read("cell/usrapp/main/start.pgx");
    folder.val3(&["check", "--fix", "--unsafe-fixes", "cell"]);
    assert_ne!(folder.read("cell/usrapp/main/start.pgx"), before, "inside, files are fixed");
}

#[test]
fn a_debugged_run_names_what_it_gets_and_refuses_the_rest() {
    let folder = cell(CLEAN);
    let application = folder.path().join("cell/usrapp/main");
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    session.ask("launch", json!({ "program": application, "network": true }));
    assert_eq!(session.event("output")["output"], "note: sockets reach other machines\n");
    session.end();

    folder.write("cell/val3.toml", "roots = { X = \"/\" }\n");
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let reason = session.refused("launch", json!({ "program": application }));
    assert!(
        reason.contains("`roots.X` resolves to `/`, outside of the cell") && reason.contains("val3 trust"),
        "{reason}"
    );
    session.end();
}

#[test]
fn a_debugged_run_announces_the_port_that_only_the_cell_names() {
    let (listener, port) = listener();
    let folder = calling(port, "start");
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    session.ask("launch", json!({ "program": folder.path().join("usrapp/main"), "until": 1 }));
    session.event("initialized");
    // On a busy machine the connection may take longer than the timeout of the line, which is then a run-time error.
    session.ask("setExceptionBreakpoints", json!({ "filters": [] }));
    session.ask("configurationDone", json!({}));
    let note = session.event("output")["output"].as_str().unwrap().to_owned();
    assert!(note.contains("`Socket\\host`") && note.contains(&format!("port {port} of this machine")), "{note}");
    session.event("terminated");
    session.end();
    drop(listener);
}
