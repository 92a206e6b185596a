//! Results of fixes, in both dialects.

use expect_test::{Expect, expect};
use val3_test::{Fixture, ROOT};

use crate::testing::{fixed_files, offered_fixes};

/// Checks the fixes of a listing, and the code or the lines in each changed file.
fn check(listing: &str, expect: Expect) {
    check_as(str::to_owned, listing, expect);
}

/// As [`check`], with files that `change` modifies first.
fn check_as(change: fn(&str) -> String, listing: &str, expect: Expect) {
    let fixture = Fixture::parse(listing);
    let files = fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), change(text).into_bytes()));
    let files: Vec<_> = files.collect();
    let mut shown = String::new();
    for fix in offered_fixes(&files) {
        shown += &format!("{} {}{}\n", fix.code, fix.title, if fix.safe { "" } else { " (unsafe)" });
    }
    for ((_, before), (_, after)) in files.iter().zip(fixed_files(&files)) {
        let (before, after) = (str::from_utf8(before).unwrap(), str::from_utf8(&after).unwrap());
        if before != after {
            shown += &code(after).replace('\r', "␍");
            shown += "\n";
        }
    }
    expect.assert_eq(&shown);
}

/// Content of `<Code>`; for other files, the lines from the second on.
fn code(text: &str) -> &str {
    let code = text.split_once("<Code>").or_else(|| text.split_once('\n')).unwrap_or(("", text)).1;
    code.split("</Code>").next().unwrap().trim_start_matches("<![CDATA[").trim_end_matches("]]>")
}

/// Escapes the code of a program, as in the old dialect.
fn escaped(text: &str) -> String {
    let Some((head, rest)) = text.split_once("<![CDATA[") else { return text.to_owned() };
    let (code, tail) = rest.split_once("]]>").unwrap();
    let code = code.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    format!("{head}{code}{tail}")
}

#[test]
fn misspelt_names_are_corrected() {
    check(
        "num nCount\nstring sName\n\nnCuont=1\nsNmae=\"a\"\nputnl(nCount)",
        expect![[r#"
        V0101 write `nCount` (unsafe)
        V0101 write `sName` (unsafe)
        V0103 write `putln` (unsafe)
        begin

        nCount=1
        sName="a"
        putln(nCount)
        end
    "#]],
    );
    check(
        "library part \"Disk://part/part.pjx\"\n\npart:nWieght=prat:nWeight\n\n--- part\npublic num nWeight",
        expect![[r#"
        V0601 write `nWeight` (unsafe)
        V0105 write `part` (unsafe)
        begin

        part:nWeight=part:nWeight
        end
    "#]],
    );
    check(
        "trsf trA\n\ntrA.xx=1\ncall pcik()\n\nprogram pick()\nbegin\nend",
        expect![[r#"
        V0107 write `rx` (unsafe)
        V0102 write `pick` (unsafe)
        begin

        trA.rx=1
        call pick()
        end
    "#]],
    );
}

#[test]
fn calls_are_corrected() {
    check(
        "call putln(\"a\")\n  pick()\n\nprogram pick()\nbegin\nend",
        expect![[r#"
        V0102 remove `call`
        V0103 write `call`
        begin
        putln("a")
          call pick()
        end
    "#]],
    );
}

#[test]
fn block_ends_are_corrected() {
    check(
        "num n\n\nif n==1\n  n=2\nn=3",
        expect![[r#"
        V0014 write `endIf` (unsafe)
        begin

        if n==1
          n=2
        endIf
        n=3
        end
    "#]],
    );
    check(
        "num n\n\nwhile n==1\n  if n==2\n    n=2\nendWhile",
        expect![[r#"
        V0014 write `endIf` (unsafe)
        begin

        while n==1
          if n==2
            n=2
          endIf
        endWhile
        end
    "#]],
    );
    check(
        "num n\n\nif n==1\n  n=2\nendWhile\nn=3",
        expect![[r#"
        V0014 write `endIf` (unsafe)
        begin

        if n==1
          n=2
        endIf
        n=3
        end
    "#]],
    );
    check(
        "num n\n\nswitch n\n  case 1\n    n=2\n  default\n    n=3\nendSwitch",
        expect![[r#"
        V0016 close the branch with `break`
        V0016 close the branch with `break`
        begin

        switch n
          case 1
            n=2
          break
          default
            n=3
          break
        endSwitch
        end
    "#]],
    );
}

#[test]
fn begin_and_end_are_added() {
    check_as(
        |text| text.replace("begin", ""),
        "putln(\"a\")",
        expect![[r#"
        V0028 write `begin` (unsafe)

        begin
        putln("a")
        end
    "#]],
    );
    check_as(
        |text| text.replace("\nend", "\n"),
        "putln(\"a\")",
        expect![[r#"
        V0028 write `end` (unsafe)
        begin
        putln("a")
        end

    "#]],
    );
}

#[test]
fn words_of_other_languages_are_replaced() {
    let listing = "num n\n\nIF n<>1 && n!=2\n  n=1\nelse if n==3 then\n  n=2\nend if";
    check(
        listing,
        expect![[r#"
            V0701 write `if`
            V0026 write `!=`
            V0026 write `elseIf`
            V0026 write `endIf`
            begin

            if n!=1 and n!=2
              n=1
            elseIf n==3
              n=2
            endIf
            end
        "#]],
    );
    check_as(
        escaped,
        listing,
        expect![[r#"
            V0701 write `if`
            V0026 write `!=`
            V0026 write `elseIf`
            V0026 write `endIf`
            begin

            if n!=1 and n!=2
              n=1
            elseIf n==3
              n=2
            endIf
            end
        "#]],
    );
}

#[test]
fn comparisons_and_assignments_are_corrected() {
    check(
        "num n\nbool b\n\nif n=1\n  b=(n=2)\nendIf\nn==3",
        expect![[r#"
        V0023 write `==`
        V0023 write `==` (unsafe)
        V0220 write `=` (unsafe)
        begin

        if n==1
          b=(n==2)
        endIf
        n=3
        end
    "#]],
    );
}

#[test]
fn brackets_are_corrected() {
    check(
        "num n[3]\n\nputln(n[1)\nputln(n[1]\nn[1]=2)",
        expect![[r#"
        V0011 write `]` (unsafe)
        V0011 write `)` (unsafe)
        V0012 remove `)` (unsafe)
        begin

        putln(n[1])
        putln(n[1])
        n[1]=2
        end
    "#]],
    );
}

#[test]
fn comments_move_to_lines_of_their_own() {
    let listing = "num n\n\nif n==1\n  n=2   // & so <on>\nendIf";
    check(
        listing,
        expect![[r#"
        V0024 move the comment above the line
        begin

        if n==1
          // & so <on>
          n=2
        endIf
        end
    "#]],
    );
    check_as(
        escaped,
        listing,
        expect![[r#"
        V0024 move the comment above the line
        begin

        if n==1
          // &amp; so &lt;on&gt;
          n=2
        endIf
        end
    "#]],
    );
    check_as(
        |text| escaped(text).replace('\n', "&#13;\n").replacen("&#13;", "", 3),
        listing,
        expect![[r#"
        V0024 move the comment above the line
        begin&#13;
        &#13;
        if n==1&#13;
          // &amp; so &lt;on&gt;&#13;
          n=2&#13;
        endIf&#13;
        end
    "#]],
    );
    check_as(
        |text| text.replace('\n', "\r\n"),
        listing,
        expect![[r#"
        V0024 move the comment above the line
        begin␍
        ␍
        if n==1␍
          // & so <on>␍
          n=2␍
        endIf␍
        end
    "#]],
    );
}

fn with_second_entry(text: &str) -> String {
    text.replace(
        "    <Program file=\"start.pgx\"",
        "    <Program file=\"start.pgx\"/>\n    <Program file=\"start.pgx\"",
    )
}

#[test]
fn project_entries_are_corrected() {
    check_as(
        with_second_entry,
        "putln(\"a\")",
        expect![[r#"
        V0503 remove the second entry
        <Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
          <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
          <Programs>
            <Program file="start.pgx"/>
          </Programs>
          <Database>
            <Data file="main.dtx" />
          </Database>
          <Libraries />
          <Types />
        </Project>
    "#]],
    );
}

#[test]
fn crossed_blocks_are_swapped() {
    check(
        "bool b\n\nprogram p()\nbegin\n  while b\n    if b\n      cls()\n  endWhile\n    endIf\nend",
        expect![[r#"
        V0014 swap `endWhile` and `endIf` (unsafe)
        begin
          while b
            if b
              cls()
          endIf
            endWhile
        end
    "#]],
    );
}

#[test]
fn both_missing_begin_and_end_are_added() {
    check(
        "=== main/main.pjx\n<Project><Programs><Program file=\"p.pgx\" /></Programs></Project>\n=== main/p.pgx\n\
         <Programs><Program name=\"p\"><Code><![CDATA[\n  cls()\n  put(1)\n]]></Code></Program></Programs>\n",
        expect![[r#"
        V0028 write `begin` and `end` (unsafe)

        begin
          cls()
          put(1)
        end

    "#]],
    );
}
