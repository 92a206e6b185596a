//! Scripts with unknown signals, data and lines, in applications that load libraries at run time.

use expect_test::expect;

use crate::support::{CommandOutput, Folder};

/// An application that loads the library `part` at 1 s. The library has a signal and data.
fn folder() -> Folder {
    let folder = Folder::with(
        "library part \"Disk://part/part.pjx\" autoload=false
dio dDoor
program start()
begin
  delay(1)
  if part:libLoad(\"Disk://part\")==0
    delay(2)
  endIf
end
--- part
public num nCount
public dio dCup
",
    );
    for (path, link) in [("usrapp/main/main.dtx", "valve1"), ("usrapp/part/part.dtx", "usrIn7")] {
        let unlinked = "type=\"dio\" size=\"1\" />";
        let data = folder.read(path);
        assert!(data.contains(unlinked), "{data}");
        let linked = format!("type=\"dio\" size=\"1\"><Value key=\"0\" link=\"{link}\" /></Data>");
        folder.write(path, &data.replace(unlinked, &linked));
    }
    folder
}

fn run(script: &str) -> CommandOutput {
    let folder = folder();
    folder.write("s.toml", script);
    folder.val3(&["run", "usrapp/main", "--script", "s.toml"])
}

fn test(scenario: &str) -> CommandOutput {
    let folder = folder();
    folder.write("tests/s.toml", &format!("application = \"../usrapp/main\"\n{scenario}"));
    folder.val3(&["test", "tests"])
}

#[test]
fn a_signal_that_no_variable_names_is_an_error_at_its_time() {
    let output = run("[[at]]\nt = 0.2\nio = { valv1 = true }\n[[at]]\nt = 2\nio = { usrIn7 = true, valve1 = true }\n");
    assert_eq!((output.code, output.stderr.as_str()), (0, ""), "{output:?}");
    expect![[r#"
        log: script, t = 0.2: no input or output is called `valv1`; did you mean `valve1`?
    "#]]
    .assert_eq(&output.stdout);
}

#[test]
fn a_signal_of_a_library_exists_when_the_library_is_loaded() {
    let early = run("[[at]]\nt = 0.2\nio = { usrIn7 = true }\n");
    expect![[r#"
        log: script, t = 0.2: no input or output is called `usrIn7`
    "#]]
    .assert_eq(&early.stdout);
    let late = run("[[at]]\nt = 2\nio = { usrIn7 = true }\nset = { \"part:nCount\" = 2 }\n");
    assert_eq!(late.stdout, "");
}

#[test]
fn an_expectation_never_finds_a_signal_of_the_script() {
    let output = test("[[at]]\nt = 0.2\nio = { valv1 = true }\n[expect]\nio = { valv1 = true }\n");
    assert_eq!(output.code, 1);
    expect![[r#"
        main
          FAIL  s (3.012 s)
                script, t = 0.2: no input or output is called `valv1`; did you mean `valve1`?
                `valv1` does not exist, so it is not true, at 3.012 s
                at expect.io (tests/s.toml:6)
                    6 │ io = { valv1 = true }
                last events:
                  0.200 s  log: script, t = 0.2: no input or output is called `valv1`; did you mean `valve1`?
                  1.000 s  library load `part` Disk://part: code 0 (task `main~`)
        0 passed, 1 failed
    "#]]
    .assert_eq(&output.stdout);
}

#[test]
fn data_and_lines_that_do_not_exist_fail_a_test_at_their_time() {
    let output = test(
        "[[at]]\nt = 2\nset = { \"part:nCuont\" = 1 }\n[[at]]\nt = 2.1\nreceive = { \"Socket\\\\hots\" = \"a\" }\n\
         [[at]]\nt = 2.2\nlock = \"usrIn8\"\n",
    );
    assert_eq!(output.code, 1);
    expect![[r#"
        main
          FAIL  s (3.012 s)
                script, t = 2: there is no variable `part:nCuont`
                script, t = 2.1: there is no serial line or socket `Socket\hots`
                script, t = 2.2: no input or output is called `usrIn8`; did you mean `usrIn7`?
                last events:
                  1.000 s  library load `part` Disk://part: code 0 (task `main~`)
                  2.000 s  log: script, t = 2: there is no variable `part:nCuont`
                  2.100 s  log: script, t = 2.1: there is no serial line or socket `Socket\hots`
                  2.200 s  log: script, t = 2.2: no input or output is called `usrIn8`; did you mean `usrIn7`?
        0 passed, 1 failed
    "#]]
    .assert_eq(&output.stdout);
}

#[test]
fn a_reaction_that_waits_for_nothing_is_an_error_at_the_end() {
    let script = "[[when]]\nio = { valv1 = true }\nthen = [{ key = \"F1\" }]\n\
                  [[when]]\nsent = { \"Socket\\\\host\" = \"a\" }\nthen = [{ key = \"F1\" }]\n\
                  [[when]]\ndata = { \"part:nCuont\" = 2 }\nthen = [{ key = \"F1\" }]\n\
                  [[when]]\nio = { usrIn7 = true }\ndata = { \"part:nCount\" = 2 }\nthen = [{ key = \"F1\" }]\n";
    expect![[r#"
        log: script, [[when]] in line 1: no input or output is called `valv1`; did you mean `valve1`?
        log: script, [[when]] in line 4: there is no serial line or socket `Socket\host`
        log: script, [[when]] in line 7: there is no variable `part:nCuont`; did you mean `part:nCount`?
    "#]]
    .assert_eq(&run(script).stdout);
    let output = test(script);
    assert_eq!(output.code, 1);
    expect![[r#"
        main
          FAIL  s (3.012 s)
                script, [[when]] in line 2: no input or output is called `valv1`; did you mean `valve1`?
                script, [[when]] in line 5: there is no serial line or socket `Socket\host`
                script, [[when]] in line 8: there is no variable `part:nCuont`; did you mean `part:nCount`?
                last events:
                  1.000 s  library load `part` Disk://part: code 0 (task `main~`)
        0 passed, 1 failed
    "#]]
    .assert_eq(&output.stdout);
}
