//! Run-time errors of inputs and outputs in a run, before and after the fault (12.1).

use crate::support::Folder;

/// A program that accesses a signal three times, one second apart, each time in a new task.
const PROGRAM: &str = r#"
dio dOut
dio dIn
aio aOut
dio dNone
dio dAll[1]
num nTry
program start()
begin
  for nTry=1 to 3
    taskCreate "try",10,try()
    delay(1)
    ? taskStatus("try")
    taskKill("try")
  endFor
end
program try()
begin
  ACT
  wait(false)
end
"#;

/// Results of `taskStatus` for the three accesses: 1, or the error. The second access follows `event`, the third
/// follows `undo`.
fn tries(act: &str, event: &str, undo: &str) -> String {
    let folder = Folder::with(&PROGRAM.replace("ACT", act));
    folder.link("dOut", "BasicIO-1\\%Q0");
    folder.link("dIn", "BasicIO-1\\%I0");
    folder.link("aOut", "BasicIO-1\\%QW1");
    folder.write("script.toml", &format!("[[at]]\nt = 0.5\n{event}\n[[at]]\nt = 1.5\n{undo}\n"));
    let run = folder.val3(&["run", "--script", "script.toml", "usrapp/main"]);
    run.stdout.lines().filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}

#[test]
fn protected_outputs_raise_errors() {
    for (signal, act) in [("BasicIO-1\\\\%Q0", "dOut=true"), ("BasicIO-1\\\\%QW1", "aioSet(aOut,1)")] {
        let protect = |protected| format!("protect = {{ \"{signal}\" = {protected} }}");
        assert_eq!(tries(act, &protect(true), &protect(false)), "1 124 1", "{act}");
    }
    let protect = "protect = { \"BasicIO-1\\\\%Q0\" = true }";
    assert_eq!(tries("wait(dOut==false)", protect, ""), "1 1 1", "it can be read");
    assert_eq!(tries("nTry=nTry+0*ioStatus(dOut)", protect, ""), "1 1 1", "and works");
    assert_eq!(tries("dioLink(dAll[0],dOut)\n  dioSet(dAll,1)", protect, ""), "1 124 124");
}

#[test]
fn failed_devices_raise_errors() {
    let fail = |link: &str, code: i32| format!("fault = {{ link = \"{link}\", code = {code} }}");
    for (act, link) in [("dOut=true", "BasicIO-1\\\\%Q0"), ("wait(dIn==false)", "BasicIO-1\\\\%I0")] {
        assert_eq!(tries(act, &fail(link, -3), &fail(link, 0)), "1 125 1", "{act}");
        assert_eq!(tries(act, &fail(link, -2), &fail(link, 0)), "1 123 1", "{act}");
        assert_eq!(tries(act, &fail("BasicIO-1", 7), &fail("BasicIO-1", 0)), "1 125 1", "{act}");
        assert_eq!(tries(act, &fail("BasicIO-2", 7), ""), "1 1 1", "{act}: another device");
    }
    assert_eq!(tries("nTry=nTry+0*ioStatus(dOut)", &fail("BasicIO-1", 7), ""), "1 1 1", "its state can be asked");
}

#[test]
fn inputs_and_missing_links_raise_errors() {
    let locked = "lock = [\"BasicIO-1\\\\%I0\", \"BasicIO-1\\\\%Q0\"]";
    let simulated = "simulate = { \"BasicIO-1\\\\%I0\" = true }";
    for event in [locked, simulated, "protect = { \"BasicIO-1\\\\%I0\" = true }"] {
        assert_eq!(tries("dIn=true", event, ""), "122 122 122", "{event}");
        assert_eq!(tries("wait(dIn==false)", event, ""), "1 1 1", "{event}");
    }
    assert_eq!(tries("dOut=true", locked, ""), "1 1 1", "writing a locked output has no effect and is no error");
    for act in ["dNone=true", "wait(dNone==false)", "dioSet(dAll,1)", "dioGet(dAll)"] {
        let act = if act.starts_with("dioGet") { "nTry=nTry+0*dioGet(dAll)" } else { act };
        assert_eq!(tries(act, "", ""), "123 123 123", "{act}");
    }
    assert_eq!(tries("nTry=nTry+0*ioStatus(dNone)", "", ""), "1 1 1");
}
