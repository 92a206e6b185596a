//! The result of a run: `--summary`, `--result` and `--set`.

use expect_test::expect;
use serde_json::Value;

use crate::support::Folder;

/// An application with a print, a handled error and a task that waits for an input.
fn application() -> Folder {
    let folder = Folder::with(
        "
num nZero
num nSpeed
dio diPart
program divide()
begin
  nSpeed=1/nZero
end
program work()
begin
  wait(diPart)
end
program start()
begin
  nSpeed=10
  ? \"ready \"+toString(\"\",nSpeed)
  taskCreate \"handled\",10,divide()
  wait(taskStatus(\"handled\")>1)
  taskKill(\"handled\")
  taskCreate \"work\",10,work()
end
",
    );
    folder.link("diPart", "BasicIO-1\\%I0");
    folder
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_summary_names_the_end_the_errors_and_the_next_step() {
    let folder = application();
    let output = folder.val3(&["run", "--until", "2", "--summary"]);
    assert_eq!((output.code, output.stderr.as_str()), (3, ""));
    expect![[r#"
        limit after 2.000 s of the controller's clock; exit code 3
        task `work` waits for a condition at work:5: wait(diPart)
        errors: 1
          10 division by zero at divide:5 in task `handled` at 0.000 s, handled: nSpeed=1/nZero
        prints: 1
          ready 10
        waits, longest first:
          2.00 s task `work` for a condition at work:5
        next: task `work` waits for a condition at work:5 (`wait(diPart)`): set `diPart` in the script (--script): [[at]] t = 1, io = { 'BasicIO-1\%I0' = true }
    "#]]
    .assert_eq(&output.stdout);
}

#[test]
fn the_result_file_and_the_json_summary_have_the_same_keys() {
    let folder = application();
    let output = folder.val3(&["run", "--until", "2", "--result", "result.json"]);
    assert_eq!(output.code, 3);
    let file = json(&folder.read("result.json"));
    let summary = folder.val3(&["run", "--until", "2", "--summary=json"]);
    assert_eq!(json(&summary.stdout), file);
    assert_eq!(file["errors"]["count"], 1);
    assert_eq!(file["errors"]["last"][0]["handled"], true);
    assert_eq!(file["prints"]["last"][0], "ready 10");
}

#[test]
fn a_list_of_the_summary_is_short_and_counts_everything() {
    let folder = Folder::with("num n\nprogram start()\nbegin\n  for n=1 to 1500\n    ? n\n  endFor\nend\n");
    let lists = |arguments: &[&str], file: Option<&str>| {
        let output = folder.val3(&[&["run"], arguments].concat());
        let document = json(&file.map_or(output.stdout, |file| folder.read(file)));
        let prints = &document["prints"];
        (prints["count"].as_u64().unwrap(), prints["last"].as_array().unwrap().len())
    };
    assert_eq!(lists(&["--summary=json"], None), (1500, 20));
    assert_eq!(lists(&["--result", "r.json"], Some("r.json")), (1500, 1000));
}

#[test]
fn variables_and_fields_are_set_before_the_run() {
    let folder = Folder::with(
        "num nSpeed\nstring sName\nmdesc mFast\nprogram start()\nbegin\n  ? nSpeed\n  ? sName\n  ? mFast.leave\nend\n",
    );
    let output = folder.val3(&["run", "--set", "nSpeed=2.5", "--set", "sName=bolt", "--set", "mFast.leave=20"]);
    assert_eq!((output.code, output.stdout.as_str()), (0, "2.5\nbolt\n20\n"));
    let output = folder.val3(&["run", "--set", "nSped=1"]);
    assert_eq!(output.code, 2);
    assert!(output.stderr.contains("there is no variable `nSped`; did you mean `nSpeed`?"), "{}", output.stderr);
    let output = folder.val3(&["run", "--set", "sName=5"]);
    assert!(output.stderr.contains("`sName` is of type string"), "{}", output.stderr);
    let output = folder.val3(&["run", "--set", "sName=\"5\""]);
    assert_eq!(output.stdout, "0\n5\n50\n");
}

#[test]
fn a_refused_application_has_a_result() {
    let folder = Folder::with("program start()\nbegin\n  nMissing=1\nend\n");
    let output = folder.val3(&["run", "--summary=json"]);
    let document = json(&output.stdout);
    assert_eq!((output.code, document["reason"].as_str().unwrap()), (1, "refused"));
    assert!(document["notes"]["last"][0].as_str().unwrap().contains("nMissing"), "{document}");
}

#[test]
fn the_summary_and_the_events_need_separate_outputs() {
    let output = application().val3(&["run", "--summary", "--events", "-"]);
    assert_eq!(output.code, 2);
    assert!(output.stderr.contains("cannot both use the standard output"), "{}", output.stderr);
}
