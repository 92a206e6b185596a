//! Effects of `val3.toml` on a check, and of the version of the cell on a run.

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL};

fn with_config(listing: &str, config: &str) -> Folder {
    let folder = Folder::with(listing);
    folder.write("val3.toml", config);
    folder
}

#[test]
fn levels_decide_on_the_exit_code() {
    for (listing, config, code) in [
        (FAULTY, "", 1),
        (FAULTY, "[rules]\nV0101 = \"off\"\n", 0),
        (FAULTY, "[rules]\nunknown-name = \"warning\"\n", 0),
        (UNUSUAL, "", 0),
        (UNUSUAL, "[rules]\nV07 = \"error\"\n", 1),
    ] {
        let run = with_config(listing, config).val3(&["check"]);
        assert_eq!(run.code, code, "{config} {run:?}");
    }
}

#[test]
fn each_application_has_its_own_settings() {
    let folder = Folder::with(&format!("{FAULTY}\n--- part\n{FAULTY}"));
    folder.write("usrapp/part/val3.toml", "[rules]\nV0101 = \"info\"\n");
    let run = folder.val3(&["check", "--format", "concise"]);
    let lines: Vec<_> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 2, "{run:?}");
    assert!(lines[0].contains("main/start.pgx") && lines[0].contains("error[V0101]"), "{run:?}");
    assert!(lines[1].contains("part/start.pgx") && lines[1].contains("info[V0101]"), "{run:?}");
}

#[test]
fn the_command_line_wins_over_the_file() {
    let folder = with_config(FAULTY, "[rules]\nall = \"off\"\n");
    assert_eq!(folder.val3(&["check"]).code, 0);
    assert_eq!(folder.val3(&["check", "--select", "V0101"]).code, 1);
}

#[test]
fn excluded_programs_are_not_checked() {
    let folder = with_config(FAULTY, "exclude = [\"usrapp/main/start.pgx\"]\n");
    assert_eq!(folder.val3(&["check"]).code, 0);
}

#[test]
fn a_faulty_file_ends_with_2_and_says_where() {
    for (config, words) in [
        ("[rules]\nV0101 = \"eror\"\n", &["val3.toml:2", "2 | V0101 = \"eror\"", "did you mean `error`?"][..]),
        ("[rules]\nunknown-nam = \"off\"\n", &["val3.toml:2", "did you mean `unknown-name`?"]),
        ("exclud = []\n", &["val3.toml:1", "did you mean `exclude`?"]),
        ("disk = \"nowhere\"\n", &["val3.toml:1", "no folder `nowhere`"]),
    ] {
        let run = with_config(CLEAN, config).val3(&["check"]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
        assert!(words.iter().all(|word| run.stderr.contains(word)), "{run:?}");
        assert!(run.stderr.contains(" --> val3.toml:"), "seen from the current folder: {run:?}");
    }
}

#[test]
fn the_schema_is_printed_for_editors() {
    let schemas = [
        (&["schema"][..], include_str!("../../../../editors/schema/val3.schema.json"), "cargo test -p val3-config"),
        (
            &["schema", "--debugger"],
            include_str!("../../../../editors/schema/debugger.schema.json"),
            "cargo test -p val3 the_shipped_schemas",
        ),
    ];
    for (command, shipped, update) in schemas {
        let run = Folder::empty().val3(command);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{command:?}");
        // A message with both texts would fill hundreds of lines.
        assert!(run.stdout == shipped, "the shipped schema is out of date: run `UPDATE_EXPECT=1 {update}`");
    }
}

#[test]
fn each_setting_is_shown_with_its_source() {
    let folder = Folder::with(&format!("{CLEAN}\n--- part\n{CLEAN}\n--- other\n{CLEAN}"));
    folder.write(
        "usrapp/part/val3.toml",
        "version = \"s8.12\"\narm = \"tx2-60l\"\n[rules]\nV0203 = \"off\"\nunknown-name = \"warning\"\n\n[lint.prefixes]\nnum = \"n\"\n",
    );
    let run = folder.val3(&["check", "--explain-config", "--ignore", "V0701", "--baseline", "known.json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    insta::assert_snapshot!(run.stdout);
}

const ROBOT: &str = r#"
num nStart
program start()
begin
  ? getMonitorSpeed()
  ? getProfile()
  ? setProfile("operator","4321")
  ? setProfile("operator","1234")
  ? setMonitorSpeed(90)
  ? getVersion("alter")
  ? getVersion("compliance")
  ? getVersion("testMode")
  ? libList("USB0://",sList)
  ? sList[0]
  nStart=clock()
  for nStart=1 to 999
  endFor
  ? clock()>0.1
end
string sList[1]
"#;

#[test]
fn the_controller_of_a_run_is_configured() {
    let folder = with_config(
        ROBOT,
        r#"
roots = { USB0 = "stick" }
[run]
monitor-speed = 40
line-cost = 100
profiles.operator = { password = "1234", controls-speed = true }
licences = { alter = "demo", compliance = "missing" }
"#,
    );
    folder.write("stick/note.txt", "");
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "40\ndefault\n2\n0\n-2\ndemo\n\nenabled\ntrue\nnote.txt\ntrue\n"));
    let run = folder.val3(&["run", "--monitor-speed", "30", "--line-cost", "1"]);
    assert!(run.stdout.starts_with("30\n") && run.stdout.ends_with("false\n"), "{run:?}");
    folder.write("val3.toml", "run.profile = \"staubli\"\nroots = { USB0 = \"stick\" }\n");
    assert!(folder.val3(&["run"]).stdout.starts_with("100\nstaubli\n4\n4\n0\nenabled\n"));
}

#[test]
fn viewers_get_shapes_and_units() {
    let config = "[run]\nunits = { 'Rio\\%IF0' = \"bar\" }\n\
                  [run.shapes]\nbase = \"arm/base.STL\"\n\
                  link2 = { file = \"arm/upper.glb\", unit = \"mm\", frame = \"zero\", origin = [0, 0, 20] }\n";
    let folder = with_config("program start()\nbegin\nend\naio aiPressure\n", config);
    let data = folder.read("usrapp/main/main.dtx");
    let link = "name=\"aiPressure\" type=\"aio\" size=\"1\"><Value key=\"0\" link=\"Rio\\%IF0\" /></Data>";
    let (head, rest) = data.split_once("name=\"aiPressure\"").unwrap();
    folder.write("usrapp/main/main.dtx", &format!("{head}{link}{}", rest.split_once("/>").unwrap().1));
    folder.write("arm/base.STL", "solid base\nendsolid base\n");
    folder.write("arm/upper.glb", "glTF");
    let run = folder.val3(&["run", "--scene"]);
    assert_eq!(run.code, 0, "{run:?}");
    let scene: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(scene["signals"][0]["unit"], "bar", "{}", scene["signals"]);
    let shapes = scene["arm"]["shapes"].as_array().unwrap();
    assert_eq!(shapes.len(), 7);
    let data = "c29saWQgYmFzZQplbmRzb2xpZCBiYXNlCg==";
    assert_eq!(
        shapes[0],
        serde_json::json!({ "format": "stl", "data": data, "unit": 1.0, "pose": [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] })
    );
    assert_eq!(shapes[1], serde_json::Value::Null);
    // The frame of link 2 has its joint axis, which is parallel to y while all joints are 0, as z.
    assert_eq!((&shapes[2]["format"], &shapes[2]["unit"]), (&serde_json::json!("glb"), &serde_json::json!(1.0)));
    assert_ne!(shapes[2]["pose"], shapes[0]["pose"]);
}

#[test]
fn a_run_refuses_wrong_settings() {
    for (config, word) in [
        ("run.line-cost = 0", "a line of code cannot take 0 µs"),
        ("run.monitor-speed = 101", "the monitor speed cannot be 101 %"),
        ("[run.lines]\n'Socket\\host' = \"sever:1\"", "cannot be connected to `sever:1`"),
        ("run.lines = 3", "`run.lines` must be a table"),
        ("run.shapes.link7 = \"a.stl\"", "the arm has no `link7`"),
        ("run.shapes.link1 = \"a.obj\"", "`a.obj` is not a file of a known form"),
        ("run.shapes.base = \"missing.glb\"", "missing.glb`: it does not exist"),
        ("run.shapes.link1 = { file = \"a.stl\", origin = [0, 0, 0] }", "`origin` needs `frame = \"zero\"`"),
        ("run.shapes.link1 = { file = \"a.stl\", unit = \"inch\" }", "must be one of mm, m"),
        ("run.licences.alter = \"trial\"", "must be one of enabled, demo, missing"),
    ] {
        let run = with_config(CLEAN, config).val3(&["run"]);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains(word) && run.stderr.contains("val3.toml:"), "{run:?}");
    }
}

/// The files of the cell contain the version of the controller. Without them, an application can declare a newer
/// version than the default.
#[test]
fn the_version_of_the_controller_is_that_of_the_cell_or_the_application() {
    let code = "  ? getVersion(\"System\")\n";
    assert_eq!(Folder::with(code).val3(&["run"]).stdout, "s7.11.0\n");
    let folder = Folder::with(&format!("version s8.13.1\n{code}"));
    assert_eq!(folder.val3(&["run"]).stdout, "s8.13.1\n");
    let version = "<Versions><Version name=\"val3\" compatibility=\"11.0\">s8.10.2Cs9_BS1991</Version></Versions>";
    folder.write("configs/val3version.xml", version);
    assert_eq!(folder.val3(&["run"]).stdout, "s8.10.2\n");
}
