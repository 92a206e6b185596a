//! The example cells: `palletiser` has no faults, `faulty` has the faults that its comments describe.

use val3_tests::cell;

/// Faults of `examples/faulty`: code, file below `usr/usrapp`, text of the line.
const FAULTS: &[(&str, &str, &str)] = &[
    ("V0014", "sorter/sort.pgx", "call feeder:advance"),
    ("V0101", "sorter/count.pgx", "nSortd"),
    ("V0203", "sorter/drop.pgx", "movej("),
    ("V0302", "sorter/pause.pgx", "putln("),
    ("V0322", "sorter/belt.pgx", "taskCreate"),
    ("V0401", "sorter/home.pgx", "movej("),
    ("V0501", "sorter/sorter.pjx", "park.pgx"),
    ("V0512", "sorter/sorter.dtx", "key=\"2\""),
    ("V0520", "sorter/sorter.dtx", "fTabel"),
    ("V0602", "sorter/start.pgx", "feeder:reset"),
    ("V0607", "sorter/start.pgx", "Disk://feederStep"),
    ("V0701", "sorter/stop.pgx", "  endif"),
];

/// Words that introduce the comment on a fault, one for each family.
const FAMILIES: &[&str] =
    &["Syntax: ", "Names: ", "Types: ", "Flow: ", "Tasks: ", "Motion: ", "Project: ", "Data: ", "Library: ", "Style: "];

#[test]
fn the_faults_are_where_they_should_be() {
    let cell = cell::files("faulty");
    for (code, file, text) in FAULTS {
        assert_eq!(cell::place_of(&cell, file, text).err(), None, "{code}");
    }
}

#[test]
fn each_fault_has_a_comment_of_its_family() {
    let cell = cell::files("faulty");
    let texts: Vec<String> = cell.iter().map(|(path, _)| cell::text_of(&cell, path).unwrap_or_default()).collect();
    let count = |family: &str| texts.iter().map(|text| text.matches(family).count()).sum::<usize>();
    assert!(FAMILIES.iter().all(|family| count(family) > 0));
    assert_eq!(FAMILIES.iter().map(|family| count(family)).sum::<usize>(), FAULTS.len());
}

#[test]
fn the_cells_have_the_layout_of_the_tools() {
    let of_tools = |(path, _): &&(String, Vec<u8>)| path.starts_with("usr/");
    for (path, bytes) in cell::files("palletiser").iter().chain(&cell::files("faulty")).filter(of_tools) {
        let applications = path.starts_with(cell::APPLICATIONS);
        assert!(!applications || bytes.starts_with(b"\xef\xbb\xbf"), "{path}: no byte order mark");
        assert!(!bytes.contains(&b'\r') && !bytes.ends_with(b"\n"), "{path}: line ends");
    }
}

#[test]
fn the_palletiser_is_clean() {
    assert_eq!(val3_tests::check(&cell::files("palletiser")), []);
}

#[test]
fn the_sorter_has_its_faults_and_no_others() {
    let cell = cell::files("faulty");
    let mut expected: Vec<(String, String, usize)> = FAULTS
        .iter()
        .map(|(code, file, text)| {
            cell::place_of(&cell, file, text).map(|(path, line)| ((*code).to_owned(), path, line))
        })
        .collect::<Result<_, _>>()
        .unwrap_or_default();
    expected.sort();
    let mut found: Vec<_> =
        val3_tests::check(&cell).into_iter().map(|finding| (finding.code, finding.file, finding.line)).collect();
    found.sort();
    assert_eq!(found, expected);
}
