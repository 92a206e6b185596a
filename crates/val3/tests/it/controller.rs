//! `val3 pull`, `status`, `push` and `diff` with the folder of an emulator as the controller.

use std::fs;
use std::process::Stdio;
use std::thread;
use std::time::Duration;

use expect_test::expect;

use crate::support::{CommandOutput, Folder, copy_folder};

const PROJECT: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
    <Parameters version=\"s7.5\" stackSize=\"5000\" millimeterUnit=\"true\" />\n  <Programs>\n    <Program file=\"start.pgx\" />\n    \
    <Program file=\"stop.pgx\" />\n  </Programs>\n  <Database>\n    <Data file=\"demo.dtx\" />\n  </Database>\n</Project>\n";

const DATA: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\" \
    xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n  <Datas>\n    <Data name=\"nCount\" access=\"private\" xsi:type=\"array\" \
    type=\"num\" size=\"1\">\n      <Value key=\"0\" value=\"1\" />\n    </Data>\n  </Datas>\n</Database>\n";

const IDENTITY: &str = "<controller><String name=\"serialNumber\" value=\"F10-1\" /></controller>";

pub(crate) fn program(name: &str, code: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  \
         <Program name=\"{name}\" access=\"private\">\n    <Code><![CDATA[begin\n  {code}\nend]]></Code>\n  </Program>\n</Programs>\n"
    )
}

/// A folder with an emulator, `robot`, and a project, `cell`, that was pulled from it.
pub(crate) fn pulled() -> Folder {
    let folder = Folder::empty();
    folder.write("robot/usr/configs/controller.cfx", IDENTITY);
    folder.write("robot/usr/usrapp/demo/demo.pjx", PROJECT);
    folder.write("robot/usr/usrapp/demo/demo.dtx", DATA);
    folder.write("robot/usr/usrapp/demo/start.pgx", &program("start", "nCount=nCount+1"));
    folder.write("robot/usr/usrapp/demo/stop.pgx", &program("stop", "nCount=0"));
    let run = folder.val3(&["pull", "robot", "cell"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    folder
}

/// Runs a command in the project. Paths of the temporary folder are replaced.
pub(crate) fn in_cell(folder: &Folder, args: &[&str]) -> CommandOutput {
    let mut command = folder.exact_command(args);
    command.current_dir(folder.path().join("cell"));
    let mut run = crate::support::run(command);
    run.stderr = run.stderr.replace(folder.path().to_str().unwrap(), "…");
    run
}

#[test]
fn a_push_uploads_what_has_changed() {
    let folder = pulled();
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=nCount+2"));
    let status = in_cell(&folder, &["status"]);
    assert_eq!((status.code, status.stdout.as_str()), (1, "local       usr/usrapp/demo/start.pgx: changed\n"));
    let dry = in_cell(&folder, &["push", "--dry-run"]);
    assert_eq!((dry.code, dry.stdout.starts_with("replace  usr/usrapp/demo/start.pgx (")), (0, true), "{}", dry.stderr);
    assert!(folder.read("robot/usr/usrapp/demo/start.pgx").contains("+1"));
    let asked = in_cell(&folder, &["push"]);
    assert_eq!(asked.code, 1);
    assert!(asked.stderr.contains("--unloaded"), "{}", asked.stderr);
    let pushed = in_cell(&folder, &["push", "--unloaded", "demo"]);
    assert_eq!(pushed.code, 0, "{}", pushed.stderr);
    assert!(folder.read("robot/usr/usrapp/demo/start.pgx").contains("+2"));
    assert_eq!(in_cell(&folder, &["status"]).code, 0);
    assert!(in_cell(&folder, &["push"]).stderr.ends_with("nothing to push\n"));
}

#[test]
fn errors_and_running_applications_stop_a_push() {
    let folder = pulled();
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCuont=1"));
    let run = in_cell(&folder, &["push", "--unloaded"]);
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("nCuont") && run.stderr.contains("nothing was pushed"), "{}", run.stderr);
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=3"));
    let entry = "{\"entry\":{\"type\":\"msg\",\"id\":\"0x5402\",\"val\":\"Application 'demo' started.\"}}\n";
    folder.write("robot/log/user.log", entry);
    let run = in_cell(&folder, &["push"]);
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("`demo` runs on the controller"), "{}", run.stderr);
    assert!(folder.read("robot/usr/usrapp/demo/start.pgx").contains("+1"));
}

#[test]
fn conflicts_and_broken_settings_stop_a_push() {
    let folder = pulled();
    let sio = |port: &str| format!("<sio>\n  <String name=\"a\" value=\"{port}\" />\n</sio>\n");
    folder.write("robot/usr/configs/sio.cfx", &sio("1"));
    folder.write("robot/usr/usrapp/demo/recipes.csv", "part;count\n");
    assert_eq!(in_cell(&folder, &["pull", "--all"]).code, 0);
    let push = |words: &[&str]| {
        let run = in_cell(&folder, &[&["push", "--unloaded"], words].concat());
        (run.code, run.stderr.lines().skip(1).collect::<Vec<_>>().join("\n"))
    };
    let setting = "usr/configs/sio.cfx";
    for (name, port) in [("robot", "2"), ("cell", "3")] {
        folder.write(&format!("{name}/{setting}"), &sio(port));
    }
    assert_eq!(in_cell(&folder, &["pull", "--merge"]).code, 1);
    let (code, text) = push(&[setting]);
    assert!(code == 1 && text.contains("sio.cfx`, line 2: a merge conflict is not resolved"), "{text}");
    folder.write(&format!("cell/{setting}"), "<sio><broken");
    folder.write("cell/usr/usrapp/demo/recipes.csv", "part;count\n<<<<<<< HEAD\n1;2\n=======\n1;3\n>>>>>>> other\n");
    let (code, text) = push(&[setting, "demo"]);
    assert_eq!(code, 1);
    expect![[r#"
        error: `usr/usrapp/demo/recipes.csv`, line 2: a merge conflict is not resolved
          help: keep one of the versions, and remove the marks
        error: `usr/configs/sio.cfx`: line 1: an element is not closed; the file is cut off or damaged
          help: repair it, or restore it: `.val3/base` contains the version of the last pull
        nothing was pushed"#]]
    .assert_eq(&text);
    folder.write("cell/usr/usrapp/demo/recipes.csv", "part;count\n1;3\n");
    folder.write(&format!("cell/{setting}"), &sio("3"));
    let (code, text) = push(&[setting, "demo"]);
    assert!(code == 0 && text.contains("pushed and verified: 2 files"), "{text}");
}

/// What the controller's compiler rejects stops a push of a changed application, as it stops `val3 run`.
#[test]
fn no_configuration_hides_what_the_compiler_rejects() {
    let folder = pulled();
    let library = PROJECT.replace("demo.dtx", "other.dtx");
    folder.write("robot/usr/usrapp/other/other.pjx", &library);
    folder.write("robot/usr/usrapp/other/other.dtx", DATA);
    for name in ["start", "stop"] {
        folder.write(&format!("robot/usr/usrapp/other/{name}.pgx"), &program(name, "nCount=0"));
    }
    assert_eq!(in_cell(&folder, &["pull"]).code, 0);
    let push = |words: &[&str]| in_cell(&folder, &[&["push", "--dry-run"], words].concat());
    folder.write("cell/usr/usrapp/other/start.pgx", &program("start", "nCuont=1"));
    for settings in [
        "exclude = [\"usr/usrapp/other/**\"]\n",
        "exclude = [\"**/start.pgx\"]\n",
        "[rules]\nall = \"off\"\n",
        "[rules]\nunknown-name = \"info\"\n",
    ] {
        folder.write("cell/val3.toml", settings);
        let run = push(&[]);
        assert!(run.code == 1 && run.stderr.contains("nCuont"), "{settings}: {}", run.stderr);
        assert_eq!(push(&["--ignore", "unknown-name"]).code, 0, "{settings}");
    }
    folder.write("cell/val3.toml", "exclude = [\"usr/usrapp/other/**\"]\n");
    assert_eq!(in_cell(&folder, &["push", "--unloaded", "--ignore", "V"]).code, 0);
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=3"));
    let run = push(&[]);
    let note = "note: unchanged and not checked, because val3.toml excludes them: `usr/usrapp/other`";
    assert!(run.code == 0 && run.stderr.contains(note), "{}", run.stderr);
    // Now `other` uses what changes.
    let used = library.replace(
        "</Project>",
        "  <Libraries>\n    <Library alias=\"demo\" path=\"Disk://demo/demo.pjx\" />\n  </Libraries>\n</Project>",
    );
    folder.write("cell/usr/usrapp/other/other.pjx", &used);
    assert_eq!(in_cell(&folder, &["push", "--unloaded", "--ignore", "V", "other"]).code, 0);
    let run = push(&[]);
    assert!(run.code == 1 && run.stderr.contains("nCuont"), "{}", run.stderr);
}

/// Each log was pushed over without a question once, or must stay pushable without one.
#[test]
fn a_push_needs_logs_that_prove_that_nothing_runs() {
    let folder = pulled();
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=3"));
    let s8 =
        |code: &str, text: &str| format!("{{\"entry\":{{\"type\":\"msg\",\"id\":\"{code}\",\"val\":\"{text}\"}}}}\n");
    let [start, stop] = [("0x5402", "started"), ("0x5403", "stopped")]
        .map(|(code, what)| move |name: &str| s8(code, &format!("Application '{name}' {what}.")));
    let pushed = |old: &str, new: &str, log: &str| {
        for (name, text) in [("user.old", old), ("user.log", new), ("errors.log", log)] {
            folder.write(&format!("robot/log/{name}"), text);
        }
        let run = in_cell(&folder, &["push"]);
        (run.code, run.stderr.lines().skip(1).collect::<Vec<_>>().join("\n"))
    };
    let help = "\n  help: stop and unload it on the controller, then add --unloaded";
    let runs = |name: &str| (1, format!("error: `{name}` runs on the controller, according to its log{help}"));
    let cs8 = "[01/05/21 08:00:30]: <0x5402> palletiser application started {1a2b3c4d}\n";
    assert_eq!(pushed("", "", cs8), runs("palletiser"));
    assert_eq!(pushed(&[start("palletiser"), start("tool")].concat(), &stop("tool"), ""), runs("palletiser"));
    let unknown = |why: &str| {
        let what = "error: the log of the controller does not state whether an application is loaded";
        (1, format!("{what}\n{why}{help}"))
    };
    let run = "{\"entry\":{\"type\":\"run\",\"version\":\"3.0.0\"}}\n";
    let line = "[01/05/21 08:00:30]: <0x5402> started\n";
    assert_eq!(pushed("", "", line), unknown("this line names no application that can be read: started"));
    let broken = line.replace(']', "");
    let cause = format!("this line names no application that can be read: {}", broken.trim_end());
    assert_eq!(pushed("", run, &broken), unknown(&cause));
    assert_eq!(pushed("", &stop("tool"), ""), unknown("the logs do not reach back to the start of the controller"));
    let (code, text) = pushed(&[run, &start("demo")].concat(), &stop("demo"), "");
    assert!(code == 0 && text.contains("pushed and verified: 1 file"), "{text}");
}

#[test]
fn a_push_removes_an_application_only_on_request() {
    let folder = pulled();
    for name in ["other", "third"] {
        folder.write(&format!("robot/usr/usrapp/{name}/{name}.pjx"), "<Project />");
    }
    assert_eq!(in_cell(&folder, &["pull"]).code, 0);
    let remove = |path: &str| fs::remove_dir_all(folder.path().join(path)).unwrap();
    remove("cell/usr/usrapp/other");
    remove("cell/usr/usrapp/third");
    let push = |words: &[&str]| {
        let run = in_cell(&folder, &[&["push", "--ignore", "V", "--unloaded"], words].concat());
        (run.code, run.stderr.lines().skip(1).collect::<Vec<_>>().join("\n"))
    };
    let note = "note: the push removes the applications `other`, `third` from the controller, which needs --remove other \
                --remove third";
    assert_eq!(push(&["--dry-run"]), (0, note.to_owned()));
    let refused = "error: the push would remove the application `third` from the controller\n  \
                   help: restore the local files with the `.pjx`, or add --remove third";
    assert_eq!(push(&["--remove", "other"]), (1, refused.to_owned()));
    let unknown = in_cell(&folder, &["push", "--ignore", "V", "--remove", "demo"]);
    assert!(
        unknown.code == 2 && unknown.stderr.contains("does not remove the application `demo`"),
        "{}",
        unknown.stderr
    );
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=8"));
    let (code, text) = push(&["--remove", "other", "--remove", "third"]);
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("2 removed") && text.ends_with("load on the controller again: demo"), "{text}");
    // A clone without the files of the controller.
    remove("cell/usr");
    let (code, text) = push(&[]);
    expect![[r#"
        error: no application is left in the local folder `usr/usrapp`: the push would remove 4 files from the controller
          help: restore the folder, for example with git, or pull the controller to another folder: `val3 pull ADDRESS DIR`; remove applications that are not used on the controller"#]]
    .assert_eq(&text);
    assert!(code == 1 && folder.read("robot/usr/usrapp/demo/start.pgx").contains("nCount=8"));
}

/// The project files come from the last pull if they are missing here and are not selected.
#[test]
fn applications_are_checked_also_without_their_local_project_file() {
    let folder = pulled();
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCuont=1"));
    fs::remove_file(folder.path().join("cell/usr/usrapp/demo/demo.pjx")).unwrap();
    let run = in_cell(&folder, &["push", "--unloaded", "usr/usrapp/demo/start.pgx"]);
    assert!(run.code == 1 && run.stderr.contains("nCuont"), "{}", run.stderr);
}

#[test]
fn a_push_names_files_whose_versions_on_the_controller_were_not_pulled() {
    let folder = pulled();
    folder.write("robot/usr/usrapp/demo/stop.pgx", &program("stop", "nCount=9"));
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=nCount+2"));
    let run = in_cell(&folder, &["push", "--dry-run", "demo/start.pgx"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let note = "note: changed on the controller, and not pulled, so that the check uses the versions here: \
                `usr/usrapp/demo/stop.pgx`";
    assert!(run.stderr.lines().any(|line| line == note), "{}", run.stderr);
}

#[test]
fn a_conflict_is_not_merged_without_the_version_of_the_last_pull() {
    let folder = pulled();
    for (name, count) in [("robot", "2"), ("cell", "3")] {
        let data = DATA.replace("value=\"1\"", &format!("value=\"{count}\""));
        folder.write(&format!("{name}/usr/usrapp/demo/demo.dtx"), &data);
    }
    let local = folder.read("cell/usr/usrapp/demo/demo.dtx");
    fs::remove_dir_all(folder.path().join("cell/.val3/base")).unwrap();
    let run = in_cell(&folder, &["pull", "--merge"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let reason = "demo.dtx: not merged, both versions are kept: its version of the last pull is not stored here";
    assert!(run.stderr.contains(reason), "{}", run.stderr);
    assert_eq!(folder.read("cell/usr/usrapp/demo/demo.dtx"), local);
}

#[test]
fn a_conflict_is_merged_on_request() {
    let folder = pulled();
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=5"));
    folder.write("robot/usr/usrapp/demo/start.pgx", &program("start", "nCount=6"));
    let run = in_cell(&folder, &["pull"]);
    assert_eq!(run.code, 1);
    expect![[r#"
        …/robot: controller F10-1
        error: 1 file changed here and on the controller since the last pull: `usr/usrapp/demo/start.pgx`
          help: merge the changes of both sides with `val3 pull --merge`
    "#]]
    .assert_eq(&run.stderr);
    let run = in_cell(&folder, &["pull", "--merge"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let text = folder.read("cell/usr/usrapp/demo/start.pgx");
    assert!(text.contains("<<<<<<<") && text.contains("nCount=5") && text.contains("nCount=6"), "{text}");
    assert_eq!(in_cell(&folder, &["push", "--unloaded"]).code, 1, "the check reports the conflict");
}

/// JSON document of a command in the project, with a line for each element of a list. Programs such as editors read it.
#[track_caller]
fn document(folder: &Folder, args: &[&str], code: i32) -> String {
    let run = in_cell(folder, &[args, &["--format", "json"]].concat());
    assert_eq!(run.code, code, "{}", run.stderr);
    let mut value: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    for key in ["address", "project"] {
        if let Some(path) = value.get_mut(key) {
            let shown = path.as_str().unwrap().replace(folder.path().to_str().unwrap(), "…").replace('\\', "/");
            *path = shown.into();
        }
    }
    format!("{value}\n").replace(":[{", ":[\n{").replace("},{", "},\n{")
}

#[test]
fn differences_are_a_document() {
    let folder = pulled();
    folder.write("robot/usr/usrapp/other/other.pjx", PROJECT);
    assert_eq!(in_cell(&folder, &["pull", "--all"]).code, 0);
    expect![[r#"
        {"address":"…/robot","applications":[
        {"files":[],"name":"demo"},
        {"files":[],"name":"other"}],"controller":{"arm":null,"serial":"F10-1"},"project":"…/cell","settings":[],"version":1}
    "#]].assert_eq(&document(&folder, &["status"], 0));
    folder.write("cell/usr/usrapp/demo/new.pgx", &program("new", "nCount=9"));
    folder.write("robot/usr/usrapp/demo/new.pgx", &program("new", "nCount=9"));
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=5"));
    folder.write("robot/usr/usrapp/demo/start.pgx", &program("start", "nCount=6"));
    fs::remove_file(folder.path().join("cell/usr/usrapp/demo/stop.pgx")).unwrap();
    folder.write("robot/usr/configs/sio.cfx", "<sio />");
    expect![[r#"
        {"address":"…/robot","applications":[
        {"files":[
        {"change":"added","path":"usr/usrapp/demo/new.pgx","side":"alike"},
        {"change":"changed","controller_change":"changed","path":"usr/usrapp/demo/start.pgx","side":"conflict"},
        {"change":"removed","path":"usr/usrapp/demo/stop.pgx","side":"local"}],"name":"demo"},
        {"files":[],"name":"other"}],"controller":{"arm":null,"serial":"F10-1"},"project":"…/cell","settings":[
        {"change":"added","path":"usr/configs/sio.cfx","side":"controller"}],"version":1}
    "#]]
    .assert_eq(&document(&folder, &["status"], 1));
    let refused = in_cell(&folder, &["push", "--dry-run", "--format", "json"]);
    assert_eq!((refused.code, refused.stdout.as_str()), (1, ""), "{}", refused.stderr);
}

#[test]
fn changes_of_a_push_are_a_document() {
    let folder = pulled();
    let push = ["push", "--dry-run", "--ignore", "V"];
    expect![[r#"
        {"changes":[],"version":1}
    "#]]
    .assert_eq(&document(&folder, &push, 0));
    folder.write("cell/usr/usrapp/demo/more.pgx", &program("more", "nCount=1"));
    folder.write("cell/usr/usrapp/demo/start.pgx", &program("start", "nCount=5"));
    fs::remove_file(folder.path().join("cell/usr/usrapp/demo/stop.pgx")).unwrap();
    let changes = document(&folder, &push, 0);
    expect![[r#"
        {"changes":[
        {"action":"create","path":"usr/usrapp/demo/more.pgx","size":221},
        {"action":"replace","path":"usr/usrapp/demo/start.pgx","size":222},
        {"action":"remove","path":"usr/usrapp/demo/stop.pgx","size":null}],"version":1}
    "#]]
    .assert_eq(&changes);
    let run = in_cell(&folder, &[&push[..], &["--format", "json", "--output", "plan.json"]].concat());
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert_eq!(folder.read("cell/plan.json").trim(), changes.replace('\n', ""));
}

#[test]
fn one_file_of_the_controller_is_printed() {
    let folder = pulled();
    let path = "usr/usrapp/demo/start.pgx";
    let changed = program("start", "nCount=7");
    folder.write(&format!("robot/{path}"), &changed);
    let printed = in_cell(&folder, &["pull", "--print", path]);
    assert_eq!((printed.code, printed.stdout.as_str(), printed.stderr.as_str()), (0, changed.as_str(), ""));
    assert!(folder.read(&format!("cell/{path}")).contains("nCount+1"), "nothing was pulled");
    let without_project = folder.val3(&["pull", "--print", path, "robot"]);
    assert_eq!((without_project.code, without_project.stdout), (0, changed), "{}", without_project.stderr);
    let error = |path: &str| {
        let run = in_cell(&folder, &["pull", "--print", path]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
        run.stderr
    };
    let missing = expect![[r#"
        error: the controller has no file `usr/usrapp/demo/none.pgx`
          help: name a file as `val3 status` does: usr/usrapp/demo/start.pgx
    "#]];
    missing.assert_eq(&error("usr/usrapp/demo/none.pgx"));
    assert!(error("../robot").contains("it leads to another folder"));
    assert!(error("usr/usrapp/demo").contains("usr/usrapp/demo"));
    folder.write("robot/usr/configs/controller.cfx", &IDENTITY.replace("F10-1", "F10-2"));
    assert!(error(path).contains("--new-controller"));
}

#[test]
fn wrong_usage_has_a_remedy() {
    let folder = pulled();
    let error = |args: &[&str]| {
        let run = in_cell(&folder, args);
        assert_eq!(run.code, 2, "{}", run.stderr);
        run.stderr
    };
    let message = error(&["pull", "ftp://me:hidden@robot"]);
    assert!(message.contains("a password does not belong") && !message.contains("hidden"), "{message}");
    assert!(error(&["push", "usr/configs/arm.cfx"]).contains("never written"));
    assert!(error(&["push", "usr/configs/sio.cfx"]).contains("was never pulled"));
    assert!(error(&["push", "dmeo"]).contains("has no files"));
    assert!(error(&["pull", "http://robot"]).contains("only `ftp://`"));
    assert!(error(&["pull", "--fingerprint", "SHA256:00", "ftps://robot"]).contains("64 hexadecimal digits"));
    let fingerprint = "00".repeat(32);
    assert!(error(&["pull", "--fingerprint", &fingerprint, "ftp://robot"]).contains("requires an address `ftps://`"));
    for args in [["pull", "--active"], ["info", "--passive"], ["log", "--active"], ["diff", "--active"]] {
        assert!(error(&args).contains("requires the address of a server"), "{args:?}");
    }
    folder.write("robot/usr/configs/controller.cfx", &IDENTITY.replace("F10-1", "F10-2"));
    assert!(error(&["status"]).contains("--new-controller"));
    let outside = folder.val3(&["status"]);
    assert!(outside.code == 2 && outside.stderr.contains("val3 pull ADDRESS DIR"), "{}", outside.stderr);
}

/// Ends the process at different times. The next command leaves the old or the new application.
#[test]
fn a_killed_push_is_recovered() {
    let folder = pulled();
    let [old, new] = ["nCount=nCount+1", "nCount=nCount+2"].map(|code| program("start", code));
    folder.write("cell/usr/usrapp/demo/start.pgx", &new);
    folder.write("cell/usr/usrapp/demo/demo.dtx", &DATA.replace("value=\"1\"", "value=\"2\""));
    let copies = folder.path().join("copies");
    for name in ["robot", "cell"] {
        copy_folder(&folder.path().join(name), &copies.join(name));
    }
    for step in 0..20 {
        for name in ["robot", "cell"] {
            fs::remove_dir_all(folder.path().join(name)).unwrap();
            copy_folder(&copies.join(name), &folder.path().join(name));
        }
        let mut command = folder.exact_command(&["push", "--unloaded", "--ignore", "V"]);
        command.current_dir(folder.path().join("cell")).stdout(Stdio::null()).stderr(Stdio::null());
        let mut process = command.spawn().unwrap();
        thread::sleep(Duration::from_millis(10 * step));
        process.kill().unwrap();
        process.wait().unwrap();
        let status = in_cell(&folder, &["status"]);
        assert!(status.code < 2, "{}", status.stderr);
        let [program, data] =
            ["start.pgx", "demo.dtx"].map(|name| folder.read(&format!("robot/usr/usrapp/demo/{name}")));
        let is_new = program == new && data.contains("value=\"2\"");
        assert!(is_new || program == old && data == DATA, "step {step}: {}", status.stderr);
        let left = fs::read_dir(folder.path().join("robot/usr/usrapp/demo")).unwrap().count();
        assert!(left == 4 && !folder.path().join("robot/usr/usrapp/val3.lock").exists(), "step {step}");
    }
}
