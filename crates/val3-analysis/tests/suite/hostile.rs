//! Malformed input: no panic, no endless loop.

use std::fmt::Write;

use crate::show::{faults, types};

fn repeated(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |mut out, index| {
        writeln!(out, "{}", line(index)).unwrap();
        out
    })
}

#[test]
fn thousands_of_aliases() {
    let aliases = repeated(5000, |index| format!("library a{index} \"Disk://part/part.pjx\""));
    let uses = repeated(5000, |index| format!("nA=a{index}:nWeight"));
    let listing = format!("{aliases}num nA\n{uses}--- part\npublic num nWeight\n");
    assert_eq!(faults(&listing), "");
}

#[test]
fn thousands_of_libraries_in_a_circle() {
    let project = |index: usize| format!("--- p{index}\nlibrary next \"Disk://p{0}/p{0}.pjx\"", (index + 1) % 300);
    let found = faults(&repeated(300, project));
    assert_eq!(found.lines().count(), 1, "{found}");
}

#[test]
fn thousands_of_unknown_names() {
    let data = repeated(1500, |index| format!("num nValue{index}"));
    let uses = repeated(1500, |index| format!("nValu{index}=1"));
    assert_eq!(faults(&(data + &uses)).lines().count(), 1500);
}

fn data_of_size(size: &str) -> String {
    format!(
        "nA[5]=1\n=== main/main.dtx\n<Database><Datas><Data name=\"nA\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"{size}\" /></Datas></Database>"
    )
}

#[test]
fn sizes_of_all_sorts() {
    assert_eq!(faults(&data_of_size("1000000")), "");
    for size in ["4294967295", "65536 65536", "4294967295 4294967295 4294967295"] {
        assert_eq!(
            faults(&data_of_size(size)).lines().filter(|line| line.contains("DataTooLarge")).count(),
            1,
            "{size}"
        );
    }
    for size in ["4294967296", "-1", "0", "", " ", "1 2 3 4", "1,2", "ten", &"1 ".repeat(10_000)] {
        assert_eq!(
            faults(&data_of_size(size)).lines().filter(|line| line.contains("InvalidSize")).count(),
            1,
            "{size}"
        );
    }
}

#[test]
fn a_type_that_contains_itself() {
    let path = ".tInner".repeat(60);
    let listing = format!(
        "type Slot \"Disk://Slot/Slot.pjx\"\nnum nA\nSlot tA\nnA=tA{path}.nCount\n--- Slot\n\
         type Slot \"Disk://Slot/Slot.pjx\"\npublic Slot tInner\npublic num nCount\n"
    );
    let found = faults(&listing);
    assert_eq!(found.lines().count(), 1, "{found}");
    assert!(found.contains("LibraryCircle"), "{found}");
}

#[test]
fn long_chains() {
    for count in [100, 5_000, 100_000] {
        let (sum, product) = ("+1".repeat(count), "*-1".repeat(count));
        let (fields, indexes) = (".x".repeat(count), "[0]".repeat(count));
        let (assigned, brackets) = ("nA=".repeat(count), "(".repeat(count));
        let braces = "{".repeat(count);
        types(&format!(
            "num nA\nnA=1{sum}\nnA=1{product}\nnA=nA{fields}\nnA=nA{indexes}\nnA={assigned}1\nnA={brackets}1\nnA={braces}"
        ));
    }
}

#[test]
fn odd_names() {
    for name in ["", " ", "ä", "名", "a b", "1a", "a:b", "a.b", "&lt;", "a\u{0}b", "\u{202e}a", &"a".repeat(100_000)]
    {
        let listing = format!(
            "nA=1\n=== main/main.dtx\n<Database><Datas><Data name=\"{name}\" type=\"{name}\" size=\"{name}\"><Value \
             key=\"{name}\" fatherId=\"{name}\" /></Data></Datas></Database>\n=== main/run.pgx\n<Programs><Program \
             name=\"{name}\"><Parameters><Parameter name=\"{name}\" type=\"{name}\" /></Parameters>\
             <Code><![CDATA[begin\n{name}={name}\nend]]></Code></Program></Programs>\n=== main/main.pjx\n<Project>\
             <Programs><Program file=\"{name}\" /><Program file=\"start.pgx\" /><Program file=\"run.pgx\" /></Programs>\
             <Database><Data file=\"main.dtx\" /></Database><Libraries><Library alias=\"{name}\" path=\"{name}\" />\
             </Libraries><Types><Type name=\"{name}\" path=\"{name}\" /></Types></Project>"
        );
        faults(&listing);
    }
}

#[test]
fn fathers_of_all_sorts() {
    for father in
        ["[", "]", "a[", "a[0", "[0]", ".", "a.", ".a", "a[\"x\"", "a[0][0]", "a[99999999999]", "a[-1]", "é[0]"]
    {
        let listing = format!(
            "=== main/main.pjx\n<Project><Database><Data file=\"main.dtx\" /></Database></Project>\n=== main/main.dtx\n\
             <Database><Datas><Data name=\"a\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"><Value \
             key=\"0\" fatherId=\"{}\" /></Data></Datas></Database>",
            father.replace('"', "&quot;")
        );
        faults(&listing);
    }
}
