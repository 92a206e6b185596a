use expect_test::expect;

use super::*;
use crate::testing::MarkedListing;
use val3_syntax::TextSize;

fn shown(listing: &str) -> String {
    let marked = MarkedListing::new(listing);
    let at = marked.at();
    let text = at.file.text(marked.db());
    semantic_tokens(marked.db(), at.file, None).iter().map(|token| line(text, token)).collect()
}

fn line(text: &str, token: &SemanticToken) -> String {
    let names = TokenModifier::NAMES.iter().enumerate().filter(|(bit, _)| token.modifiers & (1 << bit) != 0);
    let modifiers: String = names.map(|(_, name)| format!(".{name}")).collect();
    let word = &text[std::ops::Range::<usize>::from(token.range)];
    format!("{word} {}{modifiers}\n", TokenKind::NAMES[token.kind as usize])
}

#[test]
fn data_files_have_tokens() {
    expect![[r#"
        fA variable.declaration.global.public
        frame type.defaultLibrary
        world variable.defaultLibrary
        sA variable.declaration.global
        Slot type
        pA property.modification
        pointRx type.defaultLibrary
        fA variable.global.public
    "#]].assert_eq(&shown(
        "type Slot \"Disk://Slot/Slot.pjx\"\ncls()\n--- Slot\npublic point pA\n=== main/main.dtx\n<Database><Datas>$0<Data name=\"fA\" access=\"public\" type=\"frame\"><Value key=\"0\" fatherId=\"world[0]\" /></Data><Data name=\"sA\" type=\"Slot\"><Value key=\"0\"><Field name=\"pA\" type=\"pointRx\"><Value key=\"0\" fatherId=\"fA[0]\" /></Field></Value></Data></Datas></Database>",
    ));
}

#[test]
fn project_files_have_tokens() {
    expect![[r#"
        start function
        part namespace.declaration
    "#]].assert_eq(&shown(
        "cls()\n=== main/main.pjx\n<Project>$0<Programs><Program file=\"start.pgx\" /></Programs><Libraries><Library alias=\"part\" path=\"Disk://part/part.pjx\" /></Libraries></Project>",
    ));
}

#[test]
fn instructions_of_add_ons_and_old_instructions_are_marked() {
    expect![[r#"
        start function.declaration
        begin keyword
        sA variable.modification.global
        = operator
        $exec method.defaultLibrary.addOn
        "ls" string
        $unheard method.defaultLibrary.addOn
        end keyword
    "#]]
    .assert_eq(&shown("num nA\nstring sA\n$0sA=$exec(\"ls\")\n$unheard()"));
}

#[test]
fn escaped_code_has_tokens() {
    expect![[r#"
        start function.declaration
        begin keyword
        if keyword
        nA variable.global
        &lt; operator
        3 number
        // no comment
        putln method.defaultLibrary
        &quot;a&quot; string
        ENDIF keyword
        end keyword
    "#]].assert_eq(&shown(
        "num nA\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code>begin\n$0if nA&lt;3 // no\nputln(&quot;a&quot;)\nENDIF\nend</Code></Program></Programs>",
    ));
}

#[test]
fn the_tokens_of_a_range_are_those_of_the_file() {
    let marked = MarkedListing::new("num nA\nnA=1\nif nA==2\n$0nA=3\nendIf\nputln(\"x\")");
    let (db, at) = (marked.db(), marked.at());
    let line = TextRange::at(at.offset, TextSize::of("nA=3"));
    let all = semantic_tokens(db, at.file, None);
    let expected: Vec<_> = all.iter().filter(|token| line.intersect(token.range).is_some()).copied().collect();
    let touching = |token: &SemanticToken| token.range.end() > line.start() && token.range.start() < line.end();
    let found: Vec<_> = semantic_tokens(db, at.file, Some(line)).into_iter().filter(touching).collect();
    assert_eq!(found, expected.into_iter().filter(touching).collect::<Vec<_>>());
    assert_eq!(found.len(), 3);
}

#[test]
fn code_has_tokens() {
    expect![[r#"
        other function.declaration
        x_n parameter.declaration.byReference
        num type.defaultLibrary
        l_i variable.declaration.local
        num type.defaultLibrary
        begin keyword
        // note comment
        l_i variable.modification.local
        = operator
        x_n parameter.byReference
        + operator
        part namespace
        nB variable.global.public.library
        * operator
        sin method.defaultLibrary
        2 number
        if keyword
        l_i variable.local
        == operator
        1 number
        putln method.defaultLibrary
        "x" string
        endIf keyword
        end keyword
    "#]].assert_eq(&shown(
        "library part \"Disk://part/part.pjx\"\nnum nA\ncall other(nA)\nprogram other(num& x_n)\n  num l_i\nbegin\n  // $0note\n  l_i=x_n+part:nB*sin(2)\n  if l_i==1\n    putln(\"x\")\n  endIf\nend\n--- part\npublic num nB",
    ));
}
