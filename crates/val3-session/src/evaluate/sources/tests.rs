use proptest::prelude::*;

use super::texts;

#[test]
fn lines_are_texts_and_blocks_are_kept_together() {
    assert_eq!(texts("1+1"), ["1+1"]);
    assert_eq!(texts("nA=1\r\n\r\nnA\r\n"), ["nA=1", "nA"]);
    assert_eq!(texts("if nA==1\n\n  ? nA\nendIf\n? 2"), ["if nA==1\n\n  ? nA\nendIf", "? 2"]);
    assert_eq!(texts("while true\n? 1"), ["while true\n? 1"], "a block that is not closed is the last text");
    assert_eq!(texts(" \n"), [""; 0]);
}

#[test]
fn faulty_blocks_are_kept_together() {
    for block in [
        "switch nA\n  case 0\n    nA=1\nendSwitch",
        "switch nA\n  nA=1\n  case 0\n  break\nendSwitch",
        "if nA=1\n  nA=2\nendIf",
        "while nA<\n  nA=2\nendWhile",
        "for nA=1 3\n  ? nA\nendFor",
        "if nA==1\n  nA=)\n  nA=2\nendIf",
    ] {
        assert_eq!(texts(&format!("{block}\n? 2")), [block, "? 2"]);
    }
}

/// Indented lines of one statement of a program.
fn statement() -> impl Strategy<Value = Vec<String>> {
    let line = prop::sample::select(vec!["nA=nA+1", "? nA", "//note", "delay(0)"]);
    let simple = line.prop_map(|line| vec![line.to_owned()]);
    simple.prop_recursive(4, 24, 3, |inner| {
        let branches = prop::collection::vec(prop::collection::vec(inner, 0..3), 1..3);
        (0..5_usize, branches).prop_map(|(kind, branches)| block(kind, branches))
    })
}

/// A block with its branches. A kind of block with one branch has the statements of all branches in it.
fn block(kind: usize, branches: Vec<Vec<Vec<String>>>) -> Vec<String> {
    let bodies = branches.into_iter().map(|branch| indented(branch.into_iter().flatten()));
    let (head, end) = match kind {
        0 => {
            let mut lines = vec!["if nA==0".to_owned()];
            for (number, body) in bodies.enumerate() {
                lines.extend((number > 0).then(|| format!("elseIf nA=={number}")));
                lines.extend(body);
            }
            lines.push("endIf".to_owned());
            return lines;
        }
        1 => {
            let cases = bodies.enumerate().flat_map(|(number, body)| {
                let body = indented(body.into_iter()).into_iter();
                std::iter::once(format!("  case {number}")).chain(body).chain(["  break".to_owned()])
            });
            return std::iter::once("switch nA".to_owned()).chain(cases).chain(["endSwitch".to_owned()]).collect();
        }
        2 => ("while nA<3", "endWhile"),
        3 => ("for nA=1 to 3", "endFor"),
        _ => ("do", "until nA>3"),
    };
    std::iter::once(head.to_owned()).chain(bodies.flatten()).chain([end.to_owned()]).collect()
}

fn indented(lines: impl Iterator<Item = String>) -> Vec<String> {
    lines.map(|line| format!("  {line}")).collect()
}

proptest! {
    /// Every statement of a program is one text, however its lines are indented.
    #[test]
    fn each_statement_is_a_text(statements in prop::collection::vec(statement(), 1..4), is_flat in any::<bool>()) {
        let shown = |lines: &Vec<String>| {
            let lines = lines.iter().map(|line| if is_flat { line.trim_start() } else { line.as_str() });
            lines.collect::<Vec<_>>().join("\n")
        };
        let expected: Vec<String> = statements.iter().map(shown).collect();
        prop_assert_eq!(texts(&expected.join("\n")), expected);
    }
}
