//! Counters of lines and branch sides.

use std::collections::BTreeMap;
use std::sync::Arc;

use expect_test::{Expect, expect};
use val3_bytecode::Image;

use crate::execution::{LINE_COST, rest, started};
use crate::show::counted_image;
use val3_test::Fixture;

/// Runs the program `start`, and returns its lines with their counts and the counts of their sides.
fn counted(listing: &str) -> String {
    let image = Arc::new(counted_image(listing));
    let mut controller = started(&image, LINE_COST);
    rest(&mut controller);
    let (_, hits) = controller.vm.space.counts.images().next().unwrap();
    let counts = counts(&image, hits);
    let file = Fixture::parse(listing).files.into_iter().find(|(path, _)| path.ends_with("start.pgx")).unwrap();
    let text = String::from_utf8(file.1.into()).unwrap();
    let code = text.lines().zip(1u32..).skip_while(|(line, _)| *line != "begin" && !line.ends_with("[begin"));
    let shown = code.take_while(|(line, _)| !line.starts_with("end]") && *line != "end").map(|(line, row)| {
        let line = line.rsplit('[').next().filter(|_| line.starts_with('<')).unwrap_or(line);
        format!("{:<3} {line}\n", counts.get(&row).cloned().unwrap_or_default())
    });
    shown.skip(1).collect()
}

/// Returns the counts of the program `start` by row, as text.
fn counts(image: &Image, hits: &[u64]) -> BTreeMap<u32, String> {
    let program = image.programs.iter().find(|program| program.name == "start").unwrap();
    let hits = |counter: u16| hits[program.counters.first as usize + usize::from(counter)];
    let mut counts: BTreeMap<u32, String> =
        program.counted_lines().map(|(row, counter)| (row, hits(counter).to_string())).collect();
    for branch in &program.counters.branches {
        let sides = branch.sides.iter().map(|side| format!("{} {}", side.name, hits(side.counter)));
        *counts.entry(branch.row).or_default() += &format!(" ({})", sides.collect::<Vec<_>>().join(", "));
    }
    counts
}

#[track_caller]
fn check(code: &str, expected: Expect) {
    let listing = format!("num nX\nprogram start()\n  num i\n  num j\n  bool b\n  string s\nbegin\n{code}\nend");
    expected.assert_eq(&counted(&listing));
}

#[test]
fn both_sides_of_conditions_are_counted() {
    check(
        "for i=1 to 5\nif i==2\nj=1\nelseIf i==3 or i==4\nj=2\nelse\nj=3\nendIf\nif i>9\nj=0\nendIf\nif i<9\nendIf\nendFor",
        expect![[r#"
            1 (round 5, end 1) for i=1 to 5
            5 (true 1, false 4) if i==2
            1   j=1
            4 (true 2, false 2) elseIf i==3 or i==4
            2   j=2
                else
            2   j=3
                endIf
            5 (true 0, false 5) if i>9
            0   j=0
                endIf
            5 (true 5, false 0) if i<9
                endIf
                endFor
        "#]],
    );
}

#[test]
fn rounds_and_ends_of_loops_are_counted() {
    check(
        "while i<3\ni=i+1\nendWhile\nwhile i<3\nendWhile\ndo\ni=i-1\nuntil i<=0\ndo\ndo\ni=i+1\nuntil true\nuntil i>2\nfor i=1 to 0\nj=j+1\nendFor\nfor nX=1 to 2\nendFor",
        expect![[r#"
            4 (true 3, false 1) while i<3
            3   i=i+1
                endWhile
            1 (true 0, false 1) while i<3
                endWhile
                do
            3   i=i-1
            3 (false 2, true 1) until i<=0
                do
                do
            3   i=i+1
            3   until true
            3 (false 2, true 1) until i>2
            1 (round 0, end 1) for i=1 to 0
            0   j=j+1
                endFor
            1 (round 2, end 1) for nX=1 to 2
                endFor
        "#]],
    );
}

#[test]
fn each_case_is_counted() {
    check(
        "for i=1 to 4\nswitch i\ncase 1,2\nj=1\nbreak\ncase 9\nbreak\nendSwitch\nswitch s\ncase \"a<\"\nj=1\nbreak\ndefault\nj=2\nbreak\nendSwitch\nendFor",
        expect![[r#"
            1 (round 4, end 1) for i=1 to 4
            4 (case 1,2 2, case 9 0, no case 2) switch i
                case 1,2
            2   j=1
                break
                case 9
                break
                endSwitch
            4 (case "a<" 0, default 4) switch s
                case "a<"
            0   j=1
                break
                default
            4   j=2
                break
                endSwitch
                endFor
        "#]],
    );
}

/// Loops in blocks: the entry into the block is counted once, the iterations by the loop's counter.
#[test]
fn sides_that_begin_with_loops_are_counted_once() {
    check(
        "b=true\nif b\nwhile i<3\ni=i+1\nendWhile\nendIf\nif b\ndo\ni=i+1\nuntil i>6\nendIf\nif !b\nj=0\nelse\nfor i=1 to 2\nendFor\nendIf",
        expect![[r#"
            1   b=true
            1 (true 1, false 0) if b
            4 (true 3, false 1) while i<3
            3   i=i+1
                endWhile
                endIf
            1 (true 1, false 0) if b
                do
            4   i=i+1
            4 (false 3, true 1) until i>6
                endIf
            1 (true 0, false 1) if !b
            0   j=0
                else
            1 (round 2, end 1) for i=1 to 2
                endFor
                endIf
        "#]],
    );
}

#[test]
fn conditions_that_the_compiler_knows_are_no_branches() {
    check(
        "if true\nj=1\nendIf\nif false\nj=1\nelse\nj=2\nendIf\nwhile false\nj=1\nendWhile",
        expect![[r#"
            1   if true
            1   j=1
                endIf
            1   if false
            0   j=1
                else
            1   j=2
                endIf
            1   while false
            0   j=1
                endWhile
        "#]],
    );
}

/// A line with a waiting instruction counts once. A line that stops its task counts as executed.
#[test]
fn waiting_lines_are_counted_once() {
    check(
        "wait(clock()>0.5)\ndelay(0.1)\nb=watch(false,0.2)\nj=1/nX\nj=2",
        expect![[r#"
            1   wait(clock()>0.5)
            1   delay(0.1)
            1   b=watch(false,0.2)
            1   j=1/nX
            0   j=2
        "#]],
    );
}

#[test]
fn code_is_left_out() {
    check(
        "j=0\n//val3: no-coverage\ni=1\ni=2\n//val3: no-coverage\nif i==2\ni=3\nendIf\nif i==3\ni=4\n//val3: no-coverage\nelse\ni=5\nendIf\nswitch i\n\
         case 4\n//val3: no-coverage\ni=1\ni=2\nbreak\n//val3: no-coverage never\ndefault\ni=6\nbreak\nendSwitch\nif i==2\n//val3: no-coverage\nelseIf i==3\ni=1\nendIf",
        expect![[r#"
            1   j=0
                //val3: no-coverage
                i=1
            1   i=2
                //val3: no-coverage
                if i==2
                i=3
                endIf
            1 (true 1) if i==3
            1   i=4
                //val3: no-coverage
                else
                i=5
                endIf
            1 (case 4 1) switch i
                case 4
                //val3: no-coverage
                i=1
            1   i=2
                break
                //val3: no-coverage never
                default
                i=6
                break
                endSwitch
            1 (true 1, false 0) if i==2
                //val3: no-coverage
                elseIf i==3
                i=1
                endIf
        "#]],
    );
}

#[test]
fn a_program_is_left_out() {
    let image =
        counted_image("program start()\nbegin\n//val3: no-coverage\n? 1\nend\nprogram other()\nbegin\n? 2\nend");
    let counters = |name: &str| image.programs.iter().find(|program| program.name == name).unwrap().counters.count;
    assert_eq!([counters("start"), counters("other")], [0, 1]);
}
