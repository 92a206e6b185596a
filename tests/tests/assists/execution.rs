//! Programs behave the same before and after an assist.

use val3_analysis::db::FileRange;
use val3_ide::{SourceChange, resolve_assist};
use val3_syntax::{TextRange, TextSize};
use val3_test::Fixture;
use val3_tests::cell::Cell;
use val3_tests::running::Running;

use crate::assists::editor::Editor;

/// Programs that print the values that they evaluate.
const PROGRAMS: &str = "
num nA = 5
num nB = 2
num nStep = 0
bool bA = true
bool bB = false
string sA = \"x\"
point pA
trsf trA

program say(string x_s, num& x_n)
begin
  nStep=nStep+1
  x_n=x_n+nStep
  ?x_s
  ?x_n
end

program many(num x_a, num x_b, num& x_c)
begin
  ?x_a
  ?x_b
  x_c=x_a-x_b
end
";

fn cell(listing: &str) -> (Cell, String, TextRange) {
    let mut files: Cell = Vec::new();
    let mut marked = None;
    for (path, mut text) in Fixture::parse(&format!("{PROGRAMS}{listing}")).files {
        while let Some(at) = text.find("$0") {
            text.replace_range(at..at + 2, "");
            let at = TextSize::try_from(at).unwrap();
            marked = Some((
                path.clone(),
                marked.map_or(TextRange::empty(at), |(_, range): (_, TextRange)| range.cover_offset(at)),
            ));
        }
        files.push((path, text.into_bytes()));
    }
    let (path, range) = marked.unwrap();
    (files, path, range)
}

/// Returns the output of the application, with the numbers of run-time errors.
fn printed(cell: &Cell) -> String {
    let text = |bytes: &Vec<u8>| String::from_utf8(bytes.clone()).unwrap();
    let raw = |(path, bytes): &(String, Vec<u8>)| {
        format!("=== {}\n{}\n", path.trim_start_matches("usrapp/"), text(bytes).trim_end())
    };
    Running::start(&cell.iter().map(raw).collect::<String>()).to_the_end().printed()
}

/// Applies an assist at `$0`, or between two of them, and compares the runs.
#[track_caller]
fn check(id: &str, code: &str) -> SourceChange {
    let (files, path, range) = cell(code);
    let editor = Editor::open(&files);
    let is_own = |file: &val3_analysis::db::File| file.path(editor.db()).as_str().ends_with(&path);
    let file = editor.files().into_iter().find(is_own).unwrap();
    let change = resolve_assist(editor.db(), id, FileRange { file, range });
    let change = change.unwrap_or_else(|| panic!("`{id}` is not offered: {code}"));
    let before = printed(&files);
    assert!(!before.is_empty(), "the program prints nothing: {code}");
    assert_eq!(printed(&editor.after(&change)), before, "`{id}`: {code}\n{change:#?}");
    change
}

#[test]
fn an_extracted_variable_has_the_value_of_the_expression() {
    for code in [
        "nA=$0(nA+nB)$0*2\n?nA",
        "nA=$0nA*nB$0+nA*nB\n?nA",
        "call many($0nA-nB$0,nB,nB)\n?nB",
        "call many(1,$0nA*2$0,nA)\n?nA",
        "if $0nA>nB$0 and bA\n  ?\"yes\"\nendIf",
        "nA=$0clock()$0*0+nB\n?nA",
        "bA=$0toNum(\"7 x\",nStep,bB)!=\"\"$0\n?bA\n?bB",
        "sA=$0sA+toString(\".2\",nA)$0\n?sA",
        "pA.trsf=$0pA.trsf*trA$0\n?pA.trsf==trA",
        "switch $0nA-nB$0\n  case 3\n    ?\"three\"\n  break\n  default\n    ?\"other\"\n  break\nendSwitch",
        "if $0nA/nStep$0>1\n  ?1\nendIf",
        "while nStep<3\n  call say($0sA+\"!\"$0,nB)\nendWhile",
        "taskCreate $0\"ta\"+\"sk\"$0,10,many(nA,nB,nStep)\ndelay(1)\n?nStep",
    ] {
        check("extract-variable", code);
    }
}

#[test]
fn all_occurrences_have_the_value_of_the_first() {
    for code in [
        "nA=$0nB*3$0+nB * 3\n?nA\nif nA>(nB*3)\n  nStep=nB*3\nendIf\n?nStep\nnB=nB*3\n?nB\n?nB*3",
        "?nB*3\n?$0nB*3$0\ncall say(\"a\",nB)\n?nB*3",
        "?nB*3\nnB=1\n?$0nB*3$0\n?nB*3\n",
    ] {
        check("extract-variable-all", code);
    }
}

#[test]
fn an_inlined_variable_has_the_value_of_the_expression() {
    let program =
        |code: &str| format!("program start()\n  num l_n\n  num l_m\n  string l_s\n  bool l_b\nbegin\n{code}\nend");
    for code in [
        "l$0_n=nA+nB\n?l_n*2\n?2-l_n\n?-l_n",
        "l$0_n=nA-nB\nnA=l_n-l_n\n?nA",
        "l$0_s=sA+\"b\"\ncall say(l_s,nB)\n?nB",
        "l$0_n=-nA\n?nB-l_n\n?nB*l_n",
        "l_m=4\nl$0_n=l_m+1\ncall say(sA,nB)\ndelay(0.1)\n?l_n",
        "l$0_b=toNum(\"7 x\",nStep,bB)!=\"\"\nif l_b or bA\n  ?bB\nendIf",
        "l$0_b=nA>nB or bB\nif l_b and bA\n  ?!l_b\nelse\n  ?l_b\nendIf",
        "while nStep<3\n  l$0_n=nStep+1\n  nStep=l_n\n  ?nStep\nendWhile",
    ] {
        check("inline-variable", &program(code));
    }
}

/// Returns variants of the code for all values of the condition variables, so that every branch side is executed.
fn with_values(code: &str) -> impl Iterator<Item = String> {
    (0..8).map(move |bits| {
        let value = |bit: u32| bits >> bit & 1 == 1;
        format!("bA={}\nbB={}\nnA={}\n{code}\n?nStep", value(0), value(1), if value(2) { 5 } else { 2 })
    })
}

#[test]
fn an_inverted_if_takes_the_same_branches() {
    for condition in [
        "bA",
        "!bA",
        "bA and bB",
        "!bA or nA>nB",
        "bA and bB or nA==nB",
        "(bA or bB) and nA!=nB",
        "!(bA and bB)",
        "bA xor bB",
        "nA<nB or nA>=5",
        "(bA and !bB)",
        "bA==bB and sA!=\"y\"",
        "(bA xor bB) or !(nA<=2 and bB)",
        "toNum(\"7 x\",nStep,bB)!=\"\" and bA or toNum(\"7 x\",nStep,bB)!=\"\"",
    ] {
        for code in with_values(&format!(
            "i$0f {condition}\n  // yes\n  call say(\"yes\",nStep)\nelse\n  call say(\"no\",nStep)\nendIf\n?bB"
        )) {
            check("invert-if", &code);
        }
    }
}

#[test]
fn merged_and_split_conditions_take_the_same_branches() {
    let conditions = [
        "bA and bB",
        "(bA or bB) and nA==5",
        "toNum(\"7 x\",nStep,bB)!=\"\" and toNum(\"7 x\",nStep,bB)!=\"\"",
        "bA and nA>2 and nA/nStep>1",
        "nA<3 and (bA or bB)",
    ];
    for condition in conditions {
        for code in with_values(&format!("i$0f {condition}\n  call say(\"yes\",nStep)\nendIf\n?bB")) {
            check("split-if", &code);
        }
    }
    for (outer, inner) in [
        ("bA or bB", "nA==5"),
        ("bA", "bB or nA==5"),
        ("bA and bB", "nA==5 and !bB"),
        ("toNum(\"7 x\",nStep,bB)!=\"\"", "toNum(\"7 x\",nStep,bB)!=\"\" or bA"),
    ] {
        for code in
            with_values(&format!("i$0f {outer}\n  if {inner}\n    call say(\"yes\",nStep)\n  endIf\nendIf\n?bB"))
        {
            check("merge-if", &code);
        }
    }
    let chain = "if bA\n  call say(\"a\",nStep)\nel$0seIf toNum(\"7 x\",nStep,bB)!=\"\"\n  call say(\"b\",nStep)\nelseIf nA==5\n  call say(\"c\",nStep)\nelse\n  call say(\"d\",nStep)\nendIf\n?bB";
    with_values(chain).for_each(|code| drop(check("split-if", &code)));
    let nested = "if bA\n  call say(\"a\",nStep)\nel$0se\n  if toNum(\"7 x\",nStep,bB)!=\"\"\n    call say(\"b\",nStep)\n  elseIf nA==5\n    call say(\"c\",nStep)\n  else\n    call say(\"d\",nStep)\n  endIf\nendIf\n?bB";
    with_values(nested).for_each(|code| drop(check("merge-if", &code)));
}

#[test]
fn missing_cases_do_nothing() {
    let switch = "if nA==9\n  ?nA\nendIf\nsw$0itch nA\n  case 2\n    call say(\"two\",nStep)\n  break\nendSwitch";
    with_values(switch).for_each(|code| drop(check("add-missing-cases", &code)));
    with_values(switch).for_each(|code| drop(check("add-default", &code)));
}
