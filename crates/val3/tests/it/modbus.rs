//! `val3 run --modbus` without clients: its usage and the faults of the file. `tests/python/test_modbus.py` has clients.

use expect_test::{Expect, expect};

use crate::support::Folder;

const MODBUS: &str = r#"<TOPICSLIST>
<TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" Actif="1">
<MODULE IDModule="BOOLEAN" OutputSize="9">
<ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
<ITEM Name="bIn" Syntaxe="%Q1:8" Offset="1"/></MODULE>
</TOPIC>
<GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502" ConnectionNumber="2"/>
</TOPICSLIST>
"#;

const TABLE: &str = "applicom/Modbus/modbus.xml";

/// Runs a program with `--modbus` and the file, of which a text is replaced. Returns the exit code and the messages,
/// with any port as 1502.
fn run(from: &str, to: &str, options: &[&str]) -> String {
    let folder = Folder::with("? 1\n");
    assert!(MODBUS.contains(from), "{from}");
    folder.write(TABLE, &MODBUS.replacen(from, to, 1));
    let run = folder.val3(&[&["run", "usrapp/main", "--modbus", "0"], options].concat());
    let messages = run.stderr.split_inclusive('\n').map(|line| match line.split_once("127.0.0.1:") {
        Some((before, after)) => {
            format!("{before}127.0.0.1:1502{}", after.trim_start_matches(|c: char| c.is_ascii_digit()))
        }
        None => line.to_owned(),
    });
    format!("{}\n{}", run.code, messages.collect::<String>())
}

fn check(from: &str, to: &str, expected: Expect) {
    expected.assert_eq(&run(from, to, &[]));
}

#[test]
fn a_run_states_the_address_and_the_tables() {
    check(
        "",
        "",
        expect![[r#"
        0
        note: the Modbus server of `Modbus` is at 127.0.0.1:1502: 9 bits, 0 words, at most 2 clients
    "#]],
    );
    check(
        "\"9\"",
        "\"8\"",
        expect![[r#"
        0
        warning: applicom/Modbus/modbus.xml:3: `OutputSize` is 8, but the items of the module have 9 bits
        note: the Modbus server of `Modbus` is at 127.0.0.1:1502: 9 bits, 0 words, at most 2 clients
    "#]],
    );
}

#[test]
fn uncertain_addresses_are_not_served() {
    check(
        "%Q1:8",
        "%Q0:9",
        expect![[r#"
        2
        error: `applicom/Modbus/modbus.xml` cannot be served: it does not determine all addresses
          applicom/Modbus/modbus.xml:5: `bIn` and `bStart` have the same address 0
          applicom/Modbus/modbus.xml:5: `Offset` of `bIn` is 1, but its `Syntaxe` has the address 0
    "#]],
    );
    check(
        "Actif=\"1\"",
        "Actif=\"0\"",
        expect![[r#"
        2
        error: `applicom/Modbus/modbus.xml` cannot be served: no topic is active
          help: set `Actif` to 1 in the topic that shall be served, and to 0 in all others
    "#]],
    );
    check(
        " ConnectionNumber=\"2\"",
        "",
        expect![[r#"
        2
        error: `applicom/Modbus/modbus.xml` cannot be served: it has no number of clients for `Modbus`
          help: write <GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502" ConnectionNumber="2"/> at its end
    "#]],
    );
}

#[test]
fn usage_is_checked() {
    let folder = Folder::with("? 1\n");
    let usage = |args: &[&str]| {
        let run = folder.val3(&[&["run", "usrapp/main"], args].concat());
        assert_eq!((run.code, run.stdout.as_str()), (2, ""));
        run.stderr
    };
    assert!(usage(&["--modbus"]).contains("`usr/applicom/Modbus/modbus.xml` does not exist"));
    assert!(usage(&["--modbus", "somewhere"]).contains("ADDRESS:PORT"));
    assert!(usage(&["--modbus", "0", "--replay", "run.jsonl"]).contains("cannot be used with"));
    folder.write(TABLE, MODBUS);
    assert!(usage(&["--modbus", "0", "--time", "virtual"]).contains("omit --time virtual"));
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let address = taken.local_addr().unwrap().to_string();
    assert!(usage(&["--modbus", &address]).contains(&format!("cannot serve Modbus at {address}")));
}

/// The client writes the inputs of the robot, also without a server.
#[test]
fn items_of_the_client_are_inputs() {
    let folder = Folder::with("dio doStart\ndoStart=true\n");
    folder.write(TABLE, MODBUS);
    folder.link("doStart", r"ModbusSrv-0\Modbus-Bit\bStart");
    let run = folder.val3(&["run", "usrapp/main"]);
    assert!(run.code == 1 && run.stderr.contains("error[122]"), "{run:?}");
    // Without the file, the links show which items are needed.
    std::fs::remove_file(folder.path().join(TABLE)).unwrap();
    let run = folder.val3(&["run", "usrapp/main", "--modbus", "0"]);
    assert!(run.code == 2 && run.stderr.contains("  ModbusSrv-0\\Modbus-Bit\\bStart\n"), "{run:?}");
}
